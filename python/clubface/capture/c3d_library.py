"""What ezc3d finds in a C3D file; run in a process of its own, see :mod:`clubface.support.processes`."""

from __future__ import annotations

from typing import Any

import ezc3d
import numpy as np

TEXTS = ("LABELS", "LABELS2", "LABELS3", "UNITS")


def contents(path: str) -> dict[str, Any]:
    """Return ``points``, shape (4, points, frames), NaN where one is marked invalid; ``rate`` [Hz]; texts by name."""
    result = ezc3d.c3d(path)
    group = result["parameters"].get("POINT", {})
    return {
        "points": np.ascontiguousarray(result["data"]["points"], dtype=np.float64),
        "rate": float(result["header"]["points"]["frame_rate"]),
        "texts": {name: [str(text).strip() for text in group.get(name, {}).get("value", ())] for name in TEXTS},
    }
