"""TrackMan: the CSV of TrackMan Performance Studio, one row a shot, a row of units such as ``[mph]`` below the header.

The headings are those of public exports (repositories j72jones/stochasticGolf and tim-blackmore/
launch-monitor-regression on GitHub); the meanings are TrackMan's own parameter definitions (support.trackmangolf.com)
and the article "Club Data Definitions" (blog.trackmangolf.com).
"""

from __future__ import annotations

from clubface.launch_monitor.formats import CG, CONTACT, Field, Format

FORMAT = Format(
    name="trackman",
    title="TrackMan Performance Studio, CSV",
    marks=(
        ("Swing Direction", "Dyn. Loft"),
        ("Swing Direction", "Dynamic Loft"),
        ("Carry Flat - Length",),
        ("Swing Plane", "Swing Direction"),
        ("Club Speed", "Ball Speed", "Launch Direction", "Dyn. Loft"),
    ),
    fields={
        "speed": Field("Club Speed", unit="mph"),
        "attack": Field("Attack Angle", "Attack Ang.", unit="deg"),
        "path": Field("Club Path", unit="deg", positive="right"),
        "loft": Field("Dyn. Loft", "Dynamic Loft", unit="deg"),
        "face": Field("Face Angle", "Face Ang.", unit="deg", positive="right"),
        "toe": Field("Impact Offset", unit="mm", positive="toe"),
        "high": Field("Impact Height", unit="mm", positive="high"),
        "ball_speed": Field("Ball Speed", unit="mph"),
        "smash": Field("Smash Factor", unit="1"),
        "launch": Field("Launch Angle", "Launch Ang.", unit="deg"),
        "azimuth": Field("Launch Direction", "Launch Dir.", unit="deg", positive="right"),
        "total_spin": Field("Spin Rate", unit="rpm"),
        "spin_axis": Field("Spin Axis", unit="deg", positive="right"),
        "apex": Field("Max Height - Height", "Max Height", "Height", "Apex Height", unit="ft"),
        "carry": Field("Carry Flat - Length", "Carry", unit="yd"),
        "side": Field("Carry Flat - Side", "Carry Side", "Side", unit="yd", positive="right"),
        "landing_angle": Field("Carry Flat - Land. Angle", "Landing Angle", "Land. Angle", unit="deg"),
        "flight_time": Field("Carry Flat - Time", "Hang Time", unit="s"),
        "total": Field("Est. Total Flat - Length", "Total", unit="yd"),
        "total_side": Field("Est. Total Flat - Side", "Side Total", "Total Side", unit="yd", positive="right"),
    },
    counted=("Spin Rate Type",),
    speed_at=CG,
    face_at=CONTACT,
    notes={
        "path": "TrackMan takes attack angle, path, dynamic loft and face angle at maximum compression, about a "
        "quarter of a millisecond after first touch",
    },
    source="TrackMan, Data Parameter Definitions; TrackMan, Club Data Definitions (C. Hahn)",
)
