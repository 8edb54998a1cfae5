"""GSPro: the shots that its portal exports, sides written as letters: ``11.4 R``, ``2.6° U``, ``1.2 I-O``, ``0.9 C``.

Speeds and lengths name their units in the headings, angles in the cells; spins name none.
"""

from __future__ import annotations

from clubface.launch_monitor.cells import FACE_TO_PATH
from clubface.launch_monitor.formats import UNKNOWN, Field, Format

FORMAT = Format(
    name="gspro",
    title="GSPro, CSV of the portal",
    marks=(("Shot Key", "Ball Speed"), ("HLA", "VLA", "Club AoA"), ("HLA", "VLA", "Desc Angle")),
    club=("Club Name", "Club"),
    fields={
        "speed": Field("Club Speed", unit="mph"),
        "attack": Field("Club AoA", unit="deg"),
        "path": Field("Club Path", unit="deg", positive="in-out"),
        "loft": Field("Club Loft", "Dynamic Loft", unit="deg"),
        "face": Field("Face to Target", unit="deg", positive="open"),
        FACE_TO_PATH: Field("Face to Path", unit="deg", positive="open"),
        "lie": Field("Lie", unit="deg", positive="toe up"),
        "ball_speed": Field("Ball Speed", unit="mph"),
        "smash": Field("Smash Factor", unit="1"),
        "launch": Field("VLA", unit="deg"),
        "azimuth": Field("HLA", unit="deg", positive="right"),
        "backspin": Field("Back Spin", unit="rpm"),
        "sidespin": Field("Side Spin", unit="rpm", positive="right"),
        "total_spin": Field("Total Spin", unit="rpm"),
        "spin_axis": Field("Spin Axis", unit="deg", positive="right"),
        "apex": Field("Peak Height", unit="yd"),
        "landing_angle": Field("Desc Angle", "Descent Angle", unit="deg"),
        "carry": Field("Carry Dist", "Carry", unit="yd"),
        "total": Field("Total Dist", "Total", unit="yd"),
        "total_side": Field("Offline", unit="yd", positive="right"),
    },
    speed_at=UNKNOWN,
    source="exports of the GSPro portal",
)
