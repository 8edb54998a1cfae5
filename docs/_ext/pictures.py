"""Pictures of the width of the page stay legible on a phone: another one takes their place, or they scroll."""

from __future__ import annotations

from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx

NARROW = "-narrow"
"""Ending of the name of a picture for phones, after the name of the wide one."""


def wrap(app: Sphinx, tree: nodes.document) -> None:
    """Put each picture of the width of the page into a container, with the one for a phone if there is one."""
    for image in list(tree.findall(nodes.image)):
        if image.get("width") != "100%" or isinstance(image.parent, nodes.TextElement):
            continue
        address = Path(image["uri"])
        narrow = address.with_stem(f"{address.stem}{NARROW}")
        exists = (Path(app.env.doc2path(app.env.docname)).parent / narrow).is_file()
        wide = nodes.container(classes=["picture", "wide"] if exists else ["picture"])
        image.replace_self(wide)
        wide += image
        if exists:
            other = image.deepcopy()
            other["uri"] = narrow.as_posix()
            container = nodes.container(classes=["picture", "narrow"])
            container += other
            wide.parent.insert(wide.parent.index(wide) + 1, container)


def setup(app: Sphinx) -> dict[str, bool]:
    """Run before the pictures of a page are collected."""
    app.connect("doctree-read", wrap, priority=100)
    return {"parallel_read_safe": True}
