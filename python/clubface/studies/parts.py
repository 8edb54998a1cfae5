"""One part of a study: a Parquet file of the tasks of a chunk, whole or not there, that tells damage by a sum.

Any program reads such files. The metadata of the schema holds, under ``clubface``, where the numbers come from; and
under ``clubface-sum``, the SHA-256 of the file as it is with ``HOLE`` in place of that sum.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from clubface.errors import FileError
from clubface.support.whole_file import whole_file
from clubface.tables.parquet import pyarrow_for

TOLD, SUM = b"clubface", b"clubface-sum"
HOLE = b"the sum of the file as it is with this text in the place of it".ljust(64, b".")
DAMAGED = "this part is damaged"


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
    raise FileError(str(path), None, DAMAGED)


def _values(column: Any) -> NDArray[Any] | Names:
    if hasattr(column, "dictionary"):
        codes = column.indices.to_numpy(zero_copy_only=False).astype("int64")
        return Names(tuple(column.dictionary.to_pylist()), codes)
    return column.to_numpy(zero_copy_only=False)
