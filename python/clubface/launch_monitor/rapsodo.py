"""Rapsodo MLM2PRO: the shot export, one table a club below a title line, ended by rows of average and deviation.

The title names the player. A newer export is a single table without the title. Neither names its units. The headings
are those of public exports (repository mmender2/GolfAnalysis on GitHub) and parsers.
"""

from __future__ import annotations

from clubface.launch_monitor.formats import UNKNOWN, Field, Format

FORMAT = Format(
    name="rapsodo",
    title="Rapsodo MLM2PRO, shot export",
    marks=(("Club Type", "Club Brand", "Club Model"), ("Club Type", "Side Carry", "Launch Direction")),
    club=("Club Type",),
    title_of_player=r"Rapsodo MLM2PRO:\s*(.*?)\s+-\s+\d.*",
    fields={
        "speed": Field("Club Speed", unit="mph"),
        "attack": Field("Attack Angle", unit="deg"),
        "path": Field("Club Path", unit="deg", positive="right"),
        "ball_speed": Field("Ball Speed", unit="mph"),
        "smash": Field("Smash Factor", unit="1"),
        "launch": Field("Launch Angle", unit="deg"),
        "azimuth": Field("Launch Direction", unit="deg", positive="right"),
        "total_spin": Field("Spin Rate", unit="rpm"),
        "spin_axis": Field("Spin Axis", unit="deg", positive="right"),
        "apex": Field("Apex", unit="ft"),
        "carry": Field("Carry Distance", unit="yd"),
        "side": Field("Side Carry", unit="yd", positive="right"),
        "landing_angle": Field("Descent Angle", unit="deg"),
        "total": Field("Total Distance", unit="yd"),
    },
    counted=("Club Data Est Type",),
    speed_at=UNKNOWN,
    source="public exports of the MLM2PRO",
)
