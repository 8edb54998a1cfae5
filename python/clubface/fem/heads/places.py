"""Masses added to a head at places."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from clubface import units
from clubface.errors import InputError

if TYPE_CHECKING:
    from numpy.typing import NDArray

SPREAD = 8e-3
"""Radius about the place of an added mass within which nodes carry it [m], beyond the nearest."""

REACH = 0.3
"""Farthest place of an added mass along an axis [m]."""

LEAST_TRIM = 1e-5
"""Least that a trim mass may weigh at most [kg]."""

MASS_KEYS = {"trim": "most", "mass": "mass"}
"""What the mass of a place is called, by what it is."""

Place = tuple[Any, Any, Any, Any]
"""x, y, z and mass, text with units or SI."""


def parsed_places(places: Mapping[str, Place], what: str) -> dict[str, tuple[float, float, float, float]]:
    """Return places [m] and masses [kg], checked; errors speak of such as "x of trim toe", ``what`` being "trim"."""
    found = {}
    for name, values in places.items():
        if len(values) != 4:
            raise InputError(f"{what} {name}", values, "x, y, z and a mass")
        place = []
        for axis, value in zip("xyz", values[:3], strict=True):
            length = units.parse(value, "length", name=f"{axis} of {what} {name}")
            if not abs(length) <= REACH:
                allowed = 'within 300 mm of the face centre; numbers are metres, "-33 mm" is text'
                raise InputError(f"{axis} of {what} {name}", units.show(length, "mm"), allowed)
            place.append(length)
        key = f"{MASS_KEYS[what]} of {what} {name}"
        mass = units.parse(values[3], "mass", name=key)
        # A trim mass that may weigh nothing is none.
        least = LEAST_TRIM if what == "trim" else 0.0
        if not least <= mass <= 0.5:
            raise InputError(key, units.show(mass, "g"), units.show_range(least, 0.5, "g"))
        found[name] = (*place, mass)
    return found


def spread(places: Mapping[str, tuple[float, float, float, float]], nodes: NDArray[Any]) -> NDArray[Any]:
    """Return the mass that each node carries [kg]."""
    import numpy as np

    added = np.zeros(len(nodes))
    for x, y, z, mass in places.values():
        away = np.linalg.norm(nodes - [x, y, z], axis=1)
        share = np.maximum(0.0, 1.0 - away / (away.min() + SPREAD))
        added += mass * share / share.sum()
    return added
