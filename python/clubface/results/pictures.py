"""Pictures as specifications: panels of marks over two axes with values in SI, independent of the drawing library.

A picture describes what is drawn, not how: :mod:`clubface.present.drawing` draws it for paper and screen, the browser
with its own code. The numbers behind every mark can be saved as a table.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

from clubface.quantities import Quantity, quantity as quantity_named, unit_text

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
    """An axis of a panel.

    Attributes
    ----------
    quantity
        The quantity shown; None for names or plain numbers.
    label
        Text of the label, without the unit, which is added. Default: the label of the quantity.
    unit
        Unit in which it is drawn. Default: the golf unit of the quantity.
    limits
        Ends of the axis [SI]; None for an end chosen automatically.
    names
        Words at the positions 0, 1, 2, ... in place of numbers.
    reversed, logarithmic
        Direction and scale of the axis.
    """

    quantity: Quantity | None = None
    label: str = ""
    unit: str | None = None
    limits: tuple[float | None, float | None] = (None, None)
    names: Sequence[str] | None = None
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
    """Something drawn in a panel; see :data:`MarkKind` for the data of each kind.

    Attributes
    ----------
    label
        Entry in the legend; marks with the same label share an entry.
    style
        The name of a model, which sets colour and dash, or a number of the palette; -1 is grey, -2 black, -3 white.
    symbol
        Shape of points: "o", "s", "+", ...; "" for small dots where there are many points.
    dash
        Number of a dash pattern. Default: the dash of the style.
    hollow, faint
        Filling of points or areas.
    within
        Corners of the outline that clips a contour, shape [n, 2].
    """

    kind: MarkKind
    x: Any = None
    y: Any = None
    x0: Any = None
    x1: Any = None
    y0: Any = None
    y1: Any = None
    values: Any = None
    texts: Sequence[str] = ()
    label: str = ""
    style: str | int = 0
    symbol: str = "o"
    size: float | None = None
    dash: int | None = None
    hollow: bool = False
    faint: bool = False
    within: Any = None


@dataclass(frozen=True)
class Panel:
    """One plot of a picture.

    Attributes
    ----------
    equal
        Whether both axes have the same scale.
    aspect
        Scale of the y axis over that of the x axis. Default: free.
    values
        Axis of the colour bar of contours and cells; ``diverging`` for colours that diverge from zero.
    legend
        Whether it has a legend of its own; otherwise its marks appear in the legend of the picture.
    tall
        Whether it extends down over the empty positions below it.
    """

    marks: Sequence[Mark]
    x: Axis = field(default_factory=Axis)
    y: Axis = field(default_factory=Axis)
    title: str = ""
    equal: bool = False
    aspect: float | None = None
    values: Axis | None = None
    diverging: bool = False
    legend: bool = False
    grid: bool = True
    tall: bool = False


@dataclass(frozen=True)
class Picture:
    """A picture.

    Attributes
    ----------
    name
        Name of its file.
    caption
        Description of what it shows.
    rows
        Panels, row by row; None leaves a position empty. The panels of a shorter row are wider.
    title
        Title above the panels.
    heights, widths
        Relative sizes of rows and columns.
    height
        Height [inches]. Default: by the number of rows.
    share_x, share_y
        Whether the panels of a column share the x axis, or those of a row the y axis.
    legend
        Whether a legend of all labels is drawn above the panels.
    """

    name: str
    caption: str
    rows: Sequence[Sequence[Panel | None]]
    title: str = ""
    heights: Sequence[float] | None = None
    widths: Sequence[float] | None = None
    height: float | None = None
    share_x: bool = False
    share_y: bool = False
    legend: bool = False
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


def axis(name: str | None = None, label: str = "", *, like: str | None = None, **options: Any) -> Axis:
    """Return an axis of the quantity called ``name`` (or of SI unit ``like``); options are those of :class:`Axis`."""
    return Axis(None if name is None else quantity_named(name, like), label, **options)
