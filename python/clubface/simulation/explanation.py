"""Why a shot starts and curves as it does: variations of its delivery, in words, tables and a picture.

No rule of thumb is used. The effect of the strike or of the face-to-path angle is the change when it is removed,
computed with the same model and the same air; the shares of face and path in the start direction are exact derivatives
of the launch.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL, reduced_model
from clubface.errors import InputError, RangeWarning, ShotError, Wording
from clubface.quantities import quantity
from clubface.results.notes import Note, note, quantity_text
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, text
from clubface.simulation.flight import SPIN, VELOCITY, AirLike, Flight, GroundLike, WindLike, fly, trajectory
from clubface.simulation.impact import Parameters, impact
from clubface.simulation.inputs import DeliveryLike, HandLike, as_values
from clubface.simulation.launch import Launch, assumptions_of
from clubface.simulation.provenance import flight_conditions, provenance_of
from clubface.simulation.sensitivity import flight_derivatives, sensitivity
from clubface.simulation.shot_result import flight_views, lie_note, shape_note, shot_title, subject
from clubface.simulation.shot_shape import BIG_CURVE, STRAIGHT_CURVE, STRAIGHT_START
from clubface.support.arrays import ValueLike
from clubface.support.checks import without_warnings

OFF_TOE, OFF_HIGH = 15e-3, 8e-3
"""Offsets from the face centre of the strikes shown for comparison [m]."""
INSIDE = 0.3
"""Upper limit of these offsets, as a share of the width or the height of the face."""
LEAST_STRIKE = 1e-3
"""Distance of the strike from the face centre above which it is explained [m]."""
LEAST_TURN = math.radians(0.1)
"""Angle between the face at the strike and at its centre above which bulge is named [rad]."""
LEAST_OFFSET = 3e-3
"""Distance of the sweet spot from the face centre above which it is named [m]."""
WORTH = (
    ("side", "face", math.radians(1.0)), ("side", "path", math.radians(1.0)), ("side", "toe", 10e-3),
    ("carry", "loft", math.radians(1.0)), ("carry", "speed", 0.44704),
)  # fmt: skip
"""Slopes given in a note: flight quantity, input, and the change of the input to which the number refers [SI]."""


class WhatIf(NamedTuple):
    """The explained shot with one change in its delivery.

    Attributes
    ----------
    changes
        The changed values [SI], by name.
    launch, flight
        Launch and flight with these values.
    """

    changes: Mapping[str, float]
    launch: Launch
    flight: Flight


@dataclass(frozen=True, eq=False, repr=False)
class Explanation(Described):
    """A shot and the reasons why it flies as it does.

    Attributes
    ----------
    launch, flight
        Launch and flight of the shot.
    what_ifs
        The shot with one change, by its description: "struck in the middle", "face square to the path", "path to the
        target", "face to the target". Changes without effect are left out.
    strikes
        The same delivery with other impact points: "heel", "middle", "toe", "low", "high".
    slopes
        Exact derivatives [SI]. Of the launch: ("azimuth", "face"), ("azimuth", "path"), ("launch", "loft") and
        ("launch", "attack"). Of the landing, if the ball flies: ("side", "face"), ("side", "path"), ("side", "toe"),
        ("carry", "loft") and ("carry", "speed").
    sweet_spot
        The strike with the highest ball speed.
    conditions
        Air, wind and ground.
    """

    launch: Launch
    flight: Flight
    what_ifs: dict[str, WhatIf]
    strikes: dict[str, WhatIf]
    slopes: dict[tuple[str, str], float]
    sweet_spot: WhatIf
    conditions: dict[str, Any]

    @property
    def face_to_path(self) -> float:
        """Face angle relative to the path [rad], to the right of the path is positive."""
        return float(self.launch.input("face") - self.launch.input("path"))

    def to_result(self) -> Result:
        """Return the shot, its variations and the strikes as tables, the reasons as notes, and a picture."""
        launch = self.launch
        shot = {"as struck": WhatIf({}, launch, self.flight)}
        given = [
            *(column(name, [launch.input(name)]) for name in ("path", "face")),
            column("face_to_path", [self.face_to_path]),
            *(column(name, [launch.input(name)]) for name in ("attack", "loft", "toe", "high")),
        ]
        title = f"Why this shot flies as it does: {subject(launch)}, by {launch.model}"
        reasons = tuple(self.reasons())
        return Result(
            kind="explanation", title=title,
            tables=(
                Table("shot", (*given, *_columns(shot)), title, layout="list"),
                Table("what_if", (text("what if", [*shot, *self.what_ifs]), *_columns(shot | self.what_ifs)),
                      "What if"),
                Table("strikes", (text("strike", list(self.strikes)), *_columns(self.strikes, ("toe", "high"))),
                      "The same swing, struck elsewhere"),
            ),
            assumptions=assumptions_of([launch]), summary=reasons, notes=reasons,
            provenance=provenance_of([launch], flight_conditions(**self.conditions)),
            draw=lambda: [explanation_picture(self)],
        )  # fmt: skip

    def reasons(self) -> Iterator[Note]:
        """Yield notes on why the ball starts and curves as it does."""
        launch, flight = self.launch, self.flight
        given = {name: float(launch.input(name)) for name in ("path", "face", "attack", "loft", "toe", "high")}
        yield shape_note("shot-shape", flight)
        if (carry := float(flight.carry)) > 0.0:
            yield note("explain-shape-limits", straight_curve=STRAIGHT_CURVE * carry, big_curve=BIG_CURVE * carry,
                       straight_azimuth=STRAIGHT_START)  # fmt: skip
        yield note(
            "explain-start", face=given["face"], path=given["path"],
            face_share=self.slopes["azimuth", "face"], path_share=self.slopes["azimuth", "path"],
        )  # fmt: skip
        middle = self.what_ifs.get("struck in the middle")
        if middle is not None and abs(given["toe"]) >= LEAST_STRIKE:
            turn = face_there(launch) - given["face"]
            code = "explain-start-strike" if abs(turn) < LEAST_TURN else "explain-start-bulge"
            yield note(code, toe=given["toe"], middle_azimuth=middle.launch.azimuth, turned_face=turn)
        if held := lie_note(launch):
            yield held
        yield from self._curve_reasons(middle)
        yield note(
            "explain-launch", launch=launch.launch, loft=given["loft"], attack=given["attack"],
            backspin=launch.backspin, loft_share=self.slopes["launch", "loft"],
            attack_share=self.slopes["launch", "attack"],
        )  # fmt: skip
        if middle is not None and abs(given["high"]) >= LEAST_STRIKE:
            yield note(
                "explain-launch-strike", high=given["high"], middle_launch=middle.launch.launch,
                middle_backspin=middle.launch.backspin,
            )  # fmt: skip
        if middle is not None:
            yield from self._speed_reasons(middle)
        if ("side", "face") in self.slopes:
            worth = {f"{name}_{what}": self.slopes[what, name] * change for what, name, change in WORTH}
            yield note("explain-worth", **worth)

    def _speed_reasons(self, middle: WhatIf) -> Iterator[Note]:
        """Yield notes on the effect of the strike on ball speed and carry, and on the sweet spot."""
        if max(abs(float(self.launch.input(name))) for name in ("toe", "high")) < LEAST_STRIKE:
            return
        yield note(
            "explain-speed-strike", ball_speed=self.launch.ball_speed, carry=float(self.flight.carry),
            middle_ball_speed=middle.launch.ball_speed, middle_carry=float(middle.flight.carry),
        )  # fmt: skip
        best = self.sweet_spot
        if math.hypot(*best.changes.values()) > LEAST_OFFSET:
            yield note(
                "explain-sweet-spot", **best.changes, ball_speed=best.launch.ball_speed, carry=float(best.flight.carry)
            )

    def _curve_reasons(self, middle: WhatIf | None) -> Iterator[Note]:
        """Yield notes on why the ball curves, if it flies."""
        launch, flight = self.launch, self.flight
        if not flight.carry > 0.0:
            return
        square = self.what_ifs.get("face square to the path")
        if square is None:
            yield note("explain-curve-square", curve=flight.curve)
        else:
            yield note(
                "explain-curve-face", open_face=self.face_to_path * float(launch.input("hand")),
                curve=flight.curve, square_curve=square.flight.curve,
            )  # fmt: skip
        if middle is not None and abs(float(launch.input("toe"))) >= LEAST_STRIKE:
            yield note("explain-curve-strike", curve=flight.curve, middle_curve=middle.flight.curve)
        yield note("explain-axis", spin_axis=launch.spin_axis)

    def __repr__(self) -> str:
        return "\n".join(each.sentence for each in (*assumptions_of([self.launch]), *self.reasons()))


def explain(
    club: str | os.PathLike[str] | Club,
    delivery: DeliveryLike | None = None,
    *,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: HandLike | None = None,
    air: AirLike | None = None,
    wind: WindLike | None = None,
    ground: GroundLike | None = None,
    **values: ValueLike | None,
) -> Explanation:
    """Compute a shot and variations of it, and explain why it flies as it does.

    Parameters
    ----------
    club, delivery, parameters, ball, accuracy, hand, values
        As for :func:`clubface.impact`, for a single shot.
    model
        A model with derivatives: any but finite elements.
    air, wind, ground
        As for :func:`clubface.fly`.

    Returns
    -------
    Explanation
        The shot, its variations, the same delivery struck elsewhere, and the derivatives that the reasons quote.

    Raises
    ------
    InputError
        There are several shots, or the model has no derivatives.
    """
    reduced_model(model, "one with derivatives")
    given = dict(as_values(delivery, values))
    options: dict[str, Any] = {
        "model": model, "parameters": parameters, "ball": ball, "accuracy": accuracy, "hand": hand,
    }  # fmt: skip
    conditions = {"air": air, "wind": wind, "ground": ground}
    launch = impact(club, given, **options)
    if launch.shape:
        raise InputError("delivery", Wording(f"a batch of shape {launch.shape}"), "a single shot")
    derivatives = sensitivity(
        club, given, outputs=("azimuth", "launch", *VELOCITY, *SPIN),
        variables=("face", "path", "loft", "attack", "toe", "speed"), **options,
    )  # fmt: skip
    pairs = (("azimuth", "face"), ("azimuth", "path"), ("launch", "loft"), ("launch", "attack"))
    slopes = {pair: derivatives.value(*pair) for pair in pairs}
    flight = fly(launch, **conditions)
    if flight.carry > 0.0:
        flown = flight_derivatives(launch, **conditions)
        for what, name, _ in WORTH:
            chain = (flown.by(what, each) * derivatives.value(each, name) for each in (*VELOCITY, *SPIN))
            slopes[what, name] = float(sum(chain))

    def shots(changed: Mapping[str, Mapping[str, float]]) -> dict[str, WhatIf]:
        result = {}
        for name, changes in changed.items():
            try:
                with without_warnings(RangeWarning):
                    other = impact(club, {**given, **changes}, **options)
            except ShotError:  # that strike misses the face
                continue
            result[name] = WhatIf(changes, other, fly(other, **conditions))
        return result

    (best,) = shots({"": _sweet_spot(club, given, launch, options)}).values()
    return Explanation(launch, flight, shots(_changes(launch)), shots(_strikes(launch)), slopes, best, conditions)


def _sweet_spot(club: Any, given: Mapping[str, Any], launch: Launch, options: Mapping[str, Any]) -> dict[str, float]:
    """Return toe and high [m] of the strike with the highest ball speed, to half a millimetre.

    Searches along the face, up it, and along it again, which is enough since ball speed is nearly a paraboloid.
    """
    width, height = (float(launch.input(name)) for name in ("face_width", "face_height"))
    half = {"toe": 0.5 * width or 2.0 * OFF_TOE, "high": 0.5 * height or 2.0 * OFF_HIGH}
    best = {"toe": 0.0, "high": 0.0}
    for name, other in (("high", "toe"), ("toe", "high"), ("high", "toe")):
        reach = 0.99 * half[name] * math.sqrt(1.0 - min(best[other] / half[other], 1.0) ** 2)
        count = max(int(2.0 * reach / 0.5e-3), 1)
        line = np.linspace(-reach, reach, 2 * (count // 2) + 1)
        with without_warnings(RangeWarning):
            speeds = impact(club, {**given, **best, name: line}, on_error="nan", **options).ball_speed
        if np.isfinite(speeds).any():
            best[name] = float(line[np.nanargmax(speeds)])
    return best


def face_there(launch: Launch) -> float:
    """Return the azimuth of the face normal where the ball is struck, at the height of the face centre [rad].

    It differs from the face angle by bulge; right of the target is positive.
    """
    turn = math.asin(max(-1.0, min(1.0, float(launch.input("toe") / launch.input("bulge")))))
    return float(launch.input("face")) + float(launch.input("hand")) * math.atan2(
        math.tan(turn), math.cos(float(launch.input("loft")))
    )


def _changes(launch: Launch) -> dict[str, dict[str, float]]:
    """Return the changed values of each variation of the delivery that has an effect."""
    path = float(launch.input("path"))
    changes = {
        "struck in the middle": {"toe": 0.0, "high": 0.0},
        "face square to the path": {"face": path},
        "path to the target": {"path": 0.0},
        "face to the target": {"face": 0.0},
    }
    return {
        name: each
        for name, each in changes.items()
        if any(float(launch.input(key)) != value for key, value in each.items())
        and not (name == "face to the target" and path == 0.0)  # then it is square to the path
    }


def _strikes(launch: Launch) -> dict[str, dict[str, float]]:
    width, height = (float(launch.input(name)) for name in ("face_width", "face_height"))
    across = min(OFF_TOE, INSIDE * width) if width > 0.0 else OFF_TOE
    up = min(OFF_HIGH, INSIDE * height) if height > 0.0 else OFF_HIGH
    return {
        "middle": {"toe": 0.0, "high": 0.0},
        "heel": {"toe": -across, "high": 0.0}, "toe": {"toe": across, "high": 0.0},
        "low": {"toe": 0.0, "high": -up}, "high": {"toe": 0.0, "high": up},
    }  # fmt: skip


_SHOWN = ("azimuth", "spin_axis", "curve", "side", "carry", "launch", "backspin", "ball_speed")


def _columns(shots: Mapping[str, WhatIf], changed: tuple[str, ...] = ()) -> list[Column]:
    alone = len(shots) == 1
    columns = [column(name, [each.changes[name] for each in shots.values()]) for name in changed]
    for name in _SHOWN:
        columns.append(column(name, [_value(each, name) for each in shots.values()]))
    shapes = [each.flight.shot_shape() or None for each in shots.values()]
    return [*columns, text("shot_shape", shapes, label="shot shape", printed=not alone)]


def _value(shot: WhatIf, name: str) -> float:
    return float(getattr(shot.launch if name in shot.launch.quantities() else shot.flight, name))


_FLIGHT, _PATH, _FACE, _START, _CURVE = 0, 1, 2, 3, -2
"""Line styles: colour numbers, greys if negative."""
_TALLEST = 3.8
"""Maximum height of a view from above [inches]."""
_MIDDLE, _LESS, _MORE = 4, 5, 6
"""Styles of strikes in the middle, towards heel or sole, and towards toe or crown."""


def explanation_picture(explanation: Explanation) -> Picture:
    """Return the picture of an explanation.

    It shows the flight from above with path, face, start and curve; the head at impact, the tilted ball and the impact
    point; and the flights of strikes elsewhere on the face. Angles and flights are to scale.
    """
    launch, flight = explanation.launch, explanation.flight
    path = trajectory(launch, **explanation.conditions).position
    views, heights = flight_views({"flight": path}, styles={"flight": _FLIGHT})
    above, height = _directions_panel(views[1], heights[1], explanation, path)
    rows: list[list[Panel | None]] = [[above], [_at_impact(launch), _tilted_ball(launch), _face(explanation)]]
    sizes = [height, 2.1]
    for names, place in ((("low", "middle", "high"), 0), (("heel", "middle", "toe"), 1)):
        struck = {name: explanation.strikes[name] for name in names if name in explanation.strikes}
        paths = {name: trajectory(each.launch, **explanation.conditions).position for name, each in struck.items()}
        styles: dict[str, str | int] = dict(zip(names, (_LESS, _MIDDLE, _MORE), strict=True))
        if "struck in the middle" in explanation.what_ifs:  # else the middle is the shot
            paths["as struck"], styles["as struck"] = path, _FLIGHT
        panels, heights = flight_views(paths, styles=styles, starts=False)
        words = "; ".join(
            _strike_words(name, each, place, first=number == 0) for number, (name, each) in enumerate(struck.items())
        )
        marks = [replace(each, label=_LABELS.get(each.style, "")) for each in panels[place].marks]
        rows.append([replace(panels[place], marks=marks, title=f"{panels[place].title}\n{words}")])
        sizes.append(heights[place])
    name = flight.shot_shape() or "no flight"
    return Picture(
        "explanation", "Why the ball starts and curves as it does, and what strikes elsewhere on the face would do",
        rows, heights=sizes, height=sum(sizes) + 0.62 * len(rows) + 0.7, legend=True,
        title=f"{shot_title(launch)}: {name}",
    )  # fmt: skip


_LABELS: dict[str | int, str] = {
    _FLIGHT: "as struck", _LESS: "struck low, on the heel", _MIDDLE: "in the middle", _MORE: "high, on the toe",
}  # fmt: skip


def _strike_words(name: str, struck: WhatIf, place: int, *, first: bool) -> str:
    launch, flight = struck.launch, struck.flight
    if place == 0:
        spin, carry = _value_text("backspin", launch.backspin), _value_text("carry", flight.carry, "0")
        return f"{name}: {'launch ' * first}{_value_text('launch', launch.launch)}, {spin}, {'carry ' * first}{carry}"
    start, bend = _value_text("azimuth", launch.azimuth, "sides"), _value_text("curve", flight.curve, "sides 0")
    return f"{name}: {'starts ' * first}{start}, {'curves ' * first}{bend}"


def _value_text(name: str, value: float, spec: str = "") -> str:
    return quantity_text(float(value), quantity(name), spec)


def _directions_panel(panel: Panel, height: float, explanation: Explanation, path: Any) -> tuple[Panel, float]:
    """Return the flight from above with path, face, start and curve, and the height of the panel."""
    launch, flight = explanation.launch, explanation.flight
    marks = [each for each in panel.marks if each.kind == "rule"]
    lands = f"flight, lands {_value_text('side', flight.side, 'sides 0')}"
    marks.append(Mark("line", path[:, 0], path[:, 2], style=_FLIGHT, label=lands))
    start, landing = float(launch.azimuth), path[-1, [0, 2]]
    way = np.array([np.cos(start), np.sin(start)])
    foot = way * float(way @ landing)
    rays = {
        f"path {_value_text('path', launch.input('path'), 'sides')}": (float(launch.input("path")), 0.45, _PATH),
        f"face {_value_text('face', launch.input('face'), 'sides')}": (float(launch.input("face")), 0.6, _FACE),
        f"start {_value_text('azimuth', start, 'sides')}": (start, 1.0, _START),
    }
    ends = []
    for label, (angle, share, style) in rays.items():
        end = share * float(np.hypot(*foot)) * np.array([np.cos(angle), np.sin(angle)])
        marks.append(Mark("line", [0.0, end[0]], [0.0, end[1]], style=style, label=label))
        ends.append(1.06 * float(end[1]))
    marks.append(
        Mark("line", [foot[0], landing[0]], [foot[1], landing[1]], style=_CURVE, size=2.0, dash=0,
             label=f"curve {_value_text('curve', flight.curve, 'sides 0')}")
    )  # fmt: skip
    low, high = (each or 0.0 for each in panel.y.limits)
    limits = (min(low, *ends), max(high, *ends))
    taller = height * (limits[1] - limits[0]) / (high - low)
    return replace(panel, marks=marks, y=replace(panel.y, limits=limits)), min(taller, _TALLEST)


def _at_impact(launch: Launch) -> Panel:
    """Return the head at impact from above: the face with its bulge, and the directions, to scale."""
    hand, face, path = (float(launch.input(name)) for name in ("hand", "face", "path"))
    toe, width = float(launch.input("toe")), float(launch.input("face_width")) or 0.08
    radius, bulge = float(launch.input("ball_radius")), float(launch.input("bulge"))
    normal = np.array([np.sin(face), np.cos(face)])  # right, to the target
    to_toe = hand * np.array([np.cos(face), -np.sin(face)])
    along = np.linspace(-0.5 * width, 0.5 * width, 41)
    points = along[:, None] * to_toe - (along**2 / (2.0 * bulge))[:, None] * normal
    points -= toe * to_toe - toe**2 / (2.0 * bulge) * normal  # the strike is the origin
    here = normal + to_toe * toe / bulge
    centre = radius * here / np.hypot(*here)
    marks = [
        Mark("rule", x=0.0, style=-1, dash=2),
        _ellipse(radius, radius, -1, centre),
        Mark("line", points[:, 0], points[:, 1], style=-2, size=2.5, dash=0),
    ]
    for word, angle, style, back, length in (
        ("path", path, _PATH, 0.04, 0.06), ("face", face_there(launch), _FACE, 0.0, 0.09),
        ("start", float(launch.azimuth), _START, 0.0, 0.12),
    ):  # fmt: skip
        way = np.array([np.sin(angle), np.cos(angle)])
        marks.append(_arrow(-back * way, length * way, style))
        side = 0.018 if word != "face" else -0.018
        marks.append(Mark("text", [length * way[0] + side], [length * way[1] - 0.004], texts=[word], style=style))
    for word, end in (("heel", points[0]), ("toe", points[-1])):
        marks.append(Mark("text", [end[0]], [end[1] - 0.013], texts=[word], style=-2))
    middle = float(points[:, 0].mean())
    reach = 0.5 * width + 0.02
    return Panel(
        marks, axis(limits=(middle - reach, middle + reach), ticks=False), axis(limits=(-0.055, 0.13), ticks=False),
        "at impact, from above", equal=True, grid=False,
    )  # fmt: skip


def _tilted_ball(launch: Launch) -> Panel:
    """Return the ball as the player sees it from behind: its tilted spin axis and the lift across it."""
    tilt = float(launch.spin_axis)
    ends = 1.25 * np.array([np.cos(tilt), -np.sin(tilt)])  # to the right, up: tilted right, the right end is down
    lift = np.array([np.sin(tilt), np.cos(tilt)])
    back = 1.0 if launch.backspin >= 0.0 else -1.0
    axis_words, spin = _value_text("spin_axis", tilt, "sides"), _value_text("total_spin", launch.total_spin)
    marks = [
        Mark("line", [-1.25, 1.25], [0.0, 0.0], style=-1, dash=2, size=0.8),
        _ellipse(1.0, 1.0, -2),
        Mark("line", [-ends[0], ends[0]], [-ends[1], ends[1]], style=-2, size=2.0, dash=0),
        _arrow(np.zeros(2), 1.55 * back * lift, _FLIGHT),
        Mark("text", [1.75 * back * lift[0]], [1.75 * back * lift[1]], texts=["lift"], style=_FLIGHT),
        Mark("text", [0.0], [-1.35], texts=[f"axis {axis_words}, {spin}"], style=-2),
    ]
    blank = axis(limits=(-1.9, 1.9), ticks=False)
    return Panel(marks, blank, replace(blank, limits=(-1.6, 2.0)),
                 "the ball, from behind", equal=True, grid=False)  # fmt: skip


def _face(explanation: Explanation) -> Panel:
    """Return the face with the strike and the strikes that it is compared with."""
    launch = explanation.launch
    width, height = (float(launch.input(name)) for name in ("face_width", "face_height"))
    marks = [_ellipse(0.5 * width, 0.5 * height, -1)] if width > 0.0 and height > 0.0 else []
    struck = explanation.strikes
    for style, names in ((_LESS, ("heel", "low")), (_MIDDLE, ("middle",)), (_MORE, ("toe", "high"))):
        there = [name for name in names if name in struck]
        marks.append(
            Mark("points", [struck[name].changes["toe"] for name in there],
                 [struck[name].changes["high"] for name in there], style=style, symbol="o", hollow=True, size=5.0)
        )  # fmt: skip
    marks.append(Mark("points", [launch.input("toe")], [launch.input("high")], style=_FLIGHT, symbol="6", size=6.0,
                      label="strike"))  # fmt: skip
    across, up = (0.55 * each if each > 0.0 else 0.05 for each in (width, height))
    left_handed = float(launch.input("hand")) < 0.0
    return Panel(
        marks, axis("toe", "towards the toe", limits=(-across, across), reversed=left_handed),
        axis("high", "up the face", limits=(-up, up)),
        "where it was struck", equal=True,
    )  # fmt: skip


def _ellipse(across: float, up: float, style: int, centre: Any = (0.0, 0.0)) -> Mark:
    """Return an ellipse by its half axes."""
    turn = np.linspace(0.0, 2.0 * np.pi, 61)
    return Mark("outline", centre[0] + across * np.cos(turn), centre[1] + up * np.sin(turn), style=style)


def _arrow(start: Any, end: Any, style: int) -> Mark:
    """Return an arrow, head included, drawn as one line."""
    way = np.asarray(end) - np.asarray(start)
    barb = 0.06 * np.array([-way[1], way[0]])
    neck = np.asarray(start) + 0.88 * way
    points = np.array([start, end, neck + barb, end, neck - barb])
    return Mark("line", points[:, 0], points[:, 1], style=style, dash=0)
