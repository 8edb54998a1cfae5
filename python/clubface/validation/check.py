"""Published figures with a model's values, checks made of such figures, and the model under test."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

from clubface import published_data
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import model as model_named
from clubface.errors import RangeWarning
from clubface.published_data import PublishedTable
from clubface.quantities import Quantity, Reading, quantity as quantity_named
from clubface.simulation.impact import Tally, impact
from clubface.simulation.launch import Launch
from clubface.simulation.launch_conditioned import impact_at_launch
from clubface.support.checks import without_warnings

A_MODEL = "a model"
CERTAINTIES = {
    "good": "measured, under conditions that are stated",
    "fair": "measured, but head, ball, strike or another condition that matters is assumed",
    "poor": "measured, but on few shots, read at second hand, or with most conditions assumed",
    A_MODEL: "computed by another model, whose agreement is no proof",
}
"""Reliability of a published figure for testing a model: words and their meaning."""
SHARE = Quantity("share", "1", Reading("%", 1), Reading("%", 1), "share")
"""Errors and tolerances relative to the published value."""
READINGS = {
    "mph": "ball_speed", "deg": "launch", "rpm": "spin", "yd": "carry", "mm": "toe", "us": "contact_time",
    "1": "restitution", "%": "",
}  # fmt: skip
"""Quantities for formatting figures, by unit; a share for per cent."""


def reading(unit: str) -> Quantity:
    """Return the quantity for formatting figures with this unit."""
    return quantity_named(READINGS[unit]) if READINGS[unit] else SHARE


class Figure(NamedTuple):
    """One published figure and the model's value, in SI units.

    Attributes
    ----------
    case
        The club, shot or test it belongs to.
    quantity
        Name of the quantity, in words.
    unit
        Unit for display.
    published
        Smallest and largest value compatible with the publication (infinite for no bound): a published range, an
        average with what it leaves open (:mod:`clubface.validation.launches`), or a single value twice.
    computed
        The model's value; NaN if it does not compute the quantity.
    tolerance
        Allowed distance from the published range, in SI or relative to the published value.
    relative
        Whether the tolerance is relative.
    certainty
        Reliability of the published figure, one of ``CERTAINTIES``; empty until filled in by its check.
    """

    case: str
    quantity: str
    unit: str
    published: tuple[float, float]
    computed: float
    tolerance: float
    relative: bool = False
    certainty: str = ""

    @property
    def error_unit(self) -> str:
        """Unit of errors and tolerances for display."""
        return "%" if self.relative else self.unit

    @property
    def error(self) -> float:
        """Computed value minus the nearest published value, in SI or relative; 0 within the published range."""
        low, high = self.published
        nearest = min(max(self.computed, low), high)
        return (self.computed - nearest) / (abs(nearest) if self.relative else 1.0)

    @property
    def inside(self) -> bool | None:
        """Whether the value lies in the published interval; None without a value, or if a single value is published."""
        low, high = self.published
        return None if math.isnan(self.computed) or low == high else low <= self.computed <= high

    @property
    def within(self) -> bool | None:
        """Whether the error is within the tolerance; None if the model gives no value."""
        return None if math.isnan(self.computed) else abs(self.error) <= self.tolerance


def figure(
    case: str, quantity: str, unit: str, published: Any, computed: Any, tolerance: float, *, relative: bool = False
) -> Figure:
    """Return a figure with one published value, or a range of two."""
    ends = published if isinstance(published, tuple) else (published, published)
    return Figure(case, quantity, unit, (float(ends[0]), float(ends[1])), float(computed), tolerance, relative)


class ModelUnderTest:
    """The model under test, with its ball; ``tally`` counts shots outside the model's range."""

    def __init__(
        self, model: str, ball: str | os.PathLike[str] | Ball | None = None, tally: Tally | None = None
    ) -> None:
        self.model = model
        self.ball = ball
        self.tally = tally or Tally()

    def strike(self, club: str | Club, *, parameters: dict[str, float] | None = None, **delivery: Any) -> Launch:
        """Return the launch of one shot [SI]; NaN inputs give a NaN launch."""
        with without_warnings(RangeWarning):
            result = impact(club, delivery, model=self.model, ball=self.ball, parameters=parameters, on_error="nan")
        self.tally.add(result)
        return result

    def at_launch(self, club: str | Club, launch: Any, **delivery: Any) -> Launch:
        """Return shots with given launch angles [rad], by solving for dynamic loft; NaN if no loft gives it."""
        with without_warnings(RangeWarning):
            result = impact_at_launch(club, delivery, launch=launch, model=self.model, ball=self.ball).launch
        self.tally.add(result)
        return result

    def has(self, parameter: str) -> bool:
        """Return whether the model has a parameter of this name."""
        return any(each.name == parameter for each in model_named(self.model).parameters)


@dataclass(frozen=True)
class Check:
    """Published figures that belong together, and the function that computes them with a model.

    Attributes
    ----------
    title
        What is compared.
    sources
        Names of the published tables.
    reason
        Reason for the tolerances, and other causes of differences.
    certainty
        Reliability of its published figures, one of ``CERTAINTIES``.
    compute
        Returns the figures for the model under test.
    """

    name: str
    title: str
    sources: tuple[str, ...]
    reason: str
    certainty: str
    compute: Callable[[ModelUnderTest], Sequence[Figure]]

    @property
    def tables(self) -> list[PublishedTable]:
        """The published tables."""
        return [published_data.table(each) for each in self.sources]

    @property
    def measured(self) -> bool:
        """Whether the figures were measured; figures from another model are shown but not counted."""
        return self.certainty != A_MODEL

    def figures(self, judged: ModelUnderTest) -> list[Figure]:
        """Return the figures for the model under test, with their reliability."""
        return [each._replace(certainty=each.certainty or self.certainty) for each in self.compute(judged)]


def rows(table: str) -> Iterable[dict[str, Any]]:
    """Return the rows of a published table, numbers in SI."""
    columns = {name: values.tolist() for name, values in published_data.table(table).columns.items()}
    return [dict(zip(columns, cells, strict=True)) for cells in zip(*columns.values(), strict=True)]
