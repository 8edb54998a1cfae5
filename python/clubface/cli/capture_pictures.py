"""Where ``clubface capture read`` puts its pictures."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from clubface.cli import output
from clubface.cli.failures import say
from clubface.errors import InputError

PICTURES = "path, face and residuals; beside the table of -o unless given"


def pictures_of(picture: str | None, table: str | None, files: list[str], mapping: str) -> str | None:
    """Return the file for the pictures, or None.

    A table that is kept gets the pictures by which it can be judged beside it, a page a swing. A command that prints
    leaves no file behind unless it is told to.
    """
    inputs = [*files, mapping]
    if picture is not None:
        output.check_picture(picture, inputs)
        if len(files) > 1 and Path(picture).suffix.lower() != ".pdf":
            raise InputError("--plot", picture, "a file ending in .pdf, since several swings make several pages")
        return picture
    if table is None:
        return None
    if find_spec("matplotlib") is None:
        say('no picture is written beside the table: pip install "clubface[plots]"')
        return None
    beside = str(Path(table).with_suffix(".pdf"))
    output.check_picture(beside, inputs)
    return beside
