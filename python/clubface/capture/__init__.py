"""Motion capture: from C3D files of swings to deliveries with their uncertainty.

:func:`read_swing` reads one file and :func:`read_swings` reads many. A :class:`MarkerMap` says which marker is what.
``clubface.capture.synthetic`` makes swings whose delivery is known.
"""

from __future__ import annotations

from clubface.capture.captured import CapturedDelivery as CapturedDelivery
from clubface.capture.estimators import ESTIMATORS as ESTIMATORS
from clubface.capture.markers import FacePoint as FacePoint, MarkerMap as MarkerMap, template as template
from clubface.capture.recording import Recording as Recording, read_c3d as read_c3d, write_c3d as write_c3d
from clubface.capture.swing import (
    CapturedSwings as CapturedSwings,
    join as join,
    read_swing as read_swing,
    read_swings as read_swings,
)
