"""Results of studies: a run, the status, joined columns, and the summary."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from clubface.equipment.balls import ball
from clubface.equipment.clubs import CLUB_NAMES, club
from clubface.equipment.described import FLAT
from clubface.quantities import Quantity, quantity, with_unit
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture
from clubface.results.result import Provenance, Result
from clubface.results.table import Column, Table, table, text
from clubface.simulation.provenance import equipment_sources, flight_conditions
from clubface.studies.joining import Joined
from clubface.studies.running import Outcome, Status
from clubface.studies.study import read_study
from clubface.studies.summaries import Along, Figures, Summary
from clubface.units import size

__all__ = ["joined_result", "run_result", "status_result", "summary_picture", "summary_result"]

MOST_ROWS, MOST_COLUMNS = 8, 6
"""Maximum number of quantities and inputs in a picture and in the tables along inputs."""
ROW_HEIGHT = 1.25
"""Height of a panel [inches]."""
STATISTICS = ("mean", "deviation", "least", "most")


def run_result(done: Outcome) -> Result:
    """Return what a run of a study computed, and what is left to other runs, as a result."""
    count, shown = done.mended
    notes = [*_task_notes(done.failed, done.remark)]
    if count:
        notes.insert(0, note("study-parts-mended", parts=count, shown=list(shown)))
    code = "study-left" if done.missing else "study-complete"
    notes.append(note(code, chunks=done.missing, store=done.store))
    values = (
        text("tasks", [done.tasks]), text("chunks", [done.chunks]), text("computed", [done.computed]),
        text("kept", [done.chunks - done.computed], label="there already"), text("missing", [done.missing]),
        text("store", [done.store], printed=False), text("failed", [done.failed[0]]),
    )  # fmt: skip
    return Result("study-run", "Run of a study", values=values, notes=tuple(notes))


def status_result(state: Status) -> Result:
    """Return the status of a study as a result."""
    values = (
        text("tasks", [state.tasks]), text("chunks", [state.chunks]),
        text("chunk", [state.chunk], label="tasks a chunk"), text("done", [state.done], label="chunks done"),
        text("size", [state.size], label="bytes of all parts"), text("store", [state.store], printed=False),
    )  # fmt: skip
    chunks = [*(("missing", each) for each in state.missing), *(("damaged", each) for each in state.damaged)]
    listed = table("chunks", text("state", [each for each, _ in chunks]), text("chunk", [each for _, each in chunks]))
    notes = [note("study-store", store=state.store)]
    left = state.chunks - state.done
    if left > len(chunks):
        notes.insert(0, note("study-chunks-not-listed", chunks=left - len(chunks), left=left))
    return Result("study-status", state.name, (listed,), values, notes=tuple(notes))


def joined_result(joined: Joined) -> Result:
    """Return the SHA-256 of every column of a joined study as a result."""
    notes = _task_notes(joined.failed, joined.remark)
    if len(joined.processors) > 1:
        notes.append(note("study-processors", processors=list(joined.processors)))
    sums = table("sums", text("column", list(joined.sums)), text("sha256", list(joined.sums.values()), label="SHA-256"))
    values = (text("tasks", [joined.tasks]),)
    return Result("study-join", "Columns of a study", (sums,), values, notes=tuple(notes))


def summary_result(summary: Summary) -> Result:
    """Return means, spreads and extremes of a study, over all tasks and along every input, as a result."""
    held = _held(summary.study)
    inputs = {"study": Path(summary.study).name, "tasks": str(summary.tasks)} | {
        name: str(held[name]) for name in ("club", "ball", "hand", "model", "parameters") if name in held
    }
    inputs |= {name: str(value) for name, value in held.get("held", {}).items()}
    if held:
        inputs |= flight_conditions(*(held.get(name) for name in ("air", "wind", "ground")))
    names = [name.replace("_", " ") for name in (each.name for each in summary.along)]
    return Result(
        "study-summary", f"The study {summary.name}",
        (_overall(summary), *(_along(summary, each) for each in summary.along)),
        (text("tasks", [summary.tasks]),),
        summary=(note("study-tasks", tasks=summary.tasks, inputs=names), *_ranges(summary)),
        notes=tuple(_task_notes(summary.failed, summary.remark)),
        provenance=Provenance(inputs=inputs, sources=tuple(_sources(held))),
        draw=lambda: [summary_picture(summary)],
    )  # fmt: skip


def summary_picture(summary: Summary) -> Picture:
    """Return the picture of a study, with a row per quantity and a column per input."""
    shown = list(_quantities(summary).values())[:MOST_ROWS]
    along = list(summary.along)[:MOST_COLUMNS]
    return Picture(
        "study", "Means, spreads and extremes along every input",
        [[_panel(each, place, of_row) for each in along] for place, of_row in enumerate(shown)],
        title=f"{summary.name}: {summary.tasks} tasks", height=0.7 + ROW_HEIGHT * max(len(shown), 2),
        share_x=True, share_y=True, legend=True,
    )  # fmt: skip


def _task_notes(failed: tuple[int, str], remark: str) -> list[Note]:
    count, first = failed
    notes = [note("tasks-without-result", tasks=count, first=first)] if count else []
    return [*notes, *([note("text", text=remark)] if remark else [])]


def _quantities(summary: Summary) -> dict[str, Quantity]:
    return {name: quantity(name, unit) for name, unit in summary.quantities.items()}


def _overall(summary: Summary) -> Table:
    names, quantities = list(summary.quantities), list(_quantities(summary).values())
    return table(
        "overall",
        text("quantity", names),
        *_statistics([summary.overall] * len(names), list(range(len(names))), quantities),
        title=f"{summary.name}: all tasks",
    )


def _along(summary: Summary, along: Along) -> Table:
    """Return a table along one input: statistics by level and quantity, printed as mean and deviation."""
    quantities = _quantities(summary)
    rows = [(level, place) for level in range(len(along.levels)) for place in range(len(quantities))]
    figures = [along.figures[level] for level, _ in rows]
    places = [place for _, place in rows]
    of_rows = [list(quantities.values())[place] for place in places]
    input_quantity = None if along.unit is None else quantity(along.name, along.unit)
    heads = [f"{each.label}, {each.golf.unit}".removesuffix(", 1") for each in of_rows]
    statistics = _statistics(figures, places, of_rows)
    cells = [f"{statistics[1].shown(row)} ± {statistics[2].shown(row)}" for row in range(len(rows))]
    ends = [_ends(along.levels[level]) for level, _ in rows]
    return table(
        f"along_{along.name}",
        text(along.name, [level_text(along, level) for level, _ in rows], in_files=False),
        text("head", heads, in_files=False),
        text("cell", cells, in_files=False),
        *(
            [text("level", [along.levels[level] for level, _ in rows], printed=False)]
            if input_quantity is None
            else [
                Column("level_from", [low for low, _ in ends], input_quantity, printed=False),
                Column("level_to", [high for _, high in ends], input_quantity, printed=False),
            ]
        ),
        text("quantity", [list(quantities)[place] for place in places], printed=False),
        *(Column(each.name, each.values, each.quantity, printed=False) for each in statistics),
        title=f"Mean and deviation along {along.name.replace('_', ' ')}",
        layout="pivot",
        shown_rows=[row for row, place in enumerate(places) if place < MOST_ROWS],
    )


def _statistics(figures: Sequence[Figures], places: Sequence[int], quantities: Sequence[Quantity]) -> list[Column]:
    """Return columns of count, mean, deviation and extremes, with a row for each pair of figures and quantity index."""
    pairs = list(zip(figures, places, strict=True))
    columns = [text("count", [int(each.count[place]) for each, place in pairs], printed=False)]
    values = {name: [float(getattr(each, name)[place]) for each, place in pairs] for name in STATISTICS}
    digits = [_digits(values, row, each) for row, each in enumerate(quantities)]
    for name in STATISTICS:
        spread = name == "deviation"
        columns.append(Column(name, values[name], list(quantities), digits=digits, difference=spread, signed=False))
    return columns


def _digits(values: Mapping[str, Sequence[float]], row: int, quantity: Quantity) -> int:
    """Return the decimals that show the spread to three digits, and the largest value to at most six."""
    unit = size(quantity.golf.unit)
    spread, largest = values["deviation"][row] / unit, max(abs(values[name][row]) for name in STATISTICS) / unit
    if not 1e-6 <= spread < 1e7:
        return -5
    return max(min(2 - math.floor(math.log10(spread)), 5 - math.floor(math.log10(max(largest, spread)))), 0)


def _ranges(summary: Summary) -> list[Note]:
    notes = []
    for place, (name, each) in enumerate(list(_quantities(summary).items())[:MOST_ROWS]):
        least, most = (float(getattr(summary.overall, key)[place]) for key in ("least", "most"))
        if math.isfinite(least):
            values = {key: [float(getattr(summary.overall, key)[place])] for key in STATISTICS}
            column = Column(name, [least, most], each, digits=_digits(values, 0, each))
            most_text = with_unit(column.shown(1), each.golf.unit)
            label = each.label.capitalize()
            notes.append(note("study-range", quantity=label, least_text=column.shown(0), most_text=most_text))
    return notes


def level_text(along: Along, level: int) -> str:
    """Return an input's level as text with its unit; ends of a class are rounded to a tenth of its width."""
    value = along.levels[level]
    if along.unit is None:
        return str(value)
    swept = quantity(along.name, along.unit)
    width = (value[1] - value[0]) / size(swept.golf.unit) if isinstance(value, tuple) else 0.0
    digits = max(1 - math.floor(math.log10(width)), 0) if width > 1e-6 else -6
    column = Column(along.name, _ends(value), swept, digits=digits)
    words = f"{column.shown(0)} to {column.shown(1)}" if isinstance(value, tuple) else column.shown(0)
    return words if words == FLAT else with_unit(words, swept.golf.unit)


def _ends(level: Any) -> tuple[float, float]:
    return level if isinstance(level, tuple) else (level, level)


def _panel(along: Along, place: int, shown: Quantity) -> Panel:
    mean, deviation, least, most = (
        np.array([float(getattr(each, key)[place]) for each in along.figures]) for key in STATISTICS
    )
    middles = [sum(_ends(each)) / 2.0 for each in along.levels] if along.unit is not None else []
    of_input = None if along.unit is None else quantity(along.name, along.unit)
    x = np.arange(len(along.levels), dtype=float) if of_input is None else np.array(middles)
    finite = np.isfinite(x)
    marks = [
        Mark("band", x[finite], y0=(mean - deviation)[finite], y1=(mean + deviation)[finite], label="mean ± deviation"),
        Mark("line", x[finite], mean[finite], label="mean"),
        *(
            Mark("line", x[finite], each[finite], label="extremes", style=-1, dash=1, size=0.7)
            for each in (least, most)
        ),
    ]
    if of_input is None:
        marks = [
            Mark("intervals", x, mean, y0=least, y1=most, label="extremes", style=-1, symbol=""),
            Mark("intervals", x, mean, y0=mean - deviation, y1=mean + deviation, label="mean ± deviation"),
        ]
    elif not finite.all():  # a flat face is drawn to the right of the numbers
        last = x[finite][-1] + 0.15 * max(float(np.ptp(x[finite])), 1e-3) if finite.any() else 0.0
        low, high = mean[~finite] - deviation[~finite], mean[~finite] + deviation[~finite]
        marks.append(Mark("intervals", np.array([last]), mean[~finite], y0=low, y1=high))
        marks.append(Mark("text", np.array([last]), most[~finite], texts=[FLAT]))
    names = None if of_input is not None else [str(each) for each in along.levels]
    across = Axis(of_input, "" if of_input is not None else along.name.replace("_", " "), names=names)
    return Panel(marks, across, Axis(shown))


def _held(study: str) -> Mapping[str, Any]:
    """Return the fixed inputs of a study file of impacts; empty for other kinds, or for a store's folder."""
    asked = read_study(study) if Path(study).is_file() else None
    return asked.table if asked is not None and asked.kind.name == "impact" else {}


def _sources(held: Mapping[str, Any]) -> list[str]:
    """Return the sources of the club and ball of a study of impacts."""
    if not held:
        return []
    clubs = [club(held["club"])] if held.get("club") in CLUB_NAMES else []
    return list(equipment_sources(*clubs, *([ball(held.get("ball"))] if "ball" not in held else [])))
