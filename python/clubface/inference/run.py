"""Inference of the deliveries that could have produced a measured launch."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from clubface import _core as core, units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.models import DEFAULT_MODEL, reduced_model
from clubface.errors import InputError, RangeWarning, Wording
from clubface.inference.evaluation.statistics import MONITOR, standard_deviations
from clubface.inference.importance import drawn
from clubface.inference.posterior import FEWEST_EFFECTIVE, Posterior
from clubface.inference.prior import Expectation, Prior, prior_of, unreachable
from clubface.shots.formats import CG, CONTACT, FACE
from clubface.shots.measured import QUANTITIES
from clubface.shots.reference_points import ATTITUDE, MOTION, as_seen
from clubface.simulation.impact import Parameters, impact, warn_if_outside
from clubface.simulation.inputs import OF_CLUB, equipped, parameter_set, shots, thread_count, tolerance
from clubface.simulation.results import input_columns, outputs
from clubface.simulation.spin import (
    AXIS,
    BACK,
    DIMENSIONS as SPIN_DIMENSIONS,
    SIDE,
    SPINS,
    TOTAL,
    UNITS as SPIN_UNITS,
    agreeing,
    wrapped,
)
from clubface.support.arrays import Floats, ValueLike
from clubface.support.checks import MOST_SEED, check_count, check_names, without_warnings

STEP = 1e-4
"""Step of numerical derivatives of club data at other points of the head, in standard deviations of the prior."""


NOISE = {"ball_speed": 0.25, **MONITOR}
"""Default standard deviations of the measured launch [SI]: those that Caldwell and McPhee (2023) quote for their
monitor, and 0.25 m/s for ball speed."""
CLUB_NOISE = {
    name: units.parse(text, OF_CLUB[name])
    for name, text in {
        "speed": "1.5 mph", "attack": "1 deg", "path": "1 deg", "loft": "1 deg", "face": "1 deg", "lie": "1 deg",
        "toe": "3 mm", "high": "3 mm", "closure": "300 deg/s", "pitch_rate": "300 deg/s", "lie_rate": "300 deg/s",
    }.items()
}  # fmt: skip
"""Default standard deviations of measured club data [SI]; assumed, as for a good monitor."""
FEWEST_AT_ALL = 50
"""Number of effective draws below which a sample is unusable: all weight is on the few draws nearest the launch."""
FARTHEST = 15.0
"""Deviation from the prior, in standard deviations, above which a shot is refused: a normal distribution has no meaning
that far out, and the usual cause is a wrong unit or club."""
RETRIED = 5
"""Factor on the number of draws for another try if a sample is too small."""
_DIMENSIONS = {name: units.unit(unit).dimension for name, unit in QUANTITIES.items()}


def infer(
    launch: Mapping[str, ValueLike],
    *,
    club: str | os.PathLike[str] | Club,
    delivery: Mapping[str, ValueLike] | None = None,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    prior: Prior | str | os.PathLike[str] | None = None,
    noise: Mapping[str, ValueLike] | None = None,
    delivery_noise: Mapping[str, ValueLike] | None = None,
    samples: int = 2000,
    seed: int = 0,
    accuracy: float | None = None,
    threads: int | None = None,
    progress: Callable[[float], object] | None = None,
) -> Posterior:
    """Sample the deliveries that could have produced a launch.

    A launch has five numbers and a delivery has eleven, so many deliveries produce the same launch. The result is
    therefore a sample of deliveries, distributed as they are probable under the prior and the measurement noise.

    Parameters
    ----------
    launch
        Measured launch quantities, text with units or SI numbers: any of ``ball_speed``, ``launch``, ``azimuth``,
        ``backspin`` and ``sidespin``. Backspin and sidespin may be replaced by any two of these two, ``total_spin`` and
        ``spin_axis``.
    delivery
        Measured club data in the same form: any of ``speed``, ``attack``, ``path``, ``loft``, ``face``, ...
    club, model, parameters, ball, accuracy, threads
        As for :func:`impact`.
    prior
        "elite" (the golfers of the benchmark shots; driver and 7-iron), "tour" (the published averages), "wide"
        (golfers of any skill), the path of a TOML file, or a :class:`Prior`. Default: "elite" if it exists for the
        club, otherwise "tour".
    noise
        Standard deviations of the measured quantities by name, text with units or SI numbers. They should include the
        errors of the model. Default: those that Caldwell and McPhee (2023) quote for their monitor.
    delivery_noise
        Standard deviations of measured club data. Default: assumed, 1.5 mph, 1 degree, 3 mm and 300 deg/s.
    samples
        Number of draws to return.
    seed
        Seed of the random numbers; the same seed gives the same sample.
    progress
        Function called with the completed fraction, 0 to 1.

    Raises
    ------
    InputError
        No launch quantity is given, or an option is out of range.
    UnreachableLaunchError
        No delivery near the prior produces the launch. The usual cause is a wrong unit or club.
    """
    prepared = Inference(
        club=club, model=model, parameters=parameters, ball=ball, prior=prior, noise=noise,
        delivery_noise=delivery_noise, samples=samples, seed=seed, accuracy=accuracy, threads=threads,
    )  # fmt: skip
    posterior = prepared.of(launch, delivery, progress=progress)
    warn_if_outside((posterior.struck,))
    return posterior


class Inference:
    """Inference for many shots with common settings; arguments as for :func:`infer`.

    ``speed_at`` and ``face_at`` are the points at which club data were measured, see :class:`clubface.RecordedShots`.
    """

    def __init__(
        self,
        *,
        club: str | os.PathLike[str] | Club,
        model: str = DEFAULT_MODEL,
        parameters: Parameters | None = None,
        ball: str | os.PathLike[str] | Ball | None = None,
        prior: Prior | str | os.PathLike[str] | None = None,
        noise: Mapping[str, ValueLike] | None = None,
        delivery_noise: Mapping[str, ValueLike] | None = None,
        samples: int = 2000,
        seed: int = 0,
        accuracy: float | None = None,
        threads: int | None = None,
        speed_at: str = CG,
        face_at: str = FACE,
    ) -> None:
        self._samples = check_count("samples", samples, 1, 100_000)
        self._seed = check_count("seed", seed, 0, MOST_SEED)
        self._noise = {**NOISE, **standard_deviations(noise, _DIMENSIONS, "noise")}
        self._club_noise = {**CLUB_NOISE, **standard_deviations(delivery_noise, OF_CLUB, "delivery_noise")}
        self.club = club_named(club)
        reduced_model(model, "one that computes thousands of deliveries a second")
        self.model, self._ball, self._given_threads = model, ball, threads
        self.parameters = parameter_set(model, self.club, parameters)
        self.prior = prior_of(prior, self.club)
        self.places = (speed_at, face_at)
        self.impacts = 0
        """Number of impacts computed so far."""
        self._equipment, chosen = equipped(model, self.club, ball, self.parameters)
        self._columns_of_parameters = chosen.columns()
        self._accuracy, self._threads = tolerance(accuracy), thread_count(threads)
        self._output = {name: place for place, name in enumerate(outputs())}
        self._variables = [input_columns()[name] for name in self.prior.names]
        unit = self.prior.deliveries(np.eye(len(self.prior.names)))
        self._scales = np.array([unit[name] - self.prior.mean[name] for name in self.prior.names])
        self._mean = np.array([self.prior.mean[name] for name in self.prior.names])
        self._expected: dict[tuple[Any, ...], Expectation] = {}

    def of(
        self,
        launch: Mapping[str, ValueLike],
        delivery: Mapping[str, ValueLike] | None = None,
        *,
        progress: Callable[[float], object] | None = None,
    ) -> Posterior:
        """Return the posterior of one shot, as :func:`infer` does, but without range warnings."""
        measured, club_data = _measured_launch(launch), _measured_club(delivery or {})
        known = {name: value for name, value in club_data.items() if name not in self.prior.names}
        club_data = {name: value for name, value in club_data.items() if name not in known}
        names, club_names = tuple(measured), tuple(club_data)
        scale = self._scale(names, club_names)
        target = np.array([*measured.values(), *club_data.values()])

        def seen(standard: Floats) -> Floats:
            return self.seen(standard, names, club_names, known)

        def residuals(standard: Floats) -> Floats:
            return (seen(standard) - target) / scale

        def slopes(standard: Floats) -> tuple[Floats, Floats]:
            values, table = self.derivatives(standard, names, club_names, known)
            return (values - target) / scale, table / scale[:, None]

        self.impacts = 0
        try:
            options: dict[str, Any] = {"seed": self._seed, "progress": progress}
            draws, misfit = drawn(residuals, slopes, len(self.prior.names), size=self._samples, **options)
            if draws.effective < min(FEWEST_EFFECTIVE, self._samples):  # too few draws give poor proposals
                again, _ = drawn(residuals, slopes, len(self.prior.names), size=RETRIED * self._samples, **options)
                draws = again._replace(points=again.points[: self._samples])
        except FloatingPointError:
            advice = f"one with deliveries that {self.model} can compute for {self.club.name}"
            raise InputError("prior", self.prior.name, advice) from None
        impacts = self.impacts
        expected = self._expectation(seen, names + club_names, scale, known)
        if draws.effective < FEWEST_AT_ALL or misfit > FARTHEST**2:
            who = f"the prior ({self.prior.name}), which by {self.model}"
            raise unreachable({**measured, **club_data}, expected, who)
        deliveries = self.prior.deliveries(draws.points)
        reproduced = seen(draws.points).mean(axis=0).tolist()
        noises = dict(zip((*names, *club_names), scale.tolist(), strict=True))
        return Posterior(
            deliveries=deliveries, launch=measured, delivery=club_data, known=known, noise=noises, prior=self.prior,
            club=self.club, model=self.model, parameters=self.parameters, sample=draws._replace(evaluations=impacts),
            surprise=expected.surprise(target), expected=expected.words(expected.far(target)),
            reproduced=dict(zip((*names, *club_names), reproduced, strict=True)), seed=self._seed,
            struck=self.struck({**known, **{name: float(values.mean()) for name, values in deliveries.items()}}),
        )  # fmt: skip

    def struck(self, delivery: Mapping[str, float]) -> Any:
        """Return the launch of one delivery without warnings, NaN if it cannot be computed."""
        with without_warnings(RangeWarning):
            return impact(
                self.club, delivery, model=self.model, parameters=self.parameters, ball=self._ball,
                accuracy=self._accuracy, threads=self._given_threads, on_error="nan",
            )  # fmt: skip

    def _scale(self, names: tuple[str, ...], club_names: tuple[str, ...]) -> Floats:
        for what, given, noises in (
            ("noise", names, self._noise),
            ("delivery_noise", club_names, self._club_noise),
        ):
            for name in given:
                if noises[name] <= 0.0:
                    raise InputError(f"{what} {name}", noises[name], "positive: an exact measurement cannot be sampled")
        return np.array([*(self._noise[name] for name in names), *(self._club_noise[name] for name in club_names)])

    def _expectation(
        self, seen: Callable[[Floats], Floats], names: tuple[str, ...], scale: Floats, known: Mapping[str, float]
    ) -> Expectation:
        """Return the expectation of the prior for the quantities, cached for shots with the same ones."""
        key = (names, tuple(known.items()))
        if key not in self._expected:
            if known:
                self._expected.clear()  # the known values rarely recur
            self._expected[key] = Expectation(seen, names, scale, len(self.prior.names), self._seed)
        return self._expected[key]

    def seen(self, standard: Floats, launch: Sequence[str], club: Sequence[str], known: Mapping[str, float]) -> Floats:
        """Return the values a monitor would show, shape (n, quantities); NaN for deliveries that cannot be computed.

        Deliveries are given by ``standard`` normal deviates of the prior, shape (n, uncertain quantities), and
        ``known`` values outside the prior. Quantities of the ``launch`` come first, then those of the ``club``.
        """
        self.impacts += len(standard)
        computed, _ = core.impact(
            self.model, self._columns(standard, known), self._columns_of_parameters, len(standard), self._accuracy,
            self._threads,
        )  # fmt: skip
        values = computed[[self._output[name] for name in launch]].T
        return np.hstack([values, self._club_data(standard, club, known)]) if club else values

    def derivatives(
        self, standard: Floats, launch: Sequence[str], club: Sequence[str], known: Mapping[str, float]
    ) -> tuple[Floats, Floats]:
        """Return the values for one delivery, shape (quantities,), and their derivatives by ``standard`` as rows."""
        places = [self._output[name] for name in launch]
        point = standard[None, :]
        values, slopes = np.empty((0,)), np.empty((0, standard.size))
        if places:
            computed, _ = core.sensitivities(
                self.model, self._columns(point, known), self._columns_of_parameters, 1, places, self._variables,
                self._accuracy, self._threads,
            )  # fmt: skip
            table = computed.reshape(len(places), 1 + len(self._variables))
            values, slopes = table[:, 0], table[:, 1:] @ self._scales
        if club:
            steps = np.vstack([point, point + STEP * np.eye(standard.size), point - STEP * np.eye(standard.size)])
            data = self._club_data(steps, club, known)
            _, ahead, behind = np.split(data, [1, 1 + standard.size])
            values = np.concatenate([values, data[0]])
            slopes = np.vstack([slopes, (ahead - behind).T / (2.0 * STEP)])
        return values, slopes

    def _delivery(self, standard: Floats, known: Mapping[str, float]) -> dict[str, Floats]:
        values = self._mean + standard @ self._scales.T
        deliveries = {name: np.ascontiguousarray(values[:, place]) for place, name in enumerate(self.prior.names)}
        return {**{name: np.full(len(standard), value) for name, value in known.items()}, **deliveries}

    def _columns(self, standard: Floats, known: Mapping[str, float]) -> list[float | Floats]:
        return shots(self._equipment, self._delivery(standard, known)).columns

    def _club_data(self, standard: Floats, names: Sequence[str], known: Mapping[str, float]) -> Floats:
        given = self._delivery(standard, known)
        speed_at, face_at = self.places
        speed_at = speed_at if set(MOTION) & set(names) else CG
        face_at = face_at if set(ATTITUDE) & set(names) else FACE
        if speed_at == FACE or face_at == CONTACT:
            given = as_seen(given, self.club, speed_at=speed_at, face_at=face_at)
        return np.stack([given[name] for name in names], axis=1)


def _parsed(what: str, given: Any, dimensions: Mapping[str, str], example: str) -> dict[str, float]:
    if not isinstance(given, Mapping):
        raise InputError(what, given, f"a mapping of measured values, as in {example}")
    check_names(f"{what} value", given, dimensions)
    return {name: units.parse(each, dimensions[name], name=name) for name, each in given.items() if each is not None}


def _measured_launch(launch: Mapping[str, ValueLike]) -> dict[str, float]:
    """Return the measured launch quantities [SI], with the spin as backspin and sidespin."""
    given = _parsed("launch", launch, {**_DIMENSIONS, **SPIN_DIMENSIONS}, '{"ball_speed": "160 mph"}')
    if TOTAL in given or AXIS in given:
        given |= _parts({name: given.pop(name) for name in SPINS if name in given})
    if "azimuth" in given:
        given["azimuth"] = float(wrapped(given["azimuth"]))
    if not given:
        raise InputError("launch", dict(launch), f"at least one of {', '.join(QUANTITIES)}")
    return {name: given[name] for name in QUANTITIES if name in given}


def _parts(spins: dict[str, float]) -> dict[str, float]:
    """Return backspin and sidespin from the measured spin values."""
    known = agreeing({name: np.array([value]) for name, value in spins.items()}).values
    if BACK not in known or SIDE not in known:
        name = TOTAL if TOTAL in spins else AXIS
        needs = "give it with spin_axis or sidespin" if name == TOTAL else "give it with total_spin or backspin"
        raise InputError(name, Wording(units.show(spins[name], SPIN_UNITS[name])), needs)
    return {name: float(known[name][0]) for name in (BACK, SIDE)}


def _measured_club(delivery: Mapping[str, ValueLike]) -> dict[str, float]:
    """Return the measured club data [SI]."""
    given = _parsed("delivery", delivery, OF_CLUB, '{"speed": "110 mph"}')
    if not given.get("speed", 1.0) > 0.0:
        raise InputError("speed", given["speed"], "positive")
    return {name: given[name] for name in OF_CLUB if name in given}
