"""Running checks on models, and the validation as a result: every figure, a summary of each check, a picture."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from statistics import median
from typing import NamedTuple

import numpy as np

from clubface.equipment.balls import Ball, ball as ball_named
from clubface.equipment.models import DEFAULT_MODEL, model as model_named
from clubface.errors import InputError
from clubface.quantities import format_number, format_value
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, text
from clubface.simulation.impact import Tally
from clubface.validation.catalogue import CHECKS, check_named
from clubface.validation.check import Check, Figure, ModelUnderTest, reading


class CheckSummary(NamedTuple):
    """The errors of one model in one quantity of a check, in SI or relative; NaN if the model does not compute it."""

    quantity: str
    unit: str  # "%" for relative errors
    figures: int  # number of figures
    inside: int  # number of figures inside the published interval
    intervals: int  # number of figures with an interval
    within: int  # number of figures within the tolerance
    median: float  # of the absolute errors
    mean: float  # of the absolute errors
    bias: float  # mean error
    worst: float  # error of largest magnitude
    tolerances: tuple[float, float]  # smallest and largest
    scaled: float  # mean absolute error over tolerance

    @property
    def known(self) -> bool:
        """Whether the model computes the quantity."""
        return not math.isnan(self.mean)

    @property
    def met(self) -> bool:
        """Whether the errors are within their tolerances on average."""
        return self.scaled <= 1.0


class Verdict(NamedTuple):
    """How many measured quantities a model meets."""

    met: int  # quantities with errors within the tolerance on average
    every: int  # quantities with every figure within the tolerance
    of: int  # quantities that the model computes


def summary(figures: Iterable[Figure]) -> list[CheckSummary]:
    """Return one summary per quantity, in order of first appearance."""
    by_quantity: dict[str, list[Figure]] = {}
    for each in figures:
        by_quantity.setdefault(each.quantity, []).append(each)
    summaries = []
    for quantity, rows in by_quantity.items():
        known = [each for each in rows if each.within is not None]
        errors = [each.error for each in known]
        sizes = [abs(each) for each in errors]
        summaries.append(
            CheckSummary(
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
    """Return the mean, or NaN for no values."""
    return sum(values) / len(values) if values else math.nan


@dataclass(frozen=True)
class Validation(Described):
    """Models compared with published figures.

    Attributes
    ----------
    figures
        The figures by model and name of the check.
    """

    checks: tuple[Check, ...]
    figures: dict[str, dict[str, list[Figure]]]
    ball: str

    @property
    def models(self) -> list[str]:
        """The models, in the order requested."""
        return list(self.figures)

    def summary(self, model: str, check: str) -> list[CheckSummary]:
        """Return the summary of a model for each quantity of a check."""
        return summary(self.figures[model][check])

    def verdict(self, model: str) -> Verdict:
        """Return the number of measured quantities, over all checks, in which a model is within the tolerance."""
        every = [each for check in self.checks if check.measured for each in self.summary(model, check.name)]
        known = [each for each in every if each.known]
        return Verdict(sum(each.met for each in known), sum(each.within == each.figures for each in known), len(known))

    def to_result(self, *, detailed: bool = True) -> Result:
        """Return the validation as a result; unless ``detailed``, only the summary is printed."""
        return validation_result(self, detailed=detailed)


def validate(
    models: str | Iterable[str] = DEFAULT_MODEL,
    *,
    checks: Iterable[str] | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Validation:
    """Compare models with published figures.

    Parameters
    ----------
    models
        Names of models, including ``fem``; default ``response``.
    checks
        Names of checks in ``CHECKS``; default all.
    ball
        As for :func:`clubface.impact`.
    progress
        Called with the number of checks done and the total, over all models.
    """
    names = [model_named(each).name for each in ([models] if isinstance(models, str) else models)]
    chosen = CHECKS if checks is None else tuple(check_named(each) for each in checks)
    if not names or not chosen:
        raise InputError("models" if chosen else "checks", [], "at least one")
    figures: dict[str, dict[str, list[Figure]]] = {name: {} for name in names}
    tally = Tally()
    for done, (name, check) in enumerate(product(figures, chosen), 1):
        figures[name][check.name] = check.figures(ModelUnderTest(name, ball, tally))
        if progress is not None:
            progress(done, len(figures) * len(chosen))
    tally.warn()
    return Validation(chosen, figures, ball_named(ball).name)


EDGE = 4.0
"""Number of tolerances beyond which errors are drawn at the edge."""


def validation_result(validation: Validation, *, detailed: bool = True) -> Result:
    """Return a validation as a result; unless ``detailed``, only the summary is printed."""
    reasons = (each for check in validation.checks for each in check_notes(check)) if detailed else ()
    verdicts = (
        note("validation-verdict", model=model, met=verdict.met, quantities=verdict.of, every=verdict.every)
        for model in validation.models
        for verdict in [validation.verdict(model)]
    )
    return Result(
        kind="validation", title=f"Published figures, ball {validation.ball}",
        tables=(figure_table(validation, printed=detailed), summary_table(validation), check_table(validation)),
        notes=(*reasons, *verdicts, *_misses(validation)),
        draw=lambda: [validation_picture(validation)],
    )  # fmt: skip


MOST_MISSES = 3
"""Maximum number of failed quantities named with a model's verdict."""


def _misses(validation: Validation) -> Iterator[Note]:
    """Yield, for each model, the measured quantities with the largest mean errors over tolerance."""
    for model in validation.models:
        missed = [
            (each, check.name)
            for check in validation.checks
            if check.measured
            for each in validation.summary(model, check.name)
            if each.known and not each.met
        ]
        missed.sort(key=lambda pair: -pair[0].scaled)
        named = [
            f"{check} {each.quantity} ({format_value(each.bias, reading(each.unit))})"
            for each, check in missed[:MOST_MISSES]
        ]
        if named:
            yield note("validation-misses", model=model, missed=named)


def check_notes(check: Check) -> list[Note]:
    """Return the reason for a check's tolerances, and its sources."""
    sources = (note("published-table", title=each.title, source=each.source) for each in check.tables)
    return [note("check-reason", check=check.name, reason=check.reason), *sources]


def figure_table(validation: Validation, *, printed: bool = True) -> Table:
    """Return the table of all figures by all models."""
    rows = [
        (check.name, model, each)
        for check in validation.checks
        for model in validation.models
        for each in validation.figures[model][check.name]
    ]
    figures = [each for _, _, each in rows]
    own, errors = [reading(each.unit) for each in figures], [reading(each.error_unit) for each in figures]
    return Table(
        "figures",
        (
            text("case", [each.case for each in figures], label="shot"),
            text("check", [name for name, _, _ in rows], printed=len(validation.checks) > 1),
            text("model", [model for _, model, _ in rows], printed=len(validation.models) > 1),
            text("quantity", [each.quantity for each in figures]),
            *published_columns(figures),
            Column("computed", [each.computed for each in figures], own),
            Column("error", [each.error for each in figures], errors, difference=True),
            Column("tolerance", [each.tolerance for each in figures], errors),
            text("certainty", [each.certainty for each in figures]),
            text("inside", [each.inside for each in figures]),
            text("within", [each.within for each in figures]),
        ),
        f"{validation.checks[0].title}, by {', '.join(validation.models)}" if len(validation.checks) == 1 else "",
        printed=printed,
    )  # fmt: skip


def published_columns(figures: list[Figure]) -> tuple[Column, Column]:
    """Return the columns with the ends of the published range; an upper end may be missing."""
    quantities = [reading(each.unit) for each in figures]
    least, most = zip(*(each.published for each in figures), strict=True)
    return (
        Column("published_least", least, quantities, label="published"),
        Column("published_most", [None if math.isinf(each) else each for each in most], quantities, label="to"),
    )


def summary_table(validation: Validation) -> Table:
    """Return a table with a row per check, quantity and model: figures inside and within, and sizes of errors."""
    rows = [
        (check, model, validation.summary(model, check.name)[place])
        for check in validation.checks
        for place in range(len(validation.summary(validation.models[0], check.name)))
        for model in validation.models
    ]
    each_summary = [each for _, _, each in rows]
    quantities = [reading(each.unit) for each in each_summary]
    signed = ("mean_error", "bias"), ("worst", "worst")
    return Table(
        "summary",
        (
            text("check", [check.name for check, _, _ in rows]),
            text("quantity", [each.quantity for each in each_summary]),
            text("certainty", [check.certainty for check, _, _ in rows]),
            Column("least_tolerance", [each.tolerances[0] for each in each_summary], quantities, printed=False),
            Column("tolerance", [each.tolerances[1] for each in each_summary], quantities),
            text("model", [model for _, model, _ in rows]),
            text("inside", [each.inside if each.intervals else None for each in each_summary]),
            text("intervals", [each.intervals or None for each in each_summary], label="of intervals"),
            text("within", [each.within if each.known else None for each in each_summary]),
            text("figures", [each.figures if each.known else None for each in each_summary], label="of figures"),
            Column("median_magnitude", [each.median for each in each_summary], quantities, label="median |error|"),
            Column("mean_magnitude", [each.mean for each in each_summary], quantities, label="mean |error|"),
            *(
                Column(name, [getattr(each, key) for each in each_summary], quantities, difference=True)
                for name, key in signed
            ),
            column("scaled_error", [each.scaled for each in each_summary], "1", printed=False),
        ),
        "Errors by check, quantity and model",
    )  # fmt: skip


def check_table(validation: Validation) -> Table:
    """Return the table of checks: what they compare, its reliability, and the reasons for the tolerances."""
    checks = validation.checks
    return Table(
        "checks",
        (
            text("check", [each.name for each in checks]), text("title", [each.title for each in checks]),
            text("certainty", [each.certainty for each in checks]), text("reason", [each.reason for each in checks]),
            text("sources", [", ".join(each.sources) for each in checks]),
        ),
        "What is compared", printed=False,
    )  # fmt: skip


def tolerance_text(summary: CheckSummary) -> str:
    """Return the tolerance, or the range of tolerances, of a quantity as text."""
    quantity = reading(summary.unit)
    least, most = (format_value(each, quantity) for each in summary.tolerances)
    return most if least == most else f"{least.split(' ')[0]} to {most}"


def validation_picture(validation: Validation) -> Picture:
    """Return the picture of all errors over their tolerances, by model, with a row for each quantity of each check."""
    rows = [
        (check, each) for check in validation.checks for each in validation.summary(validation.models[0], check.name)
    ]
    borders = [place - 0.5 for place in range(1, len(rows)) if rows[place][0] is not rows[place - 1][0]]
    names = [f"{check.name}: {each.quantity}, ± {tolerance_text(each)}" for check, each in rows]
    marks = [
        Mark("shade", x0=-1.0, x1=1.0, label="within the tolerance", style=-1),
        Mark("rule", x=0.0, style=-1),
        Mark("rule", y=borders, style=-1, size=0.4),
        *_error_marks(validation, rows),
    ]
    panel = Panel(
        marks, Axis(label="computed less published, over the tolerance", limits=(-EDGE, EDGE)),
        Axis(names=names, limits=(len(rows) - 0.5, -0.5)),
    )  # fmt: skip
    return Picture(
        "validation", "Every error over its tolerance, by quantity and model", [[panel]],
        height=0.8 + 0.235 * len(rows), legend=True,
    )  # fmt: skip


def _error_marks(validation: Validation, rows: list[tuple[Check, CheckSummary]]) -> Iterator[Mark]:
    """Yield the points of each model, slightly offset so that models do not overlap."""
    models = validation.models
    for index, model in enumerate(models):
        offset = (index - 0.5 * (len(models) - 1)) * 0.56 / max(len(models), 2)
        points = [
            (each.error / each.tolerance, place + offset)
            for place, (check, summary) in enumerate(rows)
            for each in validation.figures[model][check.name]
            if each.quantity == summary.quantity and each.within is not None
        ]
        x, y = np.array(points).reshape(-1, 2).T
        yield Mark("points", np.clip(x, -EDGE, EDGE), y, style=model, label=model, size=2.6, faint=True)


def mean_text(summary: CheckSummary) -> str:
    """Return the mean absolute error of a quantity as text with its unit; "" if the model does not compute it."""
    quantity = reading(summary.unit)
    return format_value(summary.mean, quantity) if format_number(summary.mean, 1) else ""
