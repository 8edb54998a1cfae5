"""Pages of ``docs/notebooks`` are the notebooks of the same names, with the outputs that they hold."""

from __future__ import annotations

import json
from base64 import b64decode
from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

FOLDER = Path(__file__).parent.parent.parent / "notebooks"
PLACE = "notebooks/"
NARROW = 640
"""Pixels up to which a picture is shrunk to the width of a phone; a wider one scrolls there."""


def page(path: Path) -> str:
    """Return a notebook as Markdown: its text, its code, what it printed, and its pictures inside the page."""
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    parts = []
    for cell in cells:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            parts.append(_linked(source))
            continue
        parts.append(f"```python\n{source}\n```")
        parts += [_output(each) for each in cell["outputs"]]
    parts.append(f"*This page is the notebook `notebooks/{path.name}`.*")
    return "\n\n".join(parts) + "\n"


def _output(output: dict[str, Any]) -> str:
    data = output.get("data", {})
    if "image/png" in data:
        picture = "".join(data["image/png"]).replace("\n", "")
        image = f'<img alt="what the code above draws" src="data:image/png;base64,{picture}">'
        width = int.from_bytes(b64decode(picture[:32])[16:20], "big")
        return f'<div class="docutils picture drawn">{image}</div>' if width > NARROW else image
    text = "".join(output.get("text", data.get("text/plain", "")))
    return f"```text\n{text.rstrip()}\n```"


def _linked(text: str) -> str:
    """Turn links of a notebook into those of a page."""
    return text.replace("](../docs/", "](../").replace(".ipynb)", ".md)").replace("$$ ", "$$").replace(" $$", "$$")


def read(app: Sphinx, docname: str, source: list[str]) -> None:
    """Put the notebook in place of the page of its name."""
    path = FOLDER / f"{docname.removeprefix(PLACE)}.ipynb"
    if docname.startswith(PLACE):
        source[0] = page(path)
        app.env.note_dependency(str(path))


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.connect("source-read", read)
    return {"parallel_read_safe": True}
