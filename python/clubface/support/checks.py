"""Checks of single values, each with an error that says what would have been accepted."""

from __future__ import annotations

from collections.abc import Iterable
from numbers import Real
from operator import index
from typing import TypeGuard

from clubface.errors import InputError, UnknownNameError


def check_name(name: object) -> None:
    """Refuse a name that is empty, not text, or not printable."""
    if not (isinstance(name, str) and name.strip() and name.isprintable()):
        raise InputError("name", name, "printable text, not empty")


def check_text(parameter: str, value: object) -> None:
    """Refuse what is not text that a file can hold (a lone surrogate cannot be written)."""
    if not isinstance(value, str) or any("\ud800" <= c <= "\udfff" for c in value):
        raise InputError(parameter, value, "text")


def check_choice(parameter: str, value: object, known: Iterable[str]) -> None:
    """Refuse a value that is not one of the ``known`` words."""
    known = tuple(known)
    if not isinstance(value, str) or value not in known:  # an array has no answer to whether it is in
        raise UnknownNameError(parameter, value, known)


def check_names(what: str, names: Iterable[object], known: Iterable[str]) -> None:
    """Refuse names of which one is not among the ``known``; ``what`` each is."""
    known = tuple(known)
    for name in names:
        check_choice(what, name, known)


def is_number(value: object) -> TypeGuard[float]:
    """Tell a real number from anything else, ``True`` and ``False`` among it."""
    return isinstance(value, Real) and not isinstance(value, bool)


def check_share(share: object) -> None:
    """Refuse what is not a number between 0 and 1."""
    if not (is_number(share) and 0.0 < share < 1.0):
        raise InputError("share", share, "between 0 and 1")


MOST_SEED = 2**63 - 1
"""The largest seed of random numbers."""


def whole(value: object) -> int | None:
    """Return a whole number of any type, NumPy's among them, as an ``int``; of anything else, ``True`` too, None."""
    try:
        return None if isinstance(value, bool) else index(value)  # pyright: ignore[reportArgumentType]
    except TypeError:
        return None


def is_count(value: object, least: int, most: int) -> bool:
    """Tell a whole number within limits from anything else."""
    count = whole(value)
    return count is not None and least <= count <= most


def check_count(parameter: str, value: object, least: int, most: int) -> int:
    """Return a whole number within limits, and refuse anything else."""
    count = whole(value)
    if count is None or not least <= count <= most:
        raise InputError(parameter, value, f"a whole number from {least} to {most}")
    return count
