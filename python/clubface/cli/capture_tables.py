"""The tables that ``clubface capture`` prints."""

from __future__ import annotations

from typing import Any

from clubface import units
from clubface.cli import output
from clubface.cli.tables import print_numbers

ROWS = (
    ("club speed", "speed", "mph", 2), ("attack", "attack", "deg", 2), ("path", "path", "deg", 2),
    ("dynamic loft", "loft", "deg", 2), ("face angle", "face", "deg", 2), ("lie", "lie", "deg", 2),
    ("towards the toe", "toe", "mm", 2), ("high", "high", "mm", 2), ("closure", "closure", "deg/s", 0),
    ("pitch rate", "pitch_rate", "deg/s", 0), ("lie rate", "lie_rate", "deg/s", 0),
)  # fmt: skip
LAUNCH_ROWS = (("ball speed", "ball_speed", "mph", 2), ("launch", "launch", "deg", 2), ("azimuth", "azimuth", "deg", 2))
SHOWN = ROWS[:5] + ROWS[6:9]
"""The columns of a table of many swings."""


def print_study(found: Any) -> None:
    """Print bias, spread and coverage, a row a quantity."""
    from clubface.motion_capture.study import UNITS

    heads = ["", *(f"{name}\n{figure}" for name in found.errors for figure in ("bias", "spread", "covers, %"))]
    figures = {name: (found.bias(name), found.spread(name), found.coverage(name)) for name in found.errors}
    rows = []
    for label, name, _, _ in ROWS:
        digits = 0 if UNITS[name] == "deg/s" else 3
        row = [f"{label}, {UNITS[name]}"]
        for bias, spread, coverage in figures.values():
            row += [output.number(bias[name], digits), output.number(spread[name], digits)]
            row.append(output.number(100.0 * coverage[name], 1))
        rows.append(row)
    noise = f"{units.from_si(found.cameras.noise, 'mm'):g} mm"
    print_numbers(
        heads, rows, title=f"{len(found)} swings, {found.club.name}, markers' noise {noise}: captured less true"
    )


def print_one(found: Any) -> None:
    """Print one delivery, value by value."""
    rows = []
    for label, name, unit, digits in ROWS:
        value, deviation = found.get(name, unit)
        rows.append([f"{label}, {unit}", output.number(value, digits), output.number(deviation, digits)])
    for label, name, unit, digits in LAUNCH_ROWS if found.launch else ():
        value, deviation = (units.from_si(each[name], unit) for each in (found.launch, found.launch_uncertainty))
        rows.append([f"{label}, {unit}", output.number(value, digits), output.number(deviation, digits)])
    print_numbers(("", "", "standard\ndeviation"), rows, title=f"{found.source}: {found.club.name}, {found.estimator}")
    noise = f"markers' noise {units.fixed(found.marker_noise, 'mm', 3)}"
    for known in found.geometry:
        output.print_paragraph(str(known))
    print(f"first touch {found.time:.6f} s, after frame {found.frames[0]}; {found.used} frames used; {noise}")
    output.print_notes(found.notes)


def print_many(found: Any) -> None:
    """Print a table of swings, and the mean of each standard deviation."""
    from pathlib import Path

    heads = ("swing", *(f"{label}\n{unit}" for label, _, unit, _ in SHOWN))
    rows = [
        [Path(each.source).name, *(output.number(each.get(name, unit)[0], digits) for _, name, unit, digits in SHOWN)]
        for each in found.captured
    ]
    deviations = found.uncertainty.deliveries
    means = [float(units.from_si(deviations[name].mean(), unit)) for _, name, unit, _ in SHOWN]
    last = [output.number(mean, digits) for mean, (*_, digits) in zip(means, SHOWN, strict=True)]
    rows.append(["standard deviation", *last])
    print_numbers(heads, rows, summary=True)
    shared = [str(each) for each in found.captured[0].geometry]
    for known in shared:
        if all(known in map(str, each.geometry) for each in found.captured):
            output.print_paragraph(known)
    output.print_notes(found.shots.notes)
