"""What the compiled core knows of equipment; the one place where this room names it."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from clubface._core import check, inputs, models as models
from clubface.equipment.attachment import ADDED_NAMES
from clubface.errors import ShotError

_OWN_NAMES = {"club_mass": "mass", "static_loft": "loft", "ball_mass": "mass", "ball_radius": "radius",
              "ball_inertia": "inertia"}  # fmt: skip
"""What a club or a ball calls the inputs that a shot calls otherwise."""


def check_body(group: str, values: Mapping[str, float]) -> None:
    """Refuse the inputs of a "club" or "ball" [SI] that no body can have."""
    fault = check(group, [values.get(name, 0.0) for name in _input_names()])
    if fault is not None:
        name, message = fault
        own = "added_inertia" if name in ADDED_NAMES else _OWN_NAMES.get(name, name)
        raise ShotError(own, values[name], message)


@cache
def _input_names() -> tuple[str, ...]:
    return tuple(each["name"] for each in inputs())
