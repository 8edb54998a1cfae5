"""Reproduces the benchmark shots bit for bit: ``python -m clubface.validation.benchmark_recipe``.

Players with habits deliver clubheads; a mixture of models, with effects that no fitted model has, gives the launches;
motion capture and a launch monitor measure them with errors.
"""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.balls import published_ball
from clubface.equipment.clubs import Club, club as club_named
from clubface.equipment.parameters import ParameterSet
from clubface.shots.tables.headings import heading_of
from clubface.shots.tables.parquet import pyarrow_for
from clubface.simulation.impact import impact
from clubface.simulation.results import inputs, outputs
from clubface.support.arrays import Floats
from clubface.support.files import whole_file
from clubface.validation.benchmark_data import CLUBS, FOLDER, Recipe, recipe

LAUNCH = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")


def with_shaft(recipe: Recipe) -> Club:
    """Return the club with the tip of the shaft as a point mass that moves with the head.

    Mass, CG and inertia are for both together; the delivery refers to their common CG.
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
    """Return the change in restitution from the face centre, by scatter of the ball and impact location."""
    distance = np.hypot(delivery["toe"], delivery["high"]) / recipe.flex_radius
    return scatter - recipe.flex_drop * distance**2


def launches(recipe: Recipe, name: str, delivery: Mapping[str, Floats], offsets: Floats | float) -> dict[str, Floats]:
    """Return the launches by model ``name`` with the parameters of the mixture; ``offsets`` change its restitution."""
    parameters = true_parameters(recipe, name, delivery, offsets)
    result = impact(with_shaft(recipe), model=name, parameters=parameters, delivery=delivery, ball=published_ball())
    return {quantity: np.asarray(getattr(result, quantity)) for quantity in LAUNCH}


def true_parameters(recipe: Recipe, name: str, delivery: Mapping[str, Floats], offsets: Floats | float) -> ParameterSet:
    """Return the parameters of model ``name``, as arrays if they vary from shot to shot."""
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
    """Return the head speed along the face normal [m/s], at the face centre and without rotation."""
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


RATES = {"face": ("closure", -1.0), "loft": ("pitch_rate", 1.0), "lie": ("lie_rate", 1.0)}
"""Rotation rate of each angle, and its sign: a closing face turns to the left."""


def captured(recipe: Recipe, truth: Mapping[str, Floats], random: np.random.Generator) -> dict[str, Floats]:
    """Return the delivery as measured by motion capture, from the true one [SI].

    The head moves on an arc. Its position and attitude are measured with noise in the last three frames before impact.
    As in Caldwell and McPhee (2023), linear extrapolation of the last two positions, attitudes and velocities gives the
    delivery at impact; the arc and increasing rates cause the extrapolation error.
    """
    shots = truth["speed"].size
    first = recipe.frame * random.random(shots)
    times = np.stack([-first - recipe.frame * number for number in range(3)])
    ahead = first + recipe.time_noise * random.standard_normal(shots)
    position = _arc(recipe, truth, times) + recipe.position_noise * random.standard_normal((3, 3, shots))
    newest, older = np.diff(position[::-1], axis=0)[::-1] / recipe.frame
    velocity = newest + (newest - older) * (ahead / recipe.frame + 0.5)
    at_impact = position[0] + newest * ahead
    result = _direction(velocity)
    for angle, (rate, sign) in RATES.items():
        growth = recipe.growth[rate][0] + recipe.growth[rate][1] * random.standard_normal(shots)
        seen = truth[angle] + sign * (truth[rate] * times + 0.5 * growth * times**2)
        seen = seen + recipe.attitude_noise * random.standard_normal((3, shots))
        slope = (seen[0] - seen[1]) / recipe.frame
        result[angle], result[rate] = seen[0] + slope * ahead, sign * slope
    # A head measured too far right or too high shifts the impact point towards the heel or the sole. The component
    # along the path does not matter, since the ball touches the face.
    right = at_impact[2] - at_impact[0] * np.tan(truth["path"])
    up = at_impact[1] - at_impact[0] * np.tan(truth["attack"])
    result["toe"] = truth["toe"] - right / np.cos(truth["face"])
    result["high"] = truth["high"] - up / np.cos(truth["loft"])
    return {name: result[name] for name in truth}


def monitored(recipe: Recipe, truth: Mapping[str, Floats], random: np.random.Generator) -> dict[str, Floats]:
    """Return the launch as measured by the monitor, from the true one [SI]."""
    return {name: values + recipe.monitor[name] * random.standard_normal(values.size) for name, values in truth.items()}


def _arc(recipe: Recipe, truth: Mapping[str, Floats], times: Floats) -> Floats:
    """Return the positions [m], shape [times, xyz, shots], of heads that pass the origin at time 0.

    Each moves at constant speed around a centre on the player's side, up the swing plane.
    """
    attack, path = truth["attack"], truth["path"]
    along = np.stack([np.cos(attack) * np.cos(path), np.sin(attack), np.cos(attack) * np.sin(path)])
    up_the_plane = np.array([0.0, np.sin(recipe.swing_plane), -np.cos(recipe.swing_plane)])[:, None]
    inward = up_the_plane - along * (along * up_the_plane).sum(axis=0)
    inward = inward / np.linalg.norm(inward, axis=0)
    angle = (truth["speed"] * times / recipe.arc_radius)[:, None, :]
    return recipe.arc_radius * (np.sin(angle) * along + (1.0 - np.cos(angle)) * inward)


def _direction(velocity: Floats) -> dict[str, Floats]:
    speed = np.linalg.norm(velocity, axis=0)
    return {"speed": speed, "attack": np.arcsin(velocity[1] / speed), "path": np.arctan2(velocity[2], velocity[0])}


def players_of(recipe: Recipe) -> NDArray[np.int64]:
    """Return the player (from 0) of each shot; the first players have one more shot."""
    return np.sort(np.arange(recipe.shots) % recipe.players)


def deliveries(recipe: Recipe, random: np.random.Generator) -> dict[str, Floats]:
    """Return the true delivery of every shot [SI].

    Every quantity is normally distributed over players and over each player's shots, and may be correlated with
    another. Speeds outside the range are drawn again.
    """
    player = players_of(recipe)
    habits = _standard(recipe, random, recipe.players)
    deviations = _standard(recipe, random, recipe.shots)
    result = {}
    for name, spread in recipe.delivery.items():
        result[name] = spread.mean + spread.between * habits[name][player] + spread.within * deviations[name]
    speed, spread = result["speed"], recipe.delivery["speed"]
    both = float(np.hypot(spread.between, spread.within))
    while (outside := (speed < recipe.slowest) | (speed > recipe.fastest)).any():
        speed[outside] = spread.mean + both * random.standard_normal(int(outside.sum()))
    return result


def _standard(recipe: Recipe, random: np.random.Generator, count: int) -> dict[str, Floats]:
    """Return standard normal deviates of each quantity, with correlations."""
    plain = {name: _standardised(random.standard_normal(count)) for name in recipe.delivery}
    result = dict(plain)
    for name, (leader, correlation) in recipe.follows.items():
        result[name] = _standardised(correlation * plain[leader] + np.sqrt(1.0 - correlation**2) * plain[name])
    return result


def _standardised(values: Floats) -> Floats:
    """Return ``values`` scaled to mean 0 and standard deviation 1, so that a small sample has the recipe's spread."""
    return (values - values.mean()) / values.std()


CAPTURE_DIGITS = {"mm": 1, "deg/s": 0}
"""Decimals of measured delivery quantities by unit; 2 for speed and angles."""
MONITOR_DIGITS = {"rpm": 0}
"""Decimals of measured launch quantities by unit; 1 for speed and angles, as on monitors."""
TRUE_DIGITS = 5
"""Decimals of true values, so that the files are identical on every machine."""


class Made(NamedTuple):
    """The shots of one club, in SI units, one element per shot."""

    player: NDArray[np.int64]  # number from 1
    model: NDArray[Any]  # behind the launch
    restitution: Floats  # added to the model's, for scatter of the ball and impact location
    true_delivery: dict[str, Floats]
    true_launch: dict[str, Floats]
    delivery: dict[str, Floats]  # measured, as the launch
    launch: dict[str, Floats]


def make(plan: Recipe) -> Made:
    """Return the shots of one club."""
    random = np.random.default_rng(plan.seed)
    player = players_of(plan) + 1
    truth = _rounded(deliveries(plan, random), {}, TRUE_DIGITS)
    names = list(plan.mixture)
    model = np.array(names, dtype=object)[(random.random(plan.shots) * len(names)).astype(int)]
    scatter = plan.ball_scatter * random.standard_normal(plan.shots)
    restitution = np.round(restitution_offsets(plan, truth, scatter), 9)
    launch = {name: np.empty(plan.shots) for name in LAUNCH}
    for name in names:
        own = model == name
        result = launches(plan, name, {key: each[own] for key, each in truth.items()}, restitution[own])
        for key, values in result.items():
            launch[key][own] = values
    launch = _rounded(launch, {}, TRUE_DIGITS)
    delivery = _rounded(captured(plan, truth, random), CAPTURE_DIGITS, 2)
    seen = _rounded(monitored(plan, launch, random), MONITOR_DIGITS, 1)
    return Made(player, model, restitution, truth, launch, delivery, seen)


def tables(plan: Recipe) -> dict[str, dict[str, Any]]:
    """Return the columns of the two files of one club, by file name."""
    made = make(plan)
    first: dict[str, Any] = {"club": [plan.head] * plan.shots, "player": made.player}
    kept = {"model": made.model.tolist(), "restitution_offset": made.restitution}
    return {
        f"{plan.club}.parquet": first | _columns(made.delivery | made.launch),
        f"{plan.club}-truth.parquet": first | kept | _columns(made.true_delivery | made.true_launch),
    }


def write(folder: Path = FOLDER) -> list[Path]:
    """Write the files of all clubs and return their paths."""
    files = []
    for club in CLUBS:
        for name, columns in tables(recipe(club)).items():
            path = folder / name
            arrow = pyarrow_for(path)
            with whole_file(path) as file:
                arrow.parquet.write_table(arrow.table(columns), file, compression="zstd")
            files.append(path)
    return files


def _unit(name: str) -> tuple[str, str]:
    """Return heading and unit of a quantity's column."""
    return heading_of(name, (inputs()[name] if name in inputs() else outputs()[name]).unit)


def _rounded(values: dict[str, Floats], digits: dict[str, int], otherwise: int) -> dict[str, Floats]:
    """Return SI values after rounding in the unit of their column, as they are read back."""
    result = {}
    for name, each in values.items():
        shown = _unit(name)[1]
        cells = np.round(units.from_si(each, shown), digits.get(shown, otherwise)) + 0.0  # no negative zero
        result[name] = units.to_si(cells, shown)
    return result


def _columns(values: dict[str, Floats]) -> dict[str, Floats]:
    """Return columns in the units of their headings, rounded to remove conversion errors."""
    return {_unit(name)[0]: np.round(units.from_si(each, _unit(name)[1]), 9) for name, each in values.items()}


if __name__ == "__main__":
    for file in write(Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER):
        print(f"{file}: {file.stat().st_size} bytes")
