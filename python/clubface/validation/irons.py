"""Spin of irons and wedges: by loft, by friction, and where it is largest."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from clubface import units
from clubface.simulation.launch import Launch
from clubface.support.arrays import Floats
from clubface.validation.at_launch import SPIN
from clubface.validation.check import Figure, Judged, figure, rows

GOLF_DIGEST: dict[str, Any] = {"speed": units.parse("82 mph", "speed"), "attack": units.parse("-3 deg", "angle")}
COOL_CLUBS: dict[str, Any] = {"speed": units.parse("80 mph", "speed"), "attack": units.parse("-2 deg", "angle")}
SLOPE_TOLERANCE = 0.15
WEDGE: dict[str, Any] = {"speed": units.parse("46 mph", "speed"), "attack": units.parse("-5 deg", "angle")}
"""The attack angle, which is not published, is that of the pitching wedges of the PGA Tour."""
WEDGE_TOLERANCE = units.parse("1 deg", "angle")
LEAST_FRICTION, HALVINGS = 0.02, 10
PEAK: dict[str, Any] = {"speed": units.parse("75 mph", "speed"), "attack": units.parse("-5 deg", "angle")}
PEAK_LOFTS = np.radians(np.arange(31.0, 64.0, 4.0))
PEAK_TOLERANCE = units.parse("4 deg", "angle")


def by_loft(judged: Judged) -> list[Figure]:
    """Return the spin of 7-irons at the mean of the published lofts or launch angles, and its slope over them."""
    found = []
    for table, column, delivery in (
        ("robot-7-irons-2026", "dynamic_loft", GOLF_DIGEST), ("robot-7-irons-launch-2026", "launch", COOL_CLUBS),
    ):  # fmt: skip
        angles, spins = (np.array([row[name] for row in rows(table)]) for name in (column, "spin"))
        middle, wide = float(angles.mean()), float(angles.std())
        computed = []
        for angle in (middle - wide, middle, middle + wide):
            launched = column == "launch"
            shot = (
                judged.at_launch("7-iron", angle, **delivery)
                if launched
                else judged.hit("7-iron", loft=angle, **delivery)
            )
            computed.append(shot.total_spin)
        named = "dynamic loft" if column == "dynamic_loft" else "launch angle"
        what = f"7-iron, {named} {units.show(middle, 'deg', 3)}"
        slope, degree = float(np.polyfit(angles, spins, 1)[0]), math.radians(1.0)
        found += [
            figure(what, "spin", "rpm", spins.mean(), computed[1], SPIN, relative=True),
            figure(what, "spin by a degree", "rpm", slope * degree,
                   degree * (computed[2] - computed[0]) / (2.0 * wide), SLOPE_TOLERANCE, relative=True),
        ]  # fmt: skip
    return found


def sliding(judged: Judged) -> list[Figure]:
    """Return how much higher a ball starts that slides and spins less, by as much as published.

    The loft is that with which a urethane ball starts as published. The friction of the ball that slides is not known:
    it is the one with which the model loses the published share of the spin.
    """
    row = {each["balls"]: each for each in rows("robot-wedge-covers-2025")}
    grips, slides = row["urethane"], row["two that slide"]
    kept, computed = slides["spin"] / grips["spin"], math.nan
    if judged.has("friction"):
        whole = judged.at_launch("pitching-wedge", grips["launch"], **WEDGE)
        loft = whole.delivery["loft"]

        def with_friction(friction: float) -> Launch:
            return judged.hit("pitching-wedge", parameters={"friction": friction}, loft=loft, **WEDGE)

        low, high = LEAST_FRICTION, float(whole.parameters.values["friction"])
        if with_friction(low).total_spin < kept * whole.total_spin:
            for _ in range(HALVINGS):
                middle = 0.5 * (low + high)
                slow = with_friction(middle).total_spin < kept * whole.total_spin
                low, high = (middle, high) if slow else (low, middle)
            computed = with_friction(high).launch - whole.launch
    rises = slides["launch"] - grips["launch"]
    return [figure("wedge, 46 mph, 0.64 of the spin", "rise of launch angle", "deg", rises, computed, WEDGE_TOLERANCE)]


def peak(judged: Judged) -> list[Figure]:
    """Return the spin loft at which a wedge spins most."""
    (row,) = rows("spin-peak")
    spins = np.array([float(judged.hit("pitching-wedge", loft=loft, **PEAK).total_spin) for loft in PEAK_LOFTS])
    published = (row["spin_loft_still_gripping"], row["spin_loft_sliding"])
    computed = top(PEAK_LOFTS - PEAK["attack"], spins)
    return [figure("wedge, 75 mph", "spin loft of most spin", "deg", published, computed, PEAK_TOLERANCE)]


def top(places: Floats, values: Floats) -> float:
    """Return where values are largest, by a parabola through the largest and its neighbours; an end if they rise."""
    index = int(np.argmax(values))
    if index in (0, len(places) - 1):
        return float(places[index])
    a, b, _ = np.polyfit(places[index - 1 : index + 2] - places[index], values[index - 1 : index + 2], 2)
    return float(places[index] - b / (2.0 * a))
