"""The chunks of a study: computed or found, and the store of those that are finished.

One chunk of a study: found whole in the store, or computed and kept there. All workers do this, anywhere.

What a study has finished: a store with a part for each chunk that is done.

One part of a study: a Parquet file of the tasks of a chunk, whole or not there, that tells damage by a sum.

Any program reads such files. The metadata of the schema holds, under ``clubface``, where the numbers come from; and
under ``clubface-sum``, the SHA-256 of the file as it is with ``HOLE`` in place of that sum.
"""

from __future__ import annotations

import hashlib
import json
import os
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from clubface.errors import ClubfaceError, FileError
from clubface.jobs.store import PARTS, RECORD, PartStore, read_checked, write_checked
from clubface.shots.tables.parquet import pyarrow_for
from clubface.studies.kinds.kind import Task
from clubface.studies.study import StudyFile, read_study
from clubface.support.files import InputFile, InputRecord, absolute, given_files, prepared_folder, whole_file
from clubface.support.fingerprint import check_same, fingerprint, fingerprints, first_difference

ENDING = ".parquet"
INPUTS = "inputs"
A_FOLDER = 1000
"""Parts of a folder: file systems slow down with very many."""
DAMAGED_RECORD = (
    "this record of a study is damaged; remove it: clubface study run makes it anew, and keeps the parts that fit"
)
OTHERWISE = "give another folder with --store, or remove this one"


def store_of(path: Path) -> Path:
    """Return the folder of the store of a study's file, unless another is named."""
    return path.with_name(f"{path.stem}.store")


class StudyStore(PartStore):
    """The store of a study.

    Its ``record`` has besides ``content`` the ``name``, ``count`` and ``chunk`` (tasks in all and in a chunk),
    ``axes``, ``columns``, and ``provenance``, which every part repeats.
    """

    @property
    def count(self) -> int:
        """The tasks of the study."""
        return self.record["count"]

    @property
    def chunks(self) -> int:
        """The chunks of the study."""
        return -(-self.count // self.record["chunk"])

    @property
    def identity(self) -> str:
        """A text that is the same only for the same study in chunks of the same size."""
        return fingerprint([self.record["content"], self.record["chunk"]])[:16]

    def tasks(self, chunk: int) -> range:
        """Return the tasks of a chunk."""
        size = self.record["chunk"]
        return range(chunk * size, min((chunk + 1) * size, self.count))

    def path(self, chunk: int) -> Path:
        """Return the file of a chunk."""
        return self.parts / f"{chunk // A_FOLDER:04d}" / f"{chunk:08d}{ENDING}"

    @property
    def inputs(self) -> Path:
        """The folder of what the study has read, each file under its fingerprint: workers read nothing else."""
        return self.folder / INPUTS

    def keep_input(self, given: InputFile) -> None:
        """Keep a file that the study has read; one too large to be kept is read in its own place."""
        path = self.inputs / given.sha256
        if given.content is not None and not path.exists():
            with whole_file(self.prepare(path)) as file:
                file.write(given.content)

    def input(self, sum_: str) -> bytes | None:
        """Return what was read under a fingerprint, None where it is not kept."""
        with suppress(OSError):
            return (self.inputs / sum_).read_bytes()
        return None

    def files_read(self) -> Iterator[InputFile]:
        """Yield what the study has read, by the names that the files have from its folder; what is not kept is left."""
        for name, sum_ in self.record["provenance"]["files"].items():
            if (content := self.input(sum_)) is not None:
                yield InputFile(name, os.fspath(self.inputs / sum_), len(content), sum_, False, content)

    def present(self) -> bytearray:
        """Return for each chunk whether a part is there (1) or not (0); no part is read."""
        found = bytearray(self.chunks)
        for each in self.files():
            stem = each.name.partition(".")[0]
            if each.name.endswith(ENDING) and stem.isdecimal() and int(stem) < len(found) and each.is_file():
                found[int(stem)] = 1
        return found


def open_store(folder: Path) -> StudyStore:
    """Return the store in a folder."""
    record = read_checked(folder / RECORD, DAMAGED_RECORD) if (folder / RECORD).is_file() else {}
    if "chunk" not in record:  # no store, or that of another long work
        raise FileError(str(folder), None, "this folder holds no study")
    return StudyStore(folder, record)


def begin(folder: Path, study: StudyFile, describe: Callable[[], dict[str, Any]]) -> StudyStore:
    """Return the store of a study in a folder, which is made unless it is there.

    Parameters
    ----------
    folder
        The folder.
    study
        The study.
    describe
        Called for the rest of the record where there is none yet. The size of a chunk is among it: it is decided once,
        by whoever comes first, since workers on other machines must cut the study into the same chunks.

    Raises
    ------
    FileError
        The store belongs to another study, or the folder is something else.
    """
    content = fingerprints(study.content())
    if not (folder / RECORD).exists():
        if folder.exists() and (not folder.is_dir() or any(each.name not in (PARTS, INPUTS) for each in _seen(folder))):
            raise FileError(str(folder), None, "this is no store of a study; give another folder with --store")
        record = {"content": content, "name": study.name, "count": study.design.count, **describe()}
        prepared_folder(folder)
        try:
            write_checked(folder / RECORD, record, new=True)
        except FileError:
            if not (folder / RECORD).exists():
                raise
    found = open_store(folder)
    check_study(found, study)
    for each in _handed_over(study):
        found.keep_input(each)
    return found


def check_study(store: StudyStore, study: StudyFile) -> None:
    """Refuse a store of another study; of a file that has changed it is said where."""
    before = store.record["provenance"]["files"]
    now = {f"file {name}": sum_ for name, sum_ in study.files().items()}
    contents = {each.sha256: each.content for each in _handed_over(study)}

    def change(name: str) -> str:
        key = name.removeprefix("file ")
        if name not in now or key not in before:
            return "" if name not in {*now, *(f"file {each}" for each in before)} else " (named in one of them alone)"
        return first_difference(store.input(before[key]), contents.get(now[name]))

    check_same(store.folder, fingerprints(study.content()), store.record["content"], OTHERWISE, change)


def arguments_of(store: StudyStore, study: StudyFile) -> tuple[str, str, str, list[tuple[str, str, int]]]:
    """Return what a worker is told: study, store, its identity, and path, fingerprint and size of all inputs."""
    files = [(path, each.sha256, each.size) for path, each in study.inputs.by_path().items()]
    return absolute(study.path), absolute(store.folder), store.identity, files


def _handed_over(study: StudyFile) -> list[InputFile]:
    return [each for each in study.inputs.files if not each.shipped]


def _seen(folder: Path) -> list[Path]:
    return [each for each in folder.iterdir() if not each.name.startswith(".")]


TOLD, SUM = b"clubface", b"clubface-sum"
HOLE = b"the sum of the file as it is with this text in the place of it".ljust(64, b".")
DAMAGED_PART = "this part is damaged"


@dataclass(frozen=True)
class Names:
    """A column of names.

    Attributes
    ----------
    choices
        The names there are.
    codes
        The place of each among them, int64.
    """

    choices: tuple[str, ...]
    codes: NDArray[Any]

    def __len__(self) -> int:
        return len(self.codes)


Values = Mapping[str, "NDArray[Any] | Names"]
"""Columns by name: numbers, or names."""


class ColumnSum:
    """The SHA-256 of the values of a column, in order: 8 bytes a number, least significant first, or a line a name."""

    def __init__(self) -> None:
        self._sum = hashlib.sha256()

    def add(self, values: NDArray[Any] | Names) -> ColumnSum:
        """Go on with further values."""
        if isinstance(values, Names):
            self._sum.update("".join(f"{values.choices[code]}\n" for code in values.codes.tolist()).encode())
        else:
            self._sum.update(values.astype("<f8", copy=False).tobytes())
        return self

    def text(self) -> str:
        """Return the sum so far."""
        return self._sum.hexdigest()


def write_part(path: Path, columns: Values, units: Mapping[str, str], told: Mapping[str, Any]) -> None:
    """Write a part, synced, under its name once it is whole.

    Parameters
    ----------
    path
        The file.
    columns
        The columns.
    units
        The SI unit of each column of numbers.
    told
        What is told of the part besides, of what JSON has.
    """
    pyarrow = pyarrow_for(path)
    arrays, fields = [], []
    for name, each in columns.items():
        arrays.append(arrow_array(pyarrow, each))
        fields.append(pyarrow.field(name, arrays[-1].type, metadata={"unit": units[name]} if name in units else None))
    schema = pyarrow.schema(fields, {TOLD: json.dumps(told).encode(), SUM: HOLE})
    stream = pyarrow.BufferOutputStream()
    names = [name for name, each in columns.items() if isinstance(each, Names)]
    table = pyarrow.Table.from_arrays(arrays, schema=schema)
    pyarrow.parquet.write_table(table, stream, **encoding(columns, names))
    content = stream.getvalue().to_pybytes()
    place = content.rindex(HOLE)
    with whole_file(path) as file:
        file.write(content[:place])
        file.write(hashlib.sha256(content).hexdigest().encode())
        file.write(content[place + len(HOLE) :])


def arrow_array(pyarrow: Any, column: NDArray[Any] | Names) -> Any:
    """Return a column as Parquet files have it: numbers, or a dictionary of names."""
    if isinstance(column, Names):
        codes = pyarrow.array(column.codes.astype("int32"))
        return pyarrow.DictionaryArray.from_arrays(codes, pyarrow.array(column.choices))
    return pyarrow.array(column)


def encoding(columns: Iterable[str], names: Sequence[str]) -> dict[str, Any]:
    """Return how Parquet is written fast and small: few numbers are the same, but the first bytes of many are alike."""
    numbers = [name for name in columns if name not in names]
    return {
        "compression": "snappy",
        "write_statistics": False,
        "use_dictionary": list(names),
        "use_byte_stream_split": numbers,
    }


def read_part(path: Path) -> tuple[dict[str, NDArray[Any] | Names], dict[str, Any]]:
    """Return the columns of a part, and what is told of it.

    Raises
    ------
    FileError
        It is damaged; one that is not there is a ``FileNotFoundError``.
    """
    pyarrow = pyarrow_for(path)
    if path.exists() and not path.is_file():  # such as a pipe, at which reading would wait
        raise FileError(str(path), None, "this is not a file; remove it")
    # As a whole: the file may be replaced by another process while it is read.
    try:
        content = path.read_bytes()
        file = pyarrow.parquet.ParquetFile(pyarrow.BufferReader(content))
        told = file.metadata.metadata  # as it stands there; the Arrow schema beside it has a copy with the hole
        place = content.rindex(told[SUM])
        found = hashlib.sha256(content[:place])
        for each in (HOLE, content[place + len(HOLE) :]):
            found.update(each)
        if found.hexdigest().encode() == told[SUM]:
            table = file.read()
            columns = {name: _values(table.column(name).combine_chunks()) for name in table.column_names}
            return columns, json.loads(told[TOLD])
    except FileNotFoundError:
        raise
    except (OSError, ValueError, KeyError, TypeError, IndexError, AttributeError, pyarrow.ArrowException):
        pass
    raise FileError(str(path), None, DAMAGED_PART)


def _values(column: Any) -> NDArray[Any] | Names:
    if hasattr(column, "dictionary"):
        codes = column.indices.to_numpy(zero_copy_only=False).astype("int64")
        return Names(tuple(column.dictionary.to_pylist()), codes)
    return column.to_numpy(zero_copy_only=False)


COMPUTED, KEPT, MENDED = "computed", "kept", "mended"
"""What was done for a chunk: computed, found in the store, or computed in place of a damaged part."""
NOTES = ("failed", "outside")
"""What a part tells of its tasks: how many have no result, with the first of them, and shots outside of a range."""


class Chunks:
    """The chunks of a study and its store.

    Parameters
    ----------
    study
        The study.
    store
        Its store.
    """

    def __init__(self, study: StudyFile, store: StudyStore) -> None:
        self._study, self._store = study, store
        self._task: Task = study.task
        self._axes = {each.name: each for each in study.design.axes}
        self._units = {name: each.unit for name, each in self._axes.items() if each.unit is not None}
        self._units |= {name: each.unit for name, each in self._task.columns.items()}

    def ensure(self, chunk: int) -> dict[str, Any]:
        """See that the part of a chunk is there and whole; return what was ``did``, and ``NOTES``."""
        try:
            return self._kept(chunk)
        except FileNotFoundError:
            did = COMPUTED
        except FileError:
            did = MENDED
        tasks = self._store.tasks(chunk)
        try:
            found = self._task.run(tasks)
        except ClubfaceError as error:
            raise self._study.wrap(error) from None
        columns = {name: self._input(name, each) for name, each in self._study.design.values(tasks).items()}
        notes = {"failed": [len(found.failed), *found.failed[:1]], "outside": found.outside}
        told = {
            "study": self._store.identity,
            "first": tasks.start,
            "tasks": len(tasks),
            **notes,
            **self._store.record["provenance"],
            **self._task.depends_on,
        }
        path = self._store.prepare(self._store.path(chunk))
        try:
            write_part(path, {**columns, **found.columns}, self._units, told)
        except FileError:
            # Another run may have finished the study meanwhile, and tidied up what it took for remains.
            with suppress(FileNotFoundError, FileError):
                return self._kept(chunk)
            raise
        return {"did": did, **notes}

    def _kept(self, chunk: int) -> dict[str, Any]:
        _, told = checked_part(self._store, chunk)
        return {"did": KEPT, **{name: told[name] for name in NOTES}}

    def _input(self, name: str, values: NDArray[Any]) -> NDArray[Any] | Names:
        axis = self._axes[name]
        return Names(axis.choices, values) if axis.choices else values.astype("float64", copy=False)


def checked_part(store: StudyStore, chunk: int) -> tuple[dict[str, NDArray[Any] | Names], dict[str, Any]]:
    """Return the columns of the part of a chunk and what is told of it.

    Raises
    ------
    FileNotFoundError
        There is none.
    FileError
        It is damaged, or the part of another chunk or study.
    """
    path, tasks = store.path(chunk), store.tasks(chunk)
    columns, told = read_part(path)
    wanted = (store.identity, tasks.start, len(tasks))
    lengths = {len(each) for each in columns.values()}
    if (told.get("study"), told.get("first"), told.get("tasks")) != wanted or lengths != {len(tasks)}:
        raise FileError(str(path), None, "this part belongs to another study")
    return columns, told


_opened: dict[tuple[str, str, str], Chunks] = {}
_opening = threading.Lock()


def ensure(study: str, folder: str, identity: str, files: Sequence[tuple[str, str, int]], chunk: int) -> dict[str, Any]:
    """See that a chunk is done, for a worker that knows the study by its file and its store alone.

    Parameters
    ----------
    study, folder
        The file of the study and the folder of its store, as this machine sees them.
    identity
        Of the store.
    files
        Path, fingerprint and size of what the study has read; the store has the contents.
    chunk
        The number of the chunk.

    Returns
    -------
    dict
        What was ``did``, and ``NOTES``.

    Raises
    ------
    FileError
        The file or the store have become those of another study.
    """
    key = (study, folder, identity)
    with _opening:
        if key not in _opened:
            store = open_store(Path(folder))
            read = read_study(study, InputRecord(given_files(files, store.inputs)))
            check_study(store, read)
            if store.identity != identity:
                raise FileError(folder, None, "this store has become that of another study meanwhile")
            _opened.clear()
            _opened[key] = Chunks(read, store)
        opened = _opened[key]
    return opened.ensure(chunk)
