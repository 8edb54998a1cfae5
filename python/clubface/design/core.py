"""What the compiled core computes of golfers, their shots and faces; the one place where this room names it."""

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
