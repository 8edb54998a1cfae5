"""Every shot of a dispersion as a row of a CSV or Parquet file, a chunk at a time."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from clubface.support.arrays import Floats
from clubface.support.whole_file import whole_file
from clubface.tables.headings import heading_of, shot_words
from clubface.tables.parquet import pyarrow_for
from clubface.tables.writer import csv_lines, delimiter_of, is_parquet, number_cells
from clubface.units import SI_UNITS, from_si

Sink = Callable[[Mapping[str, Floats], Mapping[str, Floats]], None]
"""Takes the deliveries of a chunk and what came of them."""
Write = Callable[[dict[str, Floats]], None]
"""Takes the columns of a chunk by heading."""


@contextmanager
def shots_file(path: str | os.PathLike[str], *, seed: int = 0) -> Iterator[Sink]:
    """Open a file for shots; it has its name once the block is left, whole or not at all.

    Columns carry their units. A shot without a result has empty cells (in Parquet nulls). Shots come in quasi-random
    order, in which those that follow each other are more different than by chance. Rows are therefore shuffled within
    each chunk, as ``seed`` has it: what is taken from their order, such as a drift, is then that of a session.
    """
    target = Path(path)
    opened = _parquet if is_parquet(target) else _csv
    random = np.random.default_rng(seed)
    with whole_file(target) as file, opened(file, target) as write:

        def take(deliveries: Mapping[str, Floats], values: Mapping[str, Floats]) -> None:
            columns = _columns({**deliveries, **values})
            order = random.permutation(len(next(iter(columns.values()))))
            write({name: each[order] for name, each in columns.items()})

        yield take


def _columns(values: Mapping[str, Floats]) -> dict[str, Floats]:
    dimensions = shot_words().dimensions
    found = {}
    for name, numbers in values.items():
        heading, unit = heading_of(name, SI_UNITS[dimensions[name]])
        found[heading] = from_si(np.asarray(numbers), unit)
    return found


@contextmanager
def _csv(file: BinaryIO, target: Path) -> Iterator[Write]:
    delimiter, begun = delimiter_of(target), False

    def write(columns: dict[str, Floats]) -> None:
        nonlocal begun
        if not begun:
            file.write(csv_lines([list(columns)], delimiter))
            begun = True
        file.write(csv_lines(zip(*map(number_cells, columns.values()), strict=True), delimiter))

    yield write


@contextmanager
def _parquet(file: BinaryIO, target: Path) -> Iterator[Write]:
    arrow = pyarrow_for(target)
    writer: Any = None

    def write(columns: dict[str, Floats]) -> None:
        nonlocal writer
        table = arrow.table({name: arrow.array(each, from_pandas=True) for name, each in columns.items()})
        if writer is None:
            writer = arrow.parquet.ParquetWriter(file, table.schema)
        writer.write_table(table)

    yield write
    if writer is not None:
        writer.close()
