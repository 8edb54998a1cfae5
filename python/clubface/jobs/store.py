"""Keeps the finished parts of a long computation in a folder until its result is written, so that it can be resumed.

The folder contains ``job.json``, which identifies the computation; ``values.jsonl``, one line per finished value, with
a checksum; ``parts``, for parts that are files; and ``lock``, held by the process at work. A damaged value counts as
not finished. Fingerprints of the inputs decide whether parts belong to a computation.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import fields, is_dataclass
from enum import Enum
from itertools import zip_longest
from pathlib import Path, PurePath
from typing import Any, BinaryIO, Self

from clubface.errors import FileError, shortened
from clubface.jobs.lock import Lock
from clubface.schema import Document
from clubface.support.files import place_of, prepared_folder, same_file, synced, unwritable, whole_file, write_text
from clubface.support.version import __version__

__all__ = ["Finished", "Store", "prepare_parent", "read_record", "store_for", "unfinished_folder", "write_record"]

RECORD, VALUES, PARTS, LOCK = "job.json", "values.jsonl", "parts", "lock"
FOREIGN = "this is not a record of unfinished work; move it away, or give another name"
DAMAGED = "this record of unfinished work is damaged"
START_AGAIN = "start again without resuming"
FLUSH_INTERVAL = 0.5
"""Maximum delay until a finished value is on disk [s]; small values are written together."""


def fingerprint(content: Any) -> str:
    """Return a fingerprint of content made of JSON types, arrays, dataclasses and the like."""
    return hashlib.sha256(json.dumps(_as_json(content), sort_keys=True).encode()).hexdigest()


def _as_json(value: Any) -> Any:
    """Return content as JSON types; arrays are included in full, not abbreviated as in their text."""
    if value is None or isinstance(value, (str, int, float)):
        return value
    if isinstance(value, Mapping):
        plain = {key: _as_json(each) for key, each in value.items()}
        return plain if all(isinstance(key, str) for key in plain) else sorted((repr(key), plain[key]) for key in plain)
    if isinstance(value, (set, frozenset)):
        value = sorted(value)
    if isinstance(value, (list, tuple)):
        return [_as_json(each) for each in value]
    if is_dataclass(value):
        return [type(value).__name__, *([each.name, _as_json(getattr(value, each.name))] for each in fields(value))]
    if isinstance(value, Document):
        return _as_json(value.data)
    if isinstance(value, (PurePath, Enum)):
        return str(value)
    import numpy as np

    if isinstance(value, np.ndarray) and value.dtype != object:
        return [str(value.dtype), value.shape, hashlib.sha256(np.ascontiguousarray(value).tobytes()).hexdigest()]
    if isinstance(value, (np.ndarray, np.generic)):
        return _as_json(value.tolist())
    raise TypeError(f"a {type(value).__name__} has no fingerprint")


def fingerprints(content: Mapping[str, Any]) -> dict[str, str]:
    """Return the fingerprints of the inputs of a computation and of the version, by the names used in messages."""
    return {name: fingerprint(each) for name, each in {**content, "version": __version__}.items()}


def check_same(
    folder: Path,
    now: Mapping[str, str],
    begun: Mapping[str, str],
    otherwise: str,
    change: Callable[[str], str] = lambda _: "",
) -> None:
    """Raise FileError if the work in ``folder`` was started with other content; both from :func:`fingerprints`.

    ``change`` returns the difference in an input, by its name.
    """
    if other := [f"{name}{change(name)}" for name in {**now, **begun} if now.get(name) != begun.get(name)]:
        what = f"with another {', another '.join(other)}" if begun else "as other work, whose record is damaged"
        raise FileError(str(folder), None, f"this was begun {what}; {otherwise}")


def first_difference(before: bytes | None, now: bytes | None) -> str:
    """Return, in brackets, the first line of a text that has changed; empty if unknown."""
    try:
        both = [[] if each is None else each.decode().splitlines() for each in (before, now)]
    except UnicodeDecodeError:
        return ""
    for number, (one, other) in enumerate(zip_longest(*both, fillvalue=""), 1):
        if one != other and before is not None and now is not None:
            shown = [shortened(each.strip(), 60) or "empty" for each in (one, other)]
            return f" (line {number} was {shown[0]} and is {shown[1]})"
    return ""


def unfinished_folder(path: Path, inputs: Iterable[str | os.PathLike[str]] = ()) -> Path:
    """Return the folder for the finished parts of an output file; no input may be inside it."""
    folder = path.with_name(path.name + ".unfinished")
    for each in inputs:
        place = Path(place_of(each))
        if Path(place_of(folder)) in (place, *place.parents):
            message = f"the finished parts of {path} go to {folder}; give another name for one of the files"
            raise FileError(os.fspath(each), None, message)
    return folder


def store_for(output: str | os.PathLike[str] | None, content: Mapping[str, Any], **options: Any) -> Finished:
    """Return the store for the finished parts of an output file, or without a file, one for this run only.

    Options are those of :class:`Store`.
    """
    if output is None:
        return Finished()
    return Store(unfinished_folder(Path(output)), content, output=Path(output), **options)


class Finished:
    """The finished values of one computation, by name, kept for this run only.

    Attributes
    ----------
    resumed
        Names of the values finished by an earlier run.
    """

    resumed: tuple[str, ...] = ()

    def __init__(self) -> None:
        self._values: dict[str, Any] = {}

    @property
    def folder(self) -> Path | None:
        """The folder of the store, if there is one."""
        return None

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

    def keep(self, name: str, value: Any) -> None:
        """Keep a value that JSON can hold; its numbers keep all their digits."""
        self._values[name] = value

    def once(self, name: str, compute: Callable[[], Any]) -> Any:
        """Return the kept value, or compute and keep it."""
        if name not in self._values:
            self.keep(name, compute())
        return self._values[name]

    def write_result(self, path: Path, write: Callable[[BinaryIO], object]) -> None:
        """Write the result of the computation, completely or not at all."""
        with whole_file(path) as file:
            write(file)

    def remove(self) -> None:
        """Remove the values when the computation is finished."""
        self._values = {}

    def close(self) -> None:
        """Keep the values for another run, if there is a folder."""


class Store(Finished):
    """The finished values of one computation, by name, and its part files, in a folder.

    Parameters
    ----------
    folder
        The folder; its parent must exist.
    content
        Inputs of the computation by the names used in messages: source, options, accuracy. The version is always added.
    output
        Output of the computation, for messages.
    resume
        True raises FileError if the folder holds parts of another, interrupted computation; False removes them.
    remedy
        Advice in that message.

    Raises
    ------
    FileError
        The folder belongs to another computation, contains something else, or is used by another process.
    """

    def __init__(
        self,
        folder: Path,
        content: Mapping[str, Any],
        *,
        output: Path | None = None,
        resume: bool = True,
        remedy: str = START_AGAIN,
    ) -> None:
        super().__init__()
        self._folder = folder
        self._output = output or folder
        self._content = fingerprints(content)
        self._identity = fingerprint(self._content)
        self._fresh: dict[str, Any] = {}
        self._written = time.monotonic()
        self._finished = False
        if not folder.parent.is_dir():
            raise FileError(str(self._output), None, f"there is no folder {str(folder.parent)!r}")
        _check_folder(folder)
        self._lock = Lock(folder / LOCK, self._output)
        try:
            self._values = self._read_values()
            self._claim_folder(resume, remedy)
        except BaseException:
            self._remove_if_empty()
            self._lock.release()
            raise
        self.resumed = tuple(self._values)

    @property
    def folder(self) -> Path:
        """The folder."""
        return self._folder

    def _claim_folder(self, resume: bool, remedy: str) -> None:
        """Claim the folder for this computation; parts of another one raise FileError or are removed."""
        record, begun = self._folder / RECORD, dict[str, str]()
        with suppress(FileError):
            begun = read_record(record, DAMAGED)
        if begun == self._content:
            return
        if (record.exists() or (self._folder / VALUES).exists()) and not self._values:
            if resume:
                check_same(self._folder, self._content, begun, remedy)
            (self._folder / VALUES).unlink(missing_ok=True)
            shutil.rmtree(self._folder / PARTS, ignore_errors=True)
        write_record(record, self._content)

    def _read_values(self) -> dict[str, Any]:
        """Return the values whose lines are complete and belong to this computation."""
        try:
            lines = (self._folder / VALUES).read_bytes().split(b"\n")
        except OSError:
            return {}
        values = {}
        for line in lines:
            with suppress(ValueError, RecursionError):
                if line[:64].decode() == self._checksum(line[65:]):
                    name, value = json.loads(line[65:])
                    values[name] = value
        return values

    def _checksum(self, text: bytes) -> str:
        return hashlib.sha256(self._identity.encode() + text).hexdigest()

    def keep(self, name: str, value: Any) -> None:
        """Keep a value that JSON can hold; its numbers keep all their digits."""
        self._values[name] = self._fresh[name] = value
        if time.monotonic() - self._written > FLUSH_INTERVAL:
            self.flush()

    def flush(self) -> None:
        """Write all values to disk."""
        if self._fresh:
            texts = [json.dumps(each).encode() for each in self._fresh.items()]
            lines = [b"%b %b\n" % (self._checksum(each).encode(), each) for each in texts]
            try:
                with open(self._folder / VALUES, "ab") as file:
                    # End a line left incomplete by a full disk or a power cut.
                    file.write(b"\n" + b"".join(lines))
                    file.flush()
                    os.fsync(file.fileno())
            except OSError as error:
                raise unwritable(self._output, error) from None
            self._fresh = {}
        self._written = time.monotonic()

    def file(self, name: str) -> Path:
        """Return the path for a part that the caller writes, such as the store of a nested computation."""
        return prepare_parent(self._folder / PARTS / name)

    def keep_part(self, name: str, content: bytes) -> str:
        """Keep bytes as a file; return their checksum, for :meth:`part`."""
        with whole_file(self.file(name)) as file:
            file.write(content)
        return hashlib.sha256(content).hexdigest()

    def part(self, name: str, checksum: str) -> Path | None:
        """Return the file of a part with this checksum, or None if it is missing or damaged."""
        path = self._folder / PARTS / name
        with suppress(OSError), open(path, "rb") as file:
            return path if hashlib.file_digest(file, "sha256").hexdigest() == checksum else None
        return None

    def write_result(self, path: Path, write: Callable[[BinaryIO], object]) -> None:
        """Write the result as :func:`.whole_file` does, with the temporary file in the folder of the store."""
        self.flush()
        sibling = same_file(path.parent, self._folder.parent)
        with whole_file(path, folder=self._folder if sibling else None) as file:
            write(file)

    def remove(self) -> None:
        """Remove the folder when the computation is finished."""
        self._fresh, self._values, self._finished = {}, {}, True
        with suppress(OSError):
            for each in self._folder.iterdir():
                if each.is_dir():
                    shutil.rmtree(each, ignore_errors=True)
                elif each.name != LOCK:
                    each.unlink()
        self._lock.close()
        with suppress(OSError):  # another process may have started to use it
            self._folder.rmdir()

    def close(self) -> None:
        """Write all values to disk for another run; remove an empty folder."""
        try:
            self.flush()
        finally:
            self._remove_if_empty()
            self._lock.release()

    def _remove_if_empty(self) -> None:
        parts = self._folder / PARTS
        with suppress(OSError):
            parts.rmdir()
        if not self._finished and not parts.exists() and not (self._folder / VALUES).exists():
            self.remove()


def _check_folder(folder: Path) -> None:
    """Raise FileError for a folder that contains anything but unfinished work."""
    try:
        names = [each.name for each in folder.iterdir() if each.name[0] != "."]
    except FileNotFoundError:
        return
    except OSError as error:
        if folder.is_file():
            raise FileError(str(folder), None, FOREIGN) from None
        raise unwritable(folder, error) from None
    if not set(names) <= {RECORD, VALUES, PARTS, LOCK}:
        raise FileError(str(folder), None, FOREIGN)


def prepare_parent(path: Path) -> Path:
    """Return an output path after creating its folder."""
    if not path.parent.is_dir():
        prepared_folder(path.parent)
        synced(path.parent.parent)
    return path


MAX_RECORD_BYTES = 64_000_000


def write_record(path: Path, values: Mapping[str, Any], *, new: bool = False) -> None:
    """Write a small JSON file with a checksum; with ``new``, an existing file is an error."""
    text = json.dumps(values)
    checksum = hashlib.sha256(text.encode()).hexdigest()
    write_text(path, f'{{"sum": "{checksum}", "values": {text}}}', new=new)


def read_record(path: Path, damaged: str) -> dict[str, Any]:
    """Read a file of :func:`write_record`; raise :class:`FileError` with the message ``damaged`` for any other."""
    try:
        record = json.loads(path.read_bytes()) if path.stat().st_size <= MAX_RECORD_BYTES else {}
        if record["sum"] == hashlib.sha256(json.dumps(record["values"]).encode()).hexdigest():
            return record["values"]
    except (OSError, ValueError, KeyError, TypeError, RecursionError, OverflowError):
        pass
    raise FileError(str(path), None, damaged)
