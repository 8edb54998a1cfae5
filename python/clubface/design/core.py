"""Functions of the compiled core for golfers, shots and faces; no other module of this package imports it."""

from clubface._core import (
    FaceOutline as FaceOutline,
    ShotTally as ShotTally,
    dispersion_quantities as dispersion_quantities,
    face_fine as face_fine,
    face_quantities as face_quantities,
    golfer_deliveries as golfer_deliveries,
    head_margins as head_margins,
    hole_strokes as hole_strokes,
    pseudo_inertia as pseudo_inertia,
    quasi_random as quasi_random,
    strokes_at as strokes_at,
    volume_forms as volume_forms,
)

Space = tuple[str, tuple[float, float, float], tuple[float, float, float]]
"""Shape, centre and size of a volume."""
