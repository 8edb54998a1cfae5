"""The result of an identification."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from clubface import units
from clubface.equipment.models import model as model_named
from clubface.equipment.parameters import ParameterSet
from clubface.identification.identifiability import Identifiability
from clubface.identification.profile import Profile, outside
from clubface.measured.shots import QUANTITIES
from clubface.recorded.loft_origin import LoftOrigin
from clubface.recorded.shots import RejectedRow
from clubface.simulation.quantities import outputs
from clubface.units import display_unit, from_si

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
        unit = units.display_unit(name, model_named(self.model).parameter(name).unit)
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
