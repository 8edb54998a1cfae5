"""What comparisons and maps tell of a shot: quantities of the launch and of the flight after it."""

from __future__ import annotations

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
