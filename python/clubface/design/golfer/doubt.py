"""What rests on assumed figures: how much the landings of a golfer spread if a spread of the delivery is off.

Figures are changed one at a time, and the same quasi-random shots are hit with each, so that a difference is one of the
figure and not of the sample.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from clubface.design.dispersion.sampling import dispersion
from clubface.design.golfer.golfer import ASSUMED, Golfer
from clubface.equipment.clubs import Club
from clubface.errors import InputError
from clubface.support.arrays import Floats

OFF = 0.3
"""Share by which a figure is taken to be off."""
COUNT = 2**13
"""Shots of each change; with them a standard deviation is known to about 1%, and a change of one better."""
QUANTITIES = ("carry", "side")
LEAST = 0.01
"""Least eigenvalue of correlations made stronger: what is left of a variable that all but follows from others."""


class Doubt(NamedTuple):
    """What the landings do if one figure is smaller or larger.

    Attributes
    ----------
    figure
        As :meth:`Golfer.source` names it: "spread of face", "correlation", "mishits".
    assumed
        Whether it has no published or measured source.
    spread
        Standard deviation [m] of each of ``QUANTITIES`` with the figure smaller and larger, shape (2,).
    """

    figure: str
    assumed: bool
    spread: dict[str, tuple[float, float]]


class Doubts(NamedTuple):
    """How far the spread of the landings rests on each figure.

    Attributes
    ----------
    off
        Share by which every figure is changed.
    spread
        Standard deviation [m] of each of ``QUANTITIES`` with all figures as they are.
    figures
        Each figure, the one that changes the landings most first.
    """

    off: float
    spread: dict[str, float]
    figures: tuple[Doubt, ...]

    def changes(self, of: Doubt, name: str) -> tuple[float, float]:
        """Return by which share a quantity spreads more with the figure smaller and larger; 0 if it never differs."""
        now, (less, more) = self.spread[name], of.spread[name]
        return (less / now - 1.0, more / now - 1.0) if now > 0.0 else (0.0, 0.0)


def is_assumed(golfer: Golfer, figure: str) -> bool:
    """Return whether a figure of a golfer has no published or measured source."""
    return golfer.source(figure).startswith(ASSUMED)


def doubts(golfer: Golfer, club: Club, *, off: float = OFF, count: int = COUNT) -> Doubts:
    """Hit the shots of a golfer with each spread, the correlations and the share of mishits off by ``off`` either way.

    Parameters
    ----------
    golfer, club
        Who hits what, by the default model in still air.
    off
        Share, from above 0 to below 1.
    count
        Shots of each change.
    """
    if not 0.0 < off < 1.0:
        raise InputError("off", off, "a share between 0 and 1")
    player = golfer.for_hand(club.hand)

    def spreads(of: Golfer) -> dict[str, float]:
        found = dispersion(of, club, count=count)
        return {name: found.spread(name) for name in QUANTITIES}

    figures = []
    for figure in _figures(player):
        less, more = (spreads(changed(player, figure, factor)) for factor in (1.0 - off, 1.0 + off))
        told = {name: (less[name], more[name]) for name in QUANTITIES}
        figures.append(Doubt(figure, is_assumed(golfer, figure), told))
    found = Doubts(off, spreads(player), tuple(figures))
    order = sorted(figures, key=lambda each: -max(abs(found.changes(each, name)[1]) for name in QUANTITIES))
    return found._replace(figures=tuple(order))


def changed(golfer: Golfer, figure: str, factor: float) -> Golfer:
    """Return a golfer one of whose figures is ``factor`` times as large, all others as they are."""
    if figure == "mishits":
        return golfer.replace(mishit_share=min(golfer.mishit_share * factor, 0.99))
    spread = golfer.spread
    if figure == "correlation":
        correlation = golfer.correlation * factor
        np.fill_diagonal(correlation, 1.0)
        return golfer.replace(covariance=possible(correlation) * np.outer(spread, spread))
    scale = np.where([f"spread of {name}" == figure for name in golfer.variables], factor, 1.0)
    return golfer.replace(covariance=golfer.covariance * np.outer(scale, scale))


def possible(correlation: Floats) -> Floats:
    """Return correlations that are possible together, near those given: eigenvalues are raised to ``LEAST``.

    Strong correlations made stronger may contradict each other.
    """
    values, vectors = np.linalg.eigh(correlation)
    if values[0] >= LEAST:
        return correlation
    raised = (vectors * np.maximum(values, LEAST)) @ vectors.T
    scale = np.sqrt(np.diag(raised))
    scaled = raised / np.outer(scale, scale)
    np.fill_diagonal(scaled, 1.0)
    return 0.5 * (scaled + scaled.T)


def _figures(golfer: Golfer) -> list[str]:
    found = [f"spread of {name}" for name, each in zip(golfer.variables, golfer.spread, strict=True) if each > 0.0]
    if np.count_nonzero(golfer.correlation) > len(golfer.variables):
        found.append("correlation")
    return [*found, "mishits"] if golfer.mishit_share > 0.0 else found
