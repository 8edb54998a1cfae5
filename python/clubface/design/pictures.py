"""Pictures of designs: comparisons, dispersions, faces, golfers, best lofts, optima, fittings and searches.

The picture of an optimum: where the shots land before and after, and the front or the place within the bounds.

The picture of a fitting: where the shots of the best combinations land, and how far the others are behind.

The picture of a search: objective and limits of every design that the engine judged.
"""

from __future__ import annotations

import math
import textwrap
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from clubface import units
from clubface.design.optimisation.fitting import Combination, Fitting, told as combination_name
from clubface.design.optimisation.fitting_run import landings
from clubface.design.optimisation.landings import SHARE, own_value
from clubface.design.optimisation.study import UNITS
from clubface.design.shells.report import SHORT
from clubface.design.shells.study import QUANTITIES as SHELL_QUANTITIES
from clubface.plots import COLOURS, DASHES, WIDTH, styled

if TYPE_CHECKING:
    from clubface.design.optimisation.result import Optimum
    from clubface.design.shells.run import Improved


POINTS = 400
"""Shots of a golfer that are drawn."""
UNIT = "yd"


@styled
def optimum_figure(of: Optimum) -> Figure:
    """Draw the landings with the start and with the optimum; beside them the front, or every field in its bounds."""
    figure = Figure(figsize=(WIDTH, 3.4), layout="constrained")
    if not (of.front or any(name in of.study.bounds for name in of.club)):  # nothing has a place between bounds
        _draw_landings(figure.subplots(), of)
        return figure
    left, right = figure.subplots(1, 2, width_ratios=(1.0, 1.2))
    _draw_landings(left, of)
    if of.front:
        _draw_front(right, of)
    else:
        _draw_bounds(right, of)
    return figure


def _draw_landings(axes: Axes, of: Optimum) -> None:
    golfers = of.study.landings(of.study.shots, seed=of.study.seed + 1)
    clubs: dict[str, Any] = {"start": {}, "optimum": of.club}
    landed = {name: np.concatenate([each.of(club) for each, _ in golfers], axis=1) for name, club in clubs.items()}
    draw_landings(axes, landed, ("--", "-"))


def draw_landings(axes: Axes, landed: Mapping[str, NDArray[Any]], lines: Sequence[Any]) -> None:
    """Draw where shots come down and the ellipses that hold ``SHARE`` of them.

    Parameters
    ----------
    landed
        Carry and side [m] by what made them, each of shape (landings, shots).
    lines
        The line style of each ellipse.
    """
    ellipses: list[NDArray[Any]] = []
    for (name, values), line, colour in zip(landed.items(), lines, COLOURS, strict=False):
        side = units.from_si(values[1], UNIT)
        down = units.from_si(np.sqrt(np.maximum(values[0] ** 2 - values[1] ** 2, 0.0)), UNIT)
        axes.plot(
            side[:POINTS], down[:POINTS], ".", color=colour, markersize=2.0, alpha=0.35, markeredgewidth=0.0
        )  # fmt: skip
        ellipses.append(_ellipse(side, down))
        axes.plot(*ellipses[-1], color=colour, label=name, linestyle=line)
    # The ellipses set the frame: a topped ball far behind would make all others small.
    drawn = np.hstack(ellipses)
    middle, half = 0.5 * (drawn.min(axis=1) + drawn.max(axis=1)), 0.55 * np.ptp(drawn, axis=1).max()
    axes.set_xlim(middle[0] - half, middle[0] + half)
    axes.set_ylim(middle[1] - half, middle[1] + half)
    axes.set_aspect("equal", adjustable="box")
    axes.set_xlabel(f"side ({UNIT}), right is positive")
    axes.set_ylabel(f"distance down the line ({UNIT})")
    axes.set_title(f"Landings, with the ellipses of {SHARE:.0%}")
    axes.legend(loc="upper left", ncols=len(ellipses))


def _ellipse(side: NDArray[Any], down: NDArray[Any]) -> NDArray[Any]:
    """Return points of the ellipse that holds ``SHARE`` of normal shots with this covariance, shape (2, points)."""
    values, vectors = np.linalg.eigh(np.cov(np.array([side, down])))
    angle = np.linspace(0.0, 2.0 * math.pi, 200)
    circle = np.array([np.cos(angle), np.sin(angle)]) * math.sqrt(-2.0 * math.log1p(-SHARE))
    around = vectors @ (np.sqrt(np.maximum(values, 0.0))[:, None] * circle)
    return np.array([[side.mean()], [down.mean()]]) + around


def _draw_front(axes: Axes, of: Optimum) -> None:
    one, other = (of.study.objective(name) for name in of.study.objectives)
    values = [[units.from_si(point.values[each.name], each.unit) for point in of.front] for each in (one, other)]
    axes.plot(*values, "o-", color=COLOURS[1], label="front")
    # The start is judged on the same shots as the front only nearly: on fresh ones.
    start = [units.from_si(of.fresh.value("start", each.name), each.unit) for each in (one, other)]
    axes.plot(*start, "s", color=COLOURS[0], label="start, on fresh shots")
    for each, setter in ((one, axes.set_xlabel), (other, axes.set_ylabel)):
        setter(each.meaning if each.unit == "1" else f"{each.meaning} ({each.unit})")
    axes.set_title("Clubs than which none is better in both")
    axes.legend()


def _draw_bounds(axes: Axes, of: Optimum) -> None:
    bounds = of.study.bounds
    names = [name for name in of.club if name in bounds]
    for row, name in enumerate(names):
        low, high = bounds[name]
        start = own_value(of.study.club, name)
        place = [(value - low) / (high - low) for value in (start, of.club[name])]
        axes.plot([0.0, 1.0], [row, row], color="0.8", linewidth=3.0, solid_capstyle="round")
        for colour, value, where, below in zip(COLOURS, (start, of.club[name]), place, (True, False), strict=False):
            text = f"{units.from_si(value, UNITS[name]):.4g}"
            axes.annotate(
                text, (where, row), (0.0, -6.0 if below else 6.0), textcoords="offset points", ha="center",
                va="top" if below else "bottom", color=colour,
            )  # fmt: skip
        axes.plot(place[0], row, "s", color=COLOURS[0], label="start" if row == 0 else None)
        axes.plot(place[1], row, "o", color=COLOURS[1], label="optimum" if row == 0 else None)
    told = [f"{name}\n{units.show_range(*bounds[name], UNITS[name])}" for name in names]
    axes.set_yticks(range(len(names)), told)
    axes.set_xticks([])
    axes.set_ylim(len(names) - 0.5, -0.8)
    axes.grid(visible=False)
    axes.set_title("Place between the least and the most that is allowed")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=2)


LANDINGS, FITTING_BARS = 3, 10
"""The best combinations whose landings are drawn, and that are compared."""
LETTERS = 36
"""Of a line of the name of a combination."""
ERRORS = 2.0
"""Standard errors that a bar of uncertainty reaches: about 19 of 20 differences lie within."""


@styled
def fit_figure(of: Fitting, found: Sequence[Combination]) -> Figure:
    """Draw landings and ellipses of the best combinations, and how far behind the best the others are."""
    figure = Figure(figsize=(WIDTH, max(3.2, 0.8 + 0.42 * min(len(found), FITTING_BARS))), layout="constrained")
    left, right = figure.subplots(1, 2, width_ratios=(1.0, 1.1))
    best = enumerate(found[:LANDINGS], 1)
    draw_landings(left, {f"{rank}": np.concatenate(landings(of, each), axis=1) for rank, each in best}, DASHES)
    _draw_bars(right, of, found[:FITTING_BARS])
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
    changes = textwrap.wrap(combination_name(of.changes), LETTERS)
    return "\n".join([f"{number}: {parts[0]}", *parts[1:], *changes])


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
    words, _, unit = SHELL_QUANTITIES[found.study.objective]
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
            range(1, len(steps) + 1), shares, ".-", color=COLOURS[place % len(COLOURS)], label=SHELL_QUANTITIES[name][0]
        )
    axes.axhline(100.0, color="0.3", linewidth=1.0)
    axes.set_xlabel("design")
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set_ylabel("share of the limit (%)")
    if found.chosen.goal.limits:
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2)
