"""The errors of models on measured shots, their sizes and trends, and which model is best."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from clubface.evaluation.published_accuracy import PublishedAccuracy, published
from clubface.evaluation.statistics import Best, ErrorSize
from clubface.evaluation.trends import Trend
from clubface.measured.shots import MeasuredShots
from clubface.recorded.shots import RejectedRow
from clubface.support.arrays import Floats

if TYPE_CHECKING:
    from clubface.equipment.parameters import ParameterSet


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
