"""Motion capture: deliveries with uncertainty from C3D files of swings.

:func:`read_swing` reads one file, :func:`read_swings` many. A :class:`MarkerMap` identifies the markers.
``clubface.capture.synthetic`` generates swings with known deliveries.
"""

from __future__ import annotations

from clubface.capture.captured import CapturedDelivery, swing_picture
from clubface.capture.estimators import ESTIMATORS
from clubface.capture.geometry import Assumed, Known
from clubface.capture.markers import FacePoint, MarkerMap, template
from clubface.capture.recording import Recording, read_c3d, write_c3d
from clubface.capture.swing import CapturedSwings, join, read_swing, read_swings

__all__ = [
    "ESTIMATORS", "Assumed", "CapturedDelivery", "CapturedSwings", "FacePoint", "Known", "MarkerMap", "Recording",
    "join", "read_c3d", "read_swing", "read_swings", "swing_picture", "template", "write_c3d",
]  # fmt: skip
