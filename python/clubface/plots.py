"""Pictures for papers: force histories, trajectories, a whole shot, and the style of every other figure.

Every function returns a matplotlib ``Figure``; :func:`save` writes it as PNG, SVG or PDF by the file's ending.

How all pictures look: type, lines, one colour and dash a model, files.

One shot by one or several models: the forces during contact, and the flight.
"""

from __future__ import annotations

import io
import math
import os
import textwrap
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import wraps
from pathlib import Path
from typing import Any, NamedTuple, ParamSpec, TypeVar

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.text import Text

from clubface import units
from clubface.equipment.models import models
from clubface.errors import LINES, InputError, legible
from clubface.support.files import whole_file

P = ParamSpec("P")
R = TypeVar("R")

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00", "#56B4E9", "#8C510A", "#7F7F7F")
"""One a model, in the order of the registry, the last for finite elements; colour-blind readers tell them apart (Okabe
and Ito, brown and grey)."""
_FOUR: tuple[Any, ...] = ("-", (0, (5, 1.5)), (0, (1, 1.2)), (0, (5, 1.2, 1, 1.2)))
DASHES: tuple[Any, ...] = (*_FOUR, *_FOUR, (0, (9, 1.2)))
"""So that a print without colour keeps them apart."""
MARKERS = ("o", "s", "^", "D", "v", "P", "X", "*", "h")
ENDINGS = (".png", ".svg", ".pdf")
WIDTH = 7.2
"""Inches: two columns of a journal."""

_STYLE: dict[Any, Any] = {
    "font.size": 8.0,
    "axes.titlesize": 8.0,
    "axes.labelsize": 8.0,
    "legend.fontsize": 7.5,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.6,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "0.90",
    "grid.linewidth": 0.5,
    "lines.linewidth": 1.3,
    "lines.markersize": 4.0,
    "legend.frameon": False,
    "legend.handlelength": 1.8,
    "legend.handletextpad": 0.5,
    "figure.dpi": 100.0,
    "savefig.dpi": 300.0,
    "text.parse_math": False,  # a dollar sign in the name of a club or golfer is no formula
    "svg.fonttype": "path",
    "svg.hashsalt": "clubface",
    "pdf.fonttype": 42,
}


def _settings() -> dict[Any, Any]:
    """Return every setting but the backend: matplotlib's own defaults, and the style over them."""
    defaults = {key: value for key, value in mpl.rcParamsDefault.items() if key != "backend"}
    return {**defaults, **_STYLE}


def styled(draw: Callable[P, R]) -> Callable[P, R]:
    """Draw in the common style, leaving the caller's matplotlib settings alone."""

    @wraps(draw)
    def wrapped(*args: P.args, **kwargs: P.kwargs) -> R:
        with mpl.rc_context(_settings()):
            return draw(*args, **kwargs)

    return wrapped


def look(model: str) -> dict[str, Any]:
    """Return colour and dash of a model's lines."""
    return {"color": COLOURS[_index(model) % len(COLOURS)], "linestyle": DASHES[_index(model) % len(DASHES)]}


def marker(model: str) -> dict[str, Any]:
    """Return colour and shape of a model's points."""
    index = _index(model)
    return {"color": COLOURS[index % len(COLOURS)], "marker": MARKERS[index % len(MARKERS)], "linestyle": "none"}


def _index(model: str) -> int:
    known = list(models())
    return known.index(model) if model in known else len(known)


def legend_above(figure: Figure, lines: Iterable[Any], *, title: str | None = None) -> None:
    """Put one legend, with the title of the figure, above all panels, where it covers nothing."""
    handles = list(lines)
    width = sum(len(str(each.get_label())) + 6 for each in handles)
    columns = math.ceil(len(handles) / max(math.ceil(len(handles) / 9), math.ceil(width / 110))) if handles else 1
    legend = figure.legend(
        handles=handles, loc="outside upper left", ncols=columns, columnspacing=1.3, title=title, alignment="left"
    )
    legend.get_title().set_fontsize(8.5)


def check_ending(path: str | os.PathLike[str]) -> Path:
    """Refuse a picture whose ending is not one of ``ENDINGS``."""
    target = Path(path)
    if target.suffix.lower() not in ENDINGS:
        raise InputError("picture", os.fspath(path), f"a file ending in {', '.join(ENDINGS)}")
    return target


@styled
def save(figure: Figure, path: str | os.PathLike[str]) -> Path:
    """Write ``figure`` to ``path``, in the format of its ending; the same figure gives the same bytes."""
    target = check_ending(path)
    dates = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}, ".png": {}}
    kind = target.suffix.lower()
    _make_legible(figure)
    with whole_file(target) as file:
        figure.savefig(file, format=kind[1:], metadata=dates[kind])
    return target


def _make_legible(figure: Figure) -> None:
    """Write out the characters of names of files, clubs and players that no picture should get."""
    for each in figure.findobj(Text):
        if isinstance(each, Text) and (text := legible(each.get_text(), LINES)) != each.get_text():
            each.set_text(text)


@styled
def svg(figure: Figure) -> str:
    """Return ``figure`` as the text of an SVG file; the same figure gives the same text."""
    _make_legible(figure)
    kept = io.StringIO()
    figure.savefig(kept, format="svg", metadata={"Date": None})
    return kept.getvalue()


FORCES = {
    "normal_force": "normal force (kN)",
    "force_y": "friction along y' (kN)",
    "force_z": "friction along z' (kN)",
}
"""Columns of a history and their axis labels; y' points up the face, z' to the toe."""

_FLATTEST, _TALLEST = 0.11, 0.5
"""Height over width of a view: below the first it is stretched, above the second it does not fill the width."""
_VIEW_WIDTH = WIDTH - 0.7
"""Inches, about."""
_TITLE_LETTERS = 95
"""In a line of the title."""


@styled
def force_histories(histories: Mapping[str, Any]) -> Figure:
    """Draw the force on the ball over time, normal and along the face, one line a model.

    Parameters
    ----------
    histories
        A :class:`clubface.History` (or its columns by name) for each model.
    """
    figure = Figure(figsize=(WIDTH, 2.5), layout="constrained")
    _draw_forces(figure.subplots(1, len(FORCES)), histories)
    legend_above(figure, _keys(histories))
    return figure


@styled
def trajectories(flights: Mapping[str, Any]) -> Figure:
    """Draw flights from the side and from above.

    Parameters
    ----------
    flights
        For each model (or other name) the positions of the ball [m], shape [n, 3], axes x, y, z.
    """
    return _figure(flights, {}, "")


@styled
def shot_figure(flights: Mapping[str, Any], histories: Mapping[str, Any] | None = None, *, title: str = "") -> Figure:
    """Draw one shot: forces above, the flight from the side and from above below.

    Models without a history are left out of the panels of force, which a line below says.

    Parameters
    ----------
    flights
        As :func:`trajectories`.
    histories
        As :func:`force_histories`; may be empty.
    title
        What was hit and how.
    """
    return _figure(flights, histories or {}, title)


class _View(NamedTuple):
    """One projection of the flights.

    Attributes
    ----------
    name
        For its heading.
    axis
        The coordinate drawn upwards: 1 (height) or 2 (right of the target).
    limits
        Of that coordinate [yd], from the lower edge to the upper.
    stretch
        By how much its scale exceeds that of the distance.
    shape
        Height over width of the panel.
    """

    name: str
    axis: int
    limits: tuple[float, float]
    stretch: float
    shape: float


def _figure(flights: Mapping[str, Any], histories: Mapping[str, Any], title: str) -> Figure:
    flights = {name: units.from_si(np.asarray(each, dtype=float), "yd") for name, each in flights.items()}
    positions = np.concatenate(list(flights.values()))
    length = 1.03 * max(float(positions[:, 0].max()), 1.0)
    margin = 0.06 * float(np.ptp(positions[:, 2])) + 0.5
    right, left = max(float(positions[:, 2].max()), 0.0), min(float(positions[:, 2].min()), 0.0)
    views = (
        _view("from the side", 1, (0.0, 1.06 * max(float(positions[:, 1].max()), 0.5)), length),
        _view("from above", 2, (right + margin, left - margin), length),
    )
    heights = [each.shape * _VIEW_WIDTH for each in views]
    forces = 2.2 if histories else 0.0
    lines = textwrap.wrap(title, _TITLE_LETTERS)
    figure = Figure(figsize=(WIDTH, forces + sum(heights) + 1.35 + 0.18 * len(lines)), layout="constrained")
    if histories:
        parts: Any = figure.subfigures(2, 1, height_ratios=[forces, sum(heights) + 0.95])
        top, bottom = parts
        _draw_forces(top.subplots(1, len(FORCES)), histories)
        without = [name for name in flights if name not in histories]
        if without:
            top.supxlabel(f"no force history (impulse models): {', '.join(without)}", fontsize=7.0, color="0.35")
    else:
        bottom = figure
    for axes, view in zip(bottom.subplots(2, 1, height_ratios=heights, sharex=True), views, strict=True):
        _draw_view(axes, view, flights, length)
    legend_above(figure, _keys(flights), title="\n".join(lines) or None)
    return figure


def _view(name: str, axis: int, limits: tuple[float, float], length: float) -> _View:
    span, stretch = abs(limits[1] - limits[0]), 1.0
    steps = iter((2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0))
    while span * stretch < _FLATTEST * length:
        stretch = next(steps, _FLATTEST * length / span + 1.0)
    return _View(name, axis, limits, stretch, min(span * stretch / length, _TALLEST))


def _draw_forces(panels: Sequence[Axes], histories: Mapping[str, Any]) -> None:
    for axes, (column, label) in zip(panels, FORCES.items(), strict=True):
        for model, history in histories.items():
            axes.plot(
                units.from_si(_column(history, "time"), "us"),
                units.from_si(_column(history, column), "kN"),
                **look(model),
            )
        axes.set(xlabel="time (µs)", ylabel=label)
        axes.set_xlim(left=0.0)
        if column == "normal_force":
            axes.set_ylim(bottom=0.0)
            continue
        axes.axhline(0.0, color="0.5", linewidth=0.6, zorder=1)
        low, high = axes.get_ylim()
        if high - low < _LEAST_FORCE:
            axes.set_ylim(-_LEAST_FORCE / 2.0, _LEAST_FORCE / 2.0)


_LEAST_FORCE = 0.04
"""kN over which an axis of friction extends at least, so that noise does not fill a panel."""


def _draw_view(axes: Axes, view: _View, flights: Mapping[str, Any], length: float) -> None:
    for name, points in flights.items():
        axes.plot(points[:, 0], points[:, view.axis], **look(name))
    axes.set_xlim(0.0, length)
    axes.set_ylim(*view.limits)
    axes.set_aspect(view.stretch)
    scale = "equal scales" if view.stretch == 1.0 else f"stretched {view.stretch:g} times sideways"
    axes.set_title(f"{view.name}, {scale if view.axis == 2 else scale.replace('sideways', 'upwards')}")
    if view.axis == 1:
        axes.set_ylabel("height (yd)")
        return
    axes.axhline(0.0, color="0.5", linewidth=0.6, zorder=1)
    axes.set(xlabel="distance along the target line (yd)", ylabel="right (yd)")


def _keys(names: Iterable[str]) -> list[Line2D]:
    return [Line2D([], [], label=name, **look(name)) for name in names]


def _column(history: Any, name: str) -> Any:
    return np.asarray(history[name] if isinstance(history, Mapping) else getattr(history, name), dtype=float)
