"""The list of checks: what is published, what models must reproduce, and how closely."""

from __future__ import annotations

from clubface.support.checks import check_choice
from clubface.validation import launches, strikes
from clubface.validation.check import A_MODEL, Check

CHECKS = (
    Check(
        "tour-irons", "Averages of the tours at their launch: irons",
        (*launches.SEASONS, "drive-scatter-blackmore", "launch-shares-horizontal"),
        "As for the irons of single golfers. The interval is what the scatter of golfers may have done to the averages:"
        " none, or the face-to-path of golfers who drive as fast as the PGA Tour. That of irons is not published.",
        "fair", launches.tour(lambda club: club.endswith(("iron", "wedge"))),
    ),
    Check(
        "tour-driver", "Averages of the tours at their launch: driver",
        (*launches.SEASONS, "drive-scatter-blackmore", "launch-shares-horizontal"),
        "9%, for heads that are unknown. The interval holds the scatter, as for the irons, and a strike 0 to 6 mm above"
        " the face centre, since where the balls were struck is not published.",
        "fair", launches.tour(lambda club: club == launches.DRIVER),
    ),
    Check(
        "tour-woods", "Averages of the tours at their launch: fairway woods and hybrids",
        (*launches.SEASONS, "drive-scatter-blackmore", "launch-shares-horizontal"),
        "As for the driver, struck at the face centre. These heads are scaled from the driver and not measured.",
        "poor", launches.tour(lambda club: club in launches.WOODS),
    ),
    Check(
        "amateur-drives", "Drives by handicap at their launch",
        ("drives-by-handicap", "drive-scatter-blackmore", "launch-shares-horizontal"),
        "As for the drives of the tours, with the scatter of golfers of the same club speed. The dynamic lofts that are"
        " published with them are not used.",
        "fair", launches.amateurs,
    ),
    Check(
        "irons-at-launch", "Irons of single golfers and of a robot at their measured launch",
        ("shots-bliss-2026", "shots-r50-2026", "robot-7-irons-launch-2026", "drive-scatter-blackmore"),
        "The loft is solved so that the launch angle is as measured, since monitors derive lofts from the ball. 15%: at"
        " one launch and speed tours and robots differ by a quarter, heads and balls are unknown, and a groove lower on"
        " the face is worth 6%. The interval of golfers holds their scatter; a robot has none.",
        "fair", launches.irons,
    ),
    Check(
        "drives-at-launch", "Drives at their measured launch", ("drives-blackmore", "shots-bliss-2026"),
        "As for the drives of the tours. The drives of many golfers are chosen to start near their path, so that their"
        " interval has no scatter, but for the height of the strike.",
        "fair", launches.drives,
    ),
    Check(
        "launch-shares", "Where balls start between path and face",
        ("launch-shares-vertical", "launch-shares-trackman", "launch-shares-horizontal"),
        "The spread over shots that is published; TrackMan publishes none, and gets the largest difference between both"
        " sources. The deliveries are those published elsewhere for amateurs and a robot.",
        "fair", launches.shares,
    ),
    Check(
        "curvature", "Curve of shots by face angle less path", ("curvature-trackman",),
        "A quarter: these are worked examples of another model of impact and flight, rounded to a yard.",
        A_MODEL, launches.curvature,
    ),
    Check(
        "head-after-impact", "How the driver's head goes on", ("head-after-impact",),
        "4 to 6 degrees are published, taken here as those of a spin loft of 10 and of 15 degrees; within 1 degree.",
        "poor", launches.head_after_impact,
    ),
    Check(
        "robot-irons", "Spin of 7-irons of a robot by loft", ("robot-7-irons-2026", "robot-7-irons-launch-2026"),
        "As for the irons at their launch, and the slope within 15%, twice its standard error over the heads. Whether"
        " the dynamic loft was measured is not stated. These figures contradict those of the tours: the 7-iron of the"
        " LPGA Tour spins 6699 rpm at 76 mph, starting at 19.0 degrees, and these irons 4920 rpm at 80 mph, starting at"
        " 20.9 degrees. No model can meet both. The heads are of 2026; many are hollow and have a deep, low mass"
        " centre, which takes spin away.",
        "poor", launches.by_loft,
    ),
    Check(
        "sliding", "Launch of a ball that slides on a wedge", ("robot-wedge-covers-2025",),
        "1 degree: over 60 balls that do not slide, the launch angle scatters by 0.6 degrees.",
        "fair", launches.sliding,
    ),
    Check(
        "spin-peak", "Spin loft at which a wedge spins most", ("spin-peak",),
        "4 degrees: few shots by one golfer, and the friction of his ball and face is not known.",
        "poor", launches.peak,
    ),
    Check(
        "best-strike", "Where on its face a driver is fastest", ("best-strike-blackmore",),
        "At a launch angle of 10 to 14 degrees, with the loft solved and an attack angle of 0, the best height must lie"
        " between -2 and 3.5 mm; 2 mm to the side, and 0.2% of the ball speed. The heads that golfers own are not this"
        " one.",
        "fair", strikes.best_strike,
    ),
    Check(
        "toe-hits", "A driver struck towards the toe", ("driver-toe-hits-2011",),
        "Means over 14 heads of 2011, by a robot: 1% of ball speed, 1 degree, 200 rpm, 5 yards. Loft and closure of the"
        " robot and the side on which the ball ends are not stated. Ball speed falls with the square of the distance:"
        " 10 mm cost 0.5% where 19 mm cost 2%.",
        "fair", strikes.toe_hits,
    ),
    Check(
        "strike-height", "A driver struck 15 mm higher", ("driver-height-2014",),
        "1 degree and 300 rpm: two groups of shots by hand, whose heights on the face are not known.",
        "poor", strikes.height,
    ),
    Check(
        "gear-effect", "Spin axis of strikes off the centre", ("strike-offsets-trackman", "gear-effect-2016"),
        "30%, since depth of the mass centre and inertia of the heads are not published; 15% for the impulse model,"
        " whose head is known.",
        A_MODEL, strikes.gear_effect,
    ),
    Check(
        "plates", "Restitution against plates and a rigid head",
        ("plate-cor-three-piece", "plate-cor-reduced-distance", "head-without-spring", "plate-granite-2002",
         "tangential-restitution"),
        "0.01, or 0.02 at low speed, and 0.1 along the plate, where friction or speed are not stated. The ball modern"
        " was fitted to these figures among others.",
        "fair", strikes.plates,
    ),
    Check(
        "contact-time", "Contact time of a drive", ("drive-contact-time",),
        "25 us around the published range of 400 to 500 us.",
        "fair", strikes.contact_time,
    ),
    Check(
        "longest-drives", "Launch of the longest drives by club speed", ("optimum-trackman-2010",),
        "1 degree and 300 rpm, which PING counts as near the optimum. Impact and flight are tested together.",
        A_MODEL, launches.by_club_speed,
    ),
    Check(
        "longest-drives-ping", "Launch of the longest drives by ball speed", ("optimum-ping-2019",),
        "The same.",
        A_MODEL, launches.by_ball_speed,
    ),
)  # fmt: skip
"""Every check, those at a measured launch first."""


def check_named(name: str) -> Check:
    """Return the check of this name."""
    by_name = {each.name: each for each in CHECKS}
    check_choice("check", name, by_name)
    return by_name[name]
