"""What the compiled core computes of golfers, their shots and faces; the one place where this room names it."""

from typing import Any

from clubface import _core
from clubface._core import (
    FaceOutline as FaceOutline,
    ShotTally as ShotTally,
    dispersion_quantities as dispersion_quantities,
    face_fine as face_fine,
    face_quantities as face_quantities,
    golfer_deliveries as golfer_deliveries,
    hole_strokes as hole_strokes,
    quasi_random as quasi_random,
    strokes_at as strokes_at,
)

Space = tuple[str, tuple[float, float, float], tuple[float, float, float]]
"""Shape, centre and size of a volume."""


def pseudo_inertia(values: list[float]) -> list[list[float]]:
    """Return the pseudo-inertia of a body with ten mass properties."""
    return _core.pseudo_inertia(values)


def volume_forms(space: Space) -> list[tuple[str, Any]]:
    """Return the quadratic forms of which no body in a volume has a negative trace, each after its words."""
    return _core.volume_forms(space)


def head_margins(placed: Space, whole: Space, shell: Any, budget: float, pseudo: Any) -> list[tuple[str, float, str]]:
    """Return name, value and reason of every condition on a head."""
    return _core.head_margins(placed, whole, shell, budget, pseudo)
