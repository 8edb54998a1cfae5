"""From a measured launch back to the deliveries that can have made it.

Many deliveries make the same launch, so the answer is a sample of deliveries. :func:`clubface.infer` draws it.
"""

from clubface.inference.posterior import Posterior as Posterior
from clubface.inference.prior import Prior as Prior, UnreachableLaunchError as UnreachableLaunchError
from clubface.inference.run import infer as infer
