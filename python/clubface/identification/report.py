"""An identification in words and tables."""

from __future__ import annotations

import math
from collections.abc import Sequence

from clubface.identification.result import Identification
from clubface.measured.shots import QUANTITIES
from clubface.simulation.quantities import outputs
from clubface.units import display_unit, from_si

PARAMETER_HEADS = ("parameter", "value", "from", "to", "profile", "identified")
DEVIATION_HEADS = ("quantity", "mean size", "MAE", "held out", "bias", "std")


def headline(of: Identification) -> str:
    """Return one sentence: model, club, shots, cost."""
    held = "" if math.isnan(of.cost_holdout) else f", held out {of.cost_holdout:.5g}"
    kind = {"published": "published cost", "least-squares": "mean square", "robust": "robust cost"}[of.cost_kind]
    return f"{of.model}, {of.club}, {of.shots} shots: {kind} {of.cost:.5g}{held}"


def effort(of: Identification) -> str:
    """Return one sentence on what was computed."""
    return f"{of.evaluations:,} evaluations, {of.impacts:,} impacts, {of.wall_s:.1f} s"


def parameter_rows(of: Identification) -> list[list[str]]:
    """Return a row a free parameter: value, interval, profile likelihood interval, and whether it is identified."""
    rows = []
    for name in of.free:
        low, high = of.intervals[name]
        profile = of.profiles.get(name)
        span = ""
        if profile is not None:
            ends = [of.shown(name, value) for value in profile.interval]
            span = f"{ends[0] if profile.closed[0] else 'bound'} .. {ends[1] if profile.closed[1] else 'bound'}"
        value = of.shown(name, float(of.parameters.values[name]), 5)
        rows.append([name, value, of.shown(name, low), of.shown(name, high), span, of.identified(name)])
    return rows


def deviation_rows(of: Identification) -> list[list[str]]:
    """Return a row a launch quantity, in the units people read."""
    rows = []
    for name, each in of.deviations.items():
        unit = QUANTITIES.get(name) or display_unit(name, outputs()[name].unit)
        numbers = (each.mean, each.mae, each.mae_holdout, each.bias, each.std)
        shown = ["" if math.isnan(number) else f"{from_si(number, unit):.4g}" for number in numbers]
        rows.append([f"{name} [{unit}]", *shown])
    return rows


def remarks(of: Identification) -> list[str]:
    """Return warnings, weak directions and notes, in this order."""
    weak = [f"weak: {each.words}" for each in of.identifiability.directions if each.strength == "weak"]
    left = [f"{_rows(len(of.dropped))} not used, the first: {_dropped(of)}"] if of.dropped else []
    return [*of.warnings, *weak, *left, *of.notes]


def text(of: Identification) -> str:
    """Return everything for the screen."""
    parts = [headline(of), effort(of), "", *_table(PARAMETER_HEADS, parameter_rows(of)), ""]
    parts += [*_table(DEVIATION_HEADS, deviation_rows(of))]
    said = remarks(of)
    return "\n".join(parts + ([""] + [f"* {each}" for each in said] if said else []))


def _rows(count: int) -> str:
    return "one row was" if count == 1 else f"{count} rows were"


def _dropped(of: Identification) -> str:
    first = of.dropped[0]
    return f"row {first.line}: {first.reason}"


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    widths = [max(len(each) for each in column) for column in zip(heads, *rows, strict=True)]
    lines = []
    for row in (heads, *rows):
        cells = [
            cell.rjust(width) if place else cell.ljust(width)
            for place, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        lines.append("  ".join(cells).rstrip())
    return lines
