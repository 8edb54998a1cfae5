"""What motion capture and launch monitor make of the benchmark's true shots."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from clubface.benchmark_data.recipe import Recipe
from clubface.support.arrays import Floats

RATES = {"face": ("closure", -1.0), "loft": ("pitch_rate", 1.0), "lie": ("lie_rate", 1.0)}
"""The rate at which each angle turns, and its sign: a closing face turns to the left."""


def captured(recipe: Recipe, truth: Mapping[str, Floats], random: np.random.Generator) -> dict[str, Floats]:
    """Return the delivery that motion capture gives for the true one, SI.

    The head moves on an arc. Its position and attitude are seen with noise in the last three frames before impact. As
    in Caldwell and McPhee (2023), straight lines through the last two positions, attitudes and velocities give the
    delivery at impact. What the lines miss, because of the arc and of growing rates, is the error of extrapolation.
    """
    shots = truth["speed"].size
    first = recipe.frame * random.random(shots)
    times = np.stack([-first - recipe.frame * number for number in range(3)])
    ahead = first + recipe.time_noise * random.standard_normal(shots)
    position = _arc(recipe, truth, times) + recipe.position_noise * random.standard_normal((3, 3, shots))
    newest, older = np.diff(position[::-1], axis=0)[::-1] / recipe.frame
    velocity = newest + (newest - older) * (ahead / recipe.frame + 0.5)
    at_impact = position[0] + newest * ahead
    found = _direction(velocity)
    for angle, (rate, sign) in RATES.items():
        growth = recipe.growth[rate][0] + recipe.growth[rate][1] * random.standard_normal(shots)
        seen = truth[angle] + sign * (truth[rate] * times + 0.5 * growth * times**2)
        seen = seen + recipe.attitude_noise * random.standard_normal((3, shots))
        slope = (seen[0] - seen[1]) / recipe.frame
        found[angle], found[rate] = seen[0] + slope * ahead, sign * slope
    # A head believed too far to the right or too high puts the ball towards the heel or the sole; the line along which
    # the head travels is left out: the ball touches the face.
    right = at_impact[2] - at_impact[0] * np.tan(truth["path"])
    up = at_impact[1] - at_impact[0] * np.tan(truth["attack"])
    found["toe"] = truth["toe"] - right / np.cos(truth["face"])
    found["high"] = truth["high"] - up / np.cos(truth["loft"])
    return {name: found[name] for name in truth}


def monitored(recipe: Recipe, truth: Mapping[str, Floats], random: np.random.Generator) -> dict[str, Floats]:
    """Return the launch that the monitor shows for the true one, SI."""
    return {name: values + recipe.monitor[name] * random.standard_normal(values.size) for name, values in truth.items()}


def _arc(recipe: Recipe, truth: Mapping[str, Floats], times: Floats) -> Floats:
    """Return the positions [m], shape [times, xyz, shots], of heads that pass the origin at time 0.

    Each turns at constant speed about a centre on the players' side, up the swing plane.
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
    return {
        "speed": speed,
        "attack": np.arcsin(velocity[1] / speed),
        "path": np.arctan2(velocity[2], velocity[0]),
    }
