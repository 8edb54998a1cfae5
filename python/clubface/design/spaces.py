"""The space that a head fills where nobody has measured it: assumed, and scaled from the driver and the 7-iron."""

from __future__ import annotations

from typing import NamedTuple

from clubface import units
from clubface.design.feasibility import Volume
from clubface.equipment.clubs import Club
from clubface.quantities import Quantity, Reading

DRIVER = Volume(shape="box", centre=(-0.055, -0.001, 0.003), size=(0.115, 0.062, 0.124))
"""Of a driver at the limit of the rules."""
IRON = Volume(shape="box", centre=(-0.00661, -0.00069, 0.0), size=(0.03454, 0.05613, 0.078))
"""Around the mesh of the built-in head 7-iron."""
DRIVER_VOLUME = units.to_si(460.0, "cm3")
DRIVER_WIDTH, IRON_WIDTH = 0.105, 0.07
"""Widths of the faces of both [m], by which other heads are scaled."""
FREE = 0.03
"""Mass that a designer may place freely [kg]; the rest is shell. That of a driver; assumed of others."""


def _length(name: str, label: str, meaning: str) -> Quantity:
    return Quantity(name, "m", Reading("mm", 1), Reading("mm", 1), label, meaning=meaning)


QUANTITIES = (
    _length("face_to_back", "face to back", "length of the head from the face to the back"),
    _length("sole_to_crown", "sole to crown", "height of the head from the sole to the crown"),
    _length("heel_to_toe", "heel to toe", "width of the head from the heel to the toe"),
    Quantity("volume", "m3", Reading("cm3", 0), Reading("cm3", 0), "volume", meaning="volume of the head"),
    Quantity(
        "free_mass", "kg", Reading("g", 1), Reading("g", 1), "free mass",
        meaning="mass that may be placed anywhere in the head; the rest is shell",
    ),
)  # fmt: skip
"""What a space is described by."""


class Space(NamedTuple):
    """What a head may be, if nothing else is known of it, and where all of it comes from.

    ``volume`` is where its mass may be, ``displaced`` its volume as the rules measure it [m3], or None, and ``free``
    the mass that may be placed freely [kg].
    """

    volume: Volume
    displaced: float | None
    free: float
    origin: str


def usual_space(club: Club) -> Space:
    """Return the space that the head of a club is assumed to fill."""
    is_iron = club.kind == "iron"
    usual, width = (IRON, IRON_WIDTH) if is_iron else (DRIVER, DRIVER_WIDTH)
    scale = club.face_width / width
    x, y, z = (scale * each for each in usual.centre)
    depth, height, length = (scale * each for each in usual.size)
    origin = "the box around the meshed head 7-iron" if is_iron else "that of a driver of 460 cm3"
    if scale != 1.0:
        origin += f" times {scale:.3g}, as the widths of the faces"
    displaced = None if is_iron else DRIVER_VOLUME * scale**3
    volume = Volume(shape="box", centre=(x, y, z), size=(depth, height, length))
    return Space(volume, displaced, FREE, f"assumed: {origin}")
