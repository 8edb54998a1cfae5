"""The files of data that come with the package: where they lie and what they are called."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from clubface.support.checks import check_choice

DATA = Path(__file__).parent.parent / "data"


def builtin_names(folder: str) -> tuple[str, ...]:
    """List the names of the descriptions shipped in ``data/<folder>``, in alphabetical order."""
    return tuple(sorted(path.stem for path in (DATA / folder).glob("*.toml")))


def builtin_path(what: str, name: object, folder: str, known: Iterable[str] | None = None) -> Path:
    """Return the file of the description in ``data/<folder>`` that is called ``name``; ``what`` it is, for errors."""
    names = tuple(known or builtin_names(folder))
    check_choice(what, name, names)
    return DATA / folder / f"{name}.toml"


def is_path(which: object) -> bool:
    """Tell a path from the name of a built-in."""
    return isinstance(which, os.PathLike) or (
        isinstance(which, str) and (which.endswith(".toml") or "/" in which or os.sep in which)
    )


def beside(which: str, folder: Path) -> str | Path:
    """Return a name as it is, and a path that a file names as it is from the folder of that file."""
    return folder / which if is_path(which) else which


def path_of(what: str, which: str | os.PathLike[str], folder: str) -> str | os.PathLike[str]:
    """Return the path that is meant by itself, or by the name of a description in ``data/<folder>``."""
    return which if is_path(which) else builtin_path(what, which, folder)
