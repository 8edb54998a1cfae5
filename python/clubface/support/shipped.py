"""The files of data that come with the package: where they lie and what they are called."""

from __future__ import annotations

import os
from pathlib import Path

from clubface.errors import UnknownNameError

DATA = Path(__file__).parent.parent / "data"


def builtin_names(folder: str) -> tuple[str, ...]:
    """List the names of the descriptions shipped in ``data/<folder>``, in alphabetical order."""
    return tuple(sorted(path.stem for path in (DATA / folder).glob("*.toml")))


def builtin_path(what: str, name: str, known: tuple[str, ...]) -> Path:
    """Return the file of the built-in club or ball called ``name``."""
    if name not in known:
        raise UnknownNameError(what, name, known)
    return DATA / f"{what}s" / f"{name}.toml"


def is_path(which: object) -> bool:
    """Tell a path from the name of a built-in."""
    return isinstance(which, os.PathLike) or (
        isinstance(which, str) and (which.endswith(".toml") or "/" in which or os.sep in which)
    )
