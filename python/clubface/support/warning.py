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
_silent = ContextVar("_silent", default=False)


@contextmanager
def without_warnings() -> Iterator[None]:
    """Make equipment without a warning; one that is kept back may still be given later."""
    token = _silent.set(True)
    try:
        yield
    finally:
        _silent.reset(token)


def warn_once(message: str, category: type[Warning]) -> None:
    """Warn, but say the same thing only once in a process."""
    if message not in _given and not _silent.get():
        _given.add(message)
        warnings.warn(message, category, stacklevel=_level_of_the_caller())


def _level_of_the_caller() -> int:
    """Return how far up the stack, from ``warn_once``, the first code outside the package stands."""
    inside = (str(Path(__file__).parent.parent), dataclasses.__file__, "<string>")
    frame, level = sys._getframe(2), 2
    while frame.f_back is not None and frame.f_code.co_filename.startswith(inside):
        frame, level = frame.f_back, level + 1
    return level
