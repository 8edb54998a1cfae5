"""The picture of a club: where the shots finish or start, and face, path and start line from above."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from clubface import units
from clubface.plots import COLOURS, WIDTH, styled
from clubface.present.club_summary import ClubFigures

RAYS = {
    "azimuth": ("start of the ball", COLOURS[0]),
    "face": ("club face", COLOURS[1]),
    "path": ("club path", COLOURS[2]),
}
LEAST_ANGLE = 4.0
"""Degrees that the picture of directions shows at least to either side."""


@styled
def club_picture(of: ClubFigures) -> Figure:
    """Draw the shots of a club beside its directions at impact."""
    figure = Figure(figsize=(WIDTH, 3.0), layout="constrained")
    left, right = figure.subplots(1, 2)
    _draw_shots(left, of)
    _draw_directions(right, of)
    return figure


def _draw_shots(axes: Axes, of: ClubFigures) -> None:
    columns: dict[str, Any] = {**of.shots.deliveries, **of.shots.launches}
    if {"carry", "side"} <= set(columns):
        across, along = (units.from_si(columns[name], "yd") for name in ("side", "carry"))
        axes.set_xlabel("left - distance from the line (yd) - right")
        axes.set_ylabel("carry (yd)")
        axes.set_title("Where your shots land")
    else:
        nothing = np.full(len(of.shots), np.nan)
        across = units.from_si(columns.get("azimuth", nothing), "deg")
        along = units.from_si(columns.get("ball_speed", nothing), "mph")
        axes.set_xlabel("left - start direction (deg) - right")
        axes.set_ylabel("ball speed (mph)")
        axes.set_title("How your shots start")
    known = np.isfinite(across) & np.isfinite(along)
    if not known.any():
        axes.text(0.5, 0.5, "no direction was measured", transform=axes.transAxes, ha="center", va="center")
        return
    across, along = across[known], along[known]
    axes.plot(across, along, "o", color=COLOURS[0], alpha=0.7)
    axes.plot(across.mean(), along.mean(), "+", color="black", markersize=14, markeredgewidth=1.6)
    axes.axvline(0.0, color="0.5", linewidth=0.8)
    widest = max(float(np.abs(across).max()), 1.0)
    axes.set_xlim(-1.15 * widest, 1.15 * widest)


def _draw_directions(axes: Axes, of: ClubFigures) -> None:
    """Draw the directions as rays from the ball, seen from above, the target up."""
    given = {name: of.measured[name].mean for name in RAYS if name in of.measured}
    guessed = set()
    if of.inferred is not None:
        for name in ("face", "path"):
            if name not in given:
                given[name] = of.inferred.mean[name]
                guessed.add(name)
    degrees = {name: float(np.degrees(value)) for name, value in given.items()}
    widest = max([LEAST_ANGLE, *(1.3 * abs(each) for each in degrees.values())])
    for name, angle in degrees.items():
        label, colour = RAYS[name]
        told = f"{label} {abs(angle):.1f}° {'right' if angle > 0 else 'left'}{', estimated' if name in guessed else ''}"
        axes.plot([0.0, angle], [0.0, 1.0], color=colour, label=told, linewidth=2.0,
                  linestyle="--" if name in guessed else "-")  # fmt: skip
    axes.axvline(0.0, color="0.5", linewidth=0.8)
    axes.set_xlim(-widest, widest)
    axes.set_ylim(0.0, 1.45)
    axes.set_yticks([])
    axes.set_xlabel("left - degrees from the target - right")
    axes.set_title("From above, the target up")
    if degrees:
        axes.legend(loc="upper left", frameon=True, framealpha=1.0, edgecolor="none")  # it covers the target line
