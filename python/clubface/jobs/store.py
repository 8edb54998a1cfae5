"""Stores of long work: parts that are finished, and records that tell damage.

A store of what is finished: a record of what it is of, and parts. Studies and every other long work keep theirs so.

The store is the truth. A part is written under another name, synced and renamed, and its name says what is in it: a
part that is there and whole is done, whoever computed it. Nobody keeps a list, and nothing is locked: two runs that
compute the same part write the same content.

Small records in JSON that are written whole and synced, and that tell damage by a sum.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from clubface.errors import FileError
from clubface.support.files import prepared_folder, synced, write_text

RECORD, PARTS = "record.json", "parts"


@dataclass(frozen=True)
class PartStore:
    """The store in a folder.

    Attributes
    ----------
    folder
        Where it is.
    record
        What it is of: ``content`` (see :func:`.fingerprints`), and what the work says of itself besides.
    """

    folder: Path
    record: dict[str, Any]

    @property
    def parts(self) -> Path:
        """The folder of the parts."""
        return self.folder / PARTS

    def prepare(self, path: Path) -> Path:
        """Return the path of a part that is to be written, in a folder that is on the disk."""
        if not path.parent.is_dir():
            prepared_folder(path.parent)
            synced(path.parent.parent)
        return path

    def files(self) -> Iterator[os.DirEntry[str]]:
        """Yield all files among the parts, those in folders of folders too."""
        yield from _files(os.fspath(self.parts))

    def size(self) -> int:
        """Return the bytes of all parts."""
        total = 0
        for each in self.files():
            with suppress(OSError):
                total += each.stat().st_size
        return total

    def tidy(self) -> None:
        """Remove what killed runs have left; to be called when all parts are there and nobody writes."""
        for each in self.files():
            if each.name.startswith("."):
                with suppress(OSError):
                    os.unlink(each.path)

    def remove(self) -> None:
        """Remove all of it at once for everybody else: another run may be about to begin in the same place."""
        gone = self.folder.with_name(f".{self.folder.name}-{os.urandom(6).hex()}")
        with suppress(OSError):
            self.folder.rename(gone)
        shutil.rmtree(gone, ignore_errors=True)


def _files(folder: str) -> Iterator[os.DirEntry[str]]:
    try:
        with os.scandir(folder) as found:
            entries = sorted(found, key=lambda each: each.name)
    except FileNotFoundError:
        return
    for each in entries:
        if each.is_dir(follow_symlinks=False):
            yield from _files(each.path)
        else:
            yield each


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
