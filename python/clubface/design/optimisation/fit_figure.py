"""The picture of a fitting: where the shots of the best combinations land, and how far the others are behind."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure

from clubface import units
from clubface.design.optimisation.combination import Combination, told
from clubface.design.optimisation.figures import draw_landings
from clubface.design.optimisation.fitting import Fitting
from clubface.design.optimisation.fitting_run import landings
from clubface.plots.style import COLOURS, DASHES, WIDTH, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LANDINGS, BARS = 3, 10
"""The best combinations whose landings are drawn, and that are compared."""
LETTERS = 36
"""Of a line of the name of a combination."""
ERRORS = 2.0
"""Standard errors that a bar of uncertainty reaches: about 19 of 20 differences lie within."""


@styled
def fit_figure(of: Fitting, found: Sequence[Combination]) -> Figure:
    """Draw landings and ellipses of the best combinations, and how far behind the best the others are."""
    figure = Figure(figsize=(WIDTH, max(3.2, 0.8 + 0.42 * min(len(found), BARS))), layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=(1.0, 1.1))
    best = enumerate(found[:LANDINGS], 1)
    draw_landings(left, {f"{rank}": np.concatenate(landings(of, each), axis=1) for rank, each in best}, DASHES)
    _draw_bars(right, of, found[:BARS])
    return figure


def _draw_bars(axes: Axes, of: Fitting, found: Sequence[Combination]) -> None:
    judge = of.judge(of.objective)
    behind = [units.from_si(judge.sign * (each.value - found[0].value), judge.unit) for each in found]
    errors = [ERRORS * units.from_si(each.error, judge.unit) for each in found]
    colours = [COLOURS[place] if place < LANDINGS else "0.6" for place in range(len(found))]
    axes.barh(range(len(found)), behind, xerr=errors, color=colours, height=0.6, capsize=2.5,
              error_kw={"elinewidth": 0.9, "ecolor": "0.2"})  # fmt: skip
    axes.set_yticks(range(len(found)), [_label(place + 1, each) for place, each in enumerate(found)], fontsize=6.5)
    axes.set_ylim(len(found) - 0.4, -0.6)
    axes.set_xlim(left=1.05 * min(0.0, float(np.nanmin(np.subtract(behind, errors)))))
    axes.set_xlabel(f"behind the best{'' if judge.unit == '1' else f' ({judge.unit})'}")
    axes.set_title(textwrap.fill(f"By the {judge.meaning}", LETTERS))


def _label(number: int, of: Combination) -> str:
    parts = textwrap.wrap(", ".join(each for each in (of.club, of.ball, of.setting) if each), LETTERS)
    changes = textwrap.wrap(told(of.changes), LETTERS)
    return "\n".join([f"{number}: {parts[0]}", *parts[1:], *changes])
