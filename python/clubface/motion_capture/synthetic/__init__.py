"""Synthetic swings: a clubhead on an exactly known path, as cameras would record it.

:func:`random_swing` makes one swing, :class:`Cameras` record it, and :func:`synthesize` writes a folder of swings.
"""

from __future__ import annotations

from clubface.motion_capture.synthetic.files import calibration_map, positions_map, synthesize, truth
from clubface.motion_capture.synthetic.golfer import random_chain, random_swing
from clubface.motion_capture.synthetic.laboratory import Cameras
from clubface.motion_capture.synthetic.path import Chain, Turn, motion
from clubface.motion_capture.synthetic.synthetic_swing import SyntheticSwing, swing

__all__ = [
    "Cameras",
    "Chain",
    "SyntheticSwing",
    "Turn",
    "calibration_map",
    "motion",
    "positions_map",
    "random_chain",
    "random_swing",
    "swing",
    "synthesize",
    "truth",
]
