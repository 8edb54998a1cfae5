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
"""A number of a single shot, an array of the shape of the batch of many.

Which of both it is follows from the values of a call and not from their types, so that a type checker takes it as
either. A union would ask for a check before every use of a result, which the guide to typing advises against:
https://typing.python.org/en/latest/guides/writing_stubs.html#the-any-trick
"""
