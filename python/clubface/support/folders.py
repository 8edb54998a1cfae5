"""Folders for results."""

from __future__ import annotations

import os
from pathlib import Path

from clubface.errors import FileError


def prepared_folder(folder: str | os.PathLike[str]) -> Path:
    """Make the folder; one that cannot be made is told before any work is done."""
    path = Path(folder)
    try:
        path.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        raise FileError(str(path), None, "this is a file; give the name of a folder") from None
    if not os.access(path, os.W_OK):
        raise FileError(str(path), None, "this folder cannot be written to")
    return path
