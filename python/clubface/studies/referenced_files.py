"""Fingerprints of the files that a study refers to, and of those that these name in turn, such as a mesh."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from clubface.errors import FileError
from clubface.support.fingerprint import fingerprint_of_file
from clubface.support.strict_toml import Document


def fingerprints_of(path: Path) -> list[str]:
    """Return fingerprints of the bytes of a file and of all files it names, in the order in which it names them."""
    return list(dict.fromkeys(fingerprint_of_file(each) for each in _files(path, set())))


def files_of(path: Path) -> list[Path]:
    """Return a file, and all files it names; a folder names none."""
    return list(_files(path, set())) if path.is_file() else [path]


def _files(path: Path, seen: set[Path]) -> Iterator[Path]:
    if "\0" in str(path):
        raise FileError(str(path), None, "cannot be read: no name of a file has the character \\u0000")
    if (real := path.resolve()) in seen:
        return
    seen.add(real)
    yield path
    if path.suffix.lower() != ".toml":
        return
    for text in _texts(Document.read(path).data):
        # A name of a file has a point; few other texts are files that exist.
        if "." in text and len(text) < 1000 and text.isprintable() and (named := path.parent / text).is_file():
            yield from _files(named, seen)


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for each in value.values():
            yield from _texts(each)
    elif isinstance(value, list):
        for each in value:
            yield from _texts(each)
