"""P1's global search: a genetic algorithm over the unit cube, a whole generation evaluated at once."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

POPULATION, GENERATIONS, REFINED = 200, 100, 5
"""Of P1 section 2.3."""


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
    points: NDArray[np.float64]
    costs: NDArray[np.float64]

    def best(self, count: int) -> NDArray[np.float64]:
        """Return the ``count`` best points, best first, shape (count, free)."""
        return self.points[np.argsort(self.costs, kind="stable")[:count]]


def search(
    costs_of: Callable[[NDArray[np.float64]], NDArray[np.float64]],
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
    from pymoo.algorithms.soo.nonconvex.ga import GA
    from pymoo.core.evaluator import Evaluator
    from pymoo.core.population import Population as Individuals
    from pymoo.core.problem import Problem
    from pymoo.problems.static import StaticProblem

    cube = Problem(n_var=free, n_obj=1, xl=0.0, xu=1.0)

    def evaluated(individuals: Individuals, costs: NDArray[np.float64]) -> Individuals:
        Evaluator().eval(StaticProblem(cube, F=costs[:, None]), individuals)
        return individuals

    algorithm = GA(pop_size=population)
    algorithm.setup(cube, termination=("n_gen", generations + 1), seed=seed, verbose=False)
    done = begun.generation if begun else 0
    if begun is not None:
        algorithm.pop = evaluated(Individuals.new("X", begun.points), begun.costs)
        algorithm.n_iter, algorithm.is_initialized = done + 1, True
    survivors = begun
    for generation in range(done, generations):
        algorithm.random_state = np.random.default_rng((seed, generation))
        offspring = algorithm.ask()
        if offspring is None:  # every child is a copy of a parent: the population has collapsed
            break
        algorithm.tell(infills=evaluated(offspring, costs_of(np.asarray(offspring.get("X")))))
        assert algorithm.pop is not None
        points, costs = np.asarray(algorithm.pop.get("X")), np.asarray(algorithm.pop.get("F"))
        survivors = Population(generation + 1, points, costs[:, 0])
        if after_generation is not None:
            after_generation(survivors)
    assert survivors is not None
    return survivors
