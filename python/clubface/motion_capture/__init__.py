"""Motion capture: from C3D files of swings to deliveries with their uncertainty.

:func:`read_swing` reads one file and :func:`read_swings` reads many. A :class:`MarkerMap` says which marker is what.
``clubface.motion_capture.synthetic`` makes swings whose delivery is known.
"""

from __future__ import annotations

from clubface.motion_capture.captured import CapturedDelivery as CapturedDelivery
from clubface.motion_capture.estimators import ESTIMATORS as ESTIMATORS
from clubface.motion_capture.joined import join as join
from clubface.motion_capture.mapping_file import MarkerMap as MarkerMap, template as template
from clubface.motion_capture.markers import FacePoint as FacePoint
from clubface.motion_capture.recording import Recording as Recording, read_c3d as read_c3d, write_c3d as write_c3d
from clubface.motion_capture.shots import CapturedSwings as CapturedSwings, read_swings as read_swings
from clubface.motion_capture.swing import read_swing as read_swing
