"""One published figure beside what a model computes, checks made of such figures, and the model that is judged."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from clubface import measurements
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import model as model_named
from clubface.errors import InputError, RangeWarning
from clubface.measurements import PublishedTable
from clubface.simulation.impact import impact
from clubface.simulation.launch import Launch
from clubface.simulation.outside import Tally
from clubface.support.warning import without_warnings
from clubface.tour.solved_loft import solve_loft


class Figure(NamedTuple):
    """One published figure, and what a model computes, SI.

    Attributes
    ----------
    what
        The club, shot or test it belongs to.
    quantity
        What it is, in words.
    unit
        The unit it is read in.
    published
        The least and the largest value published, infinite where there is none; twice the same for a single value.
    computed
        What the model gives; NaN if it says nothing of the quantity.
    tolerance
        How far outside the published range a model may be: in SI, or as a share of the published value.
    relative
        Whether the tolerance is a share.
    """

    what: str
    quantity: str
    unit: str
    published: tuple[float, float]
    computed: float
    tolerance: float
    relative: bool = False

    @property
    def error(self) -> float:
        """Computed less the nearest published value, SI or a share; 0 within the published range."""
        low, high = self.published
        nearest = min(max(self.computed, low), high)
        return (self.computed - nearest) / (abs(nearest) if self.relative else 1.0)

    @property
    def within(self) -> bool | None:
        """Whether the error is within the tolerance; None where the model gives nothing."""
        return None if math.isnan(self.computed) else abs(self.error) <= self.tolerance


def figure(
    what: str, quantity: str, unit: str, published: Any, computed: Any, tolerance: float, *, relative: bool = False
) -> Figure:
    """Return a figure with one published value, or a range of two."""
    ends = published if isinstance(published, tuple) else (published, published)
    return Figure(what, quantity, unit, (float(ends[0]), float(ends[1])), float(computed), tolerance, relative)


class Judged:
    """The model that is judged, with its ball.

    Attributes
    ----------
    model
        Its name.
    ball
        As for :func:`clubface.impact`.
    tally
        Counts its shots outside its range.
    """

    def __init__(
        self, model: str, ball: str | os.PathLike[str] | Ball | None = None, tally: Tally | None = None
    ) -> None:
        self.model = model
        self.ball = ball
        self.tally = tally or Tally()

    def hit(self, club: str | Club, *, parameters: dict[str, float] | None = None, **delivery: Any) -> Launch:
        """Return the launch of one shot, SI; a value that is NaN gives a launch of NaN."""
        with without_warnings(RangeWarning):
            found = impact(club, delivery, model=self.model, ball=self.ball, parameters=parameters, on_error="nan")
        self.tally.add(found)
        return found

    def loft(self, club: str, speed: float, attack: float, launch: float, high: float = 0.0) -> float:
        """Return the dynamic loft [rad] with which the model launches at an angle; NaN if no loft does."""
        try:
            return solve_loft(club, speed, attack, launch, high=high, model=self.model, ball=self.ball)
        except InputError:
            return math.nan

    def has(self, parameter: str) -> bool:
        """Return whether the model has a parameter of this name."""
        return any(each.name == parameter for each in model_named(self.model).parameters)


@dataclass(frozen=True)
class Check:
    """Published figures that belong together, and how a model is asked for them.

    Attributes
    ----------
    name
        A short name.
    title
        What is compared.
    sources
        Names of the published tables.
    reason
        Why the tolerances are what they are, and what else may part model and figures.
    compute
        Returns the figures by the model that is judged.
    """

    name: str
    title: str
    sources: tuple[str, ...]
    reason: str
    compute: Callable[[Judged], Sequence[Figure]]

    @property
    def tables(self) -> list[PublishedTable]:
        """The published tables."""
        return [measurements.table(each) for each in self.sources]
