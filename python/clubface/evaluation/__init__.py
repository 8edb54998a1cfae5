"""How well models predict measured shots: errors beside published ones, where they come from, which model is best."""

from clubface.evaluation.evaluate import Evaluation as Evaluation
from clubface.evaluation.evaluate import evaluate as evaluate
from clubface.evaluation.published import PublishedAccuracy as PublishedAccuracy
from clubface.evaluation.published import published as published

__all__ = ["Evaluation", "PublishedAccuracy", "evaluate", "published"]
