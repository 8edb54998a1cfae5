"""Accuracy of the estimators: bias, spread and coverage on synthetic swings with known truth."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from statistics import NormalDist
from typing import Any

import numpy as np

from clubface import units
from clubface.capture.estimators import ESTIMATORS, ROUGHNESS, estimator
from clubface.capture.reduction import QUANTITIES
from clubface.capture.rotations import Array
from clubface.capture.setup import Setup, prepare
from clubface.capture.swing import capture
from clubface.capture.synthetic.laboratory import (
    BARE_RATE,
    Cameras,
    asked_at_random,
    bare_map,
    check_swings,
    positions_map,
    record_bare,
)
from clubface.capture.synthetic.synthetic_swing import LAUNCH, club_of_hand, random_swing
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL, models
from clubface.errors import FileError
from clubface.jobs import Finished, Job, Store, run
from clubface.quantities import Quantity, Reading, display_unit, quantity
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, text
from clubface.simulation.impact import impact
from clubface.simulation.inputs import OF_CLUB
from clubface.support.checks import without_warnings

__all__ = ["Study", "bare_study", "study", "study_picture"]

UNITS = {
    name: "m/s" if name == "speed" else display_unit(name, units.SI_UNITS[dimension])
    for name, dimension in OF_CLUB.items()
}
"""Units in which errors are displayed: m/s, deg, mm, deg/s."""
DRAWN = ("speed", "attack", "path", "loft", "face", "toe", "high", "closure")
REMEDY = "finish that study, or name another folder"


@dataclass(frozen=True, kw_only=True, eq=False)
class Study(Described):
    """Errors of several estimators on the same swings, in SI units.

    Attributes
    ----------
    club
        The club of the swings.
    cameras
        Cameras of the laboratory.
    errors
        Captured minus true deliveries by estimator, shape (swings, 11), in the order of ``QUANTITIES``.
    deviations
        Standard deviations stated by the estimators.
    touches
        Errors of the time of first touch [s], shape (swings,).
    truth
        True deliveries, shape (swings, 11).
    """

    club: Club
    cameras: Cameras
    errors: dict[str, Array]
    deviations: dict[str, Array]
    touches: dict[str, Array]
    truth: Array

    def __len__(self) -> int:
        return len(next(iter(self.errors.values())))

    def figures(self, name: str) -> dict[str, Array]:
        """Return statistics of an estimator's errors by quantity [SI], under the names of the methods below."""
        errors = self.errors[name]
        return {
            "bias": errors.mean(0), "spread": errors.std(0, ddof=1), "worst": np.abs(errors).max(0),
            "stated": np.sqrt((self.deviations[name] ** 2).mean(0)),
        }  # fmt: skip

    def bias(self, name: str) -> dict[str, float]:
        """Return an estimator's mean errors by quantity [UNITS]."""
        return _in_units(self.figures(name)["bias"])

    def spread(self, name: str) -> dict[str, float]:
        """Return the standard deviations of an estimator's errors by quantity [UNITS]."""
        return _in_units(self.figures(name)["spread"])

    def worst(self, name: str) -> dict[str, float]:
        """Return an estimator's largest errors by quantity [UNITS]."""
        return _in_units(self.figures(name)["worst"])

    def stated(self, name: str) -> dict[str, float]:
        """Return the root mean square of an estimator's stated standard deviations by quantity [UNITS]."""
        return _in_units(self.figures(name)["stated"])

    def coverage(self, name: str, level: float = 0.95) -> dict[str, float]:
        """Return how often an estimator's intervals contain the truth, by quantity; rejected swings are excluded."""
        half = NormalDist().inv_cdf(0.5 + 0.5 * level)
        inside = np.abs(self.errors[name]) < half * self.deviations[name]
        read = np.isfinite(self.errors[name][:, 0])
        return dict(zip(QUANTITIES, inside[read].mean(0).tolist(), strict=True))

    def launch_errors(self, name: str, model: str = DEFAULT_MODEL) -> dict[str, Array]:
        """Return the launch errors that result from using an estimator's instead of true deliveries.

        The launches are those of an impact model with its published parameters. The errors are ``ball_speed``,
        ``launch``, ``azimuth``, ``backspin`` and ``sidespin`` [SI], shape (swings,).
        """
        true, seen = (
            impact(self.club, dict(zip(QUANTITIES, values.T, strict=True)), model=model)
            for values in (self.truth, self.truth + self.errors[name])
        )
        return {each: getattr(seen, each) - getattr(true, each) for each in LAUNCH}

    def to_result(self) -> Result:
        """Return the errors as a result, one row per quantity and estimator."""
        noise, names = self.cameras.noise, list(self.errors)
        rows = [(place, name) for place in range(len(QUANTITIES)) for name in names]
        kinds = [quantity(QUANTITIES[place]) for place, _ in rows]
        figures = {name: self.figures(name) for name in names}
        covered = [self.coverage(name)[QUANTITIES[place]] for place, name in rows]
        share = Quantity("coverage", metric=Reading("%", 1), golf=Reading("%", 1), label="covers")
        errors = Table(
            "errors",
            (
                text("quantity", [each.label for each in kinds]), text("estimator", [name for _, name in rows]),
                *(
                    Column(figure, [figures[name][figure][place] for place, name in rows], kinds, digits=3,
                           difference=figure == "bias")
                    for figure in figures[names[0]]
                ),
                Column("coverage", covered, share),
            ),
        )  # fmt: skip
        title = f"{len(self)} swings, {self.club.name}, markers' noise {units.show(noise, 'mm', 3)}: captured less true"
        settings = (
            text("swings", [len(self)], printed=False), text("rate_hz", [self.cameras.rate], printed=False),
            column("marker_noise", [noise], "radius", printed=False), text("gaps", [self.cameras.gaps], printed=False),
        )  # fmt: skip
        label = "no noise" if noise == 0.0 else f"{units.show(noise, 'mm', 3)} noise"
        return Result("capture-study", title, (errors,), settings, draw=lambda: [study_picture({label: self})])


def study_picture(studies: Mapping[str, Study]) -> Picture:
    """Plot bias and spread of every estimator: one panel per quantity, one group of lines per study.

    The studies are given by the label of their group, such as "no noise".
    """
    groups = Axis(names=list(studies), reversed=True, limits=(-0.6, len(studies) - 0.4))
    panels = [Panel(list(_error_marks(studies, name)), axis(name, unit=UNITS[name]), groups) for name in DRAWN]
    return Picture(
        "capture-study", "Bias and spread of every estimator", [panels[:4], panels[4:]],
        "captured less true: mean, middle half and 95% of the swings", height=4.0, share_y=True, legend=True,
    )  # fmt: skip


def _error_marks(studies: Mapping[str, Study], name: str) -> Iterator[Mark]:
    yield Mark("rule", x=0.0, style=-1)
    for group, each in enumerate(studies.values()):
        for place, (estimator_name, errors) in enumerate(each.errors.items()):
            error = errors[:, QUANTITIES.index(name)]
            low, first, last, high = np.quantile(error, [0.025, 0.25, 0.75, 0.975])
            y = group + 0.8 * ((place + 0.5) / len(each.errors) - 0.5)
            yield Mark("line", [first, last], [y, y], label=estimator_name, style=place, dash=0, size=3.6)
            yield Mark("line", [low, high], [y, y], style=place, dash=0, size=1.0)
            yield Mark("points", [error.mean()], [y], style=place, hollow=True, size=3.6)


def study(
    count: int = 200,
    *,
    club: str | Club = "driver",
    hand: str | None = None,
    cameras: Cameras | None = None,
    estimators: Iterable[str] = tuple(ESTIMATORS),
    roughness: float = ROUGHNESS,
    seed: int = 1,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Study:
    """Read ``count`` synthetic swings with each estimator, and compare the deliveries with the truth.

    Parameters
    ----------
    count, club, hand, cameras, seed
        As for :func:`clubface.capture.synthetic.synthesize`.
    estimators, roughness
        Names of the estimators, and roughness for the smoother.
    checkpoint
        A folder that stores swings already read, so that the study can continue after an interruption. It is removed
        at the end.
    progress
        Called with the number of swings read and the total.

    Raises
    ------
    FileError
        The checkpoint belongs to another study, or is in use by another process.
    """
    check_swings(count, seed)
    seen = cameras or Cameras()
    names = tuple(estimators)
    for name in names:
        estimator(name)
    head = club_of_hand(club, hand)
    ready = {name: prepare(positions_map(head, seen), head, estimator=name, roughness=roughness) for name in names}
    content = {"club": head.inputs(), "laboratory": seen, "estimator": [names, roughness], "seed": seed}

    read = partial(read_swing, seed=seed, club=head, cameras=seen, ready=tuple(ready.values()))
    with Finished() if checkpoint is None else Store(Path(checkpoint), content, remedy=REMEDY) as store:
        rows = run(Job("swings", range(count), read), store=store, progress=progress).values()
        store.remove()
    return _study(head, seen, names, rows)


def _study(club: Club, cameras: Cameras, names: Iterable[str], rows: Iterable[Sequence[Any]]) -> Study:
    """Return the study of swings with a row each, as from :func:`read_swing`."""
    truth, *values = (np.array(each) for each in zip(*rows, strict=True))
    errors, deviations, touches = (dict(zip(names, each.swapaxes(0, 1), strict=True)) for each in values)
    return Study(club=club, cameras=cameras, errors=errors, deviations=deviations, touches=touches, truth=truth)


def read_swing(number: int, *, seed: int, club: Club, cameras: Cameras, ready: Iterable[Setup]) -> list[Any]:
    """Read the synthetic swing of this ``seed`` and ``number`` with several setups.

    Returns the true delivery, shape (11,); errors and stated standard deviations per setup, shape (setups, 11); and
    errors of the time of first touch; all in SI units.
    """
    swing = random_swing(np.random.default_rng([seed, number, 0]), club=club)
    truth = np.array([swing.truth[name] for name in QUANTITIES])
    recording, first = cameras.record_from(swing, np.random.default_rng([seed, number, 1]))
    outcome = [capture(recording, each) for each in ready]
    errors = [[getattr(each.delivery, name) for name in QUANTITIES] - truth for each in outcome]
    deviations = [[each.uncertainty[name] for name in QUANTITIES] for each in outcome]
    return [truth.tolist(), np.array(errors).tolist(), deviations, [float(each.time + first) for each in outcome]]


WAYS = ("address", "swing", "address, markers measured")
"""Calibrations compared by :func:`bare_study`; in the last, marker positions have errors of ``RULER``."""
RULER = 5e-3
"""Standard deviation of positions measured with a ruler [m]."""


def bare_study(
    count: int = 100,
    *,
    club: str | Club = "driver",
    hand: str | None = None,
    cameras: Cameras | None = None,
    ways: Iterable[str] = WAYS,
    seed: int = 1,
) -> Study:
    """Read synthetic swings with three markers on the head and no ball, and compare with the truth.

    Everything the reader assumes is drawn for each swing from its assumed distribution: angles at address, marker
    positions, lie and impact point. The impact model varies from swing to swing among the published ones, so that the
    reader's own model is not the truth. Parameters are as for :func:`study`; errors are by calibration instead of
    estimator, and NaN for rejected swings.
    """
    check_swings(count, seed)
    seen = cameras or Cameras(rate=BARE_RATE, noise=3e-4)
    head = club_of_hand(club, hand)
    names, impact_models = tuple(ways), tuple(models())
    rows = []
    for number in range(count):
        asked = asked_at_random(np.random.default_rng([seed, number, 2]))
        impact_model = impact_models[number % len(impact_models)]
        with without_warnings():
            swing = random_swing(
                np.random.default_rng([seed, number, 0]), club=head, hand=None, model=impact_model, **asked
            )
        truth = np.array([swing.truth[name] for name in QUANTITIES])
        errors, deviations = np.full((2, len(names), len(QUANTITIES)), np.nan)
        touches = np.full(len(names), np.nan)
        rows.append((truth, errors, deviations, touches))
        bare = record_bare(swing, seen, np.random.default_rng([seed, number, 1]))
        for place, name in enumerate(names):
            by, _, measured = name.partition(", ")
            off = RULER * np.random.default_rng([seed, number, 3]).normal(size=(len(bare.cluster), 3))
            positions = np.array(list(bare.cluster.values())) + off
            cluster = dict(zip(bare.cluster, map(tuple, positions.tolist()), strict=True)) if measured else None
            mapping = bare_map(head, seen, by, cluster)
            mapping = replace(mapping, accuracy=RULER) if measured else mapping
            try:
                outcome = capture(bare.recording, prepare(mapping, head))
            except FileError:
                continue
            errors[place] = np.array([getattr(outcome.delivery, each) for each in QUANTITIES]) - truth
            deviations[place] = [outcome.uncertainty[each] for each in QUANTITIES]
            touches[place] = outcome.time + bare.first
    return _study(head, seen, names, rows)


def _in_units(values: Array) -> dict[str, float]:
    return {
        name: float(units.from_si(value, UNITS[name])) for name, value in zip(QUANTITIES, values.tolist(), strict=True)
    }
