"""What the compiled core computes of golfers and where their shots go; the one place where this room names it."""

from clubface._core import (
    ShotTally as ShotTally,
    dispersion_quantities as dispersion_quantities,
    golfer_deliveries as golfer_deliveries,
    hole_strokes as hole_strokes,
    quasi_random as quasi_random,
    strokes_at as strokes_at,
)
