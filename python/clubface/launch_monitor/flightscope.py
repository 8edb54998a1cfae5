"""FlightScope (Mevo, Mevo+, X3): the session table of FS Golf and myflightscope.com, sides written as ``10.5 L``.

Units stand in the headings, a dash where nothing was measured, and below the shots rows ``Avg`` and ``Dev``. The
headings are those of public exports (repositories dmombo/GolfStats and sghill/golf on GitHub) and parsers.
"""

from __future__ import annotations

from clubface.launch_monitor.cells import FACE_TO_PATH
from clubface.launch_monitor.formats import UNKNOWN, Field, Format

FORMAT = Format(
    name="flightscope",
    title="FlightScope Mevo, Mevo+ and X3, CSV of FS Golf",
    marks=(("Ball", "Smash", "Launch V", "Launch H"), ("Ball", "Smash", "Lateral"), ("Launch Angle V", "Ball Speed")),
    club=("Club",),
    fields={
        "speed": Field("Club", "Club Speed"),
        "attack": Field("AOA", "Angle of Attack", unit="deg"),
        "path": Field("Club Path", unit="deg", positive="right"),
        "loft": Field("Dynamic Loft", "D Loft", unit="deg"),
        "face": Field("FTT", "Face to Target", unit="deg", positive="right"),
        FACE_TO_PATH: Field("FTP", "Face to Path", unit="deg", positive="right"),
        "toe": Field("Lateral Impact", positive="toe"),
        "high": Field("Vertical Impact", positive="high"),
        "ball_speed": Field("Ball", "Ball Speed"),
        "smash": Field("Smash", "Smash Factor", unit="1"),
        "launch": Field("Launch V", "Launch Angle V", unit="deg"),
        "azimuth": Field("Launch H", "Launch Angle H", unit="deg", positive="right"),
        "total_spin": Field("Spin", unit="rpm"),
        "spin_axis": Field("Spin Axis", unit="deg", positive="right"),
        "apex": Field("Height"),
        "flight_time": Field("Time"),
        "carry": Field("Carry", "Carry Distance"),
        "side": Field("Lateral", positive="right"),
        "landing_angle": Field("DescentV", "Descent V", unit="deg"),
        "total": Field("Total"),
    },
    needs_units=False,
    speed_at=UNKNOWN,
    notes={"toe": "FlightScope does not publish the sign of its lateral impact: the toe was taken as positive"},
    source="public exports of FS Golf",
)
