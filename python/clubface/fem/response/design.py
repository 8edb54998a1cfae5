"""Strikes to fit response functions to: all kinds of rigid heads and the built-in clubs, with balls at rest or not."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.clubs import Club, club
from clubface.equipment.parameters import RANGES
from clubface.support.checks import without_warnings
from clubface.units import parse

RANGE = RANGES["response"]
SPINS = ("ball_backspin", "ball_sidespin", "ball_riflespin")
CLUBS = (
    "driver", "3-wood", "5-wood", "hybrid", "3-iron", "5-iron", "6-iron", "7-iron", "8-iron", "9-iron",
    "pitching-wedge",
)  # fmt: skip


class Strike(NamedTuple):
    """A head, how it is delivered (SI, as for :func:`clubface.impact`), and the coefficient of friction."""

    club: Club
    delivery: dict[str, float]
    friction: float


@dataclass(frozen=True)
class Part:
    """Some of the strikes.

    Attributes
    ----------
    make
        Returns strikes for a number and a seed.
    count, seed
        How many, and the seed of their sequence.
    held_out
        Whether the coefficients are not fitted to them.
    built_in
        Whether the heads are those of the built-in clubs.
    """

    make: Callable[[int, int], list[Strike]]
    count: int
    seed: int
    held_out: bool
    built_in: bool = False


def heads(count: int, seed: int) -> list[Strike]:
    """Return strikes with free heads of all kinds, evenly over the range of the model.

    Speed, angle between path and normal, friction and mass are those of the model's range, most masses up to 450 g;
    radii of gyration of 13.5 to 55 mm; CG and impact point anywhere on a clubface; half of them flat, some turning, and
    with rigid faces or characteristic times from 100 us to the end of the range.
    """
    return _heads(_sequence(24, count, seed))


def spinning_heads(count: int, seed: int) -> list[Strike]:
    """Return strikes as those of heads of all kinds, with balls that spin about any axis before impact."""
    points = _sequence(27, count, seed)
    return _spinning(_heads(points), points[:, 24:])


def spinning_clubs(count: int, seed: int) -> list[Strike]:
    """Return strikes as those with the built-in clubs, with balls that spin about any axis before impact."""
    points = _sequence(13, count, seed)
    return _spinning(_clubs(points), points[:, 10:])


def _spinning(of: list[Strike], shares: NDArray[Any]) -> list[Strike]:
    """Return strikes with a spin of the ball, given as shares of its range about the three axes."""
    found = []
    for each, u in zip(of, shares, strict=True):
        spin = {name: float(_between(name, share)) for name, share in zip(SPINS, u, strict=True)}
        found.append(each._replace(delivery={**each.delivery, **spin}))
    return found


def _heads(points: NDArray[Any]) -> list[Strike]:
    """Return strikes with free heads from points of the unit cube."""
    from scipy.spatial.transform import Rotation

    found = []
    slowest, fastest = RANGE["speed"]
    lightest, heaviest = RANGE["club_mass"]
    softest = RANGE["characteristic_time"][1]
    for u in points:
        mass = heaviest if u[4] < 0.04 else lightest * (0.45 / lightest) ** u[3]
        gyration = np.array([0.0135 * (0.035 / 0.0135) ** u[6], *(0.024 * (0.055 / 0.024) ** u[7:9])])
        moments = mass * gyration**2
        # No moment of a body exceeds the sum of the others.
        largest = moments.argmax()
        moments[largest] = min(moments[largest], 0.97 * (moments.sum() - moments[largest]))
        # The least moment of irons is about the line from heel to toe, that of others about the vertical.
        moments = moments[[2, 1, 0]] if u[21] < 0.7 else moments[[1, 0, 2]]
        turn = Rotation.from_rotvec((u[14:17] - 0.5) * math.pi / 3.0).as_matrix()
        inertia = turn @ np.diag(moments) @ turn.T
        curvature = max(u[5] - 0.5, 0.0) * 2.0 / 0.23
        radius = 1.0 / curvature if curvature else math.inf
        head = Club(
            name="head", kind="wood", mass=mass, cg_x=0.045 * u[22], cg_y=(u[17] - 0.5) * 0.016,
            cg_z=(u[18] - 0.5) * 0.012, loft=0.0, bulge=radius, roll=radius, face_width=0.076, face_height=0.052,
            ixx=inertia[0, 0], iyy=inertia[1, 1], izz=inertia[2, 2], ixy=inertia[0, 1], ixz=inertia[0, 2],
            iyz=inertia[1, 2], characteristic_time=0.0 if u[19] < 0.3 else 100e-6 + (softest - 100e-6) * u[20],
        )  # fmt: skip
        incidence = _between("incidence", u[1])
        loft = min(incidence, math.radians(60.0))
        delivery = {
            "speed": slowest * (fastest / slowest) ** u[0],
            "loft": loft,
            "attack": loft - incidence,
            "static_loft": 0.0,
            "toe": (u[9] - 0.5) * 0.044,
            "high": (u[10] - 0.5) * 0.026,
            "face": (u[11] - 0.5) * math.radians(20.0) if u[12] < 0.5 else 0.0,
            "closure": (u[13] - 0.5) * 110.0 if u[12] > 0.4 else 0.0,
        }
        found.append(
            Strike(head, {key: float(value) for key, value in delivery.items()}, float(_between("friction", u[2])))
        )
    return found


def _between(name: str, share: float) -> float:
    """Return a value within the range of the model, at a share of its width."""
    least, most = RANGE[name]
    return least + (most - least) * share


def clubs(count: int, seed: int) -> list[Strike]:
    """Return strikes with the built-in clubs as golfers deliver them, good and bad, with faces of several kinds."""
    return _clubs(_sequence(10, count, seed))


def _clubs(points: NDArray[Any]) -> list[Strike]:
    """Return strikes with the built-in clubs, one after the other, from points of the unit cube."""
    found = []
    for number, u in enumerate(points):
        head = club(CLUBS[number % len(CLUBS)])
        wood = head.kind == "wood"
        rigid, least, more = (0.2, 200e-6, 80e-6) if wood else (0.4, 100e-6, 120e-6)
        head = head.replace(characteristic_time=0.0 if u[8] < rigid else float(least + more * u[9]))
        delivery = {
            "speed": parse(f"{60.0 + (60.0 if wood else 40.0) * u[0]} mph", "speed"),
            "attack": math.radians(-4.0 + 8.0 * u[1] if wood else -7.0 + 7.0 * u[1]),
            "loft": float(head.loft) + math.radians(-6.0 + 8.0 * u[2]),
            "toe": (u[4] - 0.5) * 0.036,
            "high": (u[5] - 0.5) * 0.020,
            "face": math.radians(8.0 * (u[6] - 0.5)),
            "closure": math.radians(3000.0 * u[7]),
        }
        found.append(Strike(head, {key: float(value) for key, value in delivery.items()}, float(0.15 + 0.35 * u[3])))
    return found


def _sequence(dimensions: int, count: int, seed: int) -> NDArray[Any]:
    """Return the first points of a Sobol sequence, which is even where the number is a power of two."""
    from scipy.stats import qmc

    sequence = qmc.Sobol(dimensions, seed=seed)  # pyright: ignore[reportCallIssue]
    return sequence.random_base2((count - 1).bit_length())[:count]


PARTS: dict[str, Part] = {
    "heads": Part(heads, 1024, 101, held_out=False),
    "clubs": Part(clubs, 440, 102, held_out=False, built_in=True),
    "more heads": Part(heads, 1024, 105, held_out=False),
    "heads, held out": Part(heads, 512, 103, held_out=True),
    "clubs, held out": Part(clubs, 220, 104, held_out=True, built_in=True),
    "spinning balls, heads": Part(spinning_heads, 256, 106, held_out=False),
    "spinning balls, clubs": Part(spinning_clubs, 132, 107, held_out=False, built_in=True),
    "spinning balls, heads, held out": Part(spinning_heads, 128, 108, held_out=True),
    "spinning balls, clubs, held out": Part(spinning_clubs, 66, 109, held_out=True, built_in=True),
}
"""The strikes of the coefficients, and those that they were not fitted to, by what they are."""


def strikes(parts: Mapping[str, Part]) -> dict[tuple[int, int], Strike]:
    """Return the strikes of some parts by the numbers of part and strike."""
    with without_warnings():
        return {
            (place, number): strike
            for place, part in enumerate(parts.values())
            for number, strike in enumerate(part.make(part.count, part.seed))
        }
