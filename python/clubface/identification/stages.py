"""The stages of an identification: search, refinement, hold-out, bootstrap, profiles; finished parts are kept."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from statistics import NormalDist
from typing import Any

import numpy as np

from clubface import units
from clubface.equipment.models import Parameter
from clubface.identification.asymptotic import errors_of_minimum
from clubface.identification.checkpoint import Checkpoint
from clubface.identification.cost import Cost
from clubface.identification.identifiability import Identifiability, identifiability, scatter
from clubface.identification.profile import Profile, Profiler
from clubface.identification.refine import refine
from clubface.identification.resampling import Refits, bootstrap, held_out, interval_of
from clubface.identification.result import Deviation, Identification
from clubface.identification.sanity import apart, at_bound, contradicted, fit_warnings, worse
from clubface.identification.search import Population, search
from clubface.identification.simulator import Effort, Simulator
from clubface.support.arrays import Floats

FEWEST_GROUPS = 10
"""Fewer groups of shots than these can be drawn in too few ways for a bootstrap alone."""

Progress = Callable[[str, int, int, float], object]
"""Stage, done, of how much, least cost so far."""


class Stages:
    """Runs the stages in order; a finished part is not computed again.

    Parameters
    ----------
    simulator, cost
        Of all shots.
    noise
        Standard deviation of each quantity [SI].
    settings
        What was asked for.
    checkpoint
        Keeps the parts.
    progress
        Told after every part.
    """

    def __init__(
        self,
        simulator: Simulator,
        cost: Cost,
        noise: Floats,
        settings: Mapping[str, Any],
        checkpoint: Checkpoint,
        progress: Progress | None,
    ) -> None:
        self.simulator = simulator
        self.cost = cost
        self.noise = noise
        self.settings = settings
        self.checkpoint = checkpoint
        self.best = np.inf
        self._progress = progress or (lambda stage, done, of, best: None)

    def search(self) -> Population:
        """Return the last generation of the genetic algorithm."""
        total, shots = self.settings["generations"], len(self.simulator.shots)
        kept = self.checkpoint.value("search")
        begun = None if kept is None else Population(kept[0], np.array(kept[1]), np.array(kept[2]))
        effort = Effort() if kept is None else self.checkpoint.spent

        def costs_of(points: Floats) -> Floats:
            effort.add(len(points), shots)
            return self.cost.of(self.simulator.launches(points))

        def keep(survivors: Population) -> None:
            self.best = float(survivors.costs.min())
            value = [survivors.generation, survivors.points.tolist(), survivors.costs.tolist()]
            self.checkpoint.keep("search", value, effort)
            self._progress("search", survivors.generation, total, self.best)

        if begun is not None and (begun.generation >= total or self.checkpoint.value("refined 0") is not None):
            return begun
        return search(
            costs_of, len(self.simulator.free), population=self.settings["population"], generations=total,
            seed=self.settings["seed"], begun=begun, after_generation=keep,
        )  # fmt: skip

    def refine(self, survivors: Population) -> list[tuple[Floats, float]]:
        """Return the points and costs at which the refinements of the best survivors end."""
        starts = survivors.best(self.settings["refined"])
        found = []
        for place, start in enumerate(starts):
            once = self._telling("refinement", len(starts))

            def compute(start: Floats = start) -> list[Any]:
                end = refine(self.simulator, self.cost, start)
                self.best = min(self.best, end.cost)
                return [end.point.tolist(), end.cost]

            point, cost = once(f"refined {place}", compute)
            self.best = min(self.best, cost)
            found.append((np.array(point), float(cost)))
        return found

    def result(self, notes: tuple[str, ...]) -> Identification:
        """Run all stages."""
        ends = self.refine(self.search())
        costs = [cost for _, cost in ends]
        point = ends[int(np.argmin(costs))][0]
        simulated = self.simulator.launch(point)
        measured = self.simulator.shots.launches
        reckoned = scatter(simulated - measured, self.noise)
        told = identifiability(self.simulator, point, reckoned)
        held, samples = self._resampled(point, told)
        profiles = self._profiles(point, reckoned, told)
        free = self.simulator.free
        shots = self.simulator.shots
        confidence = self.settings["confidence"]
        intervals = self._intervals(point, told, samples, profiles)
        before = self.simulator.before()
        deviations = {
            name: _deviation(measured[place], simulated[place], before[place], None if held is None else held[place])
            for place, name in enumerate(shots.quantities)
        }
        values = dict(zip(free.names, free.values(point).tolist(), strict=True))
        warnings = (
            *worse(deviations, free.fixed.name),
            *fit_warnings(self.simulator, point, told, costs),
            *apart(intervals, profiles),
            *contradicted(values, intervals, profiles),
        )
        spans = ", ".join(f"{each.name} {_span(each, intervals[each.name])}" for each in free.declared())
        parameters = free.parameters(
            point, name=f"identified from {Path(shots.source).name}".replace("/", " "), reference=f"{len(shots)} shots",
            source=f"clubface identify: {self.settings['cost']} cost",
            caveats=(*warnings, f"{100 * confidence:g}% intervals: {spans}"),
        )  # fmt: skip
        spent = self.checkpoint.spent
        return Identification(
            model=free.fixed.model, club=shots.club.name, parameters=parameters, free=free.names,
            intervals=intervals, confidence=confidence,
            method="bootstrap" if len(samples) else "information",
            cost=min(costs), cost_holdout=float("nan") if held is None else self.cost.value(held),
            cost_kind=self.settings["cost"],
            deviations=deviations,
            evaluations=spent.evaluations, impacts=spent.impacts, wall_s=self.checkpoint.seconds, shots=len(shots),
            dropped=shots.dropped, refined=tuple(costs), samples=samples, held_out=held,
            identifiability=told, profiles=profiles, at_bound=at_bound(free, point),
            warnings=warnings, notes=notes, settings=dict(self.settings), loft_origins=shots.loft_origins,
        )  # fmt: skip

    def _resampled(self, point: Floats, told: Identifiability) -> tuple[Floats | None, Floats]:
        """Return held-out launches and bootstrapped parameters [SI], none of either where none is asked for."""
        folds, count, seed = (self.settings[name] for name in ("folds", "bootstrap", "seed"))
        free = self.simulator.free
        held, samples = None, np.empty((0, len(free)))
        if folds or count:
            refits = Refits(self.simulator, self.cost, point, told.errors)
            if folds:
                held = held_out(refits, folds, seed, self._telling("hold-out", folds))
            if count:
                samples = free.values(bootstrap(refits, count, seed, self._telling("bootstrap", count)))
        return held, samples

    def _profiles(self, point: Floats, noise: Floats, told: Identifiability) -> dict[str, Profile]:
        names = self.settings["profiles"]
        if not names:
            return {}
        profiler = Profiler(self.simulator, noise, told.errors)
        optimum = np.array(self.checkpoint.once("most likely", lambda: profiler.most_likely(point).tolist()))
        once = self._telling("profiles", len(names))

        def compute(place: int) -> list[Any]:
            each = profiler.profile(place, optimum)
            return [each.values.tolist(), each.rise.tolist(), list(each.interval), list(each.closed)]

        found = {}
        for name in names:
            place = self.simulator.free.names.index(name)
            values, rise, interval, closed = once(f"profile {name}", lambda place=place: compute(place))
            found[name] = Profile(name, np.array(values), np.array(rise), tuple(interval), tuple(closed))
        return found

    def _intervals(
        self, point: Floats, told: Identifiability, samples: Floats, profiles: Mapping[str, Profile]
    ) -> dict[str, tuple[float, float]]:
        """Return an interval a parameter.

        That of few groups of shots takes in the one without a bootstrap. One that Fisher's information finds unknown
        takes in its profile or bounds, and the fit itself: a refit begins at the fit and would not leave it along a
        direction that changes nothing, or leaves it to wherever the next shots lead.
        """
        free = self.simulator.free
        confidence, groups = self.settings["confidence"], int(self.simulator.shots.groups.max()) + 1
        low, high = np.full(len(free), np.inf), np.full(len(free), -np.inf)
        if len(samples):
            low, high = interval_of(samples, confidence, groups)
        if groups < FEWEST_GROUPS or not len(samples):
            reach = NormalDist().inv_cdf(0.5 * (1.0 + confidence))
            reach = np.minimum(reach * errors_of_minimum(self.simulator, self.cost, point, told), 1.0)
            ends = [free.values(np.clip(point + sign * reach, 0.0, 1.0)) for sign in (-1.0, 1.0)]
            low, high = np.minimum(low, ends[0]), np.maximum(high, ends[1])
        found = {name: (float(a), float(b)) for name, a, b in zip(free.names, low, high, strict=True)}
        fit = free.values(point)
        for name, value, least, most in zip(free.names, fit, free.lower, free.upper, strict=True):
            if name in told.unknown:
                a, b = profiles[name].interval if name in profiles else (float(least), float(most))
                found[name] = (min(found[name][0], a, float(value)), max(found[name][1], b, float(value)))
        return found

    def _telling(self, stage: str, total: int) -> Callable[[str, Callable[[], Any]], Any]:
        """Return ``once`` of the checkpoint, which tells how far the stage is."""
        done = 0

        def once(name: str, compute: Callable[[], Any]) -> Any:
            nonlocal done
            value = self.checkpoint.once(name, compute)
            done += 1
            self._progress(stage, done, total, self.best)
            return value

        return once


def _span(of: Parameter, interval: tuple[float, float]) -> str:
    unit = units.display_unit(of.name, of.unit)
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
