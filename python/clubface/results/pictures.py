"""Pictures as specifications: panels of marks over two axes with values in SI, independent of the drawing library.

A picture describes what is drawn, not how: :mod:`clubface.present.drawing` draws it for paper and screen, the browser
with its own code. The numbers behind every mark can be saved as a table.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np

from clubface.quantities import Quantity, quantity as quantity_named, unit_text
from clubface.support.arrays import Floats

MarkKind = Literal[
    "line", "points", "bars", "intervals", "band", "area", "stack", "steps", "contour", "cells", "outline", "rule",
    "slope", "text", "shade",
]  # fmt: skip
"""``line`` and ``points`` have x and y; ``bars`` lie along x at the positions y and start at ``x0``.

``intervals`` reach from ``x0`` to ``x1`` or from ``y0`` to ``y1`` about their points; ``band`` fills between ``y0``
and ``y1``; ``stack`` is an area on top of the previous ones; ``steps`` is a histogram, x the edges and y the counts;
``contour`` has ``values`` over a grid; ``cells`` are polygons (x and y of shape [n, corners]) coloured by ``values``;
``outline`` is a closed line; ``rule`` is a line across the panel at x or y; ``slope`` a line through (x, y) with the
slope in ``values``; ``text`` writes ``texts``; ``shade`` fills the panel from ``x0`` to ``x1``.
"""


@dataclass(frozen=True)
class Axis:
    """An axis of a panel."""

    quantity: Quantity | None = None  # None for names or plain numbers
    label: str = ""  # without the unit, which is added; default: that of the quantity
    unit: str | None = None  # in which it is drawn; default: the golf unit of the quantity
    limits: tuple[float | None, float | None] = (None, None)  # ends of the axis [SI]; None for one chosen automatically
    names: Sequence[str] | None = None  # words at the positions 0, 1, 2, ... in place of numbers
    reversed: bool = False
    logarithmic: bool = False
    ticks: bool = True

    @property
    def unit_drawn(self) -> str:
        """The unit in which the axis is drawn."""
        return self.unit or (self.quantity.reading.unit if self.quantity is not None else "1")

    @property
    def heading(self) -> str:
        """The label with the unit."""
        words = self.label or (self.quantity.label if self.quantity is not None else "")
        unit = unit_text(self.unit_drawn)
        return f"{words} ({unit})" if words and unit else words


@dataclass(frozen=True)
class Mark:
    """Something drawn in a panel; see :data:`MarkKind` for the data of each kind."""

    kind: MarkKind
    x: Any = None
    y: Any = None
    x0: Any = None
    x1: Any = None
    y0: Any = None
    y1: Any = None
    values: Any = None
    texts: Sequence[str] = ()
    label: str = ""  # entry in the legend; marks with the same label share an entry
    style: str | int = 0  # name of a model, or a number of the palette; -1 is grey, -2 black, -3 white
    symbol: str = "o"  # "o", "s", "+", ...; "" for small dots where there are many points
    size: float | None = None
    dash: int | None = None  # number of a dash pattern; default: that of the style
    hollow: bool = False
    faint: bool = False
    within: Any = None  # corners of the outline that clips a contour, shape [n, 2]


@dataclass(frozen=True)
class Panel:
    """One plot of a picture."""

    marks: Sequence[Mark]
    x: Axis = field(default_factory=Axis)
    y: Axis = field(default_factory=Axis)
    title: str = ""
    equal: bool = False  # whether both axes have the same scale
    aspect: float | None = None  # scale of the y axis over that of the x axis; default: free
    values: Axis | None = None  # of the colour bar of contours and cells
    diverging: bool = False  # whether colours diverge from zero
    legend: bool = False  # of its own; otherwise its marks appear in that of the picture
    grid: bool = True
    tall: bool = False  # whether it extends down over the empty positions below it


@dataclass(frozen=True)
class Picture:
    """A picture."""

    name: str  # of its file
    caption: str  # what it shows
    rows: Sequence[Sequence[Panel | None]]  # None leaves a position empty; the panels of a shorter row are wider
    title: str = ""  # above the panels
    heights: Sequence[float] | None = None  # relative sizes of the rows
    widths: Sequence[float] | None = None  # relative sizes of the columns
    height: float | None = None  # [inches]; default: by the number of rows
    share_x: bool = False  # whether the panels of a column share the x axis
    share_y: bool = False  # whether the panels of a row share the y axis
    legend: bool = False  # whether a legend of all labels is drawn above the panels
    footnote: str = ""

    def in_units(self, shown_units: Mapping[str, str]) -> Picture:
        """Return the picture with the axes in the requested units, by quantity."""

        def axis_in(axis: Axis) -> Axis:
            name = None if axis.quantity is None else axis.quantity.name
            return replace(axis, unit=shown_units[name]) if name is not None and name in shown_units else axis

        def panel_in(panel: Panel | None) -> Panel | None:
            if panel is None:
                return None
            values = None if panel.values is None else axis_in(panel.values)
            return replace(panel, x=axis_in(panel.x), y=axis_in(panel.y), values=values)

        return replace(self, rows=[[panel_in(each) for each in row] for row in self.rows])

    def panels(self) -> list[Panel]:
        """Return the panels, row by row."""
        return [each for row in self.rows for each in row if each is not None]


def ellipse_about(points: Floats, deviations: float) -> Floats:
    """Return the ellipse, shape (2, 121), so many standard deviations about the mean of points, shape (2, n)."""
    sizes, directions = np.linalg.eigh(np.cov(points))
    turn = np.linspace(0.0, 2.0 * np.pi, 121)
    circle = np.sqrt(np.maximum(sizes, 0.0))[:, None] * np.array([np.cos(turn), np.sin(turn)])
    return points.mean(axis=1)[:, None] + deviations * directions @ circle


def axis(name: str | None = None, label: str = "", *, like: str | None = None, **options: Any) -> Axis:
    """Return an axis of the quantity called ``name`` (or of SI unit ``like``); options are those of :class:`Axis`."""
    return Axis(None if name is None else quantity_named(name, like), label, **options)
