"""Reading of C3D files with ezc3d; runs in its own process, see :mod:`clubface.support.processes`."""

from __future__ import annotations

from typing import Any

import ezc3d
import numpy as np

TEXTS = ("LABELS", "LABELS2", "LABELS3", "UNITS")


def contents(path: str) -> dict[str, Any]:
    """Return ``points``, shape (4, points, frames), NaN where marked invalid; ``rate`` [Hz]; and texts by name."""
    result = ezc3d.c3d(path)
    group = result["parameters"].get("POINT", {})
    return {
        "points": np.ascontiguousarray(result["data"]["points"], dtype=np.float64),
        "rate": float(result["header"]["points"]["frame_rate"]),
        "texts": {name: [str(text).strip() for text in group.get(name, {}).get("value", ())] for name in TEXTS},
    }
