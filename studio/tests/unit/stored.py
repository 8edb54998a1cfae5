"""Write what the package gives for strikes that the unit tests of the studio compare with their own results.

``python studio/tests/unit/stored.py`` writes, next to itself, ``poses.json``, where a contact model has head and ball
at first touch.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
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
    """Compute and write them."""
    text = "[\n" + ",\n".join(json.dumps(strike(*each)) for each in DELIVERIES) + "\n]\n"
    Path(__file__).with_name("poses.json").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
