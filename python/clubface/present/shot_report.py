"""The report of one shot, with the conditions of its flight in words.

The report of one shot: what the club did, how the ball left and where it flew, by one model or several.

Air, wind and ground of a flight in words, whether given or not: what another run needs to fly the same ball.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from clubface.equipment.models import model
from clubface.plots import svg
from clubface.present.report import Block, Data, Heading, Paragraph, Picture, Table, origin
from clubface.simulation.flight import Flight, air_of, conditions
from clubface.simulation.launch import Launch
from clubface.simulation.results import SHOWN, flight_inputs, outputs
from clubface.units import from_si, show

LISTED = (
    "ball_speed", "smash", "launch", "azimuth", "backspin", "sidespin", "spin_axis", "carry", "side", "total", "apex",
    "landing_angle", "contact_time", "peak_force",
)  # fmt: skip


def shot_blocks(
    launches: Mapping[str, Launch],
    flights: Mapping[str, Flight],
    figure: Any,
    positions: Mapping[str, Any],
    *,
    given: Mapping[str, str] | None = None,
) -> Iterator[Block]:
    """Yield the pieces of the report on one shot; all mappings go by the name of the model.

    ``figure`` draws it, ``positions`` has the places of the ball in flight [m], and ``given`` tells what else went in.
    """
    first = next(iter(launches.values()))
    yield Heading(1, f"A shot with the {first.club.name}")
    yield Paragraph(tuple(_words(first, flights[first.model])))
    if len(launches) > 1:
        yield Paragraph((f"These are the figures of the model {first.model}; the table has those of the others.",))
    yield _table(launches, flights)
    rows = [
        (name, *(round(float(each), 3) for each in from_si(point, "yd")))
        for name, place in positions.items()
        for point in np.asarray(place)
    ]
    flown = Data("flight", ("model", "forward (yd)", "height (yd)", "right (yd)"), rows)
    yield Picture("The flight from the side and from above, and the forces where a model has them", svg(figure), flown)
    yield from origin(launches.values(), given=given)


def _words(launch: Launch, flight: Flight) -> Iterator[str]:
    def told(value: float, unit: str, digits: int = 0) -> str:
        return f"{from_si(value, unit):.{digits}f}"

    yield (
        f"The {launch.club.name} meets the ball {launch.ball.name} at {told(launch.delivery['speed'], 'mph', 1)} mph, "
        f"with {told(launch.delivery['loft'], 'deg', 1)} degrees of dynamic loft."
    )
    yield (
        f"The ball leaves at {told(launch.ball_speed, 'mph', 1)} mph, {told(launch.launch, 'deg', 1)} degrees upwards, "
        f"and spins with {told(launch.total_spin, 'rpm')} rpm."
    )
    aside = abs(from_si(flight.side, "yd"))
    way = "right" if flight.side > 0.0 else "left"
    place = "on the line to the target" if aside < 0.5 else f"{aside:.0f} yd {way} of the line"
    yield (
        f"It carries {told(flight.carry, 'yd')} yd and lands {place}, after it has risen to "
        f"{told(flight.apex, 'yd')} yd; it comes down at {told(flight.landing_angle, 'deg')} degrees."
    )


def _table(launches: Mapping[str, Launch], flights: Mapping[str, Flight]) -> Table:
    shown, exact = [], []
    for quantity in LISTED:
        unit, digits = SHOWN[quantity]
        values = [
            float((each if quantity in outputs() else flights[name]).get(quantity, unit))
            for name, each in launches.items()
        ]
        label = quantity.replace("_", " ") + ("" if unit == "1" else f" ({unit})")
        shown.append((label, *("" if np.isnan(value) else f"{value:.{digits}f}" for value in values)))
        exact.append((label, *values))
    headings = ("quantity", *(model(name).name for name in launches))
    return Table(headings, shown, Data("shot", headings, exact))


def flight_conditions(air: Any = None, wind: Any = None, ground: Any = None) -> dict[str, str]:
    """Return the conditions of a flight by name, those that were not given among them.

    Parameters
    ----------
    air, wind, ground
        As for :func:`clubface.fly`; single values.
    """
    known = flight_inputs()
    values = {name: each.default for name, each in known.items()} | conditions(air, wind, ground)
    altitude = air_of(air).altitude
    told = [show(values["temperature"], "degC"), show(values["pressure"], "hPa", 5)]
    told.append(f"{100.0 * values['humidity']:g} % humidity")
    if altitude is not None:
        told.append(f"the pressure being that at an altitude of {show(altitude, 'm')}")
    turf = (
        f"level turf after Penner (2002): tilt of the dent {show(values['ground_tilt'], 'deg', 3)}, friction "
        f"{values['ground_friction']:g} sliding and {values['rolling_friction']:g} rolling, restitution times "
        f"{values['restitution_factor']:g}, a fast ball slowed to 1/e in {show(values['grass_length'], 'm', 3)}"
    )
    return {"air": ", ".join(told), "wind": _wind(values), "ground": turf}


def _wind(values: dict[str, Any]) -> str:
    words = {"wind_x": ("with the shot", "against the shot"), "wind_y": ("upwards", "downwards"),
             "wind_z": ("to the right", "to the left")}  # fmt: skip
    told = [
        f"{show(abs(values[name]), 'm/s', 3)} ({from_si(abs(values[name]), 'mph'):.0f} mph) {sides[values[name] < 0.0]}"
        for name, sides in words.items()
        if values[name]
    ]
    return ", ".join(told) or "none"
