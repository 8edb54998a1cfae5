"""The style of all pictures: fonts, lines, one colour and dash pattern per model, file formats."""

from __future__ import annotations

import io
import math
import os
from collections.abc import Callable, Iterable
from functools import cache, wraps
from pathlib import Path
from typing import IO, Any, ParamSpec, TypeVar

import matplotlib as mpl
from matplotlib.backend_bases import get_registered_canvas_class
from matplotlib.figure import Figure
from matplotlib.text import Text

from clubface import _core
from clubface.errors import LINES, InputError, legible
from clubface.support.files import whole_file

P = ParamSpec("P")
R = TypeVar("R")

COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#000000", "#E69F00", "#56B4E9", "#8C510A", "#7F7F7F")
"""One colour per model, in the order of the registry, the last for finite elements; distinguishable by colour-blind
readers (Okabe and Ito, brown and grey)."""
_FOUR: tuple[Any, ...] = ("-", (0, (5, 1.5)), (0, (1, 1.2)), (0, (5, 1.2, 1, 1.2)))
DASHES: tuple[Any, ...] = (*_FOUR, *_FOUR, (0, (9, 1.2)))
"""Dash patterns, so that models can be told apart in black and white."""
MARKERS = ("o", "s", "^", "D", "v", "P", "X", "*", "h")
ENDINGS = (".png", ".svg", ".pdf")
UNDATED: dict[str, dict[str, None]] = {"png": {}, "svg": {"Date": None}, "pdf": {"CreationDate": None}}
"""Metadata that leaves out the date in each format, so that the same figure gives the same bytes."""
POINTS = 72.0
"""Points per inch in vector formats."""
WIDTH = 7.2
"""Width of two journal columns [inches]."""

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
    """Return every matplotlib setting except the backend: its defaults, overridden by the style."""
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
    """Return the colour and dash pattern of a model's lines."""
    return {"color": COLOURS[_index(model) % len(COLOURS)], "linestyle": DASHES[_index(model) % len(DASHES)]}


def marker(model: str) -> dict[str, Any]:
    """Return the colour and shape of a model's points."""
    index = _index(model)
    return {"color": COLOURS[index % len(COLOURS)], "marker": MARKERS[index % len(MARKERS)], "linestyle": "none"}


def _index(model: str) -> int:
    known = _models()
    return known.index(model) if model in known else len(known)


@cache
def _models() -> list[str]:
    return [each["name"] for each in _core.models()]


def legend_above(figure: Figure, lines: Iterable[Any], *, title: str | None = None) -> None:
    """Put one legend and the title of the figure above all panels."""
    handles = list(lines)
    width = sum(len(str(each.get_label())) + 6 for each in handles)
    room = 110 * figure.get_figwidth() / WIDTH
    columns = math.ceil(len(handles) / max(math.ceil(len(handles) / 9), math.ceil(width / room))) if handles else 1
    legend = figure.legend(
        handles=handles, loc="outside upper left", ncols=columns, columnspacing=1.3, title=title, alignment="left"
    )
    legend.get_title().set_fontsize(8.5)


@styled
def save(figure: Figure, path: str | os.PathLike[str]) -> Path:
    """Write ``figure`` to ``path``, in the format of its ending; the same figure gives the same bytes."""
    target = Path(path)
    if target.suffix.lower() not in ENDINGS:
        raise InputError("picture", os.fspath(path), f"a file ending in {', '.join(ENDINGS)}")
    with whole_file(target) as file:
        _render(figure, file, target.suffix.lower()[1:])
    return target


def _render(figure: Figure, file: IO[Any], kind: str) -> None:
    """Draw a figure into a file.

    The canvas lays it out and draws it once; ``Figure.savefig`` would draw it twice, the first time for the layout.
    """
    _make_legible(figure)
    figure.set_dpi(mpl.rcParams["savefig.dpi"] if kind == "png" else POINTS)
    canvas = get_registered_canvas_class(kind)(figure)
    getattr(canvas, f"print_{kind}")(file, metadata=UNDATED[kind])


def _make_legible(figure: Figure) -> None:
    """Escape control characters in texts, such as names of files, clubs and players."""
    for each in figure.findobj(Text):
        if isinstance(each, Text) and (text := legible(each.get_text(), LINES)) != each.get_text():
            each.set_text(text)


@styled
def svg(figure: Figure) -> str:
    """Return ``figure`` as the text of an SVG file; the same figure gives the same text."""
    kept = io.StringIO()
    _render(figure, kept, "svg")
    return kept.getvalue()
