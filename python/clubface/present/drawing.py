"""Draws pictures from their specification, in one style, for paper and screen."""

from __future__ import annotations

import os
import textwrap
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Polygon
from matplotlib.ticker import MaxNLocator

from clubface import units
from clubface.errors import InputError
from clubface.present.style import COLOURS, DASHES, MARKERS, WIDTH, legend_above, look, marker, styled
from clubface.results.pictures import Axis, Mark, Panel, Picture
from clubface.support.files import whole_file

ROW_HEIGHT = 2.4
"""Default height of a row of panels [inches]."""
NARROW = 3.9
"""Width of a picture on a phone screen [inches]."""
AROUND = 0.7
"""Space above and below the axes of a panel for title, tick labels and axis label, which keep their size [inches]."""
LONGEST_NAMES = 60
"""Total length of the names below a panel above which they are rotated; two thirds of it in a narrow picture."""
LETTERS = {"title": 16.0, "footnote": 20.0}
"""Characters per inch in a line above or below the panels."""
_GREYS = {-1: "0.5", -2: "0.1", -3: "white"}


def draw(picture: Picture, shown_units: Mapping[str, str] | None = None) -> Figure:
    """Return a picture as a matplotlib figure; ``shown_units`` are the requested units, by quantity."""
    return _draw(picture.in_units(shown_units) if shown_units else picture, WIDTH)


def draw_narrow(picture: Picture, shown_units: Mapping[str, str] | None = None) -> Figure:
    """Return a picture for a phone screen, with its panels below each other; otherwise as :func:`draw`."""
    return _draw(_stack_panels(picture.in_units(shown_units) if shown_units else picture), NARROW)


def _height(picture: Picture) -> float:
    return picture.height or ROW_HEIGHT * len(picture.rows) + 0.4


def _stack_panels(picture: Picture) -> Picture:
    """Return a picture with one panel per row; panels keep their height, or with equal scales their aspect ratio."""
    columns = max(len(row) for row in picture.rows)
    shares = picture.heights or [1.0] * len(picture.rows)
    inches = [_height(picture) * each / sum(shares) for each in shares]
    widths = picture.widths or [1.0] * columns
    panels: list[Panel] = []
    heights: list[float] = []
    for line, row in enumerate(picture.rows):
        for place, panel in enumerate(row):
            if panel is None:
                continue
            span = columns // len(row)
            width = WIDTH * sum(widths[place * span : (place + 1) * span]) / sum(widths)
            height = inches[line]
            if panel.tall:
                height = sum(inches[line : _end_of_tall(picture.rows, line, place)])
            first = row[0]
            if first is not None and first.y.names and panel.y.names is None and (picture.share_y or not panel.y.ticks):
                panel = replace(panel, y=first.y)  # side by side, this panel shared the names of the first one
            panels.append(panel)
            around = min(AROUND, height)
            heights.append(around + (height - around) * min(1.0, NARROW / width) if panel.equal else height)
    stack = [[each] for each in panels]
    return replace(picture, rows=stack, heights=heights, widths=None, height=sum(heights), share_x=False, share_y=False)


def _end_of_tall(rows: Sequence[Sequence[Panel | None]], line: int, place: int) -> int:
    """Return the row after the last one that a tall panel spans."""
    below = line + 1
    while below < len(rows) and len(rows[below]) > place and rows[below][place] is None:
        below += 1
    return below


class _RoundedLayout(ConstrainedLayoutEngine):
    """Constrained layout to 1e-9 of the figure.

    The order of its equations, and with it the last digits of positions, depends on memory addresses.
    """

    def execute(self, fig: Any) -> None:
        super().execute(fig)
        for axes in fig.axes:
            axes.set_position(np.round(axes.get_position(original=True).bounds, 9))
            axes.set_in_layout(True)


@styled
def _draw(picture: Picture, width: float) -> Figure:
    rows = [list(each) for each in picture.rows]
    columns = max(len(row) for row in rows)
    figure = Figure(figsize=(width, _height(picture)), layout=_RoundedLayout())
    grid = figure.add_gridspec(len(rows), columns, height_ratios=picture.heights, width_ratios=picture.widths)
    first_of_row: dict[int, Axes] = {}
    first_of_column: dict[int, Axes] = {}
    for line, row in enumerate(rows):
        bars: dict[int, list[tuple[Axes, Any, Panel]]] = {}
        for place, panel in enumerate(row):
            if panel is None:
                continue
            span = columns // len(row)
            shared = {
                "sharex": first_of_column.get(place) if picture.share_x and span == 1 else None,
                "sharey": first_of_row.get(line) if picture.share_y else None,
            }
            below = _end_of_tall(rows, line, place) if panel.tall else line + 1
            axes = figure.add_subplot(grid[line:below, place * span : (place + 1) * span], **shared)
            first_of_row.setdefault(line, axes)
            first_of_column.setdefault(place, axes)
            fixed = panel.values is not None and None not in panel.values.limits
            bars.setdefault(id(panel.values if fixed else panel), []).append((axes, _draw_panel(axes, panel), panel))
            if picture.share_x and any(len(below) > place and below[place] is not None for below in rows[line + 1 :]):
                axes.set_xlabel("")
                axes.tick_params(labelbottom=False)
            if picture.share_y and first_of_row[line] is not axes:
                axes.set_ylabel("")
                axes.tick_params(labelleft=False)
        for group in bars.values():  # panels with a common axis of values share a colour bar
            every, (shown, *_), (panel, *_) = zip(*group, strict=True)
            if shown is not None and panel.values is not None:
                bar = figure.colorbar(shown, ax=list(every), fraction=0.05, pad=0.01)
                bar.set_label(panel.values.heading)
    _head(figure, picture)
    return figure


@styled
def animate(pictures: Sequence[Picture], path: str | os.PathLike[str], *, seconds: float = 5.0) -> Path:
    """Write pictures of the same panels as an animated GIF and return its path."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    target = Path(path)
    if target.suffix.lower() != ".gif":
        raise InputError("animation", os.fspath(path), "a file ending in .gif")
    figure = draw(pictures[0])
    figure.set_dpi(100)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    figure.set_layout_engine("none")  # the positions of the panels stay fixed
    panels = [axes for axes in figure.axes if axes.get_label() != "<colorbar>"]
    images = []
    for picture in pictures:
        for axes, panel in zip(panels, picture.panels(), strict=True):
            axes.clear()
            _draw_panel(axes, panel)
        canvas.draw()
        images.append(Image.fromarray(np.array(canvas.buffer_rgba())[..., :3]).quantize(colors=96))
    pace = max(20, round(1e3 * seconds / len(images)))
    with whole_file(target) as file:
        images[0].save(file, format="gif", save_all=True, append_images=images[1:], duration=pace, loop=0)
    return target


def picture_data(picture: Picture) -> tuple[list[str], list[list[Any]]]:
    """Return the numbers behind a picture as headings and rows, one row per point of every mark."""
    headings = ["panel", "mark", "x", "y", "low", "high", "value", "x unit", "y unit"]
    rows = []
    for number, panel in enumerate(picture.panels(), 1):
        name = panel.title or panel.y.heading or str(number)
        for mark in panel.marks:
            if mark.kind in ("rule", "slope", "text", "shade"):
                continue
            for point in _points(mark, panel):
                rows.append([name, mark.label or mark.kind, *point, panel.x.unit_drawn, panel.y.unit_drawn])
    return headings, rows


def _points(mark: Mark, panel: Panel) -> Iterator[list[Any]]:
    """Yield x, y, low, high and value of every point of a mark, in the units of the axes."""
    mark = _scaled(mark, panel)
    low, high = (mark.y0, mark.y1) if mark.x0 is None else (mark.x0, mark.x1)
    parts = [mark.x, mark.y, low, high, mark.values]
    if mark.kind == "contour":
        x, y = np.meshgrid(parts[0], parts[1])
        parts[0], parts[1] = x, y
    arrays = [None if each is None else np.ravel(each) for each in parts]
    length = max((each.size for each in arrays if each is not None), default=0)
    for index in range(length):
        yield [None if each is None or index >= each.size else each[index].item() for each in arrays]


def _scaled(mark: Mark, panel: Panel) -> Mark:
    """Return a mark with its numbers in the units in which the axes of its panel are drawn."""
    axes = {"x": panel.x, "y": panel.y, "values": panel.values or Axis()}
    names = ("x", "x0", "x1", "y", "y0", "y1", "values")
    return replace(mark, **{name: _scale(getattr(mark, name), axes[name.rstrip("01")]) for name in names})


def _scale(values: Any, axis: Axis) -> Any:
    """Convert SI values to the unit in which an axis is drawn."""
    if values is None:
        return None
    array = np.asarray(values, dtype=float)
    return array if axis.unit_drawn == "1" else np.asarray(units.from_si(array, axis.unit_drawn), dtype=float)


def _draw_panel(axes: Axes, panel: Panel) -> Any:
    """Draw a panel; return its colour scale, if it has one."""
    axes.grid(visible=panel.grid)
    floor: dict[str, Any] = {}
    for mark in panel.marks:
        _DRAWERS[mark.kind](axes, panel, _scaled(mark, panel), floor)
    for axis, setter in ((panel.x, "x"), (panel.y, "y")):
        _set_axis(axes, axis, setter)
    if panel.aspect is not None:
        axes.set_aspect(panel.aspect)
    if panel.equal:
        axes.set_aspect("equal", adjustable="datalim" if panel.x.limits == (None, None) else "box")
    axes.set_title(panel.title)
    if panel.legend:
        handles, labels = axes.get_legend_handles_labels()
        once = dict(zip(labels, handles, strict=True))
        axes.legend(once.values(), once.keys(), ncols=1 + (len(once) > 4))
    return floor.get("coloured")


def _set_axis(axes: Axes, axis: Axis, name: str) -> None:
    if axis.logarithmic:
        getattr(axes, f"set_{name}scale")("log")
    getattr(axes, f"set_{name}label")(axis.heading)
    low, high = (None if each is None else float(_scale(each, axis)) for each in axis.limits)
    if low is not None or high is not None:
        getattr(axes, f"set_{name}lim")(low, high)
    if axis.names is not None:
        narrow = axes.figure.get_figwidth() < WIDTH  # pyright: ignore[reportAttributeAccessIssue]
        long = name == "x" and sum(map(len, axis.names)) > LONGEST_NAMES * (2 / 3 if narrow else 1)
        turned = {"rotation": 35, "ha": "right"} if long else {}
        getattr(axes, f"set_{name}ticks")(range(len(axis.names)), axis.names, **turned)
        axes.grid(visible=False, axis=name)  # pyright: ignore[reportArgumentType]
    if not axis.ticks:
        getattr(axes, f"set_{name}ticks")([])
    if axis.reversed and not getattr(axes, f"{name}axis_inverted")():
        getattr(axes, f"invert_{name}axis")()


def _head(figure: Figure, picture: Picture) -> None:
    if picture.legend:
        handles: dict[str, Any] = {}
        for panel in picture.panels():
            for mark in panel.marks:
                if mark.label and not panel.legend:
                    handles.setdefault(mark.label, _key(mark))
        legend_above(figure, handles.values(), title=_broken(figure, "title", picture.title) or None)
    elif picture.title:
        figure.suptitle(_broken(figure, "title", picture.title), fontsize=8.5, x=0.01, ha="left")
    if picture.footnote:
        figure.supxlabel(_broken(figure, "footnote", picture.footnote), fontsize=7.0, color="0.35")


def _broken(figure: Figure, place: str, text: str) -> str:
    """Wrap a text to the width of the figure."""
    return "\n".join(textwrap.fill(line, int(LETTERS[place] * figure.get_figwidth())) for line in text.split("\n"))


def _key(mark: Mark) -> Any:
    """Return the legend entry of a mark."""
    if mark.kind in ("bars", "area", "stack", "band", "steps", "shade"):
        return Patch(facecolor=_colour(mark), alpha=0.6, label=mark.label)
    if mark.kind == "points" or (mark.kind == "intervals" and mark.symbol):
        return Line2D([], [], label=mark.label, **_point_look(mark))
    return Line2D([], [], label=mark.label, **_line_look(mark))


def _colour(mark: Mark) -> str:
    if isinstance(mark.style, str):
        return look(mark.style)["color"]
    return _GREYS.get(mark.style) or COLOURS[mark.style % len(COLOURS)]


def _line_look(mark: Mark) -> dict[str, Any]:
    if isinstance(mark.style, str) and mark.dash is None:
        return look(mark.style) | ({"linewidth": mark.size} if mark.size else {})
    dash = (
        mark.dash if mark.dash is not None else (mark.style if isinstance(mark.style, int) and mark.style >= 0 else 0)
    )
    return {"color": _colour(mark), "linestyle": DASHES[dash % len(DASHES)]} | (
        {"linewidth": mark.size} if mark.size else {}
    )


def _point_look(mark: Mark) -> dict[str, Any]:
    if not mark.symbol:
        return {
            "color": _colour(mark), "marker": ".", "linestyle": "none", "markersize": mark.size or 2.0,
            "alpha": 0.4, "markeredgewidth": 0.0,
        }  # fmt: skip
    shape = marker(mark.style)["marker"] if isinstance(mark.style, str) and mark.symbol == "o" else mark.symbol
    shape = MARKERS[int(shape) % len(MARKERS)] if shape.isdigit() else shape
    filled = {"markerfacecolor": "white"} if mark.hollow else {}
    faint = {"alpha": 0.7} if mark.faint else {}
    size = {"markersize": mark.size} if mark.size else {}
    return {"color": _colour(mark), "marker": shape, "linestyle": "none", **filled, **faint, **size}


def _line(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    axes.plot(mark.x, mark.y, label=mark.label or None, **_line_look(mark))


def _draw_points(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    if mark.values is not None:
        extent = _extent(mark, panel)
        floor["coloured"] = axes.scatter(mark.x, mark.y, c=mark.values, s=mark.size or 9.0, linewidths=0, **extent)
        return
    axes.plot(mark.x, mark.y, label=mark.label or None, rasterized=np.size(mark.x) > 500, **_point_look(mark))
    for at, up, words in zip(np.ravel(mark.x), np.ravel(mark.y), mark.texts, strict=False):
        axes.annotate(words, (at, up), (3.0, 3.0), textcoords="offset points", fontsize=7.0)


def _bars(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    left = 0.0 if mark.x0 is None else mark.x0
    bars = axes.barh(mark.y, mark.x - left, left=left, height=mark.size or 0.7, color=_colour(mark),
                     alpha=0.6 if mark.faint else 1.0, linewidth=0.0, label=mark.label or None)  # fmt: skip
    if mark.texts:
        axes.bar_label(bars, mark.texts, padding=2.0, fontsize=7.0)


def _intervals(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    errors: dict[str, Any] = {}
    for name, centre, low, high in (("xerr", mark.x, mark.x0, mark.x1), ("yerr", mark.y, mark.y0, mark.y1)):
        if low is not None:
            errors[name] = np.abs([centre - low, high - centre])
    appearance = _point_look(mark) if mark.symbol else {"fmt": "none", "ecolor": _colour(mark)}
    axes.errorbar(mark.x, mark.y, capsize=2.0, elinewidth=0.8, label=mark.label or None, **appearance, **errors)


def _band(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    look = {"color": _colour(mark), "alpha": 0.25, "linewidth": 0.0}
    axes.fill_between(mark.x, mark.y0, mark.y1, label=mark.label or None, **look)


def _area(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    look = {"color": _colour(mark), "alpha": 0.3 if mark.faint else 0.75, "linewidth": 0.0}
    axes.fill(mark.x, mark.y, label=mark.label or None, **look)


def _stack(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    below = floor.get("stack", np.zeros_like(mark.y))
    floor["stack"] = below + mark.y
    look = {"color": _colour(mark), "alpha": 0.75, "linewidth": 0.0}
    axes.fill_between(mark.x, below, floor["stack"], label=mark.label or None, **look)


def _steps(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    axes.stairs(mark.y, mark.x, fill=True, color=_colour(mark), alpha=0.6, label=mark.label or None)


def _contour(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    """Fill between round contour levels, clipped to an outline if there is one."""
    low, high = _ends(mark, panel)
    if not high - low > 1e-9 * max(abs(low), abs(high), 1e-9):
        low, high = low - 0.5, high + 0.5
    levels = MaxNLocator(11).tick_values(low, high)
    extent = _extent(mark, panel, (levels[0], levels[-1]))
    values = np.ma.masked_invalid(np.clip(mark.values, levels[0], levels[-1]))
    shown = axes.contourf(mark.x, mark.y, values, levels=levels, **extent)
    lines = axes.contour(mark.x, mark.y, values, levels=levels[1:-1], colors="0.15", linewidths=0.4)
    if mark.within is not None:
        corners = np.asarray(mark.within)
        points = np.column_stack([_scale(corners[:, 0], panel.x), _scale(corners[:, 1], panel.y)])
        cut = Polygon(points, facecolor="none", edgecolor="none", transform=axes.transData)
        axes.add_patch(cut)
        for each in (shown, lines):
            each.set_clip_path(cut)
    floor["coloured"] = shown


def _cells(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    corners = np.stack([mark.x, mark.y], axis=-1)
    if mark.values is None:
        fill: dict[str, Any] = {"facecolors": _colour(mark)}
    else:
        extent = _extent(mark, panel)
        fill = {"array": np.ravel(mark.values), "cmap": extent["cmap"], "clim": (extent["vmin"], extent["vmax"])}
    shown = axes.add_collection(PolyCollection(list(corners), edgecolors="0.35", linewidths=0.25, **fill))
    if mark.values is not None:
        floor["coloured"] = shown
    axes.autoscale_view()


def _outline(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    shape = {key: each for key, each in _line_look(mark).items() if key != "color"}
    corners = np.column_stack([mark.x, mark.y])
    axes.add_patch(Polygon(corners, fill=False, edgecolor=_colour(mark), label=mark.label or None, **shape))
    axes.autoscale_view()


def _rule(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    thin = {"color": _colour(mark), "linewidth": mark.size or 0.7, "linestyle": DASHES[mark.dash or 0], "zorder": 1}
    for each in np.atleast_1d(mark.x) if mark.x is not None else ():
        axes.axvline(float(each), **thin)
    for each in np.atleast_1d(mark.y) if mark.y is not None else ():
        axes.axhline(float(each), **thin)


def _slope(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    thin = {"color": _colour(mark), "linewidth": 0.8, "linestyle": DASHES[mark.dash or 0]}
    axes.axline((float(mark.x), float(mark.y)), slope=float(mark.values), **thin)


def _text(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    """Write texts at their positions, or in the middle of an otherwise empty panel."""
    if mark.x is None:
        axes.set_axis_off()
        axes.text(0.5, 0.5, "\n".join(mark.texts), transform=axes.transAxes, ha="center", va="center",
                  fontsize=mark.size or 7.5)  # fmt: skip
        return
    for at, up, words in zip(np.ravel(mark.x), np.ravel(mark.y), mark.texts, strict=True):
        axes.text(float(at), float(up), words, ha="center", va="center", color=_colour(mark), fontsize=mark.size or 7.0)


def _shade(axes: Axes, panel: Panel, mark: Mark, floor: dict[str, Any]) -> None:
    axes.axvspan(float(mark.x0), float(mark.x1), color="0.80", zorder=0, linewidth=0.0)


def _ends(mark: Mark, panel: Panel) -> tuple[float, float]:
    """Return the smallest and the largest value of a mark, unless its value axis has limits."""
    axis, values = panel.values or Axis(), mark.values
    low, high = (None if each is None else float(_scale(each, axis)) for each in axis.limits)
    finite = values[np.isfinite(values)]
    low = low if low is not None else float(finite.min(initial=np.inf) if finite.size else 0.0)
    return low, high if high is not None else float(finite.max(initial=-np.inf) if finite.size else 1.0)


def _extent(mark: Mark, panel: Panel, ends: tuple[float, float] | None = None) -> dict[str, Any]:
    """Return the colour map and its limits."""
    low, high = ends or _ends(mark, panel)
    if panel.diverging:
        most = max(abs(low), abs(high), 1e-12)
        low, high = -most, most
    return {"cmap": "RdBu_r" if panel.diverging else "viridis", "vmin": low, "vmax": high}


_DRAWERS: dict[str, Callable[[Axes, Panel, Mark, dict[str, Any]], None]] = {
    "line": _line, "points": _draw_points, "bars": _bars, "intervals": _intervals, "band": _band, "area": _area,
    "stack": _stack, "steps": _steps, "contour": _contour, "cells": _cells, "outline": _outline, "rule": _rule,
    "slope": _slope, "text": _text, "shade": _shade,
}  # fmt: skip
