"""Print, as JSON, what ``clubface.fem`` gives for the cases that the browser tests compare with the pages.

Each case is its described input, as the core takes it, and the quantities of its impact, SI, by name.
"""

from __future__ import annotations

import json
import math
import sys
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from clubface import fem
from clubface.fem.backend import HOW
from clubface.fem.impact_result import CONTACT
from clubface.fem.result import Impact
from clubface.fem.run import case, face_of, inputs_of, one_shot
from clubface.fem.settings import Settings

DRIVE = {"speed": "105 mph", "attack": "2 deg", "loft": "13 deg", "toe": "8 mm", "high": "4 mm"}


def quantities(impact: Impact) -> dict[str, float]:
    """Return what the page shows of an impact; without what is not a number."""
    values = {name: float(getattr(impact, name)) for name in (*CONTACT, "energy_error", "steps")}
    return {name: value for name, value in (impact.outcome() | values).items() if math.isfinite(value)}


def drive(ball: str, delivery: Mapping[str, Any], threads: int) -> tuple[dict[str, Any], Impact]:
    """Return the case of a drive, and its impact."""
    made, how = fem.ball(ball), replace(HOW, threads=threads)
    shot = one_shot("driver", delivery, made)
    impact = fem.strike("driver", delivery, ball=made, settings=how)
    return case(made, face_of(None, shot.club, inputs_of(shot)), made.friction, how), impact


def main() -> None:
    """Compute every case on one thread."""
    thrown = fem.reference(settings=Settings(threads=1))
    described, struck = drive("modern", DRIVE, 1)
    json.dump(
        {
            "reference": {
                "case": case(thrown.ball, {"plane": thrown.given}, thrown.friction, Settings(threads=1)),
                "values": quantities(thrown),
            },
            "drive": {"case": described, "values": quantities(struck)},
        },
        sys.stdout,
    )


if __name__ == "__main__":
    main()
