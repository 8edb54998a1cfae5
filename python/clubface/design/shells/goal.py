"""What is best for a design, and within which limits: the measure by which two designs are compared."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from clubface.support.arrays import Floats

Values = dict[str, float]
"""The quantities of a design by name, all positive."""
PENALTY = 10.0
"""Weight of the largest relative violation against the relative change of the objective. No limit of a head is worth
more to its objective: 1% of characteristic time is worth 0.1% of ball speed."""


@dataclass(frozen=True, kw_only=True)
class Goal:
    """What is best, and within which limits.

    Attributes
    ----------
    objective
        Name of a quantity.
    largest
        Whether it shall be large; otherwise small.
    limits
        The least and the greatest value of quantities, by name; 0 and infinity where there is none.
    """

    objective: str
    largest: bool
    limits: Mapping[str, tuple[float, float]]

    def cost(self, values: Values) -> float:
        """Return the logarithm of the objective, or minus it if it shall be large: smaller is better."""
        return (-1.0 if self.largest else 1.0) * math.log(values[self.objective])

    def excess(self, values: Values) -> Floats:
        """Return by how much every limit is broken, relatively; negative where it is kept."""
        result = []
        for name, (least, most) in self.limits.items():
            if least > 0.0:
                result.append(math.log(least / values[name]))
            if most < math.inf:
                result.append(math.log(values[name] / most))
        return np.array(result)

    def violation(self, values: Values) -> float:
        """Return the largest relative excess over a limit; 0 within all, infinity for a design that failed."""
        if not all(math.isfinite(value) for value in values.values()):
            return math.inf
        return max(0.0, *self.excess(values)) if self.limits else 0.0

    def merit(self, values: Values) -> float:
        """Return cost and weighted violation."""
        violation = self.violation(values)
        return self.cost(values) + PENALTY * violation if violation < math.inf else math.inf

    def better(self, one: Values, other: Values) -> bool:
        """Tell whether ``one`` is the better design: first within limits, then by the objective."""
        if self.violation(other) == 0.0:
            return self.violation(one) == 0.0 and self.cost(one) < self.cost(other)
        return self.violation(one) == 0.0 or self.merit(one) < self.merit(other)
