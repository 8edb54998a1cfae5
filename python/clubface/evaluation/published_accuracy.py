"""Published accuracy of the models, for comparison with what is found on other shots."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from clubface import units
from clubface.measured.shots import QUANTITIES
from clubface.support.frozen import Frozen
from clubface.support.shipped import DATA
from clubface.support.strict_toml import Document


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
