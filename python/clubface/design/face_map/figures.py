"""Pictures of a face: contours of launch and flight on its outline."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from clubface import units as units_of
from clubface.design.face_map.difference import FaceMapDifference
from clubface.design.face_map.face_map import FaceMap
from clubface.plots.style import WIDTH, styled

SHOWN = {
    "ball_speed": "mph", "launch": "deg", "backspin": "rpm", "sidespin": "rpm", "azimuth": "deg", "carry": "yd",
    "side": "yd", "total": "yd",
}  # fmt: skip
"""What is drawn unless something else is asked for."""
SIDED = ("azimuth", "sidespin", "spin_axis", "side", "total_side")
"""Quantities of which positive means to the right: their colours turn at zero."""
LEVELS = 11
WORDS = {"azimuth": "start line"}


@styled
def face_map_figure(found: FaceMap | FaceMapDifference, *, units: Mapping[str, str] | None = None) -> Figure:
    """Draw quantities over a face, the toe on the right: a right-hander's face as seen through the head from behind.

    A cross marks the face centre, and a ring the point of the greatest ball speed.

    Parameters
    ----------
    found
        A map, or the difference of two.
    units
        What is drawn, and in which unit; left out, ``SHOWN``.
    """
    shown = dict(units or SHOWN)
    columns = min(2, len(shown))
    rows = -(-len(shown) // columns)
    wide, tall = found.outline.greatest - found.outline.least
    panel = (WIDTH / columns - 0.9) * float(tall / wide) + 0.42
    figure = Figure(figsize=(WIDTH, rows * panel + 0.7), layout="constrained")
    panels = np.atleast_1d(figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)).reshape(-1)
    for axes, (name, unit) in zip(panels, shown.items(), strict=False):
        _panel(figure, axes, found, name, unit)
    for axes in panels[len(shown) :]:
        axes.set_axis_off()
    for axes in panels[len(panels) - columns :]:
        axes.set_xlabel("← heel   from the centre (mm)   toe →")
    for axes in panels[::columns]:
        axes.set_ylabel("up the face (mm)")
    figure.suptitle(_title(found), fontsize=8.5, x=0.01, ha="left")
    return figure


def _title(found: FaceMap | FaceMapDifference) -> str:
    first = found.first if isinstance(found, FaceMapDifference) else found
    told = f"{first.centre.club.name}, ball {first.centre.ball.name}, by {first.centre.model}"
    if isinstance(found, FaceMapDifference):
        told = f"{first.centre.club.name} less {found.second.centre.club.name}, by {first.centre.model}"
    told = f"{told}; outline {first.outline.told}" + ("; interpolated" if first.interpolated else "")
    spot = f" of {first.centre.club.name}" if isinstance(found, FaceMapDifference) else ""
    return f"{told}\n+ centre of the face    ○ greatest ball speed{spot}"


def _panel(figure: Figure, axes: Axes, found: FaceMap | FaceMapDifference, name: str, unit: str) -> None:
    toe, high, values = found.box(name)
    toe, high, values = toe * 1e3, high * 1e3, values / units_of.size(unit)
    shown = np.where(found.outline.holds(*np.meshgrid(toe / 1e3, high / 1e3)), values, np.nan)
    least, most = float(np.nanmin(shown)), float(np.nanmax(shown))
    levels = _levels(least, most)
    values = np.clip(values, levels[0], levels[-1])  # beside the face there is more, which is cut away
    signed = name in SIDED or isinstance(found, FaceMapDifference)
    reach = max(abs(levels[0]), abs(levels[-1]))
    norm = Normalize(-reach, reach) if signed else None  # the same strength of colour to both sides
    filled = axes.contourf(
        toe, high, np.ma.masked_invalid(values), levels=levels, cmap="RdBu_r" if signed else "viridis", norm=norm,
    )  # fmt: skip
    lines = axes.contour(toe, high, np.ma.masked_invalid(values), levels=levels[1:-1], colors="0.15", linewidths=0.4)
    patch = PathPatch(
        Path(np.concatenate([found.outline.corners, found.outline.corners[:1]]) * 1e3, closed=True), facecolor="none",
        edgecolor="black", linewidth=1.0, transform=axes.transData,
    )  # fmt: skip
    axes.add_patch(patch)
    for each in (filled, lines):
        each.set_clip_path(patch)
    axes.plot(0.0, 0.0, "+", color="black", markersize=6.0)
    first = found.first if isinstance(found, FaceMapDifference) else found
    best = first.best()
    axes.plot(best.toe * 1e3, best.high * 1e3, "o", markersize=5.0, markerfacecolor="none", markeredgecolor="black")
    axes.set_aspect("equal")
    axes.grid(visible=False)
    label = WORDS.get(name, name.replace("_", " "))
    side = ", right is positive" if name in SIDED else ""
    axes.set_title(f"{label} ({unit}){side}" if unit != "1" else label)
    figure.colorbar(filled, ax=axes, shrink=0.85, pad=0.02)


def _levels(least: float, most: float) -> Any:
    """Return round levels; a map without differences has a few about its value."""
    from matplotlib.ticker import MaxNLocator

    if not most - least > 1e-9 * max(abs(least), abs(most), 1e-9):
        least, most = least - 0.5, most + 0.5
    return MaxNLocator(LEVELS).tick_values(least, most)
