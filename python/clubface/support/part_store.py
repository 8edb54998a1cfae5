"""A store of what is finished: a record of what it is of, and parts. Studies and every other long work keep theirs so.

The store is the truth. A part is written under another name, synced and renamed, and its name says what is in it: a
part that is there and whole is done, whoever computed it. Nobody keeps a list, and nothing is locked: two runs that
compute the same part write the same content.
"""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from clubface.errors import FileError
from clubface.support.checked_json import read_checked, write_checked
from clubface.support.folders import prepared_folder
from clubface.support.whole_file import synced

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
        """Remove all of it, the record last: what a kill leaves is a store of fewer parts."""
        shutil.rmtree(self.parts, ignore_errors=True)
        with suppress(OSError):
            (self.folder / RECORD).unlink()
        with suppress(OSError):
            self.folder.rmdir()


def recorded(folder: Path, damaged: str) -> dict[str, Any]:
    """Return the record of the store in a folder; one that cannot be read is a :class:`FileError`: ``damaged``."""
    return read_checked(folder / RECORD, damaged)


def begin(
    folder: Path, content: Mapping[str, str], describe: Callable[[], dict[str, Any]], *, foreign: str, damaged: str
) -> dict[str, Any]:
    """Return the record of the store in a folder, which is made unless it is there.

    Parameters
    ----------
    folder
        The folder.
    content
        What the work is of, as of :func:`.fingerprints`.
    describe
        Called for the rest of the record where there is none yet. Whoever comes first decides.
    foreign, damaged
        What is told of a folder of something else, and of a record that cannot be read.

    Raises
    ------
    FileError
        The folder is something else, cannot be made, or its record cannot be read.
    """
    if not (folder / RECORD).exists():
        if folder.exists() and (not folder.is_dir() or any(each.name != PARTS for each in _seen(folder))):
            raise FileError(str(folder), None, foreign)
        record = {"content": dict(content), **describe()}
        prepared_folder(folder)
        try:
            write_checked(folder / RECORD, record, new=True)
        except FileError:
            if not (folder / RECORD).exists():
                raise
    return recorded(folder, damaged)


def _seen(folder: Path) -> list[Path]:
    return [each for each in folder.iterdir() if not each.name.startswith(".")]


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
