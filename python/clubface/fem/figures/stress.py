"""The picture of a blow: stress over the surface of a head, and the largest of every part beside its metal's yield."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.tri import Triangulation
from numpy.typing import NDArray

from clubface.fem.stress import BlowStress, PartStress, SurfaceStress
from clubface.plots.style import COLOURS, WIDTH, styled
from clubface.units import from_si

COLOUR_MAP = "YlOrRd"
LEVELS = 12
"""Contours of stress."""
FACING = 0.25
"""Cosine of the angle between a quadrilateral's normal and the view above which it is seen."""


@styled
def stress_figure(blow: BlowStress, loft: float) -> Figure:
    """Draw the stress over the surface of a head when it is largest, and a bar for the largest of each part.

    A cross marks the place of the largest stress. A line across a bar is where the metal yields, if that is known.

    Parameters
    ----------
    blow
        The stress.
    loft
        Elevation of the face normal at the face centre [rad].
    """
    bars = 0.9 + 0.32 * len(blow.parts)
    views = _views(blow.surface, loft)
    figure = Figure(figsize=(WIDTH, 2.6 + bars), layout="constrained")
    grid = figure.add_gridspec(2, len(views), height_ratios=[2.6, bars])
    panels = [figure.add_subplot(grid[0, column]) for column in range(len(views))]
    values = from_si(blow.surface.stress, "MPa")
    for axes, view in zip(panels, views, strict=True):
        _draw_view(axes, view, values, blow)
    scale = ScalarMappable(Normalize(0.0, values.max()), COLOUR_MAP)
    figure.colorbar(scale, ax=panels, shrink=0.8, label="stress (MPa)", format="%.0f")
    _draw_parts(figure.add_subplot(grid[1, :]), blow.parts)
    return figure


class View(NamedTuple):
    """A side of a head: its title, the quadrilaterals that are seen, places of all nodes [mm], and what is upwards."""

    title: str
    quads: NDArray[Any]
    along: NDArray[Any]
    height: NDArray[Any]
    label: str


def _views(surface: SurfaceStress, loft: float) -> list[View]:
    """Return the sides of a head that show its walls."""
    corners = surface.nodes[surface.quads]
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    out, up = np.array([np.cos(loft), np.sin(loft), 0.0]), np.array([-np.sin(loft), np.cos(loft), 0.0])
    ahead, vertical, toe = np.eye(3)
    sides = {
        "face": (out, up, "up the face (mm)"),
        "back": (-out, up, "up the face (mm)"),
        "crown": (vertical, ahead, "to the target (mm)"),
        "sole": (-vertical, ahead, "to the target (mm)"),
    }
    along = from_si(surface.nodes @ toe, "mm")
    views = []
    for name in surface.views:
        towards, height, label = sides[name]
        visible = normals @ towards > FACING
        views.append(View(name, surface.quads[visible], along, from_si(surface.nodes @ height, "mm"), label))
    return views


def _draw_view(axes: Axes, view: View, values: NDArray[Any], blow: BlowStress) -> None:
    """Draw contours of the stress at nodes [MPa], and a cross at the largest if it is seen."""
    triangles = np.vstack([view.quads[:, :3], view.quads[:, [0, 2, 3]]])
    levels = np.linspace(0.0, values.max(), LEVELS + 1)
    axes.tricontourf(Triangulation(view.along, view.height, triangles), values, levels=levels, cmap=COLOUR_MAP)
    peak = max(blow.parts, key=lambda part: part.stress)
    at = int(((blow.surface.nodes - np.array(peak.place)) ** 2).sum(axis=1).argmin())
    if at in view.quads:
        axes.plot(view.along[at], view.height[at], marker="x", color="black", markersize=7.0)
    axes.set_aspect("equal")
    axes.set_title(view.title)
    axes.set_xlabel("to the toe (mm)")
    axes.set_ylabel(view.label)
    axes.grid(visible=False)


def _draw_parts(axes: Axes, parts: Sequence[PartStress]) -> None:
    """Draw a bar a part, and a line across it where the metal yields, if that is known."""
    for row, part in enumerate(parts):
        yields = part.margin is not None and part.margin < 0.0
        axes.barh(row, from_si(part.stress, "MPa"), height=0.6, color=COLOURS[1 if yields else 0],
                  hatch="////" if yields else None, edgecolor="white", linewidth=0.0)  # fmt: skip
        if part.yield_stress is not None:
            at = from_si(part.yield_stress, "MPa")
            axes.plot([at, at], [row - 0.42, row + 0.42], color="black", linewidth=2.0)
    axes.set_yticks(range(len(parts)), [part.part for part in parts])
    axes.set_ylim(len(parts) - 0.4, -0.6)
    axes.set_xlabel("largest stress (MPa); the black line is where the metal yields, hatched bars are beyond it")
