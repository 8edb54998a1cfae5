"""The summary of a study as ``clubface study summary`` prints and reports it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from clubface.cli import output, reporting
from clubface.cli.tables import print_numbers
from clubface.equipment.described import FLAT
from clubface.tables.headings import heading_of
from clubface.units import from_si, size

if TYPE_CHECKING:
    from clubface.studies.summaries import Along, Figures, Summary

MOST_SHOWN = 8
"""Quantities whose means are printed along each input."""


def write_report(found: Summary, study: str, target: str) -> None:
    """Write the report of a summary; ``study`` is the file of the study, or the folder of its parts."""
    from clubface.studies.picture import draw

    reporting.write(
        target, title=f"The study {found.name}", words=_words(found),
        picture=("Means, spreads and extremes along every input", draw(found)), columns=_columns(found),
        show=lambda: print_summary(found), launches=(),
        given={"study": Path(study).name, "tasks": str(found.tasks)} | _held(study), **_flown(study),
    )  # fmt: skip


def _asked(study: str) -> Mapping[str, Any]:
    """Return what the file of a study of impacts holds fixed; nothing for other kinds, or for the folder of a study."""
    from clubface.studies.study import read_study

    asked = read_study(study) if Path(study).is_file() else None
    return asked.table if asked is not None and asked.kind.name == "impact" else {}


def _held(study: str) -> dict[str, str]:
    table = _asked(study)
    told = {name: table[name] for name in ("club", "ball", "hand", "model", "parameters") if name in table}
    return {name: str(value) for name, value in {**told, **table.get("held", {})}.items()}


def _flown(study: str) -> dict[str, Any]:
    """Return air, wind and ground of a study of impacts, and the sources of its club and ball."""
    from clubface.equipment.balls import ball
    from clubface.equipment.clubs import CLUB_NAMES, club
    from clubface.reports.origin import equipment_sources

    if not (table := _asked(study)):
        return {}
    clubs = [club(table["club"])] if table.get("club") in CLUB_NAMES else []
    return {
        "conditions": {name: table.get(name) for name in ("air", "wind", "ground")},
        "sources": equipment_sources(*clubs, *([ball(table.get("ball"))] if "ball" not in table else [])),
    }


def _words(found: Summary) -> Iterator[str]:
    """Say how much was computed, and over what the quantities range, in sentences."""
    from clubface.studies.summaries import shown_unit

    along = " and ".join(each.name.replace("_", " ") for each in found.along)
    yield f"The study has {output.counted(found.tasks, 'task')}, which differ in {along}."
    for place, (name, si) in enumerate(list(found.quantities.items())[:MOST_SHOWN]):
        unit = shown_unit(name, si)
        told = _shown(found.overall, place, unit)
        least, most = (_number(each, _decimals(told[1], max(map(abs, told)))) for each in told[2:])
        yield f"{name.replace('_', ' ').capitalize()} ranges from {least} to {most}{'' if unit == '1' else f' {unit}'}."


def _columns(found: Summary) -> dict[str, list[Any]]:
    """Return the figures as a long table: along which input, at which level, of which quantity."""
    rows = []
    for along in (None, *found.along):
        every = [found.overall] if along is None else along.figures
        labels = [""] if along is None else _level_texts(along)
        for label, figures in zip(labels, every, strict=True):
            for place, (name, si) in enumerate(found.quantities.items()):
                heading, unit = heading_of(name, si)
                told = (float(each) for each in _shown(figures, place, unit))
                rows.append(("all" if along is None else along.name, label, heading, *told))
    heads = ("along", "level", "quantity", "mean", "deviation", "least", "most")
    return {head: [row[place] for row in rows] for place, head in enumerate(heads)}


def print_summary(found: Summary) -> None:
    """Print the figures of all tasks, and the means along every input."""
    from clubface.studies.summaries import shown_unit

    units = {name: shown_unit(name, unit) for name, unit in found.quantities.items()}
    rows = []
    for place, (name, unit) in enumerate(units.items()):
        each = _shown(found.overall, place, unit)
        rows.append(
            [
                name,
                *(_number(value, _decimals(each[1], max(map(abs, each)))) for value in each),
                "" if unit == "1" else unit,
            ]
        )
    title = f"{found.name}, {output.counted(found.tasks, 'task')}"
    print_numbers(("", "mean", "deviation", "least", "most", "unit"), rows, title=title)
    shown = list(units.items())[:MOST_SHOWN]
    for along in found.along:
        heads = [f"{name}\n{'' if unit == '1' else unit}" for name, unit in shown]
        columns = []
        for place, (_, unit) in enumerate(shown):
            pairs = [_shown(figures, place, unit)[:2] for figures in along.figures]
            known = [pair for pair in pairs if pair[1] == pair[1]]
            digits = _decimals(
                max((spread for _, spread in known), default=0.0), max((abs(mean) for mean, _ in known), default=0.0)
            )
            columns.append([f"{_number(mean, digits)} ± {_number(spread, digits)}" for mean, spread in pairs])
        body = [[label, *cells] for label, *cells in zip(_level_texts(along), *columns, strict=True)]
        print()
        print_numbers(["", *heads], body, title=f"Mean and deviation along {along.name}")


def _level_texts(along: Along) -> list[str]:
    """Return the levels of an input as they are read, with their unit."""
    if along.unit is None:
        return list(along.levels)
    unit = heading_of(along.name, along.unit)[1]
    after = "" if unit == "1" else f" {unit}"

    def told(each: Any) -> str:
        if each == math.inf:
            return FLAT
        if not isinstance(each, tuple):
            return f"{from_si(each, unit):.6g}{after}"
        low, high = (float(from_si(value, unit)) for value in each)
        # The ends of a class are told to a tenth of its width, or a hundredth.
        digits = max(1 - math.floor(math.log10(high - low)), 0) if high - low > 1e-6 else None
        return f"{_number(low, digits)} to {_number(high, digits)}{after}"

    return [told(each) for each in along.levels]


def _shown(figures: Figures, place: int, unit: str) -> list[float]:
    """Return mean, deviation, least and most of a quantity in a unit."""
    values = [from_si(float(each[place]), unit) for each in (figures.mean, figures.least, figures.most)]
    return [values[0], float(figures.deviation[place]) / size(unit), *values[1:]]


def _decimals(spread: float, largest: float) -> int | None:
    """Return the decimals that show a spread to three digits, the ``largest`` value to six at most; None if none do."""
    if not 1e-6 <= spread < 1e7:
        return None
    enough = 2 - math.floor(math.log10(spread))
    most = 5 - math.floor(math.log10(max(abs(largest), spread)))
    return max(min(enough, most), 0)


def _number(value: float, decimals: int | None) -> str:
    if value != value:
        return ""
    return f"{value:.5g}" if decimals is None else f"{value:.{decimals}f}"


def document(found: Summary) -> dict[str, Any]:
    """Return a summary as JSON has it, in SI units."""

    def told(figures: Figures) -> dict[str, Any]:
        return {
            name: {key: getattr(figures, key)[place].item() for key in ("count", "mean", "deviation", "least", "most")}
            for place, name in enumerate(found.quantities)
        }

    along = {
        each.name: {
            "unit": each.unit,
            "levels": [
                {"level": FLAT if level == math.inf else level, **told(figures)}
                for level, figures in zip(each.levels, each.figures, strict=True)
            ],
        }
        for each in found.along
    }
    return {
        "name": found.name,
        "tasks": found.tasks,
        "units": dict(found.quantities),
        "overall": told(found.overall),
        "along": along,
        "failed": found.failed,
        "remark": found.remark,
    }
