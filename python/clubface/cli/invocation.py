"""What a person typed, with which another person repeats a run."""

from __future__ import annotations

import os
import shlex
from collections.abc import Sequence
from contextvars import ContextVar
from pathlib import Path

_ARGUMENTS: ContextVar[tuple[str, ...]] = ContextVar("arguments", default=())


def remember(arguments: Sequence[str]) -> None:
    """Keep the arguments of the command that begins."""
    _ARGUMENTS.set(tuple(arguments))


def command() -> str:
    """Return the command as it can be typed again, files without the folders that they lie in."""
    return shlex.join(["clubface", *(Path(each).name if _is_path(each) else each for each in _ARGUMENTS.get())])


def _is_path(text: str) -> bool:
    return os.sep in text and (os.path.isabs(text) or os.path.exists(text) or os.path.isdir(os.path.dirname(text)))
