"""Golfers as chains of driven segments: bodies, hinges, and torque generators."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from typing import Any

import numpy as np

from clubface import units
from clubface.errors import InputError, Wording
from clubface.support.checks import check_names

__all__ = ["GolferBody", "Segment"]

BY_JOINT = ("start", "onset", "rise_time", "maximum_torque", "maximum_speed")
"""Values that a golfer has for each joint."""

# Men, P. de Leva, Journal of Biomechanics 29, 1223-1230, 1996: fraction of body mass; length for a height of 1.741 m
# [m]; distance of the CG from the upper end and radii of gyration across and along, relative to the length.
DE_LEVA_HEIGHT = 1.741
UPPER_ARM = (0.0271, 0.2817, 0.5772, 0.285, 0.158)
FOREARM = (0.0162, 0.2689, 0.4574, 0.276, 0.121)
HAND = (0.0061, 0.0862, 0.7900, 0.628, 0.401)
TRUNK = (0.4346, 0.5319, 0.4486, 0.372, 0.191)
SHOULDER = 0.129
"""Distance from spine to shoulder, relative to height (R. Drillis and R. Contini, 1966)."""


Body = tuple[float, Any, Any]
"""Mass [kg], CG [m] and inertia about it [kg m2] of a rigid body, shapes (), (3,) and (3, 3)."""


def combined(one: Body, other: Body) -> Body:
    """Return two bodies as one."""
    mass = one[0] + other[0]
    cg = (one[0] * one[1] + other[0] * other[1]) / mass
    inertia = np.zeros((3, 3))
    for own, place, about in (one, other):
        away = place - cg
        inertia = inertia + about + own * (away @ away * np.eye(3) - np.outer(away, away))
    return mass, cg, inertia


@dataclass(frozen=True, kw_only=True)
class Segment:
    """A rigid body and the hinge that connects it to the previous one, in the reference pose.

    In the reference pose the club is at its static loft and lie with a square face. Vectors are in world axes (x to the
    target, y up, z to the right) with the origin in the middle of the hands.

    Attributes
    ----------
    name
        Name for tables and other programs.
    joint
        Point on the hinge axis [m], shape (3,).
    axis
        Direction of the hinge axis, shape (3,); positive angles swing the club towards the target.
    mass
        Mass [kg]; the last segment's excludes the club.
    cg
        CG of the body [m], shape (3,).
    inertia
        Inertia about the CG [kg m2], shape (3, 3).
    """

    name: str
    joint: Any
    axis: Any
    mass: float = 0.0
    cg: Any = (0.0, 0.0, 0.0)
    inertia: Any = ((0.0,) * 3,) * 3

    def __post_init__(self) -> None:
        for name, shape in (("joint", (3,)), ("axis", (3,)), ("cg", (3,)), ("inertia", (3, 3))):
            array = np.array(getattr(self, name), dtype=np.float64)
            if array.shape != shape or not np.isfinite(array).all():
                raise InputError(
                    f"{name} of {self.name}", Wording(f"of shape {array.shape}"), f"numbers, shape {shape}"
                )
            object.__setattr__(self, name, array)
        length = float(np.linalg.norm(self.axis))
        if length == 0.0:
            raise InputError(f"axis of {self.name}", 0.0, "a direction")
        object.__setattr__(self, "axis", self.axis / length)


@dataclass(frozen=True, kw_only=True)
class GolferBody:
    """A chain of segments from the ground to the hands, each driven by a torque generator at its hinge.

    Each list has one value per joint, starting at the ground.

    Attributes
    ----------
    segments
        Segments from the ground to the hands; the last hinge carries the club.
    start
        Joint angles at the top of the backswing, from the reference pose [rad]; joints cannot move back beyond them.
    onset
        Time at which each generator starts, after the start from rest [s].
    rise_time
        Time constant of the rise of activation [s].
    maximum_torque
        Torque at full activation without motion [N m].
    maximum_speed
        Joint speed at which the torque vanishes [rad/s].
    """

    segments: tuple[Segment, ...]
    start: tuple[float, ...]
    onset: tuple[float, ...]
    rise_time: tuple[float, ...]
    maximum_torque: tuple[float, ...]
    maximum_speed: tuple[float, ...]

    def __post_init__(self) -> None:
        count = len(self.segments)
        for name in BY_JOINT:
            values = tuple(float(each) for each in getattr(self, name))
            if len(values) != count:
                raise InputError(name, f"{len(values)} values", f"{count}, one for each joint")
            if name in ("rise_time", "maximum_speed") and min(values) <= 0.0:
                raise InputError(name, min(values), "more than 0")
            object.__setattr__(self, name, values)

    def replace(self, **changes: Any) -> GolferBody:
        """Return a copy with fields changed."""
        check_names("field of a golfer", changes, [each.name for each in fields(self)])
        return replace(self, **changes)

    @classmethod
    def three_segments(
        cls,
        *,
        mass: float | str = 80.0,
        height: float | str = 1.80,
        lie: float | str = "58 deg",
        start: Sequence[float | str] = ("-90 deg", "-55 deg", "-95 deg"),
        onset: tuple[float, ...] = (0.0, 0.05, 0.17),
        rise_time: tuple[float, ...] = (0.03, 0.03, 0.03),
        maximum_torque: tuple[float, ...] = (200.0, 130.0, 35.0),
        maximum_speed: tuple[float, ...] = (30.0, 30.0, 60.0),
    ) -> GolferBody:
        """Return a golfer made of torso, lead arm and club, swinging in an inclined plane.

        The three hinges follow E. J. Sprigings and R. J. Neal (Journal of Applied Biomechanics 16, 356-366, 2000). The
        bodies are those of a man of the given size by P. de Leva (Journal of Biomechanics 29, 1223-1230, 1996), without
        the trail arm. The torques are not measured; they were chosen to give a driver swing of about 41 m/s.

        Parameters
        ----------
        mass, height
            Body mass and height [kg, m], or text with units.
        lie
            Angle between ground and swing plane [rad], equal to the club's lie at address.
        start
            Angles of torso, arm and wrist at the top [rad], or text with units.
        onset, rise_time, maximum_torque, maximum_speed
            As for :class:`GolferBody`.
        """
        mass, height = units.parse(mass, "mass", name="mass"), units.parse(height, "length", name="height")
        lie = units.parse(lie, "angle", name="lie")
        up = np.array([0.0, math.sin(lie), -math.cos(lie)])  # along shaft and arm, from the hands to the shoulder
        target, normal = np.array([1.0, 0.0, 0.0]), np.array([0.0, math.cos(lie), math.sin(lie)])
        scale = height / DE_LEVA_HEIGHT
        # The middle of the grip is at the hand's CG, and the hand rotates with the club about the wrist.
        wrist = length = HAND[2] * HAND[1] * scale

        def body(part: tuple[float, ...], cg: Any, axis: Any) -> Body:
            """Return a part of the golfer with its CG [m] and the direction of its long axis."""
            share, size, _, across, along = part
            onto, own = np.outer(axis, axis), share * mass
            return own, cg, own * (size * scale) ** 2 * (across**2 * (np.eye(3) - onto) + along**2 * onto)

        arms = []
        for part in (FOREARM, UPPER_ARM):
            arms.append(body(part, (length + (1.0 - part[2]) * part[1] * scale) * up, up))
            length += part[1] * scale
        shoulder = length * up
        hub = shoulder - SHOULDER * height * target
        # The trunk rotates about its own long axis, which is identified with the hinge axis.
        bodies = {
            "torso": (hub, body(TRUNK, hub, normal)),
            "arm": (shoulder, combined(*arms)),
            "club": (wrist * up, body(HAND, np.zeros(3), up)),
        }
        return cls(
            segments=tuple(
                Segment(name=name, joint=joint, axis=normal, mass=own, cg=cg, inertia=inertia)
                for name, (joint, (own, cg, inertia)) in bodies.items()
            ),
            start=tuple(units.parse(each, "angle", name="start") for each in start),
            onset=onset, rise_time=rise_time, maximum_torque=maximum_torque, maximum_speed=maximum_speed,
        )  # fmt: skip
