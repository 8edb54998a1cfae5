"""Print, as JSON, strikes and where a contact model starts them: the ball as seen from the mass centre of the head.

``python studio/tests/unit/poses.py > studio/tests/unit/poses.json`` writes what the unit tests read.
"""

from __future__ import annotations

import json
import math
import sys
from typing import Any

import clubface
from clubface.errors import RangeWarning
from clubface.simulation.results import inputs
from clubface.support.checks import without_warnings

DELIVERIES: list[tuple[str, str, dict[str, str]]] = [
    ("driver", "right", {"loft": "13 deg", "face": "2 deg", "lie": "3 deg", "toe": "8 mm", "high": "4 mm"}),
    ("driver", "left", {"loft": "10 deg", "face": "-4 deg", "lie": "-6 deg", "toe": "-21 mm", "high": "-11 mm"}),
    ("3-wood", "left", {"loft": "12 deg", "face": "3 deg", "toe": "12 mm"}),
    ("7-iron", "right", {"loft": "24 deg", "face": "-5 deg", "lie": "10 deg", "toe": "15 mm", "high": "-9 mm"}),
    ("lob-wedge", "left", {"loft": "66 deg", "face": "12 deg", "lie": "-8 deg", "high": "7 mm"}),
]


def strike(club: str, hand: str, delivery: dict[str, str]) -> dict[str, Any]:
    """Return the inputs of a strike [SI; None is infinite] and the place of the ball when it is first touched [m]."""
    with without_warnings(RangeWarning):
        history = clubface.history(club, {"speed": "40 m/s", **delivery}, model="volumetric", hand=hand)
    given = {name: float(history.launch.input(name)) for name in inputs()}
    return {
        "inputs": {name: value if math.isfinite(value) else None for name, value in given.items()},
        "ball_from_cg": (history.ball_position[0] - history.club_position[0]).tolist(),
    }


def main() -> None:
    """Compute every strike."""
    json.dump([strike(*each) for each in DELIVERIES], sys.stdout, indent=1)


if __name__ == "__main__":
    main()
