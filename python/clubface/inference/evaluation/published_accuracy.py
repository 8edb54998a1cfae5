"""Published accuracy of the models, and whether published parameters can achieve it.

All models were compared with the same measured launches. On these shots the mean launches of two models therefore
differ by at most the sum of their mean absolute errors, whatever was measured. If two models with published parameters
differ by more on such shots, at least one of the published sets or errors is not the one used for the publication.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache
from itertools import combinations
from typing import Any, NamedTuple

from clubface import units
from clubface.equipment.balls import published_ball
from clubface.equipment.parameters import ParameterSet
from clubface.errors import RangeWarning
from clubface.schema import Document
from clubface.shots.measured import QUANTITIES
from clubface.simulation.impact import impact
from clubface.support.checks import Frozen, without_warnings
from clubface.support.files import DATA
from clubface.validation import benchmark_data


@dataclass(frozen=True, kw_only=True)
class PublishedAccuracy:
    """Published errors of one model with one club, by quantity, in SI units.

    Attributes
    ----------
    model, club
        Names of the model and of the club.
    source
        Where the numbers are printed.
    shots
        Number of shots measured.
    mean
        Mean of each measured quantity. The publication does not state whether the means of azimuth and sidespin are
        means of magnitudes.
    mae, std
        Mean absolute error and standard deviation of the error; the latter is empty if not published.
    mae_percent, std_percent
        The printed percentages of the mean; empty if there are none.
    cpu, cost
        The printed processor time [s] and cost of equation 22; None if there is none.
    caveats
        Errors in the printed numbers.
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

    def is_least(self, quantity: str) -> bool:
        """Whether this is the smallest error of its table, printed in italics in Tables 2 to 5.

        Numbers of the thesis are in none of these tables.
        """
        table = [each for each in published().values() if (each.club, each.source) == (self.club, self.source)]
        in_paper = self.source.startswith("Table")
        return in_paper and self.mae[quantity] == min(each.mae[quantity] for each in table)


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
    accuracies = {}
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
            mae_percent=_by_quantity(entry.get("mae_percent")),
            std_percent=_by_quantity(entry.get("std_percent")),
            cpu=None if cpu is None else units.to_si(cpu, "ms"),
            cost=entry.get("cost"),
            caveats=(),
        )
        accuracies[each.model, each.club] = replace(each, caveats=(*entry.get("caveats", ()), *wrong_percentages(each)))
    return Frozen(accuracies)


def wrong_percentages(accuracy: PublishedAccuracy) -> list[str]:
    """Return a sentence about every printed percentage that does not follow from the printed error and mean."""
    sentences = []
    for name, printed, values in (
        ("MAE", accuracy.mae_percent, accuracy.mae),
        ("STD", accuracy.std_percent, accuracy.std),
    ):
        for quantity, percent in printed.items():
            unit = QUANTITIES[quantity]
            error, mean = (float(units.from_si(each[quantity], unit)) for each in (values, accuracy.mean))
            half = 0.5 if unit == "rpm" else 0.005
            half_of_mean = {"ball_speed": 0.05, "launch": 0.05, "azimuth": 0.005}.get(quantity, 0.5)
            half_of_percent = 0.005 if percent < 10.0 else 0.05
            low = 100.0 * (error - half) / (mean + half_of_mean) - half_of_percent
            high = 100.0 * (error + half) / (mean - half_of_mean) + half_of_percent
            if not low <= percent <= high:
                words = quantity.replace("_", " ")
                right = 100.0 * error / mean
                sentences.append(f"{name} of {words}: printed {percent:g} %, the printed numbers give {right:.3g} %")
    return sentences


def _by_quantity(values: list[float] | None) -> dict[str, float]:
    return {} if values is None else dict(zip(QUANTITIES, map(float, values), strict=True))


def _si(values: list[float] | None) -> dict[str, float]:
    return {name: units.to_si(value, QUANTITIES[name]) for name, value in _by_quantity(values).items()}


class Pair(NamedTuple):
    """Two models with one club in one quantity, SI.

    Attributes
    ----------
    club, quantity
        The club, and one of the five launch quantities.
    first, second
        Names of the models.
    difference
        Mean of the first model minus mean of the second, on the same shots.
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
        """Whether the means differ by more than the published errors allow."""
        return abs(self.difference) > self.allowed


def pairs(parameters: Mapping[tuple[str, str], ParameterSet] | None = None) -> list[Pair]:
    """Compare all models with published errors, for each club and quantity.

    The shots are the deliveries of the benchmark from motion capture: those of the publication are not public, and the
    mean launches agree.

    Parameters
    ----------
    parameters
        Sets to use in place of the default ones, by model and club.
    """
    accuracy, compared = published(), []
    for club in benchmark_data.CLUBS:
        shots = benchmark_data.load(club)
        deliveries, head = shots.measured.deliveries, shots.head
        means: dict[str, dict[str, float]] = {}
        for model in (name for name, of in accuracy if of == club):
            chosen = (parameters or {}).get((model, club)) or ParameterSet.builtin(model, club)
            with without_warnings(RangeWarning):  # from their own shots or the substitutes for them
                launch = impact(head, deliveries, model=model, parameters=chosen, ball=published_ball())
            means[model] = {name: float(launch.get(name).mean()) for name in QUANTITIES}
        for first, second in combinations(means, 2):
            for name in QUANTITIES:
                allowed = accuracy[first, club].mae[name] + accuracy[second, club].mae[name]
                compared.append(Pair(club, name, first, second, means[first][name] - means[second][name], allowed))
    return compared


def contradictions(parameters: Mapping[tuple[str, str], ParameterSet] | None = None) -> list[Pair]:
    """Return the pairs that cannot both be right, the clearest first; ``parameters`` as for :func:`pairs`."""
    clear = [each for each in pairs(parameters) if each.contradicts]
    return sorted(clear, key=lambda each: -abs(each.difference) / each.allowed)
