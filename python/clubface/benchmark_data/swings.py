"""How the clubheads of the benchmark truly arrive: players with habits, and shots around them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from clubface.benchmark_data.recipe import Recipe
from clubface.support.arrays import Floats


def players_of(recipe: Recipe) -> NDArray[np.int64]:
    """Return the number of the player (from 0) of each shot; the first players have one shot more."""
    return np.sort(np.arange(recipe.shots) % recipe.players)


def deliveries(recipe: Recipe, random: np.random.Generator) -> dict[str, Floats]:
    """Return the true delivery of every shot, SI.

    Every quantity is normal over players and over the shots of a player, in a quantity that follows another partly
    driven by that one. Speeds outside the range are drawn again.
    """
    player = players_of(recipe)
    habits = _standard(recipe, random, recipe.players)
    deviations = _standard(recipe, random, recipe.shots)
    found = {}
    for name, spread in recipe.delivery.items():
        found[name] = spread.mean + spread.between * habits[name][player] + spread.within * deviations[name]
    speed, spread = found["speed"], recipe.delivery["speed"]
    both = float(np.hypot(spread.between, spread.within))
    while (outside := (speed < recipe.slowest) | (speed > recipe.fastest)).any():
        speed[outside] = spread.mean + both * random.standard_normal(int(outside.sum()))
    return found


def _standard(recipe: Recipe, random: np.random.Generator, count: int) -> dict[str, Floats]:
    """Return standard normal deviates of each quantity, correlated where one follows another."""
    plain = {name: _standardised(random.standard_normal(count)) for name in recipe.delivery}
    found = dict(plain)
    for name, (leader, correlation) in recipe.follows.items():
        found[name] = _standardised(correlation * plain[leader] + np.sqrt(1.0 - correlation**2) * plain[name])
    return found


def _standardised(values: Floats) -> Floats:
    """Return ``values`` with mean 0 and standard deviation 1, so that a small sample has the spread of the recipe."""
    return (values - values.mean()) / values.std()
