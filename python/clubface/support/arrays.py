"""The type of most arrays."""

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
