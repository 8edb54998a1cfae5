"""Shots: files and live messages of launch monitors, recorded, measured and predicted shots.

:func:`read` reads a file, and ``clubface.shots.open_connect`` exchanges shots over a socket.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from clubface.shots import open_connect as open_connect
    from clubface.shots.monitors import FORMATS as FORMATS
    from clubface.shots.reading import read as read
    from clubface.shots.reference_points import refer as refer

_HOME = {
    "FORMATS": "monitors",
    "read": "reading",
    "refer": "reference_points",
}

_MODULES = ("open_connect",)

__all__ = [*_HOME, *_MODULES]  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        return import_module(f"clubface.shots.{name}")
    if name not in _HOME:
        raise AttributeError(f"module 'clubface.shots' has no attribute {name!r}")
    return getattr(import_module(f"clubface.shots.{_HOME[name]}"), name)
