"""Model parameters from measured shots, and how well they are known."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from clubface.identify.result import Identification as Identification
    from clubface.identify.run import identify as identify

_HOME = {"Identification": "result", "identify": "run"}

__all__ = [*_HOME]  # pyright: ignore[reportUnsupportedDunderAll]


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module 'clubface.identify' has no attribute {name!r}")
    return getattr(import_module(f"clubface.identify.{_HOME[name]}"), name)
