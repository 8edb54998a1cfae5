"""Reading and writing Parquet files; the only module that needs pyarrow."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from importlib.util import find_spec
from io import BytesIO
from pathlib import Path
from typing import Any, BinaryIO

from clubface.errors import FileError
from clubface.results.notes import Note
from clubface.shots.tables.cells import PARTS_MISSING, Chunk
from clubface.shots.tables.file_kind import START, refuse_no_table
from clubface.support.files import open_input

ENDINGS = (".parquet", ".pq")


def pyarrow_for(path: Path | str) -> Any:
    """Return the module pyarrow, or raise an error that ``path`` needs it."""
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError:
        raise _missing(path) from None
    return pyarrow


def check_pyarrow(path: Path | str) -> None:
    """Raise an error that ``path`` needs pyarrow if it is not installed, without the cost of loading it."""
    if find_spec("pyarrow") is None:
        raise _missing(path)


def _missing(path: Path | str) -> FileError:
    return FileError(str(path), None, 'a Parquet file needs pyarrow: pip install "clubface[tables]"')


class ParquetReader:
    """A Parquet file, with the interface of :class:`clubface.shots.tables.row_source.CsvReader`."""

    counts = "row"
    header_line: int | None = None
    delimiter = ","
    decimal_comma = False
    blank = 0
    notes: tuple[Note, ...] = ()

    def __init__(self, path: Path) -> None:
        self.path = str(path)
        self._arrow, source = pyarrow_for(path), open_input(path)
        try:
            start = source.read(START)
            if not start.startswith(b"PAR1"):
                refuse_no_table(path, start)
                message = "this is not a Parquet file; the name of a text file must end in .csv or .tsv"
                raise FileError(self.path, None, message)
            source.seek(0)
            self._file = self._arrow.parquet.ParquetFile(source)
        except (OSError, ValueError, self._arrow.ArrowException) as error:
            reason = str(error).splitlines()[0] if str(error) else type(error).__name__
            raise FileError(self.path, None, f"cannot be read as Parquet: {reason}") from None
        self.headings: list[str] = list(self._file.schema_arrow.names)
        self._rows = self._file.metadata.num_rows
        self._read = 0

    def chunks(self, rows: int, skip: int) -> Iterator[Chunk]:
        """Yield chunks of ``rows`` rows, after skipping the first ``skip``."""
        try:
            for batch in self._file.iter_batches(rows):
                batch.validate(full=True)  # finds text that is not UTF-8, as from a damaged page
                first, self._read = self._read, self._read + batch.num_rows
                if self._read > skip:
                    from_ = max(0, skip - first)
                    rest = batch.slice(from_)
                    first += from_
                    yield Chunk(range(first + 1, first + 1 + rest.num_rows), rest.columns)
        except (OSError, self._arrow.ArrowException) as error:
            raise FileError(self.path, None, f"cannot be read after row {self._read}: {error}") from None

    def progress(self) -> float:
        """Return the share of the file that has been read, 0 to 1."""
        return self._read / self._rows if self._rows else 1.0

    @property
    def types(self) -> list[Any]:
        """The Arrow types of the columns."""
        return list(self._file.schema_arrow.types)

    def close(self) -> None:
        """Close the file."""
        self._file.close()


class ParquetForm:
    """Launches written to Parquet in pieces, one row group per chunk, as by ``CsvForm``."""

    def __init__(
        self, path: Path, headings: Sequence[str], types: Sequence[Any], results: Sequence[str], provenance: Any
    ) -> None:
        self._arrow = arrow = pyarrow_for(path)
        kinds = [arrow.string() if kind is None else kind for kind in types] + [arrow.float64()] * len(results)
        metadata = {"clubface": json.dumps(provenance, default=str)}
        self._schema = arrow.schema(list(zip([*headings, *results], kinds, strict=True)), metadata)
        self._width = len(headings)

    def piece(self, chunk: Chunk, rows: Sequence[int] | None, results: Sequence[Any]) -> bytes:
        """Return some rows of a chunk (None: all), each followed by its results."""
        cells = [chunk.arrow(place, rows) for place in range(self._width)]
        arrays = [*cells, *(self._arrow.array(each) for each in results)]
        file = BytesIO()
        self._arrow.parquet.write_table(self._arrow.Table.from_arrays(arrays, schema=self._schema), file)
        return file.getvalue()

    def whole(self, file: BinaryIO, pieces: Iterable[Path]) -> None:
        """Write the row groups of all pieces."""
        with self._arrow.parquet.ParquetWriter(file, self._schema) as writer:
            for path in pieces:
                try:
                    table = self._arrow.parquet.read_table(path, schema=self._schema)
                except (OSError, ValueError, self._arrow.ArrowException):
                    raise FileError(str(path), None, PARTS_MISSING) from None
                writer.write_table(table)
