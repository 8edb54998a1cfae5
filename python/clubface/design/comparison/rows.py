"""Deliveries to compare, one from each row of a file."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

from clubface.errors import FileError
from clubface.launch_monitor.summary_rows import summaries_in
from clubface.tables.headings import check_units, delivery_words, layout, plain_name
from clubface.tables.reader import open_table
from clubface.units import to_si

NAMES = ("name", "label", "delivery", "shot")
"""Headings of a column that names the rows."""


def read_deliveries(
    path: str | os.PathLike[str],
    most: int,
    note: Callable[[str], object] | None = None,
    *,
    units: Mapping[str, str] | None = None,
) -> dict[str, dict[str, float]]:
    """Read deliveries [SI] from a CSV or Parquet file of at most so many rows, by what its rows are called.

    A column ``name`` (or label, delivery, shot) names the rows; without one they are called after their lines. ``note``
    is called with what a reader of the result should know, such as a column whose name is nearly that of an input.
    ``units`` are those of columns that name none, by quantity or dimension.
    """
    given = check_units(units or {}, delivery_words().dimensions)
    reader = open_table(Path(path))
    try:
        columns = layout(reader.headings, reader.path, reader.header_line, given_units=given)
        naming = [place for place, each in enumerate(columns.headings) if plain_name(each) in NAMES]
        if note is not None:
            for text in (*reader.notes, *columns.notes):
                note(text)
        found: dict[str, dict[str, float]] = {}
        for chunk in reader.chunks(most + 1, 0):
            for reject in chunk.ragged:
                raise FileError(reader.path, reject.line, reject.reason)
            values = {column.quantity: (column, *chunk.numbers(column)) for column in columns.used}
            summaries = summaries_in(chunk, columns)
            for row, line in enumerate(chunk.lines):
                if row in summaries:
                    if note is not None:
                        note(f"{reader.counts} {line}: {summaries[row]}")
                    continue
                for _, _, missing in values.values():
                    if row in missing:
                        raise FileError(reader.path, line, missing[row])
                cells = chunk.texts([row])[0]
                name = next((cells[place].strip() for place in naming), "") or f"{reader.counts} {line}"
                if not name.isprintable():
                    raise FileError(reader.path, line, f"the name {name!r} is no printable text")
                if name in found:
                    raise FileError(reader.path, line, f"a row is called {name!r} already; give each another name")
                found[name] = {
                    key: float(to_si(numbers[row], column.unit)) for key, (column, numbers, _) in values.items()
                }
                if len(found) > most:
                    raise FileError(reader.path, line, f"there are more than {most} rows to compare; give fewer")
    finally:
        reader.close()
    if not found:
        raise FileError(reader.path, None, "there is no row with a delivery")
    return found
