"""From a launch back to the deliveries that can have made it."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.models import DEFAULT_MODEL, reduced_model
from clubface.errors import InputError, RangeWarning
from clubface.evaluation.noise import MONITOR, standard_deviations
from clubface.inference.expectation import expected_launches, surprise, unreachable
from clubface.inference.importance import sample
from clubface.inference.posterior import Posterior
from clubface.inference.prior import Prior, prior_of
from clubface.measured.shots import QUANTITIES
from clubface.simulation.impact import Parameters, impact
from clubface.simulation.inputs import parameter_set
from clubface.simulation.launch import Launch
from clubface.simulation.outside import Tally, warn_if_outside
from clubface.support.arrays import Floats
from clubface.support.checks import check_names
from clubface.support.warning import without_warnings

NOISE = {"ball_speed": 0.25, **MONITOR}
"""Standard deviations of the measured launch [SI] by default: those that Caldwell and McPhee (2023) quote for their
monitor, and 0.25 m/s of ball speed."""
FEWEST_AT_ALL = 50
"""Effective draws below which there is no sample to speak of: all weight lies on a few draws nearest to the launch."""
_POLAR = {"total_spin": "angular rate", "spin_axis": "angle"}
_DIMENSIONS = {name: units.unit(unit).dimension for name, unit in QUANTITIES.items()}


def infer(
    launch: Mapping[str, Any],
    *,
    club: str | os.PathLike[str] | Club,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    prior: Prior | str | os.PathLike[str] | None = None,
    noise: Mapping[str, Any] | None = None,
    samples: int = 2000,
    seed: int = 0,
    accuracy: float | None = None,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Posterior:
    """Sample the deliveries that can have made a launch.

    A launch has five numbers and a delivery has eleven, so many deliveries make the same launch. The result is
    therefore a sample. Each delivery appears in it as often as it is probable under the prior and the noise of the
    measurement.

    Parameters
    ----------
    launch
        What was measured, as text with units or as SI numbers: some of ``ball_speed``, ``launch``, ``azimuth``,
        ``backspin`` and ``sidespin``, or ``total_spin`` and ``spin_axis`` instead of the last two.
    club, model, parameters, ball, accuracy, threads
        As for :func:`impact`.
    prior
        "elite" (the golfers of the benchmark shots; driver and 7-iron), "tour" (the published averages), "wide"
        (golfers of any skill), the path of a TOML file, or a :class:`Prior`. If left out: "elite" where it exists,
        otherwise "tour".
    noise
        Standard deviations of the measured quantities by name, as text with units or as SI numbers. They should include
        the errors of the model. Those left out are the ones that Caldwell and McPhee (2023) quote for their monitor.
    samples
        Number of draws to return.
    seed
        Seed of the random numbers; the same seed gives the same sample.
    progress
        Called with the completed fraction, 0 to 1.

    Raises
    ------
    InputError
        The launch has no known quantity, or an option is out of range.
    UnreachableLaunchError
        No delivery anywhere near the prior makes the launch. The usual cause is a wrong unit or club.
    """
    if isinstance(samples, bool) or not isinstance(samples, int) or not 1 <= samples <= 100_000:
        raise InputError("samples", samples, "a whole number from 1 to 100000")
    measured = _measured(launch)
    deviations = {**NOISE, **standard_deviations(noise, _DIMENSIONS, "noise")}
    for name in measured:
        if deviations[name] <= 0.0:
            raise InputError(f"noise {name}", deviations[name], "positive: an exact measurement cannot be sampled")
    head = club_named(club)
    reduced_model(model, "one that computes thousands of deliveries a second")
    chosen = parameter_set(model, head, parameters)
    before = prior_of(prior, head)
    target = np.array(list(measured.values()))
    scale = np.array([deviations[name] for name in measured])

    def struck(delivery: Mapping[str, Any]) -> Launch:
        with without_warnings(RangeWarning):  # of what is tried; what is found is told below
            return impact(
                head, delivery, model=model, parameters=chosen, ball=ball, accuracy=accuracy, threads=threads,
                on_error="nan",
            )  # fmt: skip

    def predict(standard: Floats) -> Floats:
        delivery = before.deliveries(standard)
        possible = delivery["speed"] > 0.0
        delivery["speed"] = np.where(possible, delivery["speed"], before.mean["speed"])
        found = struck(delivery)
        values = np.stack([np.asarray(getattr(found, name)) for name in measured], axis=1)
        values[~possible] = np.nan
        return values

    def log_likelihood(standard: Floats) -> Floats:
        return -0.5 * np.sum(((predict(standard) - target) / scale) ** 2, axis=1)

    try:
        drawn = sample(log_likelihood, len(before.names), size=samples, seed=seed, progress=progress)
    except FloatingPointError:
        raise InputError("prior", before.name, f"one whose deliveries {head.name} and {model} can compute") from None
    expected = expected_launches(predict, len(before.names), seed)
    if drawn.effective < FEWEST_AT_ALL:
        raise unreachable(measured, expected, f"the prior ({before.name}), which by {model}")
    deliveries = before.deliveries(drawn.points)
    middle = struck({name: float(values.mean()) for name, values in deliveries.items()})
    warn_if_outside((middle,))
    return Posterior(
        deliveries=deliveries,
        launch=measured,
        noise={name: deviations[name] for name in measured},
        prior=before,
        club=head,
        model=model,
        parameters=chosen,
        sample=drawn,
        surprise=surprise(expected, target, scale, seed),
        seed=seed,
        outside=Tally().add_all((middle,)).remark(),
    )


def _measured(launch: Mapping[str, Any]) -> dict[str, float]:
    """Return the measured quantities, SI, total spin and axis as backspin and sidespin."""
    dimensions = {**_DIMENSIONS, **_POLAR}
    check_names("launch value", launch, dimensions)
    given = {
        name: units.parse(value, dimensions[name], name=name) for name, value in launch.items() if value is not None
    }
    polar = [name for name in _POLAR if name in given]
    if polar:
        if len(polar) == 1 or "backspin" in given or "sidespin" in given:
            raise InputError(
                polar[0], given[polar[0]], "give total_spin and spin_axis together, or backspin and sidespin"
            )
        total, axis = given.pop("total_spin"), given.pop("spin_axis")
        given |= {"backspin": total * math.cos(axis), "sidespin": total * math.sin(axis)}
    if not given:
        raise InputError("launch", dict(launch), f"at least one of {', '.join(QUANTITIES)}")
    return {name: given[name] for name in QUANTITIES if name in given}
