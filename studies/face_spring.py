"""A driver of shells beside the same head with a spring behind its face: what one mass and one spring leave out.

Prints, for a titanium head of today's size, ball speed, launch angle, backspin and contact time with the shells, with
the spring of the same characteristic time, and with a rigid face: the figures of docs/models/response.md.
"""

from __future__ import annotations

from collections.abc import Iterator

from clubface import fem
from clubface.fem.head_tests import characteristic_time
from clubface.fem.heads.driver import DriverHead
from clubface.fem.heads.meshed import ShellHead
from clubface.support.checks import without_warnings

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


def compared() -> Iterator[tuple[int, str, dict[str, float]]]:
    """Yield loft [deg], kind of face, and what the ball does: mph, deg, rpm, us."""
    with without_warnings():
        head = driver()
        time = characteristic_time(head)
        kinds = {"shells": head, **{name: head.club.replace(characteristic_time=each) for name, each in
                                    (("spring", time), ("rigid", 0.0))}}  # fmt: skip
        for loft in LOFTS:
            for name, club in kinds.items():
                result = fem.strike(club, speed="100 mph", loft=f"{loft} deg", settings=SETTINGS)
                launch = result.launch
                assert launch is not None
                figures = {key: float(launch.get(key, unit)) for key, unit in
                        (("ball_speed", "mph"), ("launch", "deg"), ("backspin", "rpm"))}  # fmt: skip
                yield (
                    loft,
                    name,
                    {**figures, "contact time": result.contact_time * 1e6, "characteristic time": time * 1e6},
                )


if __name__ == "__main__":
    for loft, name, figures in compared():
        text = "  ".join(f"{key} {value:.4g}" for key, value in figures.items())
        print(f"{loft} deg  {name:7s} {text}", flush=True)
