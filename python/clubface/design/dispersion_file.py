"""Every shot of a dispersion as a row of a CSV or Parquet file, a chunk at a time."""

from __future__ import annotations

import csv
import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np

from clubface.support.arrays import Floats
from clubface.support.whole_file import whole_file
from clubface.tables.headings import heading_of, shot_words
from clubface.tables.parquet import pyarrow_for
from clubface.tables.writer import DIGITS, is_parquet
from clubface.units import SI_UNITS, from_si

Sink = Callable[[Mapping[str, Floats], Mapping[str, Floats]], None]
"""Takes the deliveries of a chunk and what came of them."""


@contextmanager
def shots_file(path: str | os.PathLike[str]) -> Iterator[Sink]:
    """Open a file for shots; it has its name once the block is left, whole or not at all.

    Columns carry their units. A shot without a result has empty cells (in Parquet nulls).
    """
    target = Path(path)
    with whole_file(target) as file:
        write = _parquet(file, target) if is_parquet(target) else _csv(file, target)
        yield lambda deliveries, values: write(_columns({**deliveries, **values}))
        write(None)


def _columns(values: Mapping[str, Floats]) -> dict[str, Floats]:
    dimensions = shot_words().dimensions
    found = {}
    for name, numbers in values.items():
        heading, unit = heading_of(name, SI_UNITS[dimensions[name]])
        found[heading] = from_si(np.asarray(numbers), unit)
    return found


def _csv(file: Any, target: Path) -> Callable[[Mapping[str, Floats] | None], None]:
    delimiter = "\t" if target.suffix.lower() == ".tsv" else ","
    begun = False

    def write(columns: Mapping[str, Floats] | None) -> None:
        nonlocal begun
        if columns is None:
            return
        text = StringIO()
        rows = csv.writer(text, delimiter=delimiter, lineterminator="\n")
        if not begun:
            rows.writerow(columns)
            begun = True
        cells = [
            ["" if each != each else f"{each:.{DIGITS}g}" for each in column.tolist()] for column in columns.values()
        ]
        rows.writerows(zip(*cells, strict=True))
        file.write(text.getvalue().encode())

    return write


def _parquet(file: Any, target: Path) -> Callable[[Mapping[str, Floats] | None], None]:
    arrow = pyarrow_for(target)
    writer: Any = None

    def write(columns: Mapping[str, Floats] | None) -> None:
        nonlocal writer
        if columns is None:
            if writer is not None:
                writer.close()
            return
        table = arrow.table({name: arrow.array(each, from_pandas=True) for name, each in columns.items()})
        if writer is None:
            writer = arrow.parquet.ParquetWriter(file, table.schema)
        writer.write_table(table)

    return write
