"""The picture of a search: objective and limits of every design that the engine judged."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from clubface import units
from clubface.design.shells.study import QUANTITIES
from clubface.design.shells.words import SHORT
from clubface.plots.style import COLOURS, WIDTH, styled

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from clubface.design.shells.run import Improved

MARKS = {"start": "s", "neighbour": "^", "proposal": "o"}


@styled
def search_figure(found: Improved) -> Figure:
    """Draw the objective of every design, promised and found, and above or below the limits what it has of each."""
    figure = Figure(figsize=(WIDTH, 4.2), layout="constrained")
    left, right = figure.subplots(1, 2)
    _draw_objective(left, found)
    _draw_limits(right, found)
    return figure


def _draw_objective(axes: Axes, found: Improved) -> None:
    words, _, unit = QUANTITIES[found.study.objective]
    steps = found.chosen.found.steps
    values = [units.from_si(step.values[found.study.objective], unit) for step in steps]
    best, line = 0, []
    for number, step in enumerate(steps):
        best = number if step.accepted else best
        line.append(values[best])
    axes.step(range(1, len(steps) + 1), line, where="post", color=COLOURS[0], label="best so far")
    within = [found.chosen.goal.violation(step.values) == 0.0 for step in steps]
    for kind, mark in MARKS.items():
        for kept in (True, False):
            at = [n for n, step in enumerate(steps) if step.kind == kind and within[n] == kept]
            if at:
                axes.plot([n + 1 for n in at], [values[n] for n in at], mark, color=COLOURS[0], linestyle="none",
                          fillstyle="full" if kept else "none",
                          label=f"{kind}{'' if kept else ', beyond limits'}")  # fmt: skip
    told = [(n + 1, step.promised) for n, step in enumerate(steps) if step.promised is not None]
    if told:
        promised = [units.from_si(each[found.study.objective], unit) for _, each in told]
        axes.plot([n for n, _ in told], promised, "x", color=COLOURS[1], label="promised by the fast model")
    axes.set_xlabel("design")
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_ylabel(f"{words} ({SHORT.get(unit, unit)})")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2)


def _draw_limits(axes: Axes, found: Improved) -> None:
    steps = found.chosen.found.steps
    for place, (name, (least, most)) in enumerate(found.chosen.goal.limits.items()):
        limit = most if most < math.inf else least
        shares = [100.0 * step.values[name] / limit for step in steps]
        axes.plot(
            range(1, len(steps) + 1), shares, ".-", color=COLOURS[place % len(COLOURS)], label=QUANTITIES[name][0]
        )
    axes.axhline(100.0, color="0.3", linewidth=1.0)
    axes.set_xlabel("design")
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_ylabel("share of the limit (%)")
    if found.chosen.goal.limits:
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2)
