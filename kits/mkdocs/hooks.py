"""Adds the element's script to each page that holds a playground."""

import posixpath
from urllib.parse import urlsplit

SCRIPT = "mo-copp/mo-copp-playground.js"


def with_script(output, address, config):
    # With instant navigation the scripts of the first page are those of the whole visit.
    instant = "navigation.instant" in (config.theme.get("features") or [])
    if not instant and "<mo-copp-playground" not in output:
        return output
    return output.replace("</head>", f'<script type="module" src="{address}"></script></head>', 1)


def on_post_page(output, page, config):
    folder = posixpath.dirname(page.file.url) if not page.file.url.endswith("/") else page.file.url
    return with_script(output, posixpath.relpath(SCRIPT, folder or "."), config)


def on_post_template(output_content, template_name, config):
    """A visit may begin at a page of the theme's own: ``404.html`` is shown at any address, others at their name."""
    if not template_name.endswith(".html"):
        return output_content
    if template_name == "404.html":
        address = posixpath.join("/", urlsplit(config.site_url or "").path, SCRIPT)
    else:
        address = posixpath.relpath(SCRIPT, posixpath.dirname(template_name) or ".")
    return with_script(output_content, address, config)
