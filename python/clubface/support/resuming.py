"""Long work that goes on where it stopped: what is finished stays in a folder, and other work is not mixed with it."""

from __future__ import annotations

import hashlib
import json
import os
import time
from collections.abc import Callable, Iterable, Mapping
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path, PurePath
from typing import TYPE_CHECKING, Any, BinaryIO, Self

from clubface.errors import FileError
from clubface.support.checked_json import read_checked, write_checked
from clubface.support.folders import prepared_folder
from clubface.support.lock import Lock
from clubface.support.strict_toml import Document
from clubface.support.version import __version__
from clubface.support.whole_file import unwritable, whole_file

if TYPE_CHECKING:
    from collections.abc import Iterator

WORK, LOCK = "work.json", "lock"
"""The files of a store that tell what it is of, and who works on it."""
DAMAGED = "this record of unfinished work is damaged; remove the folder it is in, and start again"
OFTEN = 0.5
"""What is finished is on the disk after this time at most [s]: small values are written together."""


def unfinished(path: Path, inputs: Iterable[str | os.PathLike[str]] = ()) -> Path:
    """Return the folder that keeps what is finished of a file until it is complete; no input may lie in it."""
    folder = path.with_name(path.name + ".unfinished")
    for each in inputs:
        if folder.resolve() in (Path(each).resolve(), *Path(each).resolve().parents):
            message = f"the finished parts of {path} go to {folder}; give another name for one of the files"
            raise FileError(os.fspath(each), None, message)
    return folder


def kept_beside(
    output: str | os.PathLike[str] | None, content: Mapping[str, Any], *, resume: bool
) -> AbstractContextManager[Store | None]:
    """Return the store of what is finished of a file, in a folder beside it; of no file there is none.

    ``content`` and ``resume`` are as of :class:`Store`.
    """
    if output is None:
        return nullcontext()
    return Store(unfinished(Path(output)), content, of=Path(output), resume=resume)


def fingerprint(content: Any) -> str:
    """Return a text that is the same only for the same content: what JSON has, arrays, data classes, and their like."""
    return hashlib.sha256(json.dumps(_told(content), sort_keys=True).encode()).hexdigest()


def fingerprint_of_file(path: str | os.PathLike[str]) -> str:
    """Return a text that is the same only for the same bytes in a file."""
    try:
        with open(path, "rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise FileError(os.fspath(path), None, f"cannot be read: {error.strerror or error}") from None


def _told(value: Any) -> Any:
    """Return content as JSON has it: every number of an array counts, not those its text shows."""
    if value is None or isinstance(value, (str, int, float)):
        return value
    if isinstance(value, Mapping):
        told = {key: _told(each) for key, each in value.items()}
        return told if all(isinstance(key, str) for key in told) else sorted((repr(key), told[key]) for key in told)
    if isinstance(value, (set, frozenset)):
        value = sorted(value)
    if isinstance(value, (list, tuple)):
        return [_told(each) for each in value]
    if is_dataclass(value):
        return [type(value).__name__, *([each.name, _told(getattr(value, each.name))] for each in fields(value))]
    if isinstance(value, Document):
        return _told(value.data)
    if isinstance(value, (PurePath, Enum)):
        return str(value)
    import numpy as np

    if isinstance(value, np.ndarray) and value.dtype != object:
        return [str(value.dtype), value.shape, hashlib.sha256(np.ascontiguousarray(value).tobytes()).hexdigest()]
    if isinstance(value, (np.ndarray, np.generic)):
        return _told(value.tolist())
    raise TypeError(f"a {type(value).__name__} has no fingerprint")


def fingerprints(content: Mapping[str, Any]) -> dict[str, str]:
    """Return a fingerprint of each part of what a work is of, and of the version, by what a person calls it."""
    return {name: fingerprint(each) for name, each in {**content, "version": __version__}.items()}


def check_same(folder: Path, told: Mapping[str, str], begun: Mapping[str, str], otherwise: str) -> None:
    """Refuse to go on with work in ``folder`` that was begun with other content; both as of :func:`fingerprints`."""
    if other := [name for name in {**told, **begun} if told.get(name) != begun.get(name)]:
        message = f"this was begun with another {', another '.join(other)}; {otherwise}"
        raise FileError(str(folder), None, message)


class Store:
    """What a long work has finished, by name, in a folder of its own that one process works on at a time.

    Values are what JSON has. They are on the disk, whole or not at all, within ``OFTEN`` and when the store is closed.
    Larger parts go to files of the folder: a value that is kept after its file is written tells that the file is there.

    Parameters
    ----------
    folder
        The folder, which is made in one that exists.
    content
        What the work is of, by what a person calls it: source, options, accuracy. The version belongs to it always.
    of
        What the work makes, for messages.
    resume
        Whether to go on with what is there. Otherwise it is removed; a folder that is no store is left alone.
    otherwise
        What a message advises where the store belongs to other work.

    Attributes
    ----------
    resumed
        The names that were there.

    Raises
    ------
    FileError
        Another process works on it, it belongs to other work, or the folder is something else.
    """

    def __init__(
        self, folder: Path, content: Mapping[str, Any], *, of: Path | None = None, resume: bool = True,
        otherwise: str = "start again without resuming",
    ) -> None:  # fmt: skip
        self.folder = folder
        self._values: dict[str, Any] = {}
        self._fresh: dict[str, Any] = {}
        self._batches = 0
        self._written = time.monotonic()
        told = fingerprints(content)
        if not folder.parent.is_dir():
            raise FileError(str(of or folder), None, f"there is no folder {str(folder.parent)!r}")
        self._lock = self._locked(of or folder)
        try:
            self._begin(told, resume, otherwise)
        except BaseException:
            if (folder / WORK).exists():
                self._lock.release()
            else:
                self.remove()
            raise
        self.resumed = tuple(self._values)

    def _locked(self, of: Path) -> Lock:
        while True:
            if self.folder.exists() and not (self.folder / WORK).exists():
                self._refuse_others()
            try:
                prepared_folder(self.folder)
                return Lock(self.folder / LOCK, of)
            except OSError as error:
                raise unwritable(of, error) from None
            except FileError:
                if self.folder.exists():
                    raise
                # Another run has just ended and removed the folder.

    def _refuse_others(self) -> None:
        """Refuse a folder of something else, which would be removed."""
        if not self.folder.is_dir() or any(each.name != LOCK and each.name[0] != "." for each in self.folder.iterdir()):
            message = "this is no record of unfinished work; move it away, or give another name"
            raise FileError(str(self.folder), None, message)

    def _begin(self, told: dict[str, str], resume: bool, otherwise: str) -> None:
        work = self.folder / WORK
        begun = self._read(WORK) if work.exists() else None
        if begun is None:
            self._write(WORK, told)
        elif not resume:
            try:
                self._clear()
            except OSError as error:
                raise unwritable(self.folder, error) from None
            self._write(WORK, told)
        else:
            check_same(self.folder, told, begun, otherwise)
            for name in sorted(each.name for each in self.folder.glob("[0-9]*.json")):
                self._values |= self._read(name)
                self._batches = int(name.partition(".")[0]) + 1

    def _write(self, name: str, values: Mapping[str, Any]) -> None:
        write_checked(self.folder / name, values)

    def _read(self, name: str) -> dict[str, Any]:
        return read_checked(self.folder / name, DAMAGED)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: object, *rest: object) -> None:
        try:
            self.close()
        except FileError:
            if kind is None:
                raise

    def __contains__(self, name: str) -> bool:
        return name in self._values

    def __getitem__(self, name: str) -> Any:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def file(self, name: str) -> Path:
        """Return the path of a file of the store."""
        return self.folder / name

    def checked(self, name: str, sum_: str) -> Path:
        """Return the path of a file of the store that still has the fingerprint which was kept of it."""
        path = self.file(name)
        if path.exists() and fingerprint_of_file(path) != sum_:
            raise FileError(
                str(path), None, "this part of the unfinished work is damaged; start again without resuming"
            )
        return path

    def keep(self, name: str, value: Any) -> None:
        """Keep a value."""
        self._values[name] = self._fresh[name] = value
        if time.monotonic() - self._written > OFTEN:
            self.flush()

    def once(self, name: str, compute: Callable[[], Any]) -> Any:
        """Return a value: as kept, or computed and kept now."""
        if name not in self._values:
            self.keep(name, compute())
        return self._values[name]

    def flush(self) -> None:
        """Bring all values to the disk."""
        if self._fresh:
            self._write(f"{self._batches:08d}.json", self._fresh)
            self._batches += 1
            self._fresh = {}
        self._written = time.monotonic()

    @contextmanager
    def result(self, path: Path) -> Iterator[BinaryIO]:
        """Open what the work makes, as :func:`.whole_file` does; until it is whole, it lies in the store."""
        self.flush()
        beside = path.resolve().parent == self.folder.resolve().parent
        with whole_file(path, folder=self.folder if beside else None) as file:
            yield file

    def close(self) -> None:
        """Bring all values to the disk and let others work on it; an empty store is removed."""
        try:
            self.flush()
        finally:
            if self._values:
                self._lock.release()
            else:
                self.remove()

    def remove(self) -> None:
        """Remove it: the work is done."""
        self._fresh, self._values = {}, {}
        with suppress(OSError):
            self._clear()
            self._lock.release(remove=True)
            self.folder.rmdir()
        self._lock.release()

    def _clear(self) -> None:
        """Remove all but the lock, the last things first: what a kill leaves is a store of fewer things."""
        names = sorted((each.name for each in self.folder.iterdir() if each.name not in (WORK, LOCK)), reverse=True)
        batches = [name for name in names if name[0].isdigit() and name.endswith(".json")]
        for name in [*batches, *(name for name in names if name not in batches), WORK]:
            (self.folder / name).unlink(missing_ok=True)
