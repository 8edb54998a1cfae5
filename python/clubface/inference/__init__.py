"""From a measured launch back to the deliveries that could have produced it.

Many deliveries make the same launch, so the answer is a sample of deliveries. :func:`clubface.infer` draws it.
"""

from clubface.inference.file import InferReport as InferReport, infer_shots as infer_shots
from clubface.inference.importance import Sample as Sample
from clubface.inference.posterior import Posterior as Posterior, pairs_picture as pairs_picture
from clubface.inference.prior import Prior as Prior, UnreachableLaunchError as UnreachableLaunchError
from clubface.inference.run import infer as infer

__all__ = [
    "InferReport", "Posterior", "Prior", "Sample", "UnreachableLaunchError", "infer", "infer_shots", "pairs_picture",
]  # fmt: skip
