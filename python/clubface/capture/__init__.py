"""Motion capture: from C3D files of swings to deliveries with their uncertainty.

:func:`read_swing` reads one file and :func:`read_swings` reads many. A :class:`MarkerMap` says which marker is what.
``clubface.capture.synthetic`` makes swings whose delivery is known.
"""

from __future__ import annotations

from clubface.capture.captured import CapturedDelivery, swing_picture
from clubface.capture.estimators import ESTIMATORS
from clubface.capture.geometry import Assumed, Known
from clubface.capture.markers import FacePoint, MarkerMap, template
from clubface.capture.recording import Recording, read_c3d, write_c3d
from clubface.capture.swing import (
    CapturedSwings,
    join,
    read_swing,
    read_swings,
)

__all__ = [
    "ESTIMATORS", "Assumed", "CapturedDelivery", "CapturedSwings", "FacePoint", "Known", "MarkerMap", "Recording",
    "join", "read_c3d", "read_swing", "read_swings", "swing_picture", "template", "write_c3d",
]  # fmt: skip
