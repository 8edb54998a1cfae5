"""What truly happens at impact in the benchmark: a mixture of models, and effects none of the fitted models has."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from clubface.benchmark_data.recipe import Recipe
from clubface.equipment.balls import published_ball
from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.parameters import ParameterSet
from clubface.simulation.impact import impact
from clubface.support.arrays import Floats

LAUNCH = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")


def with_shaft(recipe: Recipe) -> Club:
    """Return the club with the tip of its shaft: a point of mass that moves with the head.

    Mass, CG and inertia are those of both together; the delivery is that of their common CG.
    """
    head = club_named(recipe.head)
    added, place = recipe.shaft_mass, recipe.hosel
    total = head.mass + added
    shift = place * added / total
    reduced = head.mass * added / total
    inertia = reduced * (np.dot(place, place) * np.eye(3) - np.outer(place, place))
    return head.replace(
        mass=total,
        cg_x=head.cg_x - float(shift[0]),
        cg_y=head.cg_y - float(shift[1]),
        cg_z=head.cg_z - float(shift[2]),
        **{
            f"i{a}{b}": getattr(head, f"i{a}{b}") + float(inertia["xyz".index(a), "xyz".index(b)])
            for a, b in ("xx", "yy", "zz", "xy", "xz", "yz")
        },
    )


def restitution_offsets(recipe: Recipe, delivery: Mapping[str, Floats], scatter: Floats | float) -> Floats:
    """Return by how much restitution differs from that at the face centre: the ball, and the place on the face."""
    distance = np.hypot(delivery["toe"], delivery["high"]) / recipe.flex_radius
    return scatter - recipe.flex_drop * distance**2


def launches(recipe: Recipe, name: str, delivery: Mapping[str, Floats], offsets: Floats | float) -> dict[str, Floats]:
    """Return the launches by model ``name`` with the parameters of the mixture; ``offsets`` change its restitution."""
    parameters = true_parameters(recipe, name, delivery, offsets)
    found = impact(with_shaft(recipe), model=name, parameters=parameters, delivery=delivery, ball=published_ball())
    return {quantity: np.asarray(getattr(found, quantity)) for quantity in LAUNCH}


def true_parameters(recipe: Recipe, name: str, delivery: Mapping[str, Floats], offsets: Floats | float) -> ParameterSet:
    """Return the parameters of model ``name``, an array where they vary from shot to shot."""
    part = recipe.mixture[name]
    published = ParameterSet.builtin(name, club_named(recipe.head).parameters)
    changes: dict[str, Any] = dict(part.changed)
    if "cor" in published.values:
        changes["cor_slope"] = recipe.restitution_slope
        changes["cor"] = part.restitution - recipe.restitution_slope * recipe.restitution_at + offsets
    else:
        speed = normal_speed(delivery)
        restitution = part.restitution + recipe.restitution_slope * (speed - recipe.restitution_at) + offsets
        changes["damping"] = damping_of(restitution, speed)
    return published.replace(**changes)


def normal_speed(delivery: Mapping[str, Floats]) -> Floats:
    """Return the speed of the head along the face normal [m/s], at the face centre and without rotation."""
    return (
        delivery["speed"] * np.cos(delivery["loft"] - delivery["attack"]) * np.cos(delivery["face"] - delivery["path"])
    )


def damping_of(restitution: Floats, speed: Floats) -> Floats:
    """Return the Hunt-Crossley damping [s/m] that gives ``restitution`` at a normal speed [m/s].

    With a = d v, energy of F = k x^n (1 + d dx/dt) gives ln((1 + a) / (1 - a e)) = a (1 + e) for any n; by bisection.
    """
    low, high = np.zeros_like(restitution), np.full_like(restitution, 1.0)
    for _ in range(60):
        a = 0.5 * (low + high)
        less = a * (1.0 + restitution) > np.log((1.0 + a) / (1.0 - a * restitution))
        low, high = np.where(less, a, low), np.where(less, high, a)
    return 0.5 * (low + high) / speed
