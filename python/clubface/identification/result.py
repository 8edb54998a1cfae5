"""The result of an identification."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from clubface import units
from clubface.equipment.models import model as model_named
from clubface.equipment.parameters import ParameterSet
from clubface.identification.identifiability import Identifiability
from clubface.identification.profile import Profile
from clubface.recorded.shots import RejectedRow
from clubface.simulation.quantities import outputs

if TYPE_CHECKING:
    from numpy.typing import NDArray


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
    """

    mean: float
    mae: float
    bias: float
    std: float
    mae_holdout: float


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
    warnings
        What you must know before you use the parameters.
    notes
        What was assumed about the shots.
    settings
        The options of the identification.
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
    warnings: tuple[str, ...]
    notes: tuple[str, ...]
    settings: Mapping[str, Any]

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
            "identified": {name: self.identified(name) for name in self.free},
            "warnings": list(self.warnings),
            "notes": list(self.notes),
            "settings": dict(self.settings),
        }  # fmt: skip

    def identified(self, name: str) -> str:
        """Return whether the shots determine a parameter.

        "yes", "no", "from below only" or "from above only"; or "not alone", where a combination with other parameters
        changes no launch.
        """
        told = self.identifiability
        if not math.isfinite(told.errors[told.names.index(name)]):
            return "not alone"
        if name in self.profiles:
            return self.profiles[name].verdict
        return "no" if name in told.unknown else "yes"

    def shown(self, name: str, value: float, digits: int = 4) -> str:
        """Return a value of a parameter as text, in the unit in which people read it."""
        unit = units.display_unit(name, model_named(self.model).parameter(name).unit)
        return units.show(value, unit, digits)

    def __repr__(self) -> str:
        from clubface.identification.report import text

        return text(self)


def _entry(name: str, of: Deviation) -> dict[str, Any]:
    return {
        "unit": outputs()[name].unit, "mean": of.mean, "mae": of.mae, "bias": of.bias, "std": of.std,
        "mae_holdout": of.mae_holdout,
    }  # fmt: skip
