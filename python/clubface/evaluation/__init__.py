"""How well models predict measured shots: errors beside published ones, where they come from, which model is best."""

from clubface.evaluation.evaluation import Evaluation as Evaluation
from clubface.evaluation.evaluation import evaluate as evaluate
from clubface.evaluation.published_accuracy import PublishedAccuracy as PublishedAccuracy
from clubface.evaluation.published_accuracy import published as published

__all__ = ["Evaluation", "PublishedAccuracy", "evaluate", "published"]
