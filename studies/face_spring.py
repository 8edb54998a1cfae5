"""A driver of shells beside the same head with a spring behind its face: what one mass and one spring leave out.

Computes, for a titanium head of today's size and for Roh and Lee's small one, drives with the shells, with the spring
of the same characteristic time, and with a rigid face. Writes studies/face_spring.json, which docs/models/response.md
quotes.
"""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

from clubface import fem
from clubface.fem.head_tests import characteristic_time
from clubface.fem.heads.meshed import ShellHead
from clubface.fem.heads.parametric import DriverHead
from clubface.support.checks import without_warnings

STORED = Path(__file__).with_suffix(".json")
SETTINGS = fem.Settings(until_separation=True)
LOFTS = (10, 15, 25)
"""Dynamic lofts, deg; the heads move level at 100 mph and strike at the face centre."""


def driver() -> ShellHead:
    """Return the head: 118 by 112 by 56 mm, 204 g, with a face of 3.0 mm in the middle and 2.2 mm at the edge."""
    return DriverHead(
        name="driver of shells",
        shape={
            "loft": "9.8 deg", "bulge": "305 mm", "roll": "305 mm", "width": "118 mm", "depth": "112 mm",
            "crown": "29 mm", "sole": "27 mm", "rounding": "6 mm",
        },
        thickness={
            "face_centre": "3.0 mm", "face_edge": "2.2 mm", "crown": "0.7 mm", "sole": "1.0 mm", "skirt": "0.8 mm",
        },
        target={"mass": "204 g", "cg_x": "40.8 mm", "cg_y": "11.4 mm", "cg_z": "1 mm", "izz": "4085 g cm2"},
        trims={
            "sole": ("-35 mm", "-25 mm", "0 mm", "60 g"), "front": ("-10 mm", "-25 mm", "0 mm", "60 g"),
            "back": ("-105 mm", "-8 mm", "0 mm", "60 g"), "heel": ("-40 mm", "-10 mm", "-55 mm", "60 g"),
            "toe": ("-40 mm", "-10 mm", "55 mm", "60 g"),
        },
        scales=(0.7, 1.5),
        elements=(36, 14, 25),
    ).mesh()  # fmt: skip


def compared(head: ShellHead) -> dict[str, Any]:
    """Return mass [g], characteristic time [us] and, by kind of face and dynamic loft [deg], what the ball does.

    Ball speed [mph], launch angle [deg], backspin [rpm], contact time [us], and the impulse [N s] along the face as it
    was at first touch, down the face.
    """
    with without_warnings():
        time = characteristic_time(head)
        kinds = {"shells": head, **{name: head.club.replace(characteristic_time=each) for name, each in
                                    (("spring", time), ("rigid", 0.0))}}  # fmt: skip
        figures: dict[str, Any] = {"mass": head.club.mass * 1e3, "characteristic_time": time * 1e6}
        for name, club in kinds.items():
            figures[name] = {}
            for loft in LOFTS:
                result = fem.strike(club, speed="100 mph", loft=f"{loft} deg", settings=SETTINGS)
                launch = result.launch
                assert launch is not None
                speed, angle = float(launch.ball_speed), float(launch.launch)
                figures[name][str(loft)] = {
                    **{key: float(launch.get(key, unit)) for key, unit in
                       (("ball_speed", "mph"), ("launch", "deg"), ("backspin", "rpm"))},
                    "contact_time": result.contact_time * 1e6,
                    "impulse": fem.ball("modern").mass * speed * math.sin(math.radians(loft) - angle),
                }  # fmt: skip
                text = "  ".join(f"{key} {value:.4g}" for key, value in figures[name][str(loft)].items())
                print(f"{loft} deg  {name:7s} {text}", flush=True)
    return figures


if __name__ == "__main__":
    figures = {"today": compared(driver()), "paper": compared(fem.head("paper"))}
    STORED.write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")
