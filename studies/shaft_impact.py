"""How well a 6 x 6 matrix stands for a shaft: contact and beam integrated together, and contact with the matrix.

``python studies/shaft_impact.py`` prints ball and head after an impact with a free head, with the matrix and with the
beam, and what the matrix misses. Head and shaft move linearly about first touch, the ball is a sphere, the contact
Hertz's with damping and friction; only the shaft differs.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

import clubface
from clubface.simulation.beam import Modes, cross_matrix

STIFFNESS, DAMPING, FRICTION = 2.3e7, 6.5e-3, 0.3
"""Of the contact [N/m^1.5, s/m, 1]: a drive lasts 450 us and returns with 0.8."""
CREEP = 0.3
"""Sliding at which friction is nearly full [m/s]."""
BALL_MASS, BALL_RADIUS = 45.93e-3, 21.335e-3
STEP = 0.5e-6
"""[s]; a step of half the length changes no figure printed."""
STRIKES = {
    "driver": ("driver", "graphite", 50.0, ((0.0, 0.0), (0.02, 0.0), (-0.02, 0.0), (0.0, 0.012), (0.0, -0.012))),
    "7-iron": ("7-iron", "steel", 38.0, ((0.0, 0.0), (0.015, 0.0), (-0.015, 0.0), (0.0, -0.008))),
}
"""Club, shaft, speed [m/s] and strikes [m], towards the toe and up the face."""


class Result(NamedTuple):
    """After the impact, in world axes: x to the target, y up, z to the toe.

    Attributes
    ----------
    ball_velocity, ball_spin, head_velocity, head_spin
        [m/s, rad/s], shape (3,).
    contact_time
        [s].
    peak_force
        [N].
    """

    ball_velocity: Any
    ball_spin: Any
    head_velocity: Any
    head_spin: Any
    contact_time: float
    peak_force: float


def rigid(inertia: Any) -> Modes:
    """Return the six modes of a body with a spatial inertia."""
    return Modes(np.zeros(6), np.linalg.inv(np.linalg.cholesky(np.asarray(inertia))).T)


def strike_point(club: clubface.Club, toe: float, high: float) -> tuple[Any, Any]:
    """Return the point struck from the CG, and the normal there, at the static loft."""
    loft = club.loft
    up = np.array([-math.sin(loft), math.cos(loft), 0.0])
    outward, right = np.array([math.cos(loft), math.sin(loft), 0.0]), np.array([0.0, 0.0, 1.0])
    normal = outward + toe / club.bulge * right + high / club.roll * up
    depth = 0.5 * (toe**2 / club.bulge + high**2 / club.roll)
    return np.array(club.cg) + toe * right + high * up - depth * outward, normal / np.linalg.norm(normal)


def strike(head: Modes, point: Any, normal: Any, speed: float) -> Result:
    """Return ball and head after contact at a point from the CG, the head moving to the target."""
    inertia = 0.4 * BALL_MASS * BALL_RADIUS**2
    jacobian = np.vstack([np.eye(3), cross_matrix(point)])
    # Rows: force at the point to force and moment at the CG, so that the transpose gives its velocity.
    at_point = jacobian.T @ head.head
    q, dq = np.zeros((2, len(head.frequency)))
    place, velocity, spin = np.zeros(3), np.array([-speed, 0.0, 0.0]), np.zeros(3)
    arm = -BALL_RADIUS * normal

    def force(q: Any, dq: Any, place: Any, velocity: Any, spin: Any) -> Any:
        depth = normal @ (at_point @ q - place)
        if depth <= 0.0:
            return np.zeros(3)
        relative = velocity + np.cross(spin, arm) - at_point @ dq
        closing = -normal @ relative
        pressing = max(STIFFNESS * depth**1.5 * (1.0 + DAMPING * closing), 0.0)
        sliding = relative + closing * normal
        size = np.linalg.norm(sliding)
        friction = FRICTION * pressing * math.tanh(size / CREEP) / size if size else 0.0
        return pressing * normal - friction * sliding

    now, time, peak = np.zeros(3), 0.0, 0.0
    while time < 2e-3:
        load = -at_point.T @ now
        guess = now
        for _ in range(2):
            mean = 0.5 * (now + guess)
            moved = head.advance(q, dq, load, -at_point.T @ guess, STEP)
            new_velocity = velocity + mean * (STEP / BALL_MASS)
            new_spin = spin + np.cross(arm, mean) * (STEP / inertia)
            new_place = place + 0.5 * STEP * (velocity + new_velocity)
            guess = force(*moved, new_place, new_velocity, new_spin)
        (q, dq), velocity, spin, place, now = moved, new_velocity, new_spin, new_place, guess
        time += STEP
        peak = max(peak, float(np.linalg.norm(now)))
        if time > 50e-6 and not now.any():
            break
    motion = head.head @ dq
    forward = np.array([speed, 0.0, 0.0])
    return Result(velocity + forward, spin, motion[:3] + forward, motion[3:], time, peak)


def rows(
    club: clubface.Club, shaft: clubface.Shaft, speed: float, strikes: Any, matching: str = "motion"
) -> list[tuple[Any, ...]]:
    """Return for each strike its place and the results of a free head, of the matrix, and of the beam."""
    attached = club.on_shaft(shaft, matching=matching)
    heads = rigid(club.spatial_inertia), rigid(attached.spatial_inertia), shaft.modes(club)
    return [
        (toe, high, *(strike(head, *strike_point(club, toe, high), speed) for head in heads)) for toe, high in strikes
    ]


def main() -> None:
    """Print the table."""
    from clubface.equipment.shafts import shaft

    print("            toe  high          ball m/s  backspin  sidespin rpm  head m/s  pitch  yaw deg/s   us    kN")
    for name, (club, of_shaft, speed, strikes) in STRIKES.items():
        for toe, high, *results in rows(clubface.club(club), shaft(of_shaft), speed, strikes):
            for kind, each in zip(("free", "reduced", "beam"), results, strict=True):
                spin, turn = each.ball_spin * 30.0 / math.pi, np.degrees(each.head_spin)
                print(
                    f"{name:<8} {1e3 * toe:6.0f} {1e3 * high:5.0f}  {kind:<8} {np.linalg.norm(each.ball_velocity):8.3f}"
                    f"  {spin[2]:8.0f} {-spin[1]:8.0f}      {np.linalg.norm(each.head_velocity):8.3f}"
                    f" {turn[2]:7.0f} {turn[1]:7.0f}  {1e6 * each.contact_time:5.0f} {1e-3 * each.peak_force:6.2f}"
                )


if __name__ == "__main__":
    main()
