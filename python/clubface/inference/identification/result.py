"""The result of an identification, and the checks of its shots and fit.

The result of an identification.

Checks of shots and fit: enough information, bounds, contact times and forces.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.models import model as model_named
from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError
from clubface.inference.identification.intervals import Identifiability, Profile, identifiability, outside
from clubface.inference.identification.problem import FreeParameters
from clubface.inference.identification.simulator import Simulator
from clubface.quantities import display_unit
from clubface.shots.loft_origin import LoftOrigin
from clubface.shots.measured import QUANTITIES
from clubface.shots.recorded import RejectedRow
from clubface.simulation.results import outputs
from clubface.support.arrays import Floats
from clubface.units import from_si

PARAMETER_HEADS = ("parameter", "value", "from", "to", "profile", "identified")
DEVIATION_HEADS = ("quantity", "mean size", "MAE", "held out", "before", "bias", "std")


@dataclass(frozen=True, kw_only=True, eq=False)
class Deviation:
    """How far the launches of a fit are from the measured ones, in one quantity [SI].

    Attributes
    ----------
    mean
        Mean magnitude of the measured values.
    mae
        Mean absolute error.
    bias
        Mean of simulated minus measured values.
    std
        Standard deviation of simulated minus measured values.
    mae_holdout
        Mean absolute error if every shot is simulated with a fit that did not see it; NaN without hold-out.
    mae_before
        Mean absolute error with the set that the fit began with, such as the published one.
    """

    mean: float
    mae: float
    bias: float
    std: float
    mae_holdout: float
    mae_before: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Identification:
    """Identified parameters, and how well the shots determine them.

    Attributes
    ----------
    model
        Name of the model.
    club
        Name of the club.
    parameters
        All parameters of the model. Use them wherever a parameter set is taken; ``to_toml()`` writes them to a file.
    free
        Names of the parameters that were identified.
    intervals
        Lower and upper end of the confidence interval of each free parameter [SI].
    confidence
        Confidence level of the intervals.
    method
        How the intervals were made: "bootstrap", or without one "information", from derivatives and normally
        distributed deviations.
    cost
        Cost at the identified parameters.
    cost_holdout
        Cost if every shot is simulated with a fit that did not see it; NaN without hold-out.
    cost_kind
        "published" (equation 22 of Caldwell and McPhee 2023), "least-squares" or "robust".
    deviations
        A :class:`Deviation` for each launch quantity.
    evaluations, impacts
        How often all shots were simulated, and how many impacts that makes.
    wall_s
        Time taken [s], including interrupted runs.
    shots
        Number of shots used.
    dropped
        Rows that were not used, with reasons.
    refined
        Costs at which the refinements ended.
    samples
        Parameters of the bootstrap samples [SI], shape (samples, free).
    held_out
        Launches of every shot by a fit that did not see it [SI], shape (quantities, shots); None without hold-out.
    identifiability
        Fisher's information of the shots.
    profiles
        Profile likelihoods by parameter.
    at_bound
        Names of the free parameters whose value meets a bound of the search.
    warnings
        What you must know before you use the parameters.
    notes
        What was assumed about the shots.
    settings
        The options of the identification.
    loft_origins
        What the shots tell of where their dynamic lofts come from.
    """

    model: str
    club: str
    parameters: ParameterSet
    free: tuple[str, ...]
    intervals: Mapping[str, tuple[float, float]]
    confidence: float
    method: str
    cost: float
    cost_holdout: float
    cost_kind: str
    deviations: Mapping[str, Deviation]
    evaluations: int
    impacts: int
    wall_s: float
    shots: int
    dropped: tuple[RejectedRow, ...]
    refined: tuple[float, ...]
    samples: NDArray[Any]
    held_out: NDArray[Any] | None
    identifiability: Identifiability
    profiles: Mapping[str, Profile]
    at_bound: tuple[str, ...]
    warnings: tuple[str, ...]
    notes: tuple[str, ...]
    settings: Mapping[str, Any]
    loft_origins: tuple[LoftOrigin, ...] = ()

    def to_toml(self) -> str:
        """Write the parameters as a file that ``parameters=`` and ``--parameters`` read."""
        return self.parameters.to_toml()

    def to_dict(self) -> dict[str, Any]:
        """Return the result as plain values for JSON, in SI; ``units`` holds their units."""
        told = self.identifiability
        return {
            "model": self.model,
            "club": self.club,
            "parameters": dict(self.parameters.values),
            "intervals": {name: list(pair) for name, pair in self.intervals.items()},
            "cost": self.cost,
            "cost_holdout": self.cost_holdout,
            "evaluations": self.evaluations,
            "impacts": self.impacts,
            "wall_s": self.wall_s,
            "units": self.parameters.units,
            "free": list(self.free),
            "confidence": self.confidence,
            "intervals_from": self.method,
            "cost_kind": self.cost_kind,
            "shots": self.shots,
            "dropped": [{"row": each.line, "reason": each.reason} for each in self.dropped],
            "refined": list(self.refined),
            "deviations": {name: _entry(name, each) for name, each in self.deviations.items()},
            "identifiability": {
                "standard_errors": dict(zip(told.names, told.errors.tolist(), strict=True)),
                "directions": [
                    {
                        "strength": each.strength, "words": each.words, "error": each.error,
                        "vector": each.vector.tolist(),
                    }
                    for each in told.directions
                ],
            },
            "profiles": {
                name: {
                    "values": each.values.tolist(), "rise": each.rise.tolist(), "interval": list(each.interval),
                }
                for name, each in self.profiles.items()
            },
            "at_bound": list(self.at_bound),
            "identified": {name: self.identified(name) for name in self.free},
            "warnings": list(self.warnings),
            "notes": list(self.notes),
            "loft_origins": [each._asdict() for each in self.loft_origins],
            "settings": dict(self.settings),
        }  # fmt: skip

    def identified(self, name: str) -> str:
        """Return whether the shots determine a parameter.

        "yes", "no", "from below only" or "from above only"; "not alone", where a combination with other parameters
        changes no launch; "at its bound", where the best value may lie beyond; or "contradicted", where an interval
        does not hold the value.
        """
        told = self.identifiability
        if not math.isfinite(told.errors[told.names.index(name)]):
            return "not alone"
        judged = "no" if name in told.unknown else "yes"
        verdict = self.profiles[name].verdict if name in self.profiles else judged
        if verdict == "no":
            return verdict
        if outside(float(self.parameters.values[name]), self.intervals[name], self.profiles.get(name)):
            return "contradicted"
        return "at its bound" if verdict == "yes" and name in self.at_bound else verdict

    def shown(self, name: str, value: float, digits: int = 4) -> str:
        """Return a value of a parameter as text, in the unit in which people read it."""
        unit = display_unit(name, model_named(self.model).parameter(name).unit)
        return units.show(value, unit, digits)

    def __repr__(self) -> str:
        return text(self)


def _entry(name: str, of: Deviation) -> dict[str, Any]:
    return {
        "unit": outputs()[name].unit, "mean": of.mean, "mae": of.mae, "bias": of.bias, "std": of.std,
        "mae_holdout": of.mae_holdout, "mae_before": of.mae_before,
    }  # fmt: skip


def headline(of: Identification) -> str:
    """Return one sentence: model, club, shots, cost."""
    held = "" if math.isnan(of.cost_holdout) else f", held out {of.cost_holdout:.5g}"
    kind = {"published": "published cost", "least-squares": "mean square", "robust": "robust cost"}[of.cost_kind]
    return f"{of.model}, {of.club}, {of.shots} shots: {kind} {of.cost:.5g}{held}"


def effort(of: Identification) -> str:
    """Return one sentence on what was computed."""
    return f"{of.evaluations:,} evaluations, {of.impacts:,} impacts, {of.wall_s:.1f} s"


def parameter_rows(of: Identification) -> list[list[str]]:
    """Return a row a free parameter: value, interval, profile likelihood interval, and whether it is identified."""
    rows = []
    for name in of.free:
        low, high = of.intervals[name]
        profile = of.profiles.get(name)
        span = ""
        if profile is not None:
            ends = [of.shown(name, value) for value in profile.interval]
            span = f"{ends[0] if profile.closed[0] else 'bound'} .. {ends[1] if profile.closed[1] else 'bound'}"
        value = of.shown(name, float(of.parameters.values[name]), 5)
        rows.append([name, value, of.shown(name, low), of.shown(name, high), span, of.identified(name)])
    return rows


def deviation_rows(of: Identification) -> list[list[str]]:
    """Return a row a launch quantity, in the units people read."""
    rows = []
    for name, each in of.deviations.items():
        unit = QUANTITIES.get(name) or display_unit(name, outputs()[name].unit)
        numbers = (each.mean, each.mae, each.mae_holdout, each.mae_before, each.bias, each.std)
        shown = ["" if math.isnan(number) else f"{from_si(number, unit):.4g}" for number in numbers]
        rows.append([f"{name} [{unit}]", *shown])
    return rows


def remarks(of: Identification) -> list[str]:
    """Return warnings, weak directions and notes, in this order."""
    weak = [f"weak: {each.words}" for each in of.identifiability.directions if each.strength == "weak"]
    left = [f"{_rows(len(of.dropped))} not used, the first: {_dropped(of)}"] if of.dropped else []
    return [*of.warnings, *weak, *left, *of.notes]


def text(of: Identification) -> str:
    """Return everything for the screen."""
    parts = [headline(of), effort(of), "", *_table(PARAMETER_HEADS, parameter_rows(of)), ""]
    parts += [*_table(DEVIATION_HEADS, deviation_rows(of))]
    said = remarks(of)
    return "\n".join(parts + ([""] + [f"* {each}" for each in said] if said else []))


def _rows(count: int) -> str:
    return "one row was" if count == 1 else f"{count} rows were"


def _dropped(of: Identification) -> str:
    first = of.dropped[0]
    return f"row {first.line}: {first.reason}"


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    widths = [max(len(each) for each in column) for column in zip(heads, *rows, strict=True)]
    lines = []
    for row in (heads, *rows):
        cells = [
            cell.rjust(width) if place else cell.ljust(width)
            for place, (cell, width) in enumerate(zip(row, widths, strict=True))
        ]
        lines.append("  ".join(cells).rstrip())
    return lines


AT_BOUND = 1e-4
"""A parameter within this part of its range of a bound meets it."""
WORSE, NOTHING = 0.05, 1e-6
"""Part by which a mean absolute error must grow to be called worse; less is the luck of the shots. A change of the
latter part of the mean size is rounding."""
CONTACT_TIME = (350e-6, 600e-6)
"""Mean contact times [s] outside this are unphysical: measured ones are 400 to 500 us."""
PEAK_FORCE = (8e3, 17e3)
"""Mean peak forces [N] outside this, at 50 m/s, are unphysical: measured drives reach 10 to 14 kN."""
REFERENCE_SPEED, SPEED_POWER = 50.0, 1.2
"""Hertz: the peak force grows with the speed [m/s] to the power 6/5."""


def check_information(simulator: Simulator, point: Floats, noise: Floats) -> list[str]:
    """Refuse shots that cannot determine the free parameters, and return remarks about few shots.

    The message names what the shots leave open. ``point`` is one at which the parameters are tried, such as that of the
    published set.
    """
    shots, free = simulator.shots, simulator.free
    different = shots.different()
    if different < 2:
        what = "the number of shots" if len(shots) == 1 else f"the number of different ones among {len(shots)} shots"
        advice = "at least two, with different deliveries: one shot leaves nothing to judge the fit by"
        open_ = _open(simulator.of(shots.select(np.array([0]))), point, noise)  # copies tell no more than one
        raise InputError(what, different, advice + (f". It does not determine: {open_}" if open_ else ""))
    kinds = int(np.isfinite(shots.launches).any(axis=1).sum())
    distinct = shots.distinct_deliveries()
    values = min(int(np.isfinite(shots.launches).sum()), kinds * distinct)
    notes = []
    if distinct == 1:
        notes.append(f"all {len(shots)} shots have the same delivery: how the launch depends on it is not tested")
    if different < len(shots):
        notes.append(f"only {different} of {len(shots)} shots are different: if the others are copies, take them out")
    if values < len(free):
        same = f", since all {len(shots)} shots have the same delivery" if distinct == 1 else ""
        raise InputError(
            "the number of free parameters", len(free),
            f"at most {values}, as many as there are different measured values{same}. Not determined:"
            f" {_open(simulator, point, noise)}",
        )  # fmt: skip
    if len(shots) < 5 * len(free):
        notes.append(f"{len(shots)} shots are few for {len(free)} parameters: intervals are rough")
    return notes


def _open(simulator: Simulator, point: Floats, noise: Floats) -> str:
    """Name the directions that the shots leave open."""
    told = identifiability(simulator, point, noise)
    return "; ".join(each.words for each in told.directions if each.strength in ("none", "unknown"))


def fit_warnings(simulator: Simulator, point: Floats, told: Identifiability, costs: list[float]) -> list[str]:
    """Return the warnings about a fit: bounds met, unphysical contacts, what is not identified, a doubtful search."""
    free = simulator.free
    found = list(_bounds(free, point)) + _contacts(simulator, point)
    for each in told.directions:
        if each.strength in ("none", "unknown"):
            found.append(f"not identified: {each.words}")
    best = min(costs)
    if len(costs) > 1 and sum(cost <= best * (1.0 + 1e-3) + 1e-12 for cost in costs) == 1:
        second = sorted(costs)[1]
        found.append(
            f"only one of {len(costs)} refinements reached the least cost, {best:.6g} (the next {second:.6g}): another"
            " seed or more generations may find a better fit"
        )
    return found


def apart(intervals: Mapping[str, tuple[float, float]], profiles: Mapping[str, Profile]) -> list[str]:
    """Return a warning if the fit and the least-squares fit, to which the profiles belong, exclude each other."""
    names = [
        name
        for name, each in profiles.items()
        if each.interval[0] > intervals[name][1] or each.interval[1] < intervals[name][0]
    ]
    if not names:
        return []
    return [
        f"the likelihood puts {', '.join(names)} outside the interval: the model does not describe these shots, so that"
        " its parameters depend on what the fit is judged by"
    ]


def at_bound(free: FreeParameters, point: Floats) -> tuple[str, ...]:
    """Return the names of the parameters that meet a bound."""
    return tuple(name for name, place in zip(free.names, point, strict=True) if _meets(place))


def contradicted(
    values: Mapping[str, float], intervals: Mapping[str, tuple[float, float]], profiles: Mapping[str, Profile]
) -> list[str]:
    """Return a warning of parameters [SI] whose interval, or that of their profile, does not hold their value."""
    names = [name for name in intervals if outside(float(values[name]), intervals[name], profiles.get(name))]
    if not names:
        return []
    return [
        f"outside of their own interval: {', '.join(names)}; fits to parts of the shots, or the likelihood, lead"
        " elsewhere, so that neither value nor interval can be trusted"
    ]


def worse(deviations: Mapping[str, Deviation], before: str) -> list[str]:
    """Return a warning of the quantities that the fit makes worse than the set called ``before``."""
    told = []
    for name, each in deviations.items():
        if each.mae > (1.0 + WORSE) * each.mae_before + NOTHING * each.mean:
            unit = QUANTITIES.get(name) or display_unit(name, outputs()[name].unit)
            after, then = (units.from_si(value, unit) for value in (each.mae, each.mae_before))
            told.append(f"{name} (MAE {after:.3g} {unit}, {then:.3g} {unit} before)")
    if not told:
        return []
    return [f"the fit makes some quantities worse than {before}, with which it began: {', '.join(told)}"]


def _meets(place: float) -> bool:
    return place < AT_BOUND or place > 1.0 - AT_BOUND


def _bounds(free: FreeParameters, point: Floats) -> list[str]:
    found = []
    for each, place, low, high in zip(free.declared(), point, free.lower, free.upper, strict=True):
        side, bound = ("lower", low) if place < AT_BOUND else ("upper", high)
        if _meets(place):
            shown = units.show(float(bound), display_unit(each.name, each.unit), 4)
            found.append(f"{each.name} meets its {side} bound, {shown}: the best value may lie beyond it")
    return found


def _contacts(simulator: Simulator, point: Floats) -> list[str]:
    times, forces = simulator.contact(point)
    if not np.isfinite(times).all():
        return []
    found = []
    time, force = float(np.mean(times)), float(np.mean(forces))
    if not CONTACT_TIME[0] <= time <= CONTACT_TIME[1]:
        found.append(f"contact lasts {units.fixed(time, 'us', 0)} on average; measured contacts last 400 to 500 us")
    scale = (simulator.shots.mean("speed") / REFERENCE_SPEED) ** SPEED_POWER
    low, high = (limit * scale for limit in PEAK_FORCE)
    if not low <= force <= high:
        usual = f"{10 * scale:.0f} to {14 * scale:.0f} kN"
        found.append(
            f"the normal force peaks at {units.fixed(force, 'kN', 1)} on average; measured impacts of this"
            f" speed at {usual}"
        )
    return found
