"""Whether published parameters can have the published accuracy, told by pairs of models.

Every model was compared with the same measured launches. So on these shots the mean launches of two models differ by at
most the sum of their mean absolute errors, whatever was measured. Where the published parameters of two models are
further apart on such shots, at least one of the two sets, or of the published errors, is not what was computed with.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import combinations
from typing import NamedTuple

from clubface import benchmark_data
from clubface.equipment.balls import published_ball
from clubface.equipment.parameters import ParameterSet
from clubface.errors import RangeWarning
from clubface.evaluation.published_accuracy import published
from clubface.measured.shots import QUANTITIES
from clubface.simulation.impact import impact
from clubface.support.warning import without_warnings


class Pair(NamedTuple):
    """Two models with one club in one quantity, SI.

    Attributes
    ----------
    club, quantity
        The club, and one of the five launch quantities.
    first, second
        Names of the models.
    difference
        Mean of the first model less mean of the second, on the same shots.
    allowed
        The sum of their published mean absolute errors.
    """

    club: str
    quantity: str
    first: str
    second: str
    difference: float
    allowed: float

    @property
    def contradicts(self) -> bool:
        """Whether the means are further apart than the published errors allow."""
        return abs(self.difference) > self.allowed


def pairs(parameters: Mapping[tuple[str, str], ParameterSet] | None = None) -> list[Pair]:
    """Compare all models of which errors are published, with each club in each quantity.

    The shots are the deliveries of the benchmark, as their motion capture shows them: those of the publication are not
    public, and the mean launches are the same.

    Parameters
    ----------
    parameters
        Sets to use in place of the default ones, by model and club.
    """
    accuracy, found = published(), []
    for club in benchmark_data.CLUBS:
        shots = benchmark_data.load(club)
        deliveries, head = shots.measured.deliveries, shots.head
        means: dict[str, dict[str, float]] = {}
        for model in (name for name, of in accuracy if of == club):
            chosen = (parameters or {}).get((model, club)) or ParameterSet.builtin(model, club)
            with without_warnings(RangeWarning):  # of their own shots, or of what stands for them
                launch = impact(head, deliveries, model=model, parameters=chosen, ball=published_ball())
            means[model] = {name: float(launch.get(name).mean()) for name in QUANTITIES}
        for first, second in combinations(means, 2):
            for name in QUANTITIES:
                allowed = accuracy[first, club].mae[name] + accuracy[second, club].mae[name]
                found.append(Pair(club, name, first, second, means[first][name] - means[second][name], allowed))
    return found


def contradictions(parameters: Mapping[tuple[str, str], ParameterSet] | None = None) -> list[Pair]:
    """Return the pairs that cannot both be right, the clearest first; ``parameters`` as for :func:`pairs`."""
    clear = [each for each in pairs(parameters) if each.contradicts]
    return sorted(clear, key=lambda each: -abs(each.difference) / each.allowed)
