"""What a shaft adds to the inertia of a head at impact, as a function of its stiffness, with exact derivatives."""

from __future__ import annotations

from typing import Any

from clubface.equipment.attachment import added_inputs
from clubface.equipment.clubs import Club
from clubface.equipment.shafts import Shaft

__all__ = ["attached_inputs"]


def attached_inputs(club: Club, shaft: Shaft, given: dict[str, Any]) -> dict[str, Any]:
    """Return the inputs of an impact that a shaft adds."""
    return dict(added_inputs(shaft.added_inertia(club)))
