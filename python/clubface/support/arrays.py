"""Types of common arrays and of user-facing values."""

from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Selection = slice | Sequence[int] | Sequence[bool] | NDArray[np.integer | np.bool_]
"""A NumPy selection: a slice, indices or a mask."""
ValueLike = ArrayLike
"""A number [SI], text with a unit such as "108 mph", or an array or list of either."""
NumberOrArray: TypeAlias = Any
"""A number for a single shot, or an array of the shape of a batch.

The values of a call, not their types, decide which it is, so that a type checker accepts both. A union would require a
check before every use of a result, which the typing guide advises against:
https://typing.python.org/en/latest/guides/writing_stubs.html#the-any-trick
"""


def flat(value: NumberOrArray, shape: tuple[int, ...]) -> NumberOrArray:
    """Return a column for the core: an array broadcast to the shape of the batch, flat, or a number as it is."""
    return value if isinstance(value, float) else np.ascontiguousarray(np.broadcast_to(value, shape)).reshape(-1)
