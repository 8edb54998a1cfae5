"""Foresight (GCQuad, GC3, GCHawk and others): the tables of FSX Play, and of FSX 2020 and FSX Pro.

FSX Play names unit and sign in its headings, as in ``Face Impact Horizontal (mm toe-/heel+)``. The older programs write
a title line and the side after each number, as in ``2.1 R`` or ``3.4 In-Out``, with rows of averages. The headings are
those of public parsers of such exports; the meanings are those of Foresight's guide to club and ball data.
"""

from __future__ import annotations

from clubface.launch_monitor.cells import FACE_TO_PATH
from clubface.launch_monitor.formats import FACE, UNKNOWN, Field, Format

NOTES = {"closure": "Foresight takes the closure rate about the shaft; it is used as the rate about the vertical"}

_CLUB = {
    "attack": Field("Angle of Attack", unit="deg"),
    "path": Field("Club Path", unit="deg", positive="in-out"),
    "loft": Field("Loft", "Dynamic Loft", unit="deg"),
    "lie": Field("Lie", unit="deg", positive="toe up"),
    "closure": Field("Closure Rate", unit="deg/s"),
    "high": Field("Face Impact Vertical", unit="mm", positive="high"),
}
_BALL = {
    "ball_speed": Field("Ball Speed", unit="mph"),
    "smash": Field("Efficiency", "Smash Factor", unit="1"),
    "launch": Field("Launch Angle", unit="deg"),
    "total_spin": Field("Total Spin", unit="rpm"),
    "backspin": Field("Back Spin", "Backspin", unit="rpm"),
    "sidespin": Field("Side Spin", "Sidespin", unit="rpm", positive="right"),
    "landing_angle": Field("Descent Angle", unit="deg"),
    "apex": Field("Peak Height", unit="yd"),
    "carry": Field("Carry", unit="yd"),
}

PLAY = Format(
    name="foresight",
    title="Foresight FSX Play, CSV",
    marks=(
        ("Push/Pull",),
        ("Face to Target", "Closure Rate"),
        ("Face Impact Horizontal", "Face Impact Vertical", "Angle of Attack"),
    ),
    club=("Club Name", "Club", "Club Type"),
    fields={
        "speed": Field("Club Speed", unit="mph"),
        **_CLUB,
        "face": Field("Face to Target", unit="deg", positive="open"),
        "toe": Field("Face Impact Horizontal", unit="mm", positive="heel"),
        **_BALL,
        "azimuth": Field("Push/Pull", unit="deg", positive="right"),
        "total": Field("Total Distance", unit="yd"),
        "total_side": Field("Offline", unit="yd", positive="right"),
    },
    speed_at=FACE,
    face_at=UNKNOWN,
    notes=NOTES,
    source="Foresight Sports, Introduction to Understanding Ball Launch and Club Data",
)

FSX_2020 = Format(
    name="foresight-2020",
    title="Foresight FSX 2020 and FSX Pro, CSV",
    marks=(("Side Angle", "Tilt Angle"), ("Face Impact Lateral", "Face Impact Vertical"), ("Side Angle", "Backspin")),
    fields={
        "speed": Field("Club Speed", unit="mph"),
        **_CLUB,
        "face": Field("Face to Target", unit="deg", positive="open"),
        FACE_TO_PATH: Field("Face to Path", unit="deg", positive="open"),
        "toe": Field("Face Impact Lateral", unit="mm", positive="heel"),
        **_BALL,
        "azimuth": Field("Side Angle", unit="deg", positive="right"),
        "spin_axis": Field("Tilt Angle", "Spin Tilt Axis", unit="deg", positive="right"),
        "total": Field("Total", "Total Distance", unit="yd"),
        "total_side": Field("Offline", unit="yd", positive="right"),
    },
    speed_at=FACE,
    face_at=UNKNOWN,
    notes=NOTES,
    source=PLAY.source,
)
