"""Running checks on models."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import product
from statistics import median
from typing import NamedTuple

from clubface.equipment.balls import Ball, ball as ball_named
from clubface.equipment.models import DEFAULT_MODEL, model as model_named
from clubface.errors import InputError
from clubface.results.result import Described, Result
from clubface.simulation.impact import Tally
from clubface.validation.catalogue import CHECKS, check_named
from clubface.validation.check import Check, Figure, Judged
from clubface.validation.validation_result import validation_result


class Summary(NamedTuple):
    """How one model does in one quantity of a check.

    Attributes
    ----------
    quantity, unit
        What is compared; errors that are shares have the unit "%".
    figures
        Number of figures.
    inside, intervals
        How many of them are inside the published interval, and of how many one is published.
    within
        How many of the figures are within the tolerance.
    median, mean, bias, worst
        Median and mean of the magnitudes of the errors, their mean, and the error of the largest magnitude, SI or
        shares; NaN if the model says nothing of the quantity.
    tolerances
        The least and the largest tolerance of the figures, SI or shares.
    scaled
        Mean of the magnitudes of the errors, each over its tolerance.
    """

    quantity: str
    unit: str
    figures: int
    inside: int
    intervals: int
    within: int
    median: float
    mean: float
    bias: float
    worst: float
    tolerances: tuple[float, float]
    scaled: float

    @property
    def known(self) -> bool:
        """Whether the model says anything of the quantity."""
        return not math.isnan(self.mean)

    @property
    def met(self) -> bool:
        """Whether the errors are on average within their tolerances."""
        return self.scaled <= 1.0


class Verdict(NamedTuple):
    """In how many measured quantities a model is within the tolerance: on average, with every figure, of how many."""

    met: int
    every: int
    of: int


def summary(figures: Iterable[Figure]) -> list[Summary]:
    """Return one summary for each quantity, in the order in which they come first."""
    by_quantity: dict[str, list[Figure]] = {}
    for each in figures:
        by_quantity.setdefault(each.quantity, []).append(each)
    summaries = []
    for quantity, rows in by_quantity.items():
        known = [each for each in rows if each.within is not None]
        errors = [each.error for each in known]
        sizes = [abs(each) for each in errors]
        summaries.append(
            Summary(
                quantity, rows[0].error_unit, len(rows), sum(each.inside is True for each in rows),
                sum(each.inside is not None for each in rows), sum(each.within is True for each in rows),
                median(sizes) if sizes else math.nan, _mean(sizes), _mean(errors),
                max(errors, key=abs, default=math.nan),
                (min(each.tolerance for each in rows), max(each.tolerance for each in rows)),
                _mean([abs(each.error) / each.tolerance for each in known]),
            )
        )  # fmt: skip
    return summaries


def _mean(values: Sequence[float]) -> float:
    """Return the mean, NaN of nothing."""
    return sum(values) / len(values) if values else math.nan


@dataclass(frozen=True)
class Validation(Described):
    """Models beside published figures.

    Attributes
    ----------
    checks
        What was checked.
    figures
        The figures by model, then by name of the check.
    ball
        Name of the ball.
    """

    checks: tuple[Check, ...]
    figures: dict[str, dict[str, list[Figure]]]
    ball: str

    @property
    def models(self) -> list[str]:
        """The models, in the order asked for."""
        return list(self.figures)

    def summary(self, model: str, check: str) -> list[Summary]:
        """Return how a model does in each quantity of a check."""
        return summary(self.figures[model][check])

    def verdict(self, model: str) -> Verdict:
        """Return in how many measured quantities of all checks a model is within the tolerance."""
        every = [each for check in self.checks if check.measured for each in self.summary(model, check.name)]
        known = [each for each in every if each.known]
        return Verdict(sum(each.met for each in known), sum(each.within == each.figures for each in known), len(known))

    def to_result(self, *, detailed: bool = True) -> Result:
        """Return it as a result; unless ``detailed``, people see the summary alone."""
        return validation_result(self, detailed=detailed)


def validate(
    models: str | Iterable[str] = DEFAULT_MODEL,
    *,
    checks: Iterable[str] | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Validation:
    """Compute published figures by models.

    Parameters
    ----------
    models
        Which models, ``fem`` among them; ``response`` unless given.
    checks
        Names of checks of ``CHECKS``; all unless given.
    ball
        As for :func:`clubface.impact`.
    progress
        Called with the number of checks done and of all, over all models.
    """
    names = [model_named(each).name for each in ([models] if isinstance(models, str) else models)]
    chosen = CHECKS if checks is None else tuple(check_named(each) for each in checks)
    if not names or not chosen:
        raise InputError("models" if chosen else "checks", [], "at least one")
    figures: dict[str, dict[str, list[Figure]]] = {name: {} for name in names}
    tally = Tally()
    for done, (name, check) in enumerate(product(figures, chosen), 1):
        figures[name][check.name] = check.figures(Judged(name, ball, tally))
        if progress is not None:
            progress(done, len(figures) * len(chosen))
    tally.warn()
    return Validation(chosen, figures, ball_named(ball).name)
