"""Comments that hold the figures of a page to what computes them: only the commit of the long ones is shown."""

from __future__ import annotations

import re
import sys
from pathlib import Path

from docutils import nodes
from sphinx.application import Sphinx

sys.path.insert(0, str(Path(__file__).parents[1]))
from run import BLOCK, stored


def shown(block: re.Match[str]) -> str:
    """Return what the page shows in place of a comment of figures; blocks of code stay."""
    if block["figures"] is None:
        return block[0]
    if not block["study"]:
        return ""
    return f"*Computed with the sources of commit {block['commit'] or 'unknown'}; `make study` checks these figures.*"


def commit(
    name: str, rawtext: str, text: str, lineno: int, inliner: object, options: object = None, content: object = None
) -> tuple[list[nodes.Node], list[nodes.system_message]]:
    """Return the text of ``{commit}`docs/findings.json```: the commit with which stored results were computed."""
    return [nodes.Text(stored(text)["commit"])], []


def replace_comments(app: Sphinx, name: str, source: list[str]) -> None:
    """Replace the comments of a page before it is parsed."""
    source[0] = BLOCK.sub(shown, source[0])


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the handler."""
    app.add_role("commit", commit)
    app.connect("source-read", replace_comments)
    return {"parallel_read_safe": True}
