"""Tables that grow row by row during a computation, so that an interruption loses nothing."""

from __future__ import annotations

import csv
import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeVar

from clubface.errors import FileError
from clubface.fem.core import Progress
from clubface.fem.side_by_side import side_by_side
from clubface.support.resuming import complete_lines, cut_incomplete_line, fingerprint

P = TypeVar("P")


class ResumableTable:
    """Rows found by their first two columns, in a CSV file where one is given; its first line tells what they are of.

    Parameters
    ----------
    path
        The file; None keeps the rows for this run alone.
    content
        What the rows are of: numbers, texts, arrays, data classes, and lists and mappings of these. A table of anything
        else is refused.
    columns
        Names of the columns.
    kinds
        How to read columns that are no floats.
    """

    def __init__(
        self,
        path: str | os.PathLike[str] | None,
        content: Sequence[Any],
        columns: Sequence[str],
        kinds: Mapping[str, Callable[[str], Any]],
    ) -> None:
        self._path = None if path is None else Path(path)
        self._columns, self._kinds = tuple(columns), kinds
        self._rows: dict[tuple[float, ...], dict[str, Any]] = {}
        self._mark = "# case " + fingerprint(content)[:16]
        if self._path is None:
            return
        if self._path.exists():
            self._read(self._path)
        else:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            self._path.write_text(f"{self._mark}\n{','.join(self._columns)}\n", encoding="utf-8")

    def _read(self, path: Path) -> None:
        lines = complete_lines(path)
        if lines[:1] != [self._mark] or lines[1:2] != [",".join(self._columns)]:
            raise FileError(str(path), 1, "this is not the table of this case; give another file, or remove it")
        # Each line by itself: a quotation mark in a damaged one must not swallow the others.
        for number, line in enumerate(lines[2:], 3):
            try:
                (cells,) = csv.reader([line], strict=True)
                pairs = zip(self._columns, cells, strict=True)
                self._keep({name: self._kinds.get(name, float)(text) for name, text in pairs})
            except (ValueError, csv.Error):
                raise FileError(str(path), number, "this is not a row of the table; remove it") from None
        cut_incomplete_line(path)

    def fill(
        self,
        places: Mapping[P, tuple[float, float]],
        run: Callable[[P, Progress, int], dict[str, Any]],
        *,
        what: str,
        workers: int | None,
        progress: Callable[[int, int], object] | None,
    ) -> list[dict[str, Any]]:
        """Run what has no row yet, side by side, a row added as each ends; return the rows of all.

        Parameters
        ----------
        places
            What is run, and the values of the first two columns of its row.
        run
            As for :func:`clubface.fem.side_by_side.side_by_side`; returns a row.
        what
            What is run, in the plural, for people.
        workers
            Runs at a time; left out, as many as there are cores.
        progress
            Called with the rows there are and the rows in all.
        """
        rows = {point: self._rows.get(_key(place)) for point, place in places.items()}

        def ended(point: P, row: dict[str, Any]) -> None:
            rows[point] = row
            self._add(row)
            if progress is not None:
                progress(sum(row is not None for row in rows.values()), len(rows))

        try:
            side_by_side([point for point, row in rows.items() if row is None], run, ended, workers=workers)
        except KeyboardInterrupt:
            kept = "" if self._path is None else f"; they are in {self._path}, and the same command goes on after them"
            done = sum(row is not None for row in rows.values())
            raise KeyboardInterrupt(f"{done} of {len(rows)} {what} are done{kept}") from None
        return [row for row in rows.values() if row is not None]

    def _keep(self, row: dict[str, Any]) -> None:
        self._rows[_key([row[name] for name in self._columns[:2]])] = row

    def _add(self, row: dict[str, Any]) -> None:
        self._keep(row)
        if self._path is not None:
            with self._path.open("a", encoding="utf-8", newline="") as file:
                texts = [value if isinstance(value, str) else repr(value) for value in row.values()]
                csv.writer(file, lineterminator="\n").writerow(texts)


def _key(place: Sequence[float]) -> tuple[float, ...]:
    """Return values without the rounding of units on their way."""
    return tuple(round(value, 9) for value in place)
