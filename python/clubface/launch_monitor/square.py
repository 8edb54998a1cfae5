"""Square Golf: the session that its app exports, a line of date and place, then shots club by club with their averages.

The side stands before the number, as in ``L1.2``; speed and lengths name their units, angles and spins do not.
"""

from __future__ import annotations

from clubface.launch_monitor.formats import UNKNOWN, Field, Format

FORMAT = Format(
    name="square",
    title="Square Golf, CSV of the app",
    marks=(("Index", "Launch Direction", "Offline", "Landing Angle"), ("Index", "Spin Axis", "Apex", "Offline")),
    fields={
        "speed": Field("Club Speed", unit="mph"),
        "attack": Field("Attack Angle", unit="deg"),
        "path": Field("Club Path", unit="deg", positive="right"),
        "loft": Field("Dynamic Loft", unit="deg"),
        "face": Field("Face Angle", unit="deg", positive="right"),
        "ball_speed": Field("Ball Speed", unit="mph"),
        "smash": Field("Smash Factor", unit="1"),
        "launch": Field("Launch Angle", unit="deg"),
        "azimuth": Field("Launch Direction", unit="deg", positive="right"),
        "total_spin": Field("Spin Rate", unit="rpm"),
        "backspin": Field("Back Spin", unit="rpm"),
        "sidespin": Field("Side Spin", unit="rpm", positive="right"),
        "spin_axis": Field("Spin Axis", unit="deg", positive="right"),
        "apex": Field("Apex", unit="yd"),
        "landing_angle": Field("Landing Angle", unit="deg"),
        "carry": Field("Carry", unit="yd"),
        "total": Field("Total", unit="yd"),
        "total_side": Field("Offline", unit="yd", positive="right"),
    },
    speed_at=UNKNOWN,
    source="exports of the Square Golf app",
)
