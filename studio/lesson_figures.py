"""The published figures that the lessons of the studio name, with their sources."""

from __future__ import annotations

from typing import Any

import numpy as np

from clubface import published_data
from clubface.equipment.balls import published_ball
from clubface.equipment.rules import rules
from clubface.simulation.spin import rolling_speed


def lesson_figures() -> dict[str, Any]:
    """Return limits of the rules, shares of start directions, wedge shots and the loft of a monitor, in SI."""
    starts = published_data.table("launch-shares-horizontal")
    covers = published_data.table("robot-wedge-covers-2025")
    lofts = published_data.table("standard-shots-trackman")
    along_face = lofts["ball_speed"] * np.sin(lofts["dynamic_loft"] - lofts["launch"])
    ratios = rolling_speed(published_ball(), lofts["spin"]) / along_face
    return {
        "rules": {
            name: {"title": rule.title, "most": rule.most, "tolerance": rule.tolerance, "source": rule.source}
            for name, rule in rules().items()
        },
        "start_shares": {
            "source": starts.source,
            "rows": {
                str(name): [float(share), float(spread)]
                for name, share, spread in zip(starts["club"], starts["share"], starts["spread"], strict=True)
            },
        },
        "wedge_covers": {
            "source": covers.source,
            "rows": {
                str(name): [float(launch), float(spin)]
                for name, launch, spin in zip(covers["balls"], covers["launch"], covers["spin"], strict=True)
            },
        },
        "loft_ratio": {"source": lofts.source, "value": float(np.median(ratios))},
        "club_data": {"source": published_data.table("head-after-impact").source},
    }
