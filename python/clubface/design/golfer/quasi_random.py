"""Quasi-random numbers, of which each is a function of its index."""

from __future__ import annotations

from typing import Any

import numpy as np

from clubface.support.arrays import Floats
from clubface.support.checks import MOST_SEED, check_count
from clubface.support.memory import check_request

MOST_SHOTS = 2**32
BITS = 32
"""Binary digits of the quasi-random numbers: as many as scipy can skip."""


def uniform(dimensions: int, count: int, *, seed: int = 0, start: int = 0) -> Floats:
    """Return points ``start`` to ``start + count`` of a scrambled Sobol sequence, shape (count, dimensions).

    Numbers lie strictly between 0 and 1. Point i depends on seed, number of dimensions and i alone.
    """
    from scipy.stats import qmc

    count = check_count("count", count, 1, MOST_SHOTS)
    start = check_count("start", start, 0, MOST_SHOTS - count)
    seed = check_count("seed", seed, 0, MOST_SEED)
    check_request(count, 4 * 8 * dimensions)  # the points, and what is made of them
    engine = qmc.Sobol(dimensions, scramble=True, bits=BITS, rng=np.random.default_rng(seed))
    if start:
        engine.fast_forward(start)
    # The middle of the cell that a point names, since its corner may be 0, whose normal deviate is infinite.
    return _points(engine, count) + 0.5 ** (BITS + 1)


def _points(engine: Any, count: int) -> Floats:
    import warnings

    with warnings.catch_warnings():
        # Its balance is that of a power of two; what is asked for here is any part of the sequence.
        warnings.simplefilter("ignore", UserWarning)
        return engine.random(count)
