"""Synthetic swings: a clubhead on an exactly known path, recorded by simulated cameras.

:func:`random_swing` makes a swing, :class:`Cameras` record it, and :func:`synthesize` writes a folder of swings.
"""

from __future__ import annotations

from clubface.capture.synthetic.laboratory import (
    BareSwing,
    Cameras,
    calibration_map,
    positions_map,
    record_bare,
    synthesize,
    synthesize_bare,
    truth,
)
from clubface.capture.synthetic.synthetic_swing import (
    Chain,
    SyntheticSwing,
    Turn,
    motion,
    random_chain,
    random_swing,
    swing,
)

__all__ = [
    "BareSwing",
    "Cameras",
    "Chain",
    "SyntheticSwing",
    "Turn",
    "calibration_map",
    "motion",
    "positions_map",
    "random_chain",
    "random_swing",
    "record_bare",
    "swing",
    "synthesize",
    "synthesize_bare",
    "truth",
]
