"""What comparisons and maps tell of a shot: quantities of the launch and of the flight after it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.simulation.flight import Flight
from clubface.simulation.launch import Launch
from clubface.simulation.quantities import Quantity, flight_outputs, outputs

LAUNCHED: tuple[str, ...] = (
    "ball_speed", "smash", "launch", "azimuth", "backspin", "sidespin", "total_spin", "spin_axis",
)  # fmt: skip
FLOWN: tuple[str, ...] = ("carry", "side", "total", "total_side", "apex", "landing_angle")
QUANTITIES: tuple[str, ...] = (*LAUNCHED, *FLOWN)
"""In the order of all tables."""


def quantities() -> dict[str, Quantity]:
    """Return the quantities by name, with units and meanings."""
    known = {**flight_outputs(), **outputs()}
    return {name: known[name] for name in QUANTITIES}


def symbol(quantity: str, unit: str) -> str:
    """Return the symbol of a unit that a person names for a quantity; one of another dimension is an error."""
    return units.unit(unit, name=quantity, dimension=quantities()[quantity].dimension).symbol


def values(launch: Launch, flight: Flight) -> NDArray[Any]:
    """Return ``QUANTITIES`` of a single launch and its flight [SI]."""
    return np.array([float((launch if name in LAUNCHED else flight).get(name)) for name in QUANTITIES])
