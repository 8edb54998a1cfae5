"""Global search: a genetic algorithm over the unit cube that evaluates a whole generation in one batch."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from clubface.support.arrays import Floats

POPULATION, GENERATIONS, REFINED = 200, 100, 5
"""Those of Caldwell and McPhee (2023), section 2.3."""


class Population(NamedTuple):
    """The survivors of a generation.

    Attributes
    ----------
    generation
        Generations done, the random one included.
    points
        In the unit cube, shape (population, free), in the order the algorithm keeps them.
    costs
        Shape (population,).
    """

    generation: int
    points: Floats
    costs: Floats

    def best(self, count: int) -> Floats:
        """Return the ``count`` best points, best first, shape (count, free)."""
        return self.points[np.argsort(self.costs, kind="stable")[:count]]


def search(
    costs_of: Callable[[Floats], Floats],
    free: int,
    *,
    population: int = POPULATION,
    generations: int = GENERATIONS,
    seed: int = 1,
    begun: Population | None = None,
    after_generation: Callable[[Population], object] | None = None,
) -> Population:
    """Search the unit cube by pymoo's genetic algorithm: tournament, simulated binary crossover, polynomial mutation.

    The random numbers of a generation depend on ``seed`` and its number alone, so a search goes on from the population
    ``begun`` as if it had never stopped.

    Parameters
    ----------
    costs_of
        From points of shape (n, free) to their costs, shape (n,).
    free
        Dimensions of the cube.
    population, generations
        Size and number of generations, the random first one included.
    seed
        Of the random numbers.
    begun
        Where an earlier search stopped.
    after_generation
        Called with the survivors of every generation.
    """
    from pymoo.algorithms.soo.nonconvex.ga import GA, FitnessSurvival
    from pymoo.core.population import Population as Individuals
    from pymoo.core.problem import Problem

    cube = Problem(n_var=free, n_obj=1, xl=0.0, xu=1.0)
    algorithm = GA(pop_size=population)
    individuals = None if begun is None else Individuals.new(X=begun.points, F=begun.costs[:, None])
    survivors = begun
    for generation in range(begun.generation if begun else 0, generations):
        generator = np.random.default_rng((seed, generation))
        if individuals is None:
            individuals = algorithm.initialization.do(cube, population, random_state=generator)
            individuals.set("F", costs_of(_array(individuals, "X"))[:, None])
        else:
            children = algorithm.mating.do(cube, individuals, population, random_state=generator)
            if not len(children):  # every child is a copy of a parent: the population has collapsed
                break
            children.set("F", costs_of(_array(children, "X"))[:, None])
            together = Individuals.merge(individuals, children)
            individuals = FitnessSurvival().do(cube, together, n_survive=population)
        survivors = Population(generation + 1, _array(individuals, "X"), _array(individuals, "F")[:, 0])
        if after_generation is not None:
            after_generation(survivors)
    assert survivors is not None
    return survivors


def _array(individuals: Any, name: str) -> Floats:
    return np.asarray(individuals.get(name), dtype=np.float64)
