"""The rows of a file as the tasks of a study: every one must hold numbers, or the study would not be what it says."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import FileError
from clubface.launch_monitor.summary_rows import summaries_in
from clubface.studies.axes import Swept, whole_flaw
from clubface.tables.headings import Vocabulary, check_units, delivery_words, layout, plain_name
from clubface.tables.reader import open_table

AT_A_TIME = 100_000
"""Rows."""


def table_columns(
    path: Path, known: Mapping[str, Swept], given_units: Mapping[str, str] | None = None
) -> dict[str, tuple[str, NDArray[Any]]]:
    """Return the columns of a CSV or Parquet file that give inputs: SI unit and values [SI] by name.

    ``given_units`` are the units of columns that name none, by input or dimension.

    Raises
    ------
    FileError
        No column gives an input that is ``known``, one is named like an input that holds names, there is no row, or a
        cell that is used holds no number.
    """
    reader = open_table(path)
    try:
        words = _words(known)
        units_of = check_units(given_units or {}, words.dimensions)
        found = layout(reader.headings, reader.path, reader.header_line, words, units_of, _as_key)
        used = found.used
        for heading in found.passed:
            if plain_name(heading) in known:  # of names, which rows of numbers do not hold
                name = plain_name(heading)
                message = f'this column is not read; sweep it beside the table, as in {name} = ["..."], or rename it'
                raise FileError(str(path), reader.header_line, message, heading)
        if not used:
            raise FileError(str(path), reader.header_line, "no column of this table is an input that can be swept")
        parts: dict[str, list[NDArray[Any]]] = {each.quantity: [] for each in used}
        for chunk in reader.chunks(AT_A_TIME, 0):
            if chunk.ragged:
                raise FileError(str(path), chunk.ragged[0].line, chunk.ragged[0].reason)
            for row, reason in summaries_in(chunk, found).items():
                raise FileError(str(path), chunk.lines[row], f"{reason}; remove it")
            for column in used:
                numbers, bad = chunk.numbers(column)
                if bad:
                    row = min(bad)
                    raise FileError(str(path), chunk.lines[row], bad[row], column.quantity)
                values = units.to_si(numbers, column.unit)
                flaws = (whole_flaw(each, known[column.quantity]) for each in values.tolist())
                if flaw := next(((row, each) for row, each in enumerate(flaws) if each), None):
                    message = f"{column.quantity} must be {flaw[1]}"
                    raise FileError(str(path), chunk.lines[flaw[0]], message, column.quantity)
                parts[column.quantity].append(values)
    finally:
        reader.close()
    if not any(map(len, parts.values())):
        raise FileError(str(path), reader.header_line, "there is no row below the names of the columns")
    return {
        name: (units.SI_UNITS[units.unit(known[name].unit or "1").dimension], np.concatenate(each))
        for name, each in parts.items()
    }


def _as_key(given: Mapping[str, str]) -> str:
    """Say how a study gives units."""
    pairs = ", ".join(f'{name} = "{symbol}"' for name, symbol in given.items())
    return f"units = {{ {pairs} }} under [study]"


def _words(known: Mapping[str, Swept]) -> Vocabulary:
    """Return the words for the inputs that hold numbers: their names, and those that launch monitors have for them."""
    numbers = {name: units.unit(each.unit).dimension for name, each in known.items() if each.unit is not None}
    others = {word: name for word, name in delivery_words().names.items() if name in numbers}
    grouped = {f"{known[name].group}_{name}": name for name in numbers}
    return Vocabulary({**others, **grouped, **{name: name for name in numbers}}, numbers)
