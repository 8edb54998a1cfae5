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

Place = tuple[Any, Any, Any, Any]
"""x, y, z and mass, text with units or SI."""


def parsed(places: Mapping[str, Place], what: str) -> dict[str, tuple[float, float, float, float]]:
    """Return places [m] and masses [kg], checked; ``what`` they are stands in errors."""
    found = {}
    for name, values in places.items():
        if len(values) != 4:
            raise InputError(f"{what} {name}", values, "x, y, z and a mass")
        x, y, z = (units.parse(value, "length", name=f"{what} {name}") for value in values[:3])
        mass = units.parse(values[3], "mass", name=f"{what} {name}")
        far = next((value for value in (x, y, z) if not abs(value) <= REACH), None)
        if far is not None:
            raise InputError(
                f"{what} {name}",
                units.show(far, "mm"),
                'a place within 300 mm of the face centre; numbers are metres, "-33 mm" is text',
            )
        if not 0.0 <= mass <= 0.5:
            raise InputError(f"{what} {name}", units.show(mass, "g"), "0 to 500 g")
        found[name] = (x, y, z, mass)
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
