"""What a person typed, and the files it names: with them another person repeats a run."""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Iterator, Sequence
from contextvars import ContextVar
from pathlib import Path

_ARGUMENTS: ContextVar[tuple[str, ...]] = ContextVar("arguments", default=())
WRITTEN = ("-o", "--output", "--plot", "--report")
"""Options that name what a command writes."""
MOST_BYTES = 2**17
"""Larger descriptions are told by their fingerprint alone, as tables are."""


def remember(arguments: Sequence[str]) -> None:
    """Keep the arguments of the command that begins."""
    _ARGUMENTS.set(tuple(arguments))


def command() -> str:
    """Return the command as it can be typed again, files without the folders that they lie in."""
    return shlex.join(["clubface", *(Path(each).name if _is_path(each) else each for each in _ARGUMENTS.get())])


def read_files() -> list[Path]:
    """Return the files that the command reads, and those that the descriptions among them name."""
    typed = _ARGUMENTS.get()
    todo = [
        Path(each)
        for place, each in enumerate(typed)
        if not (place and typed[place - 1] in WRITTEN) and not each.startswith("-") and _is_file(each)
    ]
    found: list[Path] = []
    while todo:
        path = todo.pop(0)
        if path not in found:
            found.append(path)
            todo += [Path(each) for each in _named_in(path) if _is_file(each)]
    return found


def is_description(path: Path) -> bool:
    """Return whether a file is a description of a size that a report repeats."""
    return path.suffix.lower() == ".toml" and path.stat().st_size <= MOST_BYTES


def _named_in(path: Path) -> Iterator[str]:
    if is_description(path):
        yield from re.findall(r"""["']([^"'\n]+\.(?:toml|csv|tsv|parquet))["']""", path.read_text(errors="replace"))


def _is_path(text: str) -> bool:
    return os.sep in text and (os.path.isabs(text) or os.path.exists(text) or os.path.isdir(os.path.dirname(text)))


def _is_file(text: str) -> bool:
    try:
        return os.path.isfile(text)
    except (OSError, ValueError):  # such as a text that is too long for a name
        return False
