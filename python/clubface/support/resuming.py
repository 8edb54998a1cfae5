"""Long work that goes on where it stopped: what is finished stays in files, and other work is not mixed with it."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

from clubface.errors import FileError
from clubface.support.plain_json import plain

LARGEST = 64_000_000
"""Bytes of a file in which work is recorded."""
UNREADABLE = "this file cannot be read; start again without resuming"
OTHERS = "this file was begun from another file or with other settings; start again without resuming"


def unfinished(path: Path, ending: str | None = None) -> Path:
    """Return the name a file has until it is complete, or that of its journal by another ``ending``."""
    return path.with_name(f"{path.stem}.part{path.suffix if ending is None else ending}")


def write_whole(path: Path, text: str) -> None:
    """Write a file, whole or not at all."""
    fresh = path.with_name(path.name + ".new")
    fresh.write_text(text, encoding="utf-8")
    os.replace(fresh, path)


def once(path: Path, compute: Callable[[], Any]) -> Any:
    """Return what a JSON file holds, computed and written there if it is not."""
    if not path.exists():
        write_whole(path, json.dumps(plain(compute()), allow_nan=False))
    try:
        return _read_json(path)
    except (OSError, ValueError):
        raise FileError(str(path), None, "this file cannot be read; remove it, and it is computed again") from None


def _read_json(path: Path) -> Any:
    """Return what a JSON file holds; a ``ValueError`` where it is damaged, however deep or long it has become."""
    if path.stat().st_size > LARGEST:
        raise ValueError
    try:
        return json.loads(path.read_bytes())
    except RecursionError:
        raise ValueError from None


def complete_lines(path: Path) -> list[str]:
    """Return the whole lines of a text file; a run that was cut off may have ended within one more."""
    content = path.read_bytes()
    try:
        return content.decode().split("\n")[:-1]
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        raise FileError(
            str(path), line, "this file is damaged: it is not UTF-8 text; remove it and start again"
        ) from None


def cut_incomplete_line(path: Path) -> None:
    """Cut a text file after its last whole line, so that more can be added."""
    with path.open("rb+") as file:
        file.truncate(file.read().rfind(b"\n") + 1)


def fingerprint(content: Any) -> str:
    """Return a text that is the same only for the same content: what JSON has, arrays, data classes, and their like."""
    return hashlib.sha256(json.dumps(content, default=_told, sort_keys=True).encode()).hexdigest()


def _told(value: Any) -> Any:
    """Return what JSON has no form for as what it has: every number of an array counts, not those its text shows."""
    import numpy as np

    if isinstance(value, np.ndarray) and value.dtype != object:
        return [str(value.dtype), value.shape, hashlib.sha256(np.ascontiguousarray(value).tobytes()).hexdigest()]
    if isinstance(value, Mapping):
        return dict(value)
    if is_dataclass(value):
        return [type(value).__name__, *((each.name, getattr(value, each.name)) for each in fields(value))]
    return str(value)


def _sum(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


class Journal:
    """How far some work has come, in a JSON file beside what it makes; a sum over it tells a damaged one.

    Parameters
    ----------
    path
        Of the file.
    settings
        The fingerprint of what the work is of.
    unreadable, others
        What an error says of a file that is no journal, and of one of other work.
    """

    def __init__(self, path: Path, settings: str, *, unreadable: str = UNREADABLE, others: str = OTHERS) -> None:
        self.path = path
        self.settings = settings
        self._unreadable = unreadable
        self._others = others

    def write(self, state: Mapping[str, Any]) -> None:
        """Record ``state``, whole or not at all."""
        text = json.dumps({"settings": self.settings, **state})
        write_whole(self.path, f'{{"sum": "{_sum(text)}", {text[1:]}')

    def read(self, check: Callable[[Any], Any], *, resume: bool = True) -> Any:
        """Return ``check`` of what was recorded, None where nothing was; refuse what is no journal or of other work.

        ``check`` takes the state apart; what it raises says that the file is no journal. Without ``resume`` it is no
        more than that which is looked at.
        """
        try:
            state = _read_json(self.path)
            if state.pop("sum") != _sum(json.dumps(state)):
                raise ValueError
            begun, found = state["settings"], check(state)
        except FileNotFoundError:
            return None
        except (OSError, ValueError, KeyError, TypeError, AttributeError, OverflowError):
            raise FileError(str(self.path), None, self._unreadable) from None
        if not resume:
            return None
        if begun != self.settings:
            raise FileError(str(self.path), None, self._others)
        return found

    def remove(self) -> None:
        """Remove it: the work is done."""
        self.path.unlink(missing_ok=True)
