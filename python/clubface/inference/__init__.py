"""From a launch back to the deliveries that can have made it: a sample of all of them, not one."""

from clubface.inference.expectation import UnreachableLaunchError as UnreachableLaunchError
from clubface.inference.posterior import Posterior as Posterior
from clubface.inference.posterior import infer as infer
from clubface.inference.prior import Prior as Prior

__all__ = ["Posterior", "Prior", "UnreachableLaunchError", "infer"]
