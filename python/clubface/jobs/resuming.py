"""Long work that goes on where it stopped: what is finished stays in a folder beside the result until that is whole."""

from __future__ import annotations

import hashlib
import os
import re
import shutil
import time
from collections.abc import Callable, Iterable, Mapping
from contextlib import AbstractContextManager, nullcontext, suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, Self

from clubface.errors import FileError
from clubface.jobs.lock import is_running, this_process
from clubface.jobs.store import RECORD, PartStore, read_checked, write_checked
from clubface.support.files import place_of, same_file, unwritable, whole_file
from clubface.support.fingerprint import check_same, fingerprint, fingerprints

if TYPE_CHECKING:
    from collections.abc import Iterator


FOREIGN = "this is no record of unfinished work; move it away, or give another name"
DAMAGED = "this record of unfinished work is damaged"
TRIES = 3
"""How often a part is written where other runs of the same work remove its folder."""
OFTEN = 0.5
"""What is finished is on the disk after this time at most [s]: small values are written together."""
NAME = re.compile("[0-9a-f]{16}")
"""Of the folder of one work."""


def unfinished(path: Path, inputs: Iterable[str | os.PathLike[str]] = ()) -> Path:
    """Return the folder that keeps what is finished of a file until it is complete; no input may lie in it."""
    folder = path.with_name(path.name + ".unfinished")
    for each in inputs:
        place = Path(place_of(each))
        if Path(place_of(folder)) in (place, *place.parents):
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


class Store:
    """What a long work has finished, by name: values of what JSON has, and larger parts of bytes.

    Each is on the disk whole or not at all, values within ``OFTEN`` and when the store is closed. What is there is
    taken, and what is damaged counts as not there. The work of each content has a folder of its own, so that nothing
    mixes. Nothing is locked: runs of the same work at the same time keep the same things in the same folder, and all
    of them end with the same result.

    Parameters
    ----------
    folder
        The folder of the stores of a result, which is made in one that exists.
    content
        What the work is of, by what a person calls it: source, options, accuracy. The version belongs to it always.
    of
        What the work makes.
    resume
        Whether to refuse to begin where other work was begun and has not ended. Otherwise that is removed, unless its
        process is still at work; a folder that is no store is left alone.
    otherwise
        What a message advises where the store belongs to other work.

    Attributes
    ----------
    folder
        The folder of the stores of the result.
    resumed
        The names of the values that were there.

    Raises
    ------
    FileError
        The folder has the store of other work, or is something else.
    """

    def __init__(
        self, folder: Path, content: Mapping[str, Any], *, of: Path | None = None, resume: bool = True,
        otherwise: str = "start again without resuming",
    ) -> None:  # fmt: skip
        self.folder, self._of = folder, of or folder
        self._told = fingerprints(content)
        self._store = PartStore(folder / fingerprint(self._told)[:16], {})
        self._values: dict[str, Any] = {}
        self._fresh: dict[str, Any] = {}
        self._written = time.monotonic()
        self._before, self._overtaken = _state(self._of), False
        if not folder.parent.is_dir():
            raise FileError(str(self._of), None, f"there is no folder {str(folder.parent)!r}")
        self._settle_with_others(resume, otherwise)
        try:
            self._write(lambda: None if _is_own(self._holder()) else self._begin())
        except BaseException:
            self._remove_if_empty()
            raise
        for path in sorted(self._store.parts.glob("*.json")):
            with suppress(FileError):
                self._values |= read_checked(path, DAMAGED)
        self.resumed = tuple(self._values)

    def _settle_with_others(self, resume: bool, otherwise: str) -> None:
        """Refuse or remove what other work has left, and refuse a folder of something else."""
        try:
            there = [each for each in self.folder.iterdir() if each.name[0] != "."]
        except FileNotFoundError:
            return
        except NotADirectoryError:
            raise FileError(str(self.folder), None, FOREIGN) from None
        except OSError as error:
            raise unwritable(self.folder, error) from None
        if not all(NAME.fullmatch(each.name) and not each.is_file() for each in there):
            raise FileError(str(self.folder), None, FOREIGN)
        others = [each for each in there if each != self._store.folder]
        if not (resume and self._store.folder in there):
            for each in others:
                self._settle_with(each, resume, otherwise)

    def _settle_with(self, other: Path, resume: bool, otherwise: str) -> None:
        record: dict[str, Any] = {"content": {}}
        with suppress(FileError):
            record = read_checked(other / RECORD, DAMAGED)
        if not _is_own(record) and is_running(record):
            message = f"process {record['process']} is writing this with other options; wait until it ends, or give"
            raise FileError(str(self._of), None, f"{message} another name")
        if resume:
            check_same(self.folder, self._told, record["content"], otherwise)
        PartStore(other, record).remove()

    def _begin(self) -> None:
        """Make the folder; its record is for people and other work, the name of the folder says what it is of."""
        self._store.prepare(self._store.parts / "any")
        with suppress(FileError):
            write_checked(self._store.folder / RECORD, {"content": self._told, **this_process()})

    def _holder(self) -> dict[str, Any]:
        """Return the record of the process that has begun the store, or gone on with it, last; {} where it is gone."""
        with suppress(FileError):
            return read_checked(self._store.folder / RECORD, DAMAGED)
        return {}

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
        """Return the path of a part that the caller keeps itself, such as the store of a work within this one."""
        return self._store.prepare(self._store.parts / name)

    def keep_part(self, name: str, content: bytes) -> str:
        """Keep bytes as a file; return their fingerprint, for :meth:`part`."""
        self._write(lambda: self._write_part(name, content))
        return hashlib.sha256(content).hexdigest()

    def part(self, name: str, sum_: str) -> Path | None:
        """Return the file of a part with such a fingerprint; None if it is gone or damaged."""
        path = self._store.parts / name
        with suppress(OSError), open(path, "rb") as file:
            return path if hashlib.file_digest(file, "sha256").hexdigest() == sum_ else None
        return None

    def _write_part(self, name: str, content: bytes) -> None:
        with whole_file(self.file(name)) as file:
            file.write(content)

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
            # Named by what is in it: another run of the same work may keep other values together.
            name = f"{fingerprint(sorted(self._fresh))[:32]}.json"
            self._write(lambda: write_checked(self.file(name), self._fresh))
            self._fresh = {}
        self._written = time.monotonic()

    def _write(self, write: Callable[[], object]) -> None:
        """Write a part. Where another run of the same work ends and removes the store meanwhile, it is begun again."""
        for tries_left in reversed(range(TRIES)):
            try:
                if not (self._store.folder / RECORD).exists():
                    self._begin()
                write()
                return
            except (FileError, OSError) as error:
                if not tries_left or self._store.parts.exists():
                    raise error if isinstance(error, FileError) else unwritable(self._of, error) from None

    def write_result(self, path: Path, write: Callable[[BinaryIO], object]) -> None:
        """Write what the work makes, as :func:`.whole_file` does; until it is whole, it lies in the store.

        If another run of the same work has ended meanwhile and removed the parts, its result is there, and stays.
        """
        self.flush()
        beside = same_file(path.parent, self.folder.parent)

        def whole() -> None:
            with whole_file(path, folder=self._store.folder if beside else None) as file:
                write(file)

        try:
            self._write(whole)
        except FileError:
            self._overtaken = _state(self._of) not in (None, self._before)
            if not self._overtaken:
                raise

    def close(self) -> None:
        """Bring all values to the disk, for another time; an empty store is removed."""
        try:
            self.flush()
        finally:
            self._remove_if_empty()

    def remove(self) -> None:
        """Remove it: the work is done. What a third run has begun after another one removed it is left alone."""
        self._fresh, self._values = {}, {}
        holder = self._holder()
        if not (self._overtaken and holder and not _is_own(holder)):
            self._clear()

    def _remove_if_empty(self) -> None:
        with suppress(OSError):
            if self._store.parts.exists():
                self._store.parts.rmdir()
            self._clear()

    def _clear(self) -> None:
        """Remove the store, and what a kill has left of one that was being removed."""
        self._store.remove()
        for each in self.folder.glob(".*"):
            shutil.rmtree(each, ignore_errors=True)
        with suppress(OSError):
            self.folder.rmdir()


def _is_own(record: Mapping[str, Any]) -> bool:
    """Tell whether this process has written a record."""
    return all(record.get(name) == value for name, value in this_process().items())


def _state(path: Path) -> tuple[int, int] | None:
    """Return what changes when a file is replaced; None where there is none."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_ino, found.st_mtime_ns
