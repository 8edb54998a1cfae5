"""Launches compared with published ones: spin, start direction, irons, optima, and the uncertainty of averages.

Radar monitors compute dynamic loft from the ball with a model of their own. Testing a model's spin at such a loft tests
it against the monitor's model. At the measured launch angle it is tested against measurements.

The mean of many shots is not the shot of the mean delivery. A face angle that scatters to both sides of the path adds
spin to every shot, and impacts scattered around a point give less ball speed than an impact at the point. The mean
delivery behind a published average may thus give less spin and more speed than the average. For a driver the impact
height is not published either, and at a given launch angle a higher impact spins less.

Both effects are computed with the default model whatever the model under test, so that the interval is always the same.
Speed, attack angle and loft scatter too, but hardly affect the means, since launch is nearly linear in them.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.models import DEFAULT_MODEL
from clubface.simulation.flight import fly
from clubface.simulation.launch import Launch
from clubface.support.arrays import Floats
from clubface.validation.check import Figure, ModelUnderTest, figure, rows
from clubface.validation.tour import averages, published_lofts

HEIGHTS = tuple(units.parse(each, "length") for each in ("0 mm", "3 mm", "6 mm"))
"""Possible impact heights on a driver [m]: the middle one is computed, the others give the bounds."""
CENTRE = (0.0,)
"""Impact height for other clubs [m]."""
DRIVER, WOODS = "driver", ("3-wood", "5-wood", "hybrid")
FACE_NODES, STRIKE_NODES = 5, 3
"""Number of Gauss-Hermite points for face-to-path, and for each coordinate of the impact point."""
QUANTITIES = ("ball_speed", "total_spin")


class Scatter(NamedTuple):
    """Standard deviations of face-to-path [rad], whose mean is 0, and of the impact point [m] about its mean."""

    face_to_path: float
    toe: float
    high: float


def scatter(club: str, drive_speed: float) -> Scatter:
    """Return the scatter of golfers with a given club speed of drives [m/s].

    Face-to-path follows from the published start-to-path with PING's measured share (launch-shares-horizontal). Irons
    get the same face-to-path and no scatter of the impact point, since none is published for irons.
    """
    group = max(
        (row for row in rows("drive-scatter-blackmore") if row["club_speed_least"] <= drive_speed),
        key=lambda row: row["club_speed_least"],
    )
    (share,) = (row["share"] for row in rows("launch-shares-horizontal") if row["club"] == "driver")
    strike = (group["toe"], group["high"]) if club in (DRIVER, *WOODS) else (0.0, 0.0)
    return Scatter(group["start_to_path"] / share, *strike)


def scattered(scatter: Scatter) -> tuple[dict[str, Floats], Floats]:
    """Return quadrature points for normally distributed face angles and impact points, and weights of sum 1."""
    axes = [
        (spread * places, weights / weights.sum())
        for spread, (places, weights) in zip(
            scatter, map(np.polynomial.hermite_e.hermegauss, (FACE_NODES, STRIKE_NODES, STRIKE_NODES)), strict=True
        )
    ]
    face, toe, high = (np.array(each) for each in zip(*itertools.product(*(axis for axis, _ in axes)), strict=True))
    weights = np.array([math.prod(each) for each in itertools.product(*(weights for _, weights in axes))])
    return {"face": face, "toe": toe, "high": high}, weights


@cache
def ratios(
    club: str, speed: float, attack: float, launch: float, scatter: Scatter | None, heights: Sequence[float]
) -> dict[str, tuple[float, float]]:
    """Return the range of the ratio of the computed shot to the shots that may have been published, by quantity.

    The computed shot is struck at the middle of ``heights`` and launches at the angle ``launch`` [rad]. The published
    one may be the shot at any of the heights with the same launch angle, or the mean of shots that scatter about it.
    """
    reference = ModelUnderTest(DEFAULT_MODEL)
    shots = reference.at_launch(club, launch, speed=speed, attack=attack, high=np.array(heights))
    possible = {name: [float(each) for each in getattr(shots, name)] for name in QUANTITIES}
    computed = {name: values[len(heights) // 2] for name, values in possible.items()}
    if scatter is not None:
        places, weights = scattered(scatter)
        for height, loft in zip(heights, shots.delivery["loft"], strict=True):
            where: dict[str, Any] = {"face": places["face"], "toe": places["toe"], "high": height + places["high"]}
            many = reference.strike(club, speed=speed, attack=attack, loft=loft, **where)
            for name in QUANTITIES:
                possible[name].append(float(weights @ getattr(many, name)))
    return {name: (computed[name] / max(values), computed[name] / min(values)) for name, values in possible.items()}


SPEED, SPIN, DRIVE_SPIN = 0.025, 0.15, 0.09
"""Relative tolerances of ball speed, of spin with irons (sources differ by a quarter at one launch and speed), and of
spin with drivers and woods (whose heads are unknown)."""
SEASONS = {"pga-2019": "PGA Tour 2019", "lpga-2019": "LPGA Tour 2019"}
"""Tables of tour averages, with their titles."""
TOUR_SPEED = units.parse("113 mph", "speed")
"""Club speed of drives [m/s] for tour players' scatter, which is unpublished and assumed as for others of this
speed."""
COOL_CLUBS: dict[str, Any] = {"speed": units.parse("80 mph", "speed"), "attack": units.parse("-2 deg", "angle")}
GOLF_DIGEST: dict[str, Any] = {"speed": units.parse("82 mph", "speed"), "attack": units.parse("-3 deg", "angle")}
"""Swings of the robots in the 7-iron tests of Cool Clubs and Golf Digest."""
ROBOT = {"club_speed": COOL_CLUBS["speed"], "attack": COOL_CLUBS["attack"]}
"""Swing of the Cool Clubs robot, by column of the published tables."""
BLADES = ("Staff MB", "Staff CB")
"""Irons in the robot test whose CG is as close to the face as in the built-in 7-iron."""


def tour(wanted: Callable[[str], bool]) -> Callable[[ModelUnderTest], list[Figure]]:
    """Return the comparison with the tour averages for clubs selected by ``wanted``."""

    def compute(judged: ModelUnderTest) -> list[Figure]:
        return [
            one
            for name, season in SEASONS.items()
            for each in averages(name)
            if wanted(each.club)
            for one in judged_at_launch(
                judged, f"{season}, {each.club}", each._asdict(), scatter=scatter(each.club, TOUR_SPEED)
            )
        ]  # fmt: skip

    return compute


def amateurs(judged: ModelUnderTest) -> list[Figure]:
    """Return ball speed and spin of golfers' drives by handicap."""
    return [
        one
        for row in rows("drives-by-handicap")
        for one in judged_at_launch(
            judged, row["group"], {"club": DRIVER, **row}, scatter=scatter(DRIVER, row["club_speed"])
        )
    ]  # fmt: skip


def irons(judged: ModelUnderTest) -> list[Figure]:
    """Return ball speed and spin of irons hit by single golfers and by a robot, which does not scatter."""
    blades = [row for row in rows("robot-7-irons-launch-2026") if row["model"] in BLADES]
    robot = {name: sum(row[name] for row in blades) / len(blades) for name in ("launch", "spin")}
    shots = [
        *(("one golfer, TrackMan 4", row, True) for row in rows("shots-bliss-2026") if row["club"] != DRIVER),
        *(("one golfer, Garmin R50", row, True) for row in rows("shots-r50-2026")),
        ("robot, two blades", {"club": "7-iron", **ROBOT, **robot}, False),
    ]
    return [
        one
        for who, row, golfer in shots
        for one in judged_at_launch(
            judged, f"{who}, {row['club']}", row, scatter=scatter(row["club"], TOUR_SPEED) if golfer else None
        )
    ]  # fmt: skip


def drives(judged: ModelUnderTest) -> list[Figure]:
    """Return ball speed and spin of many golfers' drives, selected to start near the path, and of a single golfer's."""
    return [
        one
        for table, who, scattered in (
            ("drives-blackmore", "many golfers", False), ("shots-bliss-2026", "one golfer, TrackMan 4", True),
        )
        for row in rows(table)
        if row["club"] == DRIVER
        for one in judged_at_launch(
            judged, f"{who}, {units.show(row['club_speed'], 'mph', 4)}", row,
            scatter=scatter(DRIVER, row["club_speed"]) if scattered else None,
        )
    ]  # fmt: skip


def judged_at_launch(
    judged: ModelUnderTest, what: str, row: Mapping[str, Any], *, scatter: Scatter | None
) -> Iterator[Figure]:
    """Yield ball speed, if published, and spin of a published row at the measured launch angle.

    A driver is struck at the middle of ``HEIGHTS``, other clubs at the face centre.
    """
    club = row["club"]
    heights = HEIGHTS if club == DRIVER else CENTRE
    middle = heights[len(heights) // 2]
    shot = judged.at_launch(club, row["launch"], speed=row["club_speed"], attack=row["attack"], high=middle)
    possible = ratios(club, row["club_speed"], row["attack"], row["launch"], scatter, heights)
    allowed = DRIVE_SPIN if club in (DRIVER, *WOODS) else SPIN
    for name, quantity, unit, column, tolerance in (
        ("ball_speed", "ball speed", "mph", "ball_speed", SPEED), ("total_spin", "spin", "rpm", "spin", allowed),
    ):  # fmt: skip
        if column in row:
            low, high = (row[column] * ratio for ratio in possible[name])
            yield figure(what, quantity, unit, (low, high), getattr(shot, name), tolerance, relative=True)


OPEN = units.parse("3 deg", "angle")
"""Face angle to either side with zero club path [rad]."""
CURVE_TOLERANCE = 0.25
BETWEEN_SOURCES = 0.06
"""Largest difference between the two published shares of one club."""
STEEPER_TOLERANCE = units.parse("1 deg", "angle")
HEAD_SPEED = units.parse("100 mph", "speed")


def deliveries() -> dict[str, dict[str, Any]]:
    """Return a published delivery for each club with published shares: speed, attack angle, dynamic loft."""
    drive = next(row for row in rows("drives-by-handicap") if row["group"] == "male, 10")
    wedge = next(row for row in rows("standard-shots-trackman") if row["club"] == "pitching-wedge")
    lofts = [row["dynamic_loft"] for row in rows("robot-7-irons-2026")]
    names = {"speed": "club_speed", "attack": "attack", "loft": "dynamic_loft"}
    driver, pitching_wedge = ({name: row[column] for name, column in names.items()} for row in (drive, wedge))
    return {
        "driver": driver, "7-iron": {**GOLF_DIGEST, "loft": float(np.mean(lofts))}, "pitching-wedge": pitching_wedge,
    }  # fmt: skip


def shares(judged: ModelUnderTest) -> list[Figure]:
    """Return the shares of the way from club direction to face normal, for launch angle and start direction."""
    result = []
    for club, delivery in deliveries().items():
        attack, loft = delivery["attack"], delivery["loft"]
        up = (judged.strike(club, **delivery).launch - attack) / (loft - attack)
        right, left = (judged.strike(club, face=face, **delivery).azimuth for face in (OPEN, -OPEN))
        for table, quantity, computed in (
            ("launch-shares-vertical", "launch angle (PING)", up),
            ("launch-shares-trackman", "launch angle (TrackMan)", up),
            ("launch-shares-horizontal", "start direction (PING)", (right - left) / (2.0 * OPEN)),
        ):
            (row,) = (each for each in rows(table) if each["club"] == club)
            allowed = row.get("spread", BETWEEN_SOURCES)
            result.append(figure(club, f"share of {quantity}", "1", row["share"], computed, allowed))
    return result


def curvature(judged: ModelUnderTest) -> list[Figure]:
    """Return the distance from the start line at which shots with opposite face angle and path land."""
    result = []
    for row in rows("curvature-trackman"):
        table = "pga-2019" if row["group"] == "PGA Tour" else "lpga-2019"
        average = next(each for each in averages(table) if each.club == row["club"])
        half = row["face_to_path"] / 2.0
        shot = judged.strike(
            row["club"], speed=average.club_speed, attack=average.attack, loft=published_lofts(table)[row["club"]],
            face=half, path=-half,
        )  # fmt: skip
        ball = fly(shot)
        curve = ball.carry * math.sin(math.asin(ball.side / ball.carry) - shot.azimuth)
        what = f"{row['group']}, {row['club']}, face to path {units.show(row['face_to_path'], 'deg')}"
        result.append(figure(what, "curve", "yd", row["curve"], curve, CURVE_TOLERANCE, relative=True))
    return result


def head_after_impact(judged: ModelUnderTest) -> list[Figure]:
    """Return how much steeper a driver's head moves down after the ball has left."""
    (row,) = rows("head-after-impact")
    result = []
    for loft, steeper in (("spin_loft_least", "steeper_least"), ("spin_loft_most", "steeper_most")):
        shot = judged.strike("driver", speed=HEAD_SPEED, loft=row[loft])
        computed = -math.atan2(shot.club_velocity_y, shot.club_velocity_x)
        what = f"driver, spin loft {units.show(row[loft], 'deg')}"
        result.append(figure(what, "attack angle steeper by", "deg", row[steeper], computed, STEEPER_TOLERANCE))
    return result


SLOPE_TOLERANCE = 0.15
WEDGE: dict[str, Any] = {"speed": units.parse("46 mph", "speed"), "attack": units.parse("-5 deg", "angle")}
"""Swing of the robot with the wedge; the unpublished attack angle is that of PGA Tour pitching wedges."""
WEDGE_TOLERANCE = units.parse("1 deg", "angle")
LEAST_FRICTION, HALVINGS = 0.02, 10
PEAK: dict[str, Any] = {"speed": units.parse("75 mph", "speed"), "attack": units.parse("-5 deg", "angle")}
PEAK_LOFTS = np.radians(np.arange(31.0, 64.0, 4.0))
PEAK_TOLERANCE = units.parse("4 deg", "angle")


def by_loft(judged: ModelUnderTest) -> list[Figure]:
    """Return the spin of 7-irons at the mean of the published lofts or launch angles, and its slope."""
    result = []
    for table, column, delivery in (
        ("robot-7-irons-2026", "dynamic_loft", GOLF_DIGEST), ("robot-7-irons-launch-2026", "launch", COOL_CLUBS),
    ):  # fmt: skip
        angles, spins = (np.array([row[name] for row in rows(table)]) for name in (column, "spin"))
        middle, wide = float(angles.mean()), float(angles.std())
        computed = []
        for angle in (middle - wide, middle, middle + wide):
            launched = column == "launch"
            shot = (
                judged.at_launch("7-iron", angle, **delivery)
                if launched
                else judged.strike("7-iron", loft=angle, **delivery)
            )
            computed.append(shot.total_spin)
        named = "dynamic loft" if column == "dynamic_loft" else "launch angle"
        what = f"7-iron, {named} {units.show(middle, 'deg', 3)}"
        slope, degree = float(np.polyfit(angles, spins, 1)[0]), math.radians(1.0)
        result += [
            figure(what, "spin", "rpm", spins.mean(), computed[1], SPIN, relative=True),
            figure(what, "spin by a degree", "rpm", slope * degree,
                   degree * (computed[2] - computed[0]) / (2.0 * wide), SLOPE_TOLERANCE, relative=True),
        ]  # fmt: skip
    return result


def sliding(judged: ModelUnderTest) -> list[Figure]:
    """Return how much higher a sliding ball launches whose spin is lower by the published amount.

    The loft is chosen to match the published launch of a urethane ball. The unknown friction of the sliding ball is
    chosen to match the published loss of spin.
    """
    row = {each["balls"]: each for each in rows("robot-wedge-covers-2025")}
    grips, slides = row["urethane"], row["two that slide"]
    kept, computed = slides["spin"] / grips["spin"], math.nan
    if judged.has("friction"):
        whole = judged.at_launch("pitching-wedge", grips["launch"], **WEDGE)
        loft = whole.delivery["loft"]

        def with_friction(friction: float) -> Launch:
            return judged.strike("pitching-wedge", parameters={"friction": friction}, loft=loft, **WEDGE)

        low, high = LEAST_FRICTION, float(whole.parameters.values["friction"])
        if with_friction(low).total_spin < kept * whole.total_spin:
            for _ in range(HALVINGS):
                middle = 0.5 * (low + high)
                slow = with_friction(middle).total_spin < kept * whole.total_spin
                low, high = (middle, high) if slow else (low, middle)
            computed = with_friction(high).launch - whole.launch
    rises = slides["launch"] - grips["launch"]
    return [figure("wedge, 46 mph, 0.64 of the spin", "rise of launch angle", "deg", rises, computed, WEDGE_TOLERANCE)]


def peak(judged: ModelUnderTest) -> list[Figure]:
    """Return the spin loft at which a wedge gives the most spin."""
    (row,) = rows("spin-peak")
    spins = np.array([float(judged.strike("pitching-wedge", loft=loft, **PEAK).total_spin) for loft in PEAK_LOFTS])
    published = (row["spin_loft_still_gripping"], row["spin_loft_sliding"])
    computed = top(PEAK_LOFTS - PEAK["attack"], spins)
    return [figure("wedge, 75 mph", "spin loft of most spin", "deg", published, computed, PEAK_TOLERANCE)]


def top(places: Floats, values: Floats) -> float:
    """Return the place of the maximum, by a parabola through the largest value and its neighbours, or an end."""
    index = int(np.argmax(values))
    if index in (0, len(places) - 1):
        return float(places[index])
    a, b, _ = np.polyfit(places[index - 1 : index + 2] - places[index], values[index - 1 : index + 2], 2)
    return float(places[index] - b / (2.0 * a))


LAUNCH_TOLERANCE, SPIN_TOLERANCE = units.parse("1 deg", "angle"), units.parse("300 rpm", "angular rate")
"""Tolerances within which PING's chart counts a launch as near the optimum."""
SPEEDS = ("80 mph", "100 mph", "120 mph")
BALL_SPEEDS, BALL_ATTACKS = ("100 mph", "130 mph", "160 mph"), (-4.0, 0.0, 4.0)
STEPS = np.radians(np.arange(-6.0, 7.0, 2.0))
MOVES = 3
SMASH = 1.46


def longest(judged: ModelUnderTest, speed: float, attack: float) -> Launch:
    """Return the drive with the longest carry over dynamic loft."""
    lofts, carries = _carries(judged, speed, attack, math.radians(16.0) + 0.6 * attack)
    for _ in range(MOVES):
        if 0 < (best := int(np.argmax(carries))) < len(lofts) - 1:
            break
        lofts, carries = _carries(judged, speed, attack, float(lofts[best]))
    return judged.strike("driver", speed=speed, attack=attack, loft=top(lofts, carries))


def _carries(judged: ModelUnderTest, speed: float, attack: float, middle: float) -> tuple[Floats, Floats]:
    lofts = middle + STEPS
    shots = [judged.strike("driver", speed=speed, attack=attack, loft=float(loft)) for loft in lofts]
    return lofts, np.array([fly(each).carry for each in shots])


def by_club_speed(judged: ModelUnderTest) -> list[Figure]:
    """Return the launches of the longest drives by club speed and attack angle."""
    result = []
    wanted = {round(units.parse(each, "speed"), 6) for each in SPEEDS}
    for row in rows("optimum-trackman-2010"):
        if row["optimum_of"] == "carry" and round(row["club_speed"], 6) in wanted:
            shot = longest(judged, row["club_speed"], row["attack"])
            result += _launch(_named("club", row["club_speed"], row["attack"]), row, shot)
    return result


def by_ball_speed(judged: ModelUnderTest) -> list[Figure]:
    """Return the launches of the longest drives by ball speed and attack angle.

    Club speed is chosen so that the longest drive has the published ball speed, by one correction.
    """
    result = []
    speeds = {round(units.parse(each, "speed"), 6) for each in BALL_SPEEDS}
    attacks = {round(math.radians(each), 6) for each in BALL_ATTACKS}
    for row in rows("optimum-ping-2019"):
        if round(row["ball_speed"], 6) in speeds and round(row["attack"], 6) in attacks:
            speed = row["ball_speed"] / SMASH
            shot = longest(judged, speed, row["attack"])
            shot = longest(judged, speed * row["ball_speed"] / float(shot.ball_speed), row["attack"])
            result += _launch(_named("ball", row["ball_speed"], row["attack"]), row, shot)
    return result


def _named(what: str, speed: float, attack: float) -> str:
    return f"{what} {units.from_si(speed, 'mph'):.0f} mph, attack {units.from_si(attack, 'deg'):+.0f} deg"


def _launch(what: str, row: dict[str, float], shot: Launch) -> list[Figure]:
    return [
        figure(what, "launch angle", "deg", row["launch"], shot.launch, LAUNCH_TOLERANCE),
        figure(what, "spin", "rpm", row["spin"], shot.total_spin, SPIN_TOLERANCE),
    ]
