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
    """How far a fit is from what was measured of one quantity [SI].

    Attributes
    ----------
    mean
        Of the size of the measured values.
    mae
        Mean absolute error.
    bias
        Mean of simulated minus measured.
    std
        Standard deviation of simulated minus measured.
    mae_holdout
        Mean absolute error where every shot is simulated by a fit without it; NaN without hold-out.
    """

    mean: float
    mae: float
    bias: float
    std: float
    mae_holdout: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Identification:
    """Identified parameters, and how well they are known.

    Attributes
    ----------
    model
        The model.
    club
        The name of the club.
    parameters
        All parameters of the model, to be used wherever a set is taken and written by ``to_toml()``.
    free
        Names of those that were identified.
    intervals
        For each of these the lower and upper end of its confidence interval [SI].
    confidence
        Of the intervals.
    method
        How they were made: "bootstrap", or "information" without one, from derivatives and normal deviations.
    cost
        At the parameters.
    cost_holdout
        With every shot simulated by a fit without it; NaN without hold-out.
    cost_kind
        "published" (P1's Eq. 22), "least-squares" or "robust".
    deviations
        By launch quantity.
    evaluations, impacts
        How often all shots were simulated, and the impacts this makes.
    wall_s
        Time taken, by interrupted runs as well [s].
    shots
        Number of shots used.
    dropped
        Rows that were not used.
    refined
        Costs the refinements ended at.
    samples
        Parameters of the bootstrap [SI], shape (samples, free).
    held_out
        Launches of every shot by a fit without it [SI], shape (quantities, shots); None without hold-out.
    identifiability
        What the shots can tell, by Fisher's information.
    profiles
        Profile likelihoods by parameter.
    warnings
        What must be known before the parameters are used.
    notes
        What was assumed of the shots.
    settings
        What was asked for.
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
        """Return everything made of what JSON has; values in SI, their units under ``units``."""
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
        """Say whether the shots determine a parameter: "yes", "not alone", "no", "from below only", ...

        "not alone": some combination with other parameters changes no launch.
        """
        told = self.identifiability
        if not math.isfinite(told.errors[told.names.index(name)]):
            return "not alone"
        if name in self.profiles:
            return self.profiles[name].verdict
        return "no" if name in told.unknown else "yes"

    def shown(self, name: str, value: float, digits: int = 4) -> str:
        """Write a value of a parameter in the unit people read."""
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
