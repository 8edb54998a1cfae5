"""Provenance of launches and flights: equipment, delivery, model, air, wind and ground, in words."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import MODULES
from clubface.quantities import display_unit, quantity
from clubface.results.result import Computation, Provenance
from clubface.simulation.flight import AirLike, GroundLike, WindLike, air_of, conditions
from clubface.simulation.launch import Launch
from clubface.simulation.results import flight_inputs
from clubface.units import from_si, show, show_range


def provenance_of(
    launches: Iterable[Launch], inputs: Mapping[str, str] | None = None, sources: Iterable[str] = ()
) -> Provenance:
    """Return the provenance of ``launches``: their deliveries, equipment and models.

    ``inputs`` are further inputs in words, by name ("air", "golfer"); ``sources`` are sources other than the launches'.
    """
    every = list(launches)
    computations = (
        Computation(
            each.club.name, each.ball.name, each.model, each.parameters.name, "left" if each.club.hand < 0 else "right"
        )
        for each in every
    )
    return Provenance(
        inputs={**dict(_deliveries(every)), **(inputs or {})},
        computations=tuple(dict.fromkeys(computations)),
        sources=tuple(dict.fromkeys((*_sources(every), *sources))),
        caveats=tuple(dict.fromkeys(_caveats(every))),
    )


def flight_conditions(
    air: AirLike | None = None, wind: WindLike | None = None, ground: GroundLike | None = None
) -> dict[str, str]:
    """Return air, wind and ground of a flight in words, defaults included; single values as for ``fly``."""
    values = {name: each.default for name, each in flight_inputs().items()} | conditions(air, wind, ground)
    altitude = air_of(air).altitude
    state = [show(values["temperature"], "degC"), show(values["pressure"], "hPa", 5)]
    state.append(f"{100.0 * values['humidity']:g}% humidity")
    if altitude is not None:
        state.append(f"pressure of the standard atmosphere at an altitude of {show(altitude, 'm')}")
    turf = (
        f"level turf after Penner (2002): tilt of the dent {show(values['ground_tilt'], 'deg', 3)}, friction "
        f"{values['ground_friction']:g} sliding and {values['rolling_friction']:g} rolling, restitution times "
        f"{values['restitution_factor']:g}, a fast ball slowed to 1/e in {show(values['grass_length'], 'm', 3)}"
    )
    return {"air": ", ".join(state), "wind": _wind(values), "ground": turf}


def flight_input_words(columns: Mapping[str, ArrayLike]) -> Iterator[tuple[str, str]]:
    """Yield inputs of flights [SI] in words: values or ranges, without those that are 0."""
    for name, values in columns.items():
        yield from _value_texts(name, display_unit(name, flight_inputs()[name].unit), [values])


def equipment_sources(*equipment: Club | Ball) -> Iterator[str]:
    """Yield the sources of the values of clubs and balls, grouped by source."""
    for each in equipment:
        by_source: dict[str, list[str]] = {}
        for name, source in each.sources.items():
            by_source.setdefault(source, []).append(name.replace("_", " "))
        for source, names in by_source.items():
            yield f"{type(each).__name__} {each.name}, {', '.join(names)}: {source}"


def _wind(values: Mapping[str, Any]) -> str:
    words = {"wind_x": ("with the shot", "against the shot"), "wind_y": ("upwards", "downwards"),
             "wind_z": ("to the right", "to the left")}  # fmt: skip
    parts = [
        f"{show(abs(values[name]), 'm/s', 3)} ({from_si(abs(values[name]), 'mph'):.0f} mph) {sides[values[name] < 0.0]}"
        for name, sides in words.items()
        if values[name]
    ]
    return ", ".join(parts) or "none"


def _deliveries(launches: Sequence[Launch]) -> Iterator[tuple[str, str]]:
    """Yield the values of the deliveries: those that all launches share, and the ranges of the others."""
    for name in launches[0].delivery if launches else ():
        yield from _value_texts(name, quantity(name).reading.unit, [each.input(name) for each in launches])


def _value_texts(name: str, unit: str, given: Iterable[ArrayLike]) -> Iterator[tuple[str, str]]:
    """Yield a name and its value or range in words; nothing if all values are 0."""
    values = np.concatenate([np.ravel(each) for each in given])
    values = values[np.isfinite(values)]
    if values.any():
        low, high = float(values.min()), float(values.max())
        yield name.replace("_", " "), show(low, unit) if low == high else show_range(low, high, unit)


def model_sources(made: Mapping[str, Any]) -> Iterator[str]:
    """Yield the sources of model and parameters, from the provenance of launches."""
    for what in ("model", "parameters"):
        entry = made[what]
        words = " ".join(dict.fromkeys(str(entry[key]) for key in ("source", "reference") if entry.get(key)))
        if words:
            yield f"{what.capitalize()} {entry['name']}: {words}"


def _sources(launches: Sequence[Launch]) -> Iterator[str]:
    for each in launches:
        yield from model_sources(each.provenance)
        yield from equipment_sources(each.club, each.ball)


def _caveats(launches: Sequence[Launch]) -> Iterator[str]:
    for each in launches:
        # The head of a club with a mesh is that mesh; reduced models use the rigid club only.
        if hasattr(each.club, "head") and not each.club.characteristic_time and each.model not in MODULES:
            yield (
                f"The model {each.model} treats the face of {each.club.name} as rigid: its file gives no"
                " characteristic time, and only finite elements use its mesh."
            )
        yield from (str(text) for text in each.provenance["parameters"]["caveats"])
