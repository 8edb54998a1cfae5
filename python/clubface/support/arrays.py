"""The types of most arrays, and of values as people give them."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
ValueLike = ArrayLike
"""A number [SI], text with a unit such as "108 mph", or an array or list of either."""
