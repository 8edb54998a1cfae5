"""Warnings that are given once, at the line of the caller."""

from __future__ import annotations

import dataclasses
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path

_given: set[str] = set()
_silent: ContextVar[tuple[type[Warning], ...]] = ContextVar("_silent", default=())


@contextmanager
def without_warnings(category: type[Warning] = Warning) -> Iterator[None]:
    """Work without warnings of a category; one that is kept back may still be given later."""
    token = _silent.set((*_silent.get(), category))
    try:
        yield
    finally:
        _silent.reset(token)


def is_silent(category: type[Warning]) -> bool:
    """Return whether warnings of a category are kept back."""
    return issubclass(category, _silent.get())


def warn_once(message: str, category: type[Warning], *, key: str | None = None) -> None:
    """Warn, but say the same thing, or what has the same ``key``, only once in a process."""
    key = message if key is None else key
    if key not in _given and not is_silent(category):
        _given.add(key)
        warnings.warn(message, category, stacklevel=_level_of_the_caller())


def _level_of_the_caller() -> int:
    """Return how far up the stack, from ``warn_once``, the first code outside the package stands."""
    inside = (str(Path(__file__).parent.parent), dataclasses.__file__, "<string>")
    frame, level = sys._getframe(2), 2
    while frame.f_back is not None and frame.f_code.co_filename.startswith(inside):
        frame, level = frame.f_back, level + 1
    return level
