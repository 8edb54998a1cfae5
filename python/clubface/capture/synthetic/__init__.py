"""Synthetic swings: a clubhead on an exactly known path, as cameras would record it.

:func:`random_swing` makes one swing, :class:`Cameras` record it, and :func:`synthesize` writes a folder of swings.
"""

from __future__ import annotations

from clubface.capture.synthetic.laboratory import (
    BareSwing as BareSwing,
    Cameras as Cameras,
    calibration_map as calibration_map,
    positions_map as positions_map,
    record_bare as record_bare,
    synthesize as synthesize,
    synthesize_bare as synthesize_bare,
    truth as truth,
)
from clubface.capture.synthetic.synthetic_swing import (
    Chain as Chain,
    SyntheticSwing as SyntheticSwing,
    Turn as Turn,
    motion as motion,
    random_chain as random_chain,
    random_swing as random_swing,
    swing as swing,
)
