"""The finished chunks of a study: a folder with one Parquet file per chunk, readable by any program.

A part is written under another name and renamed when complete, so that any undamaged part is final, whoever computed
it. Nothing is locked, since two runs that compute the same chunk write the same bytes. The metadata of a part's schema
holds its provenance under ``clubface``, and under ``clubface-sum`` the SHA-256 of the file with ``HOLE`` in place of
that sum.
"""

from __future__ import annotations

import hashlib
import json
import os
import shutil
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from clubface.errors import FileError
from clubface.jobs.store import (
    check_same,
    fingerprint,
    fingerprints,
    first_difference,
    prepare_parent,
    read_record,
    write_record,
)
from clubface.shots.tables.parquet import pyarrow_for
from clubface.studies.kinds.kind import TASK
from clubface.studies.study import StudyFile, read_study
from clubface.support.files import InputFile, count_as_read, prepared_folder, whole_file

__all__ = ["Names", "ParquetFormat", "StudyStore", "Values", "begin", "open_folder", "open_store", "store_folder"]

RECORD, PARTS, INPUTS, HISTORIES, SUFFIX = "record.json", "parts", "inputs", "histories", ".parquet"
PARTS_PER_FOLDER = 1000
"""Maximum number of parts per folder, as file systems slow down with very many files."""
METADATA, CHECKSUM = b"clubface", b"clubface-sum"
HOLE = b"the sum of the file as it is with this text in the place of it".ljust(64, b".")
DAMAGED_RECORD = (
    "this study record is damaged; remove it: clubface study run makes a new one, and keeps the parts that fit"
)
FOREIGN = "this part belongs to another study"
REMEDY = "give another folder with --store, or remove this one"


@dataclass(frozen=True)
class Names:
    """A column of names."""

    choices: tuple[str, ...]  # distinct
    codes: NDArray[Any]  # index of each entry in the choices, int64

    def __len__(self) -> int:
        return len(self.codes)


Values = Mapping[str, "NDArray[Any] | Names"]
"""Columns by name: numbers, or names."""


@dataclass(frozen=True)
class StudyStore:
    """The store of a study.

    Its record has ``content`` (fingerprints of the study), ``name``, ``count`` and ``chunk`` (tasks in total and per
    chunk), ``axes``, ``columns``, ``histories`` if any, and ``provenance``, which every part repeats.
    """

    folder: Path
    record: Mapping[str, Any]

    @property
    def count(self) -> int:
        """Number of tasks in the study."""
        return self.record["count"]

    @property
    def chunks(self) -> int:
        """Number of chunks in the study."""
        return -(-self.count // self.record["chunk"])

    @property
    def identity(self) -> str:
        """Fingerprint of the study and its chunk size."""
        return fingerprint([self.record["content"], self.record["chunk"]])[:16]

    @property
    def inputs(self) -> Path:
        """Folder of the study's input files, named by checksum; workers read nothing else."""
        return self.folder / INPUTS

    @property
    def columns(self) -> dict[str, str | None]:
        """SI units of the columns, swept inputs first; None for names."""
        swept = {each["name"]: each["unit"] for each in self.record["axes"]}
        return {**swept, **{name: unit for name, (unit, _) in self.record["columns"].items()}}

    def tasks(self, chunk: int) -> range:
        """Return the tasks of a chunk."""
        size = self.record["chunk"]
        return range(chunk * size, min((chunk + 1) * size, self.count))

    @property
    def histories(self) -> dict[str, dict[str, str]]:
        """SI units of the columns of each history, including the task index."""
        kept = self.record.get("histories", {})
        return {name: {TASK: "1", **{each: of[0] for each, of in columns.items()}} for name, columns in kept.items()}

    def path(self, chunk: int, folder: str = PARTS) -> Path:
        """Return the file of a chunk, its part or a file in another folder."""
        return self.folder / folder / f"{chunk // PARTS_PER_FOLDER:04d}" / f"{chunk:08d}{SUFFIX}"

    def write(self, chunk: int, columns: Values, notes: Mapping[str, Any]) -> None:
        """Write the part of a chunk: its columns, and notes as JSON."""
        metadata = {**self._identity(chunk), **notes, **self.record["provenance"]}
        self._write(self.path(chunk), self.columns, columns, metadata)

    def write_history(self, name: str, chunk: int, columns: Values) -> None:
        """Write a history of a chunk."""
        path, metadata = self.path(chunk, f"{HISTORIES}/{name}"), {**self._identity(chunk), **self.record["provenance"]}
        self._write(path, self.histories[name], columns, metadata)

    def _identity(self, chunk: int) -> dict[str, Any]:
        tasks = self.tasks(chunk)
        return {"study": self.identity, "first": tasks.start, "tasks": len(tasks)}

    def _write(self, path: Path, units: Mapping[str, str | None], columns: Values, metadata: Mapping[str, Any]) -> None:
        form = ParquetFormat(units, {METADATA: json.dumps(metadata).encode(), CHECKSUM: HOLE})
        with whole_file(prepare_parent(path)) as file:
            file.write(form.bytes(columns))

    def read(self, chunk: int) -> tuple[dict[str, NDArray[Any] | Names], dict[str, Any]]:
        """Return the columns and the metadata of a chunk's part.

        Without a part this is a FileNotFoundError; a damaged part or one of another chunk or study is a FileError.
        """
        columns, metadata = self._read(chunk, PARTS)
        if {len(each) for each in columns.values()} != {len(self.tasks(chunk))}:
            raise FileError(str(self.path(chunk)), None, FOREIGN)
        return columns, metadata

    def read_history(self, name: str, chunk: int) -> dict[str, NDArray[Any]]:
        """Return the columns of a chunk's history; errors as for :meth:`read`."""
        columns, _ = self._read(chunk, f"{HISTORIES}/{name}")
        return {each: column for each, column in columns.items() if not isinstance(column, Names)}

    def _read(self, chunk: int, folder: str) -> tuple[dict[str, NDArray[Any] | Names], dict[str, Any]]:
        path, expected = self.path(chunk, folder), self._identity(chunk)
        columns, metadata = _read_parquet(path)
        if {key: metadata.get(key) for key in expected} != expected:
            raise FileError(str(path), None, FOREIGN)
        return columns, metadata

    def parts(self) -> Iterator[tuple[Values, dict[str, Any]]]:
        """Yield columns and metadata of every part, in the order of tasks; all parts must exist."""
        if missing := self.present().count(0):
            message = f"{missing} of {self.chunks} chunks are not done yet; clubface study run computes them"
            raise FileError(str(self.folder), None, message)
        for chunk in range(self.chunks):
            try:
                yield self.read(chunk)
            except FileNotFoundError:
                raise FileError(str(self.path(chunk)), None, "this part has been removed meanwhile") from None
            except FileError as error:
                raise FileError(error.path, None, f"{error.message}; clubface study run computes it again") from None

    def present(self) -> bytearray:
        """Return for each chunk whether its part exists (1) or not (0), without reading it."""
        present = bytearray(self.chunks)
        for each in self._files():
            stem = each.name.partition(".")[0]
            if each.name.endswith(SUFFIX) and stem.isdecimal() and int(stem) < len(present) and each.is_file():
                present[int(stem)] = 1
        return present

    def size(self) -> int:
        """Return the total size of parts and histories [bytes]."""
        total = 0
        for each in self._every_file():
            with suppress(OSError):
                total += each.stat().st_size
        return total

    def _files(self) -> Iterator[os.DirEntry[str]]:
        yield from _files_in(self.folder / PARTS)

    def _every_file(self) -> Iterator[os.DirEntry[str]]:
        yield from self._files()
        for name in self.histories:
            yield from _files_in(self.folder / HISTORIES / name)

    def tidy(self) -> None:
        """Remove leftovers of killed runs; call this when all parts exist."""
        for each in self._every_file():
            if each.name.startswith("."):
                with suppress(OSError):
                    os.unlink(each.path)

    def remove(self) -> None:
        """Remove the store in one step, as other runs may be about to start in the same place."""
        removed = self.folder.with_name(f".{self.folder.name}-{os.urandom(6).hex()}")
        with suppress(OSError):
            self.folder.rename(removed)
        shutil.rmtree(removed, ignore_errors=True)

    def keep_input(self, given: InputFile) -> None:
        """Store a copy of an input file; a file too large for that is read in place."""
        path = self.inputs / given.sha256
        if given.content is not None and not path.exists():
            with whole_file(prepare_parent(path)) as file:
                file.write(given.content)

    def input(self, checksum: str) -> bytes | None:
        """Return the content of a stored input file by checksum, or None."""
        with suppress(OSError):
            return (self.inputs / checksum).read_bytes()
        return None

    def check(self, study: StudyFile) -> None:
        """Raise an error if the store belongs to another study, with the place of a change in a file."""
        before = self.record["provenance"]["files"]
        now = {f"file {name}": checksum for name, checksum in study.files().items()}
        contents = {each.sha256: each.content for each in study.inputs.files if not each.shipped}

        def change(name: str) -> str:
            key = name.removeprefix("file ")
            if name not in now or key not in before:
                named = name in {*now, *(f"file {each}" for each in before)}
                return " (named in one of them alone)" if named else ""
            return first_difference(self.input(before[key]), contents.get(now[name]))

        check_same(self.folder, fingerprints(study.content()), self.record["content"], REMEDY, change)


def _files_in(parent: Path) -> Iterator[os.DirEntry[str]]:
    """Yield the files in all subfolders of a folder."""
    with suppress(FileNotFoundError):
        for folder in sorted(os.scandir(parent), key=lambda each: each.name):
            if folder.is_dir(follow_symlinks=False):
                yield from os.scandir(folder)


def store_folder(path: Path) -> Path:
    """Return the default folder of the store for a study file."""
    return path.with_name(f"{path.stem}.store")


def open_store(study: str | os.PathLike[str], store: str | os.PathLike[str] | None = None) -> StudyStore:
    """Return the store of a study, given by the study file or the store's own folder."""
    path = Path(study)
    if path.is_dir():
        opened = open_folder(path)
        files = opened.record["provenance"]["files"].items()
        kept = [(name, checksum, opened.input(checksum)) for name, checksum in files]
        count_as_read(
            InputFile(name, os.fspath(opened.inputs / checksum), len(content), checksum, False, content)
            for name, checksum, content in kept
            if content is not None
        )
        return opened
    described = read_study(path)
    folder = Path(store) if store is not None else store_folder(path)
    if not folder.exists():
        message = f"no part of this study is finished yet; clubface study run {path} starts it"
        raise FileError(str(folder), None, message)
    opened = open_folder(folder)
    opened.check(described)
    return opened


def open_folder(folder: Path) -> StudyStore:
    """Return the store in a folder."""
    record = read_record(folder / RECORD, DAMAGED_RECORD) if (folder / RECORD).is_file() else {}
    if "chunk" not in record:  # no record, or the store of another computation
        raise FileError(str(folder), None, "this folder holds no study")
    return StudyStore(folder, record)


def begin(folder: Path, study: StudyFile, describe: Callable[[], dict[str, Any]]) -> StudyStore:
    """Return the store of a study in a folder, creating it if necessary.

    ``describe`` returns the rest of the record if there is none yet. The chunk size is part of it: the first run
    decides, since workers on other machines must use the same chunks.
    """
    if not (folder / RECORD).exists():
        seen = [each.name for each in folder.iterdir() if each.name[0] != "."] if folder.is_dir() else []
        if folder.exists() and (not folder.is_dir() or not {*seen} <= {PARTS, INPUTS, HISTORIES}):
            raise FileError(str(folder), None, "this is not the store of a study; give another folder with --store")
        content = fingerprints(study.content())
        record = {"content": content, "name": study.name, "count": study.design.count, **describe()}
        prepared_folder(folder)
        try:
            write_record(folder / RECORD, record, new=True)
        except FileError:
            if not (folder / RECORD).exists():
                raise
    opened = open_folder(folder)
    opened.check(study)
    for each in study.inputs.files:
        if not each.shipped:
            opened.keep_input(each)
    return opened


class ParquetFormat:
    """Parquet format of columns: numbers as float64 with units, names as a dictionary."""

    def __init__(self, units: Mapping[str, str | None], metadata: Mapping[bytes, bytes]) -> None:
        self._arrow = arrow = pyarrow_for("")
        text = arrow.dictionary(arrow.int32(), arrow.string())
        fields = [
            arrow.field(name, arrow.float64() if unit else text, metadata={"unit": unit} if unit else None)
            for name, unit in units.items()
        ]
        self.schema = arrow.schema(fields, metadata)
        # For fast writing and small files: few numbers are equal, but many share their first bytes.
        self.options = {
            "compression": "snappy",
            "write_statistics": False,
            "use_dictionary": [name for name, unit in units.items() if unit is None],
            "use_byte_stream_split": [name for name, unit in units.items() if unit is not None],
        }

    def table(self, columns: Values) -> Any:
        """Return columns as an Arrow table."""
        arrays = [self._array(columns[name]) for name in self.schema.names]
        return self._arrow.Table.from_arrays(arrays, schema=self.schema)

    def _array(self, column: NDArray[Any] | Names) -> Any:
        if isinstance(column, Names):
            codes = self._arrow.array(column.codes.astype("int32"))
            return self._arrow.DictionaryArray.from_arrays(codes, self._arrow.array(column.choices))
        return self._arrow.array(column)

    def bytes(self, columns: Values) -> bytes:
        """Return columns as the bytes of a file, with its checksum in place of ``HOLE``."""
        stream = self._arrow.BufferOutputStream()
        self._arrow.parquet.write_table(self.table(columns), stream, **self.options)
        content = stream.getvalue().to_pybytes()
        place, checksum = content.rindex(HOLE), hashlib.sha256(content).hexdigest().encode()
        return content[:place] + checksum + content[place + len(HOLE) :]


def _read_parquet(path: Path) -> tuple[dict[str, NDArray[Any] | Names], dict[str, Any]]:
    """Return columns and metadata of a part; raise a :class:`FileError` if it is damaged."""
    pyarrow = pyarrow_for(path)
    if path.exists() and not path.is_file():  # such as a pipe, where reading would block
        raise FileError(str(path), None, "this is not a file; remove it")
    try:
        content = path.read_bytes()  # in one go, as another process may replace the file meanwhile
        file = pyarrow.parquet.ParquetFile(pyarrow.BufferReader(content))
        metadata = file.metadata.metadata  # the Arrow schema within it has a copy with the hole
        place = content.rindex(metadata[CHECKSUM])
        whole = content[:place] + HOLE + content[place + len(HOLE) :]
        if hashlib.sha256(whole).hexdigest().encode() == metadata[CHECKSUM]:
            table = file.read()
            columns = {name: _values(table.column(name).combine_chunks()) for name in table.column_names}
            return columns, json.loads(metadata[METADATA])
    except FileNotFoundError:
        raise
    except (OSError, ValueError, KeyError, TypeError, IndexError, AttributeError, pyarrow.ArrowException):
        pass
    raise FileError(str(path), None, "this part is damaged")


def _values(column: Any) -> NDArray[Any] | Names:
    if hasattr(column, "dictionary"):
        codes = column.indices.to_numpy(zero_copy_only=False).astype("int64")
        return Names(tuple(column.dictionary.to_pylist()), codes)
    return column.to_numpy(zero_copy_only=False)
