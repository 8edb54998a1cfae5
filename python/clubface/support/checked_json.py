"""Small records in JSON that are written whole and synced, and that tell damage by a sum."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from clubface.errors import FileError
from clubface.support.whole_file import write_text

LARGEST = 64_000_000
"""Bytes of a record."""


def write_checked(path: Path, values: Mapping[str, Any], *, new: bool = False) -> None:
    """Write what JSON has with a sum over it; a ``new`` file that is there already is an error."""
    text = json.dumps(values)
    write_text(path, f'{{"sum": "{_sum(text)}", "values": {text}}}', new=new)


def read_checked(path: Path, damaged: str) -> dict[str, Any]:
    """Return what :func:`write_checked` wrote; anything else is a :class:`FileError` that says ``damaged``."""
    try:
        found = json.loads(path.read_bytes()) if path.stat().st_size <= LARGEST else {}
        if found["sum"] == _sum(json.dumps(found["values"])):
            return found["values"]
    except (OSError, ValueError, KeyError, TypeError, RecursionError, OverflowError):
        pass
    raise FileError(str(path), None, damaged)


def _sum(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()
