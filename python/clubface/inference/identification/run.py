"""Identification in stages whose finished parts are stored, so that an interrupted run can resume."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from statistics import NormalDist
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import Parameter, reduced_model
from clubface.errors import InputError
from clubface.inference.identification import search as genetic
from clubface.inference.identification.checks import at_bound, check_information, fit_warnings
from clubface.inference.identification.intervals import (
    BOOTSTRAP,
    FOLDS,
    Identifiability,
    Profile,
    Profiler,
    Refits,
    bootstrap,
    errors_of_minimum,
    held_out,
    identifiability,
    interval_of,
    scatter,
)
from clubface.inference.identification.problem import free_parameters, prepared_shots
from clubface.inference.identification.result import Deviation, Identification
from clubface.inference.identification.search import Population, refine, search
from clubface.inference.identification.simulator import Cost, Effort, Simulator, cost_of, noise_of
from clubface.jobs import Finished, Store
from clubface.quantities import display_unit
from clubface.results.notes import Note
from clubface.shots.measured import DELIVERY
from clubface.shots.recorded import RecordedShots
from clubface.simulation.impact import Parameters
from clubface.simulation.inputs import equipped, thread_count, tolerance
from clubface.support.arrays import Floats, ValueLike
from clubface.support.checks import MOST_SEED, check_count
from clubface.support.files import recorded

FEWEST_GROUPS = 10
"""With fewer groups of shots than this, there are too few resamples for a bootstrap alone."""

Progress = Callable[[str, int, int, float], object]
"""Function called with the stage, the amount done, the total, and the smallest cost so far."""


@dataclass
class Stages:
    """Runs the stages in order; finished parts are taken from the store with all their digits.

    Simulator and cost refer to all shots; ``noise`` is the standard deviation of each quantity [SI], ``best`` the
    smallest cost so far. ``progress`` is called after every part.
    """

    simulator: Simulator
    cost: Cost
    noise: Floats
    settings: Mapping[str, Any]
    store: Finished
    progress: Progress | None
    best: float = np.inf

    def __post_init__(self) -> None:
        self._began = time.monotonic() - max((self.store[name]["seconds"] for name in self.store), default=0.0)

    @property
    def seconds(self) -> float:
        """Time spent on finished parts, including earlier runs [s]."""
        return time.monotonic() - self._began

    @property
    def spent(self) -> Effort:
        """Effort spent on finished parts, including earlier runs."""
        parts = [self.store[name] for name in self.store]
        return Effort(*(sum(part[key] for part in parts) for key in ("evaluations", "impacts")))

    def search(self) -> Population:
        """Return the last generation of the genetic algorithm."""
        total, shots = self.settings["generations"], len(self.simulator.shots)
        begun, effort = None, Effort()
        if "search" in self.store:
            effort = self.spent
            generation, points, costs = self.store["search"]["value"]
            begun = Population(generation, np.array(points), np.array(costs))

        def costs_of(points: Floats) -> Floats:
            effort.add(len(points), shots)
            return self.cost.of(self.simulator.launches(points))

        def keep(survivors: Population) -> None:
            self.best = float(survivors.costs.min())
            value = [survivors.generation, survivors.points.tolist(), survivors.costs.tolist()]
            self._keep("search", value, effort)
            self._report("search", survivors.generation, total)

        if begun is not None and (begun.generation >= total or "refined 0" in self.store):
            return begun
        return search(
            costs_of, len(self.simulator.free), population=self.settings["population"], generations=total,
            seed=self.settings["seed"], begun=begun, after_generation=keep,
        )  # fmt: skip

    def refine(self, survivors: Population) -> list[tuple[Floats, float]]:
        """Return the end points and costs of the refinements of the best survivors."""
        starts = survivors.best(self.settings["refined"])
        ends = []
        for place, start in enumerate(starts):
            once = self._reporting("refinement", len(starts))

            def compute(start: Floats = start) -> list[Any]:
                end = refine(self.simulator, self.cost, start)
                self.best = min(self.best, end.cost)
                return [end.point.tolist(), end.cost]

            point, cost = once(f"refined {place}", compute)
            self.best = min(self.best, cost)
            ends.append((np.array(point), float(cost)))
        return ends

    def result(self, notes: tuple[Note, ...]) -> Identification:
        """Run all stages."""
        ends = self.refine(self.search())
        costs = [cost for _, cost in ends]
        point = ends[int(np.argmin(costs))][0]
        simulated = self.simulator.launch(point)
        measured = self.simulator.shots.launches
        reckoned = scatter(simulated - measured, self.noise)
        information = identifiability(self.simulator, point, reckoned)
        held, samples = self._resampled(point, information)
        profiles = self._profiles(point, reckoned, information)
        free = self.simulator.free
        shots = self.simulator.shots
        confidence = self.settings["confidence"]
        intervals = self._intervals(point, information, samples, profiles)
        before = self.simulator.before()
        deviations = {
            name: _deviation(measured[place], simulated[place], before[place], None if held is None else held[place])
            for place, name in enumerate(shots.quantities)
        }
        warnings = fit_warnings(self.simulator, point, information, costs, deviations, intervals, profiles)
        files = [f"{each.name}, SHA-256 {each.sha256}" for each in shots.provenance.files]
        spans = ", ".join(f"{each.name} {_span(each, intervals[each.name])}" for each in free.declared())
        parameters = free.parameters(
            point, name=f"identified from {Path(shots.source).name}".replace("/", " "), reference=f"{len(shots)} shots",
            source="; ".join([f"clubface identify: {self.settings['cost']} cost", *files]),
            caveats=(*(each.sentence for each in warnings), f"{100 * confidence:g}% intervals: {spans}"),
        )  # fmt: skip
        spent = self.spent
        return Identification(
            model=free.fixed.model, club=shots.club.name, parameters=parameters, free=free.names,
            intervals=intervals, confidence=confidence,
            method="bootstrap" if len(samples) else "information",
            cost=min(costs), cost_holdout=float("nan") if held is None else self.cost.value(held),
            cost_kind=self.settings["cost"],
            deviations=deviations,
            evaluations=spent.evaluations, impacts=spent.impacts, wall_s=self.seconds, shots=len(shots),
            dropped=shots.dropped, refined=tuple(costs), samples=samples, held_out=held,
            identifiability=information, profiles=profiles, at_bound=at_bound(free, point),
            warnings=warnings, notes=notes, settings=dict(self.settings), loft_origins=shots.loft_origins,
            provenance=shots.provenance,
        )  # fmt: skip

    def _resampled(self, point: Floats, information: Identifiability) -> tuple[Floats | None, Floats]:
        """Return held-out launches and bootstrapped parameters [SI]; empty if not requested."""
        folds, count, seed = (self.settings[name] for name in ("folds", "bootstrap", "seed"))
        free = self.simulator.free
        held, samples = None, np.empty((0, len(free)))
        if folds or count:
            refits = Refits(self.simulator, self.cost, point, information.errors)
            if folds:
                held = held_out(refits, folds, seed, self._reporting("hold-out", folds))
            if count:
                samples = free.values(bootstrap(refits, count, seed, self._reporting("bootstrap", count)))
        return held, samples

    def _profiles(self, point: Floats, noise: Floats, information: Identifiability) -> dict[str, Profile]:
        names = self.settings["profiles"]
        if not names:
            return {}
        profiler = Profiler(self.simulator, noise, information.errors)
        # The maximum likelihood point, by least squares from the fit with another cost.
        most_likely = self._once("most likely", lambda: refine(self.simulator, profiler.cost, point).point.tolist())
        optimum = np.array(most_likely)
        once = self._reporting("profiles", len(names))

        def compute(place: int) -> list[Any]:
            each = profiler.profile(place, optimum)
            return [each.values.tolist(), each.rise.tolist(), list(each.interval), list(each.closed)]

        profiles = {}
        for name in names:
            place = self.simulator.free.names.index(name)
            values, rise, interval, closed = once(f"profile {name}", lambda place=place: compute(place))
            profiles[name] = Profile(name, np.array(values), np.array(rise), tuple(interval), tuple(closed))
        return profiles

    def _intervals(
        self, point: Floats, information: Identifiability, samples: Floats, profiles: Mapping[str, Profile]
    ) -> dict[str, tuple[float, float]]:
        """Return one confidence interval per parameter.

        For few groups of shots, the bootstrap interval is extended to include the interval from derivatives. For a
        parameter that Fisher's information finds unknown, it is extended to its profile interval or bounds, and to the
        fit itself: along a direction that changes no launch, refits either stay at the fit or drift.
        """
        free = self.simulator.free
        confidence, groups = self.settings["confidence"], int(self.simulator.shots.groups.max()) + 1
        low, high = np.full(len(free), np.inf), np.full(len(free), -np.inf)
        if len(samples):
            low, high = interval_of(samples, confidence, groups)
        if groups < FEWEST_GROUPS or not len(samples):
            reach = NormalDist().inv_cdf(0.5 * (1.0 + confidence))
            reach = np.minimum(reach * errors_of_minimum(self.simulator, self.cost, point, information), 1.0)
            ends = [free.values(np.clip(point + sign * reach, 0.0, 1.0)) for sign in (-1.0, 1.0)]
            low, high = np.minimum(low, ends[0]), np.maximum(high, ends[1])
        intervals = {name: (float(a), float(b)) for name, a, b in zip(free.names, low, high, strict=True)}
        fit = free.values(point)
        for name, value, least, most in zip(free.names, fit, free.lower, free.upper, strict=True):
            if name in information.unknown:
                a, b = profiles[name].interval if name in profiles else (float(least), float(most))
                intervals[name] = (min(intervals[name][0], a, float(value)), max(intervals[name][1], b, float(value)))
        return intervals

    def _report(self, stage: str, done: int, total: int) -> None:
        if self.progress is not None:
            self.progress(stage, done, total, self.best)

    def _keep(self, name: str, value: Any, spent: Effort) -> None:
        effort = {"evaluations": spent.evaluations, "impacts": spent.impacts, "seconds": self.seconds}
        self.store.keep(name, {"value": value, **effort})

    def _once(self, name: str, compute: Callable[[], Any]) -> Any:
        """Return the kept value of a part, or compute and keep it."""
        if name not in self.store:
            before = replace(self.simulator.effort)
            value = compute()
            self._keep(name, value, self.simulator.effort.since(before))
        return self.store[name]["value"]

    def _reporting(self, stage: str, total: int) -> Callable[[str, Callable[[], Any]], Any]:
        """Return :meth:`_once` for the parts of a stage, with progress reports."""
        done = 0

        def once(name: str, compute: Callable[[], Any]) -> Any:
            nonlocal done
            value = self._once(name, compute)
            done += 1
            self._report(stage, done, total)
            return value

        return once


def _span(parameter: Parameter, interval: tuple[float, float]) -> str:
    unit = display_unit(parameter.name, parameter.unit)
    return " to ".join(units.show(end, unit, 4) for end in interval)


def _deviation(measured: Floats, simulated: Floats, before: Floats, held: Floats | None) -> Deviation:
    there = np.isfinite(measured)
    off = (simulated - measured)[there]
    return Deviation(
        mean=float(np.mean(np.abs(measured[there]))), mae=float(np.mean(np.abs(off))), bias=float(np.mean(off)),
        std=float(np.std(off, ddof=1)) if len(off) > 1 else float("nan"),
        mae_before=float(np.mean(np.abs((before - measured)[there]))),
        mae_holdout=float("nan") if held is None else float(np.mean(np.abs((held - measured)[there]))),
    )  # fmt: skip


@recorded
def identify(
    shots: RecordedShots | str | os.PathLike[str],
    *,
    club: str | os.PathLike[str] | Club,
    model: str,
    parameters: Parameters | None = None,
    free: str | Iterable[str] | None = None,
    bounds: Mapping[str, tuple[float | str, float | str]] | None = None,
    tied: Mapping[str, str] | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    only: str | None = None,
    mismatch: str = "refuse",
    quantities: Iterable[str] | None = None,
    compared_at: str = DELIVERY,
    groups: Sequence[object] | NDArray[np.generic] | None = None,
    cost: str = "published",
    normaliser: str = "absolute",
    noise: Mapping[str, ValueLike] | None = None,
    population: int = genetic.POPULATION,
    generations: int = genetic.GENERATIONS,
    refined: int = genetic.REFINED,
    folds: int = FOLDS,
    bootstrap: int = BOOTSTRAP,
    profiles: Iterable[str] | None = None,
    confidence: float = 0.95,
    seed: int = 1,
    accuracy: float | None = None,
    threads: int | None = None,
    checkpoint: str | os.PathLike[str] | None = None,
    resume: bool = False,
    progress: Progress | None = None,
) -> Identification:
    """Identify the parameters of a model from recorded shots, with their uncertainty.

    The method is that of Caldwell and McPhee (2023), section 2.3. A genetic algorithm searches the whole range of the
    parameters, its best points are refined with exact derivatives, and the best result is kept. The fit is then
    repeated on parts of the shots (hold-out) and on shots drawn with replacement (bootstrap), and profile likelihoods
    are computed.

    Parameters
    ----------
    shots
        Recorded shots, or a file that :func:`clubface.shots.read` reads.
    club, ball
        As for :func:`impact`.
    model
        Name of a model.
    parameters
        Values of the parameters that are not free, as for :func:`impact`.
    free
        Names of the parameters to identify, or "all". Default: those identified in the publication of the model.
    bounds
        Pairs of values by name, text with a unit or SI numbers, within the bounds of the model. Default: the bounds of
        the model.
    tied
        Parameters that follow a free one, by name: ``{"ring_modulus": "shear_modulus"}``.
    only, mismatch, groups
        As for :func:`evaluate`; shots of a group are held out and resampled together.
    quantities
        Launch quantities to compare. Default: the measured ones among ball speed, launch angle, azimuth, backspin and
        sidespin.
    compared_at
        As for :func:`evaluate`, with dynamic loft and face angle solved for every parameter set; derivatives include
        the change of the solution. At "delivery", lofts that a monitor computed from the ball bring the monitor's own
        model into the fit.
    cost
        "published" is equation 22 of Caldwell and McPhee; "least-squares" is weighted by the noise; "robust" is the
        same with Huber's loss.
    normaliser
        For "published": "absolute" or "signed", see :func:`clubface.inference.identification.simulator.cost_of`.
    noise
        Standard deviation of the measurement by quantity, text with a unit or SI numbers.
    population, generations, refined
        Population size, number of generations, and number of refined points. The defaults, 200, 100 and 5, are those of
        Caldwell and McPhee.
    folds
        Number of folds of the hold-out; 0 for none.
    bootstrap
        Number of bootstrap samples. With 0, the intervals assume normally distributed deviations of independent shots.
    profiles
        Parameters for which profile likelihoods are computed. Default: all free ones.
    confidence
        Confidence level of the intervals.
    seed
        Seed of all random numbers. The same seed gives bit-identical results on any number of threads.
    accuracy, threads
        As for :func:`impact`.
    checkpoint
        Folder for finished parts; it is removed at the end of the run.
    resume
        True raises FileError if the checkpoint belongs to other shots or settings; False replaces it.
    progress
        Function called with the stage, the amount done, the total, and the smallest cost so far.

    Raises
    ------
    InputError
        The shots cannot be used, belong to another club, or do not determine as many parameters as are free; or an
        option is out of range.
    FileError
        A file cannot be read, or the checkpoint belongs to other shots or settings and ``resume`` is set or another run
        uses it.
    """
    reduced_model(model, "one with derivatives")
    counts = {
        "population": (population, 4, 100_000), "generations": (generations, 1, 100_000),
        "refined": (refined, 1, population), "folds": (folds, 0, 1000), "bootstrap": (bootstrap, 0, 100_000),
        "seed": (seed, 0, MOST_SEED),
    }  # fmt: skip
    for name, given in counts.items():
        check_count(name, *given)
    if folds == 1:
        raise InputError("folds", folds, "0, or at least 2")
    if not 0.5 <= confidence < 1.0:
        raise InputError("confidence", confidence, "from 0.5 to below 1")
    (head, *_), fixed = equipped(model, club, ball, parameters)
    if fixed.includes_face and fixed.characteristic_time is None:
        # The parameters include the face of the club: after the fit, of the club used for the shots.
        fixed = replace(fixed, characteristic_time=head.characteristic_time or None)
    for name, value in fixed.values.items():
        if not isinstance(value, float):
            raise InputError(name, value, "a single number: one set of parameters is identified from all shots")
    chosen = free_parameters(fixed, free, bounds=bounds, tied=tied)
    profiled = chosen.names if profiles is None else tuple(profiles)
    for name in profiled:
        if name not in chosen.names:
            raise InputError("profiles", name, "free parameters: " + ", ".join(chosen.names))
    prepared = prepared_shots(
        shots, club=head, ball=ball, only=only, mismatch=mismatch, quantities=quantities, groups=groups,
        parameters=fixed, compared_at=compared_at,
    )  # fmt: skip
    notes = list(prepared.notes)
    deviations = noise_of(prepared.quantities, noise)
    cores, tight = thread_count(threads), tolerance(accuracy)
    simulator = Simulator(prepared, chosen, accuracy=tight, threads=cores)
    start = chosen.points(np.array([fixed.values[name] for name in chosen.names], dtype=float))
    notes += check_information(simulator, start, deviations)
    judged = cost_of(cost, prepared.launches, prepared.quantities, noise=noise, normaliser=normaliser)
    settings = {
        "model": model, "cost": cost, "normaliser": normaliser, "population": population, "generations": generations,
        "refined": refined, "folds": min(folds, int(prepared.groups.max()) + 1), "bootstrap": bootstrap,
        "profiles": list(profiled),
        "confidence": confidence, "seed": seed, "accuracy": tight, "quantities": list(prepared.quantities),
        "compared_at": compared_at,
        "noise": deviations.tolist(), "bounds": {
            name: [float(low), float(high)]
            for name, low, high in zip(chosen.names, chosen.lower, chosen.upper, strict=True)
        },
        "tied": dict(chosen.tied),
    }  # fmt: skip
    content = {
        "set of shots": [prepared.columns, prepared.launches, prepared.start, prepared.groups],
        "parameter": fixed.values,
        **settings,
    }
    with Finished() if checkpoint is None else Store(Path(checkpoint), content, resume=resume) as store:
        stages = Stages(simulator, judged, deviations, settings, store, progress)
        try:
            identification = stages.result(tuple(notes))
        except KeyboardInterrupt:
            if store.folder is None or not len(store):
                raise
            message = f"interrupted: finished parts are kept in {store.folder}; the same command continues from there"
            raise KeyboardInterrupt(message) from None
        store.remove()
    return identification
