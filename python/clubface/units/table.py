"""The table of units, and the unit that people read each quantity in."""

from __future__ import annotations

import math
from typing import NamedTuple

DIMENSIONLESS = "dimensionless"


class Unit(NamedTuple):
    """One unit: SI value = value * numerator / denominator + offset."""

    symbol: str
    dimension: str
    numerator: float
    denominator: float
    offset: float


def _units() -> dict[str, Unit]:
    units: dict[str, Unit] = {}

    def add(dimension: str, spellings: str, numerator: float = 1.0, denominator: float = 1.0, offset: float = 0.0):
        names = spellings.split(",")
        unit = Unit(names[0], dimension, numerator, denominator, offset)
        for name in names:
            units[key(name)] = unit

    add("speed", "m/s,mps,m_s")
    add("speed", "mph,mi/h,MPH", 44704.0, 1e5)
    add("speed", "km/h,kmh,kph,km_h", 10.0, 36.0)
    add("speed", "ft/s,fps,ft_s", 3048.0, 1e4)
    add("angle", "rad,radians")
    add("angle", "deg,degrees,degree,°", math.pi, 180.0)
    add("length", "m,metres,meters")
    add("length", "mm", 1.0, 1e3)
    add("length", "cm", 1.0, 1e2)
    add("length", "in,inch,inches", 254.0, 1e4)
    add("length", "yd,yard,yards,yds", 9144.0, 1e4)
    add("length", "ft,feet,foot", 3048.0, 1e4)
    add("area", "m2")
    add("area", "cm2", 1.0, 1e4)
    add("area", "mm2", 1.0, 1e6)
    add("volume", "m3")
    add("volume", "cm3,cc,ml", 1.0, 1e6)
    add("mass", "kg")
    add("mass", "g,grams,gram", 1.0, 1e3)
    add("mass", "oz", 28349523125.0, 1e12)
    add("inertia", "kg m2")
    add("inertia", "g cm2", 1.0, 1e7)
    add("angular rate", "rad/s,radps,rad_s")
    add("angular rate", "deg/s,degps,deg_s,°/s", math.pi, 180.0)
    add("angular rate", "rpm,rev/min,RPM", math.pi, 30.0)
    add("temperature", "K,kelvin")
    add("temperature", "degC,C,°C,degc,celsius", offset=273.15)
    add("temperature", "degF,F,°F,degf,fahrenheit", 5.0, 9.0, 273.15 - 160.0 / 9.0)
    add("pressure", "Pa,pa")
    add("pressure", "hPa,mbar,hpa", 100.0)
    add("pressure", "kPa,kpa", 1e3)
    add("pressure", "MPa,N/mm2", 1e6)
    add("pressure", "GPa", 1e9)
    add("pressure", "inHg,inhg", 3386.389)
    add("time", "s,seconds,sec")
    add("time", "ms", 1.0, 1e3)
    add("time", "us,µs,μs", 1.0, 1e6)
    add("force", "N,n")
    add("force", "kN,kn", 1e3)
    add("energy", "J")
    add("density", "kg/m3,kg_m3")
    add("density", "g/cm3,g_cm3", 1e3)
    add("volumetric stiffness", "N/m3")
    add("inverse speed", "s/m")
    add("inverse speed", "ms/m", 1.0, 1e3)
    add("rotary stiffness", "N m/rad,N m")
    add("rotary damping", "N m s/rad,N m s")
    add("area damping", "N s/m2,Pa s")
    add(DIMENSIONLESS, "1,-")
    add(DIMENSIONLESS, "%,percent,pct", 1.0, 1e2)
    return units


_SUPERSCRIPTS = str.maketrans({"²": "2", "³": "3", "^": None, "*": None, "·": None, "⋅": None, " ": None, "\t": None})


def key(spelling: str) -> str:
    """Return one spelling of ``kg m2``, ``kg m^2``, ``kg·m²`` and ``kg*m^2``."""
    return spelling.translate(_SUPERSCRIPTS)


UNITS = _units()

SI_UNITS: dict[str, str] = {
    unit.dimension: unit.symbol
    for unit in reversed(UNITS.values())
    if unit.numerator == unit.denominator and not unit.offset
}
"""The SI unit of each dimension."""

DISPLAY_UNITS = {
    "angle": "deg",
    "angular rate": "rpm",
    "inertia": "g cm2",
    "mass": "g",
    "temperature": "degC",
    "pressure": "hPa",
}
DISPLAY_UNITS_BY_NAME = {
    "closure": "deg/s", "pitch_rate": "deg/s", "lie_rate": "deg/s",
    "ball_backspin": "rpm", "ball_sidespin": "rpm", "ball_riflespin": "rpm",
    "toe": "mm", "high": "mm", "bulge": "mm", "roll": "mm", "face_width": "mm", "face_height": "mm",
    "cg_x": "mm", "cg_y": "mm", "cg_z": "mm", "dcg_x": "mm", "dcg_y": "mm", "dcg_z": "mm",
    "ball_radius": "mm", "radius": "mm", "cover_thickness": "mm", "penetration": "mm",
    "contact_area": "mm2", "area": "mm2", "face_area": "mm2", "stress": "MPa",
    "contact_time": "us", "characteristic_time": "us", "included_time": "us", "peak_force": "kN",
    "shear_modulus": "MPa", "ring_modulus": "MPa", "humidity": "%",
}  # fmt: skip
OF_A_HEAD = ("shape_", "thickness_", "target_", "grooves_"), ("_toe", "_high")
"""How names begin and end of lengths of a head, which people read in millimetres."""
