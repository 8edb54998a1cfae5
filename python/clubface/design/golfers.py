"""The golfers that come with the package, and any golfer by name or by file."""

from __future__ import annotations

import os

from clubface.design.golfer import Golfer
from clubface.design.golfer_file import read
from clubface.support.shipped import builtin_names


def golfers() -> tuple[str, ...]:
    """Return the names of the golfers that come with the package."""
    return builtin_names("golfers")


def golfer(which: str | os.PathLike[str] | Golfer) -> Golfer:
    """Return a golfer by the name of a shipped one or the path of a TOML file; a :class:`Golfer` is returned as is."""
    return which if isinstance(which, Golfer) else read(which)
