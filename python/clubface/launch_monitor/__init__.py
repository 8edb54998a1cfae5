"""Launch monitors: their files and their live messages, as shots with the units and signs of clubface.

:func:`read` reads a file, and ``clubface.launch_monitor.open_connect`` exchanges shots over a socket.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from clubface.launch_monitor import open_connect as open_connect
    from clubface.launch_monitor.reading import read as read
    from clubface.launch_monitor.reference_points import refer as refer
    from clubface.launch_monitor.registry import FORMATS as FORMATS

_HOME = {
    "FORMATS": "registry",
    "read": "reading",
    "refer": "reference_points",
}

_MODULES = ("open_connect",)

__all__ = [*_HOME, *_MODULES]  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name in _MODULES:
        return import_module(f"clubface.launch_monitor.{name}")
    if name not in _HOME:
        raise AttributeError(f"module 'clubface.launch_monitor' has no attribute {name!r}")
    return getattr(import_module(f"clubface.launch_monitor.{_HOME[name]}"), name)
