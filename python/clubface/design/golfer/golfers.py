"""The golfers that come with the package, and any golfer by name or by file."""

from __future__ import annotations

import os

from clubface.design.golfer.file import read
from clubface.design.golfer.golfer import Golfer
from clubface.equipment.clubs import CLUB_NAMES
from clubface.errors import InputError
from clubface.support.shipped import builtin_names, is_path


def golfers() -> tuple[str, ...]:
    """Return the names of the golfers that come with the package."""
    return builtin_names("golfers")


def club_of(which: Golfer) -> str:
    """Return the club of a golfer: a built-in one, or the path of a file; of any other the name alone is known."""
    if which.club in CLUB_NAMES or is_path(which.club):
        return which.club
    raise InputError(
        "club", None, f"give the file of {which.club!r}, with which the deliveries of {which.name} were made"
    )


def golfer(which: str | os.PathLike[str] | Golfer) -> Golfer:
    """Return a golfer by the name of a shipped one or the path of a TOML file; a :class:`Golfer` is returned as is."""
    return which if isinstance(which, Golfer) else read(which)
