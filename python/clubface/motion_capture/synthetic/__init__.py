"""Synthetic swings: a clubhead on an exactly known path, as cameras would record it.

:func:`random_swing` makes one swing, :class:`Cameras` record it, and :func:`synthesize` writes a folder of swings.
"""

from __future__ import annotations

from clubface.motion_capture.synthetic.bare import BareSwing as BareSwing, record_bare as record_bare
from clubface.motion_capture.synthetic.files import (
    calibration_map as calibration_map,
    positions_map as positions_map,
    synthesize as synthesize,
    synthesize_bare as synthesize_bare,
    truth as truth,
)
from clubface.motion_capture.synthetic.golfer import random_chain as random_chain, random_swing as random_swing
from clubface.motion_capture.synthetic.laboratory import Cameras as Cameras
from clubface.motion_capture.synthetic.path import Chain as Chain, Turn as Turn, motion as motion
from clubface.motion_capture.synthetic.synthetic_swing import SyntheticSwing as SyntheticSwing, swing as swing
