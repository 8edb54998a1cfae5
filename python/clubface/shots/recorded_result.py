"""Recorded shots as a result: range and mean of each quantity, clubs, and rejected rows."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from clubface.quantities import quantity
from clubface.results.result import Provenance, Result
from clubface.results.table import Column, Table, column, table, text
from clubface.shots.loft_origin import loft_origins, origin_notes
from clubface.shots.recorded import RecordedShots, RejectedRow

SHOWN = 10
"""Maximum number of rejected rows printed; files have all."""


def shots_result(shots: RecordedShots) -> Result:
    """Return the quantities, clubs, loft origins and rejected rows of recorded shots as a result."""
    names = [] if shots.clubs is None else shots.clubs.tolist()
    clubs = {name: names.count(name) for name in dict.fromkeys(names)}
    listed = ", ".join(f"{count} {name or 'without a name'}" for name, count in clubs.items())
    origins = loft_origins(shots)
    return Result(
        "recorded-shots",
        f"{shots.source} ({shots.format}): {listed or f'{len(shots)} shots'}",
        tables=(
            _quantities_table(shots),
            session_table(shots),
            table("clubs", text("club", list(clubs)), text("shots", list(clubs.values())), printed=False),
            table("loft_origins", *(text(name, [getattr(each, name) for each in origins])
                  for name in ("club", "file", "shots", "origin", "with_face")),
                  *(column(name, [getattr(each, name) for each in origins], unit) for name, unit in
                    (("ratio", "1"), ("ratio_scatter", "1"), ("scatter", "rad"), ("rounding", "rad"))), printed=False),
            rejected_table(shots.rejected, shots.row_word),
        ),
        notes=(*origin_notes(origins), *shots.notes),
        provenance=Provenance(inputs={"file": shots.source, "read as": shots.format}),
    )  # fmt: skip


def session_table(shots: RecordedShots) -> Table:
    """Return source, format, number of shots and reference points of club data as a table."""
    values = {name: getattr(shots, name) for name in ("source", "format", "speed_at", "face_at")}
    return table(
        "session",
        text("shots", [len(shots)]),
        *(text(name, [value]) for name, value in values.items()),
        printed=False,
    )


def _quantities_table(shots: RecordedShots) -> Table:
    measured = {name: values[~np.isnan(values)] for name, values in (shots.deliveries | shots.launches).items()}
    of_rows = [quantity(name) for name in measured]

    def numbers(name: str, statistic: str) -> Column:
        return Column(name, [float(getattr(each, statistic)()) if each.size else None for each in measured.values()],
                      of_rows)  # fmt: skip

    return table(
        "quantities", text("quantity", list(measured)), text("shots", [each.size for each in measured.values()]),
        numbers("least", "min"), numbers("mean", "mean"), numbers("greatest", "max"),
    )  # fmt: skip


def rejected_table(rejected: Iterable[RejectedRow | Sequence[object]], place: str = "line") -> Table:
    """Return the table of rejected rows, with line and reason."""
    rows = list(rejected)
    count = f"{len(rows)} row{'s' * (len(rows) != 1)} rejected"
    more = f"; the first {SHOWN}" if len(rows) > SHOWN else ""
    return table(
        "rejected", text("line", [each[0] for each in rows], label=place),
        text("reason", [each[1] for each in rows]), title=f"{count}{more}",
        shown_rows=range(min(len(rows), SHOWN)),
    )  # fmt: skip
