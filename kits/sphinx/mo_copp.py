"""The directive ``mo-copp``: a playground in HTML, its text everywhere else."""

from html import escape

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.util.docutils import SphinxDirective

#: All but ``name``, which docutils has for itself.
ATTRIBUTES = (
    "src problem plan step watch solver k j horizon hide link theme keys loading worker-url wasm-url "
    "seed student exercise required disabled"
).split()
SCRIPT = "mo-copp/mo-copp-playground.js"


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


def visit_html(translator, node):
    given = node["given"] | ({"id": node["label"]} if node["label"] else {})
    written = "".join(f' {name}="{escape(value)}"' for name, value in given.items())
    translator.body.append(f"<mo-copp-playground{written}>")


def depart_html(translator, node):
    translator.body.append("</mo-copp-playground>")


def passed(translator, node):
    """The children are written as they are."""


def add_script(app, pagename, templatename, context, doctree):
    """``add_js_file`` would add ``?v=…``: the script's own parts ask for it without that, and have it loaded twice."""
    if doctree is not None and any(doctree.findall(playground)):
        address = escape(context["pathto"](f"_static/{SCRIPT}", resource=True))
        context["body"] = f'<script type="module" src="{address}"></script>\n{context["body"]}'


def setup(app):
    others = {name: (passed, passed) for name in ("latex", "text", "man", "texinfo")}
    app.add_node(playground, html=(visit_html, depart_html), **others)
    app.add_directive("mo-copp", Playground)
    app.connect("html-page-context", add_script)
    return {"version": "0.1.0", "parallel_read_safe": True, "parallel_write_safe": True}
