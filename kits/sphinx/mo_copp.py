"""The directive ``mo-copp``: a playground in HTML, its text everywhere else."""

from html import escape

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.docutils import SphinxDirective
from sphinx.util.osutil import relative_uri

#: All but ``name``, which docutils has for itself.
ATTRIBUTES = (
    "src problem plan step watch solver k j horizon hide link theme keys loading worker-url wasm-url "
    "seed student exercise required disabled"
).split()
FOLDER = "mo-copp"
SCRIPT = f"_static/{FOLDER}/mo-copp-playground.js"


def runs_scripts(builder):
    """Books and the pages of help viewers are HTML, too: Sphinx calls these builders embedded."""
    return builder.format == "html" and not getattr(builder, "embedded", False)


class playground(nodes.General, nodes.Element):
    """A playground; its children stand for it where it cannot run."""


class Playground(SphinxDirective):
    has_content = True
    option_spec = {name: directives.unchanged for name in [*ATTRIBUTES, "name"]}

    def run(self):
        node = playground(given={name: self.options[name] for name in ATTRIBUTES if name in self.options})
        node["label"] = self.options.get("name", "")
        self.state.nested_parse(self.content, self.content_offset, node)
        return [node]


class Unscripted(SphinxPostTransform):
    """The children take the playground's place where no browser runs it: on paper, in text, in books and help viewers."""

    default_priority = 200

    def run(self, **kwargs):
        if runs_scripts(self.app.builder):
            return
        for node in list(self.document.findall(playground)):
            place = node.parent.index(node)
            node.parent[place : place + 1] = node.children


def visit_html(translator, node):
    given = node["given"] | ({"id": node["label"]} if node["label"] else {})
    written = "".join(f' {name}="{escape(value)}"' for name, value in given.items())
    translator.body.append(f"<mo-copp-playground{written}>")


def depart_html(translator, node):
    translator.body.append("</mo-copp-playground>")


def add_script(app, pagename, templatename, context, doctree):
    """``add_js_file`` would add ``?v=…``: the script's own parts ask for it without that, and have it loaded twice.

    The address is worked out here: builders that write pages for other programs have no ``pathto`` for resources.
    """
    if doctree is not None and any(doctree.findall(playground)):
        here = app.builder.get_target_uri(pagename).partition("#")[0]
        address = escape(relative_uri(here, SCRIPT))
        context["body"] = f'<script type="module" src="{address}"></script>\n{context["body"]}'


def leave_script_out(app, builder):
    """A book takes along all that is static."""
    if not runs_scripts(builder):
        app.config.exclude_patterns = [*app.config.exclude_patterns, f"**/{FOLDER}"]


def setup(app):
    app.add_node(playground, html=(visit_html, depart_html))
    app.add_directive("mo-copp", Playground)
    app.add_post_transform(Unscripted)
    app.connect("html-page-context", add_script)
    # Sphinx has it since 7.4; before, books hold the folder, and nothing in them asks for it.
    if "write-started" in app.events.events:
        app.connect("write-started", leave_script_out)
    return {"version": "0.1.0", "parallel_read_safe": True, "parallel_write_safe": True}
