"""Adds the element's script to each page that holds a playground."""

import posixpath

SCRIPT = "mo-copp/mo-copp-playground.js"


def on_post_page(output, page, config):
    # With instant navigation the scripts of the first page are those of the whole visit.
    instant = "navigation.instant" in (config.theme.get("features") or [])
    if not instant and "<mo-copp-playground" not in output:
        return output
    folder = posixpath.dirname(page.file.url) if not page.file.url.endswith("/") else page.file.url
    address = posixpath.relpath(SCRIPT, folder or ".")
    return output.replace("</head>", f'<script type="module" src="{address}"></script></head>', 1)
