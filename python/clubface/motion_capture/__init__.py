"""Motion capture: from C3D files of swings to deliveries with their uncertainty.

:func:`read_swing` reads one file and :func:`read_swings` reads many. A :class:`MarkerMap` says which marker is what.
``clubface.motion_capture.synthetic`` makes swings whose delivery is known.
"""

from __future__ import annotations

from clubface.motion_capture.captured import CapturedDelivery
from clubface.motion_capture.estimators import ESTIMATORS
from clubface.motion_capture.joined import join
from clubface.motion_capture.mapping import MarkerMap
from clubface.motion_capture.mapping_file import template
from clubface.motion_capture.markers import FacePoint
from clubface.motion_capture.recording import Recording, read_c3d, write_c3d
from clubface.motion_capture.shots import CapturedSwings, read_swings
from clubface.motion_capture.swing import read_swing

__all__ = [
    "ESTIMATORS",
    "CapturedDelivery",
    "CapturedSwings",
    "FacePoint",
    "MarkerMap",
    "Recording",
    "join",
    "read_c3d",
    "read_swing",
    "read_swings",
    "template",
    "write_c3d",
]
