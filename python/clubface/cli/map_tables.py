"""The tables that ``clubface map`` prints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from clubface.cli import output
from clubface.cli.quantity_units import Shown, label
from clubface.cli.tables import print_numbers
from clubface.units import fixed, from_si, size

DEFAULT = ("ball_speed", "launch", "backspin", "sidespin", "azimuth", "carry", "side", "total")
"""What is listed and drawn unless something else is asked for."""
LEAST_MISSED = 5e-5
"""Share of swings beside the face that is told."""
TABLE = (9, 7)
"""Points of a printed table towards the toe and upwards."""


def print_map(found: Any, maps: Sequence[Any], spreads: Sequence[Any], names: Sequence[str], shown: Shown) -> None:
    """Print a map, or the difference of two: extremes, values over the face, best points, and what scatter costs."""
    _print_extremes(found, maps, names or DEFAULT, shown)
    for name in names:
        _print_values(found, name, shown[name])
    print()
    for each in maps:
        _print_best(each, shown)
    if spreads:
        _print_spreads(maps, spreads, names or DEFAULT, shown)
    else:
        output.print_paragraph('Give --spread "12 mm x 9 mm" to learn what impacts that scatter so much cost.')
    notes = [f"{each.centre.club.name}: outline {each.outline.told}" for each in maps]
    if maps[0].interpolated:
        notes.append("between the points of the grid, values, best points and areas are interpolated")
    output.print_notes(notes)


def _print_extremes(found: Any, maps: Sequence[Any], names: Sequence[str], shown: Shown) -> None:
    import numpy as np

    first = maps[0]
    rows = []
    middles = [each.at(0.0, 0.0) for each in maps]
    for name in names:
        unit, digits = shown[name]
        values = found.get(name) / size(unit)
        middle = float(middles[0][name] - (middles[1][name] if len(maps) == 2 else 0.0)) / size(unit)
        digits += len(maps) - 1
        row = [label(name, unit), output.number(middle, digits)]
        for pick in (np.nanargmin, np.nanargmax):
            if not np.isfinite(values).any():
                row += ["", "", ""]
                continue
            up, across = np.unravel_index(pick(values), values.shape)
            row += [output.number(float(values[up, across]), digits), output.number(1e3 * found.toe[across], 0),
                    output.number(1e3 * found.high[up], 0)]  # fmt: skip
        rows.append(row)
    heads = ["", "at the\ncentre", "least", "toe\nmm", "high\nmm", "greatest", "toe\nmm", "high\nmm"]
    clubs = " less ".join(each.centre.club.name for each in maps)
    told = f"{clubs}, ball {first.centre.ball.name}, by {first.centre.model}"
    print_numbers(heads, rows, title=f"{told}: {len(first.toe)} by {len(first.high)} points of the face")


def _print_values(found: Any, name: str, of: tuple[str, int]) -> None:
    import numpy as np

    unit, digits = of
    across, up = (
        np.unique(np.round(np.linspace(0, len(each) - 1, min(count, len(each)))).astype(int))
        for each, count in zip((found.toe, found.high), TABLE, strict=True)
    )
    values = found.get(name) / size(unit)
    heads = ["high, mm", *(f"{1e3 * found.toe[place]:.0f} mm" for place in across)]
    rows = [
        [f"{1e3 * found.high[row]:.1f}", *(output.number(float(values[row, place]), digits) for place in across)]
        for row in up[::-1]
    ]
    print()
    print_numbers(heads, rows, title=f"{label(name, unit)}, over places towards the toe")


def _print_best(found: Any, shown: Shown) -> None:
    best, carry = found.best(), found.best("carry")
    area, whole = from_si(found.area(), "mm2"), from_si(found.outline.area(), "mm2")
    name = found.centre.club.name
    unit, digits = shown["ball_speed"]
    far, far_digits = shown["carry"]
    output.print_paragraph(
        f"{name}: the sweet spot lies {_place(best)}, with a ball speed of {fixed(best.value, unit, digits)}; within"
        f" 2 % of it are {area:.0f} of the {whole:.0f} mm2 of the face. The longest carry,"
        f" {fixed(carry.value, far, far_digits)}, comes from {_place(carry)}."
    )


def _place(best: Any) -> str:
    """Return a point of the face in words."""
    toe, high = (from_si(each, "mm") for each in (best.toe, best.high))
    sides = (f"{abs(toe):.1f} mm towards the {'toe' if toe > 0 else 'heel'}",
             f"{abs(high):.1f} mm {'above' if high > 0 else 'below'} the centre")  # fmt: skip
    return " and ".join(sides)


def _about(spread: Any) -> str:
    """Return the point about which impacts scatter in words."""
    if not (spread.toe or spread.high):
        return "the face centre"
    return ", ".join(f"{name} {fixed(each, 'mm', 1)}" for name, each in (("toe", spread.toe), ("high", spread.high)))


def _print_spreads(maps: Sequence[Any], spreads: Sequence[Any], names: Sequence[str], shown: Shown) -> None:
    first = spreads[0]
    deviations = " by ".join(fixed(each, "mm", 1) for each in (first.toe_deviation, first.high_deviation))
    heads = [""]
    for each in maps:
        heads += [f"{each.centre.club.name}\nmean", "standard\ndeviation", "lost by\nscatter"]
    rows = []
    for name in names:
        unit, digits = shown[name]
        row = [label(name, unit)]
        for each in spreads:
            row += [output.number(part[name] / size(unit), digits + more) for part, more in
                    ((each.mean, 0), (each.deviation, 1), (each.loss, 1))]  # fmt: skip
        rows.append(row)
    print()
    print_numbers(heads, rows, title=f"Impacts that scatter by {deviations} about {_about(first)}")
    for found, each in zip(maps, spreads, strict=True):
        if each.missed < LEAST_MISSED:
            continue
        output.print_paragraph(
            f"{found.centre.club.name}: {each.missed:.2%} of them miss the face and are not counted."
        )
