"""The errors of models on measured shots, and the accuracy that was published of them.

The errors of models on measured shots, their sizes and trends, and which model is best.

Published accuracy of the models, for comparison with what is found on other shots.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface import units
from clubface.inference.evaluation.statistics import Best, ErrorSize, Trend
from clubface.shots.measured import QUANTITIES, MeasuredShots
from clubface.shots.recorded import RejectedRow
from clubface.support.arrays import Floats
from clubface.support.checks import Frozen
from clubface.support.files import DATA
from clubface.support.strict_toml import Document

if TYPE_CHECKING:
    from clubface.equipment.parameters import ParameterSet


@dataclass(frozen=True, kw_only=True)
class PublishedAccuracy:
    """Published errors of one model with one club, by quantity, in SI units.

    Attributes
    ----------
    model, club
        Names of the model and of the club.
    source
        Where the figures are printed.
    shots
        Number of shots measured.
    mean
        Mean of each measured quantity. The publication does not say whether those of azimuth and sidespin are means of
        magnitudes.
    mae
        Mean absolute error.
    std
        Standard deviation of the error; empty if none was published.
    mae_percent, std_percent
        The printed percentages of the mean; empty if there are none.
    cpu
        The printed processor time [s]; None if there is none.
    cost
        The printed value of the cost of equation 22; None if there is none.
    caveats
        What is wrong with the printed figures.
    """

    model: str
    club: str
    source: str
    shots: int
    mean: Mapping[str, float]
    mae: Mapping[str, float]
    std: Mapping[str, float]
    mae_percent: Mapping[str, float]
    std_percent: Mapping[str, float]
    cpu: float | None
    cost: float | None
    caveats: tuple[str, ...]


@cache
def _data() -> dict[str, Any]:
    return Document.read(DATA / "published_accuracy.toml").data


def monitor_errors() -> dict[str, float]:
    """Return the mean errors of the launch monitor of the published shots, SI, by quantity."""
    return {
        name: units.parse(text, units.unit(QUANTITIES[name]).dimension) for name, text in _data()["monitor"].items()
    }


@cache
def published() -> Mapping[tuple[str, str], PublishedAccuracy]:
    """Return the published accuracy by model and club."""
    data = _data()
    clubs = {each["club"]: each for each in data["club"]}
    found = {}
    for entry in data["model"]:
        own = clubs[entry["club"]]
        cpu = entry.get("cpu_ms")
        each = PublishedAccuracy(
            model=entry["model"],
            club=entry["club"],
            source=data["thesis"] if entry["source"] == "thesis" else entry["source"],
            shots=own["shots"],
            mean=_si(own["mean"]),
            mae=_si(entry["mae"]),
            std=_si(entry.get("std")),
            mae_percent=_named(entry.get("mae_percent")),
            std_percent=_named(entry.get("std_percent")),
            cpu=None if cpu is None else units.to_si(cpu, "ms"),
            cost=entry.get("cost"),
            caveats=(),
        )
        caveats = (*entry.get("caveats", ()), *wrong_percentages(each))
        found[each.model, each.club] = PublishedAccuracy(**{**vars(each), "caveats": caveats})
    return Frozen(found)


def wrong_percentages(of: PublishedAccuracy) -> list[str]:
    """Return a sentence about every printed percentage that does not follow from the printed error and mean."""
    found = []
    for name, printed, values in (("MAE", of.mae_percent, of.mae), ("STD", of.std_percent, of.std)):
        for quantity, percent in printed.items():
            unit = QUANTITIES[quantity]
            error, mean = (float(units.from_si(each[quantity], unit)) for each in (values, of.mean))
            half = 0.5 if unit == "rpm" else 0.005
            half_of_mean = {"ball_speed": 0.05, "launch": 0.05, "azimuth": 0.005}.get(quantity, 0.5)
            half_of_percent = 0.005 if percent < 10.0 else 0.05
            low = 100.0 * (error - half) / (mean + half_of_mean) - half_of_percent
            high = 100.0 * (error + half) / (mean - half_of_mean) + half_of_percent
            if not low <= percent <= high:
                words = quantity.replace("_", " ")
                right = 100.0 * error / mean
                found.append(f"{name} of {words}: printed {percent:g} %, the printed numbers give {right:.3g} %")
    return found


def _named(values: list[float] | None) -> dict[str, float]:
    return {} if values is None else dict(zip(QUANTITIES, map(float, values), strict=True))


def _si(values: list[float] | None) -> dict[str, float]:
    return {name: units.to_si(value, QUANTITIES[name]) for name, value in _named(values).items()}


@dataclass(frozen=True, kw_only=True, eq=False)
class ModelErrors:
    """Models compared with measured shots, in SI units.

    Attributes
    ----------
    shots
        The shots that all models could compute.
    parameters
        The parameters of each model, in the order in which the models were asked for.
    predicted
        The launches that each model computes, by quantity.
    sizes
        The size of the errors, by quantity and then by model.
    best
        The best model of each quantity, and which others are as good.
    trends
        How the errors depend on the delivery, by quantity and then by model.
    floor
        Mean absolute error that a perfect model would have with the noise assumed, where it is known.
    monitor_noise, delivery_noise
        Standard deviations of the noise assumed.
    seconds
        Processor time of each model [s] for one shot.
    failed
        Shots that a model could not compute, with the reason; they are left out.
    resamples, seed
        Number of bootstrap resamples, and the seed of the random numbers.
    groups
        Number of groups of shots that belong together, such as players, which are drawn whole; None if there are none.
    """

    shots: MeasuredShots
    parameters: dict[str, ParameterSet]
    predicted: dict[str, dict[str, Floats]]
    sizes: dict[str, dict[str, ErrorSize]]
    best: dict[str, Best]
    trends: dict[str, dict[str, list[Trend]]]
    floor: dict[str, float]
    monitor_noise: dict[str, float]
    delivery_noise: dict[str, float]
    seconds: dict[str, float]
    failed: tuple[RejectedRow, ...]
    resamples: int
    seed: int
    groups: int | None = None

    @property
    def models(self) -> list[str]:
        """The models, in the order asked for."""
        return list(self.parameters)

    @property
    def quantities(self) -> list[str]:
        """The launch quantities that were measured."""
        return list(self.sizes)

    @cached_property
    def mean(self) -> dict[str, float]:
        """Mean magnitude of each measured quantity, to which percentages refer."""
        return {name: float(np.nanmean(np.abs(values))) for name, values in self.shots.launch.items()}

    @property
    def published(self) -> dict[str, PublishedAccuracy]:
        """Published accuracy of these models, for clubs of this family."""
        family = self.shots.club.parameters
        return {name: published()[name, family] for name in self.models if (name, family) in published()}

    def errors(self, model: str, quantity: str) -> Floats:
        """Return model minus measured values, one element a shot; NaN where the value was not measured."""
        return self.predicted[model][quantity] - self.shots.launch[quantity]

    def cost(self, model: str) -> float:
        """Return the cost of Caldwell and McPhee (2023), equation 22, with mean magnitudes."""
        return sum(self.sizes[name][model].mae / self.mean[name] for name in self.quantities)

    def __repr__(self) -> str:
        lines = [f"{len(self.models)} models on {len(self.shots)} shots of {self.shots.club.name}"]
        for name, best in self.best.items():
            others = f", no worse than {' and '.join(best.equals)}" if best.equals else ""
            lines.append(f"  {name}: best {best.model}{others}")
        return "\n".join(lines)
