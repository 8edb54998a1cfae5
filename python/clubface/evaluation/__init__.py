"""How well models predict measured shots: their errors, what the errors depend on, and which model is best."""

from clubface.evaluation.evaluation import Evaluation as Evaluation
from clubface.evaluation.evaluation import evaluate as evaluate
from clubface.evaluation.published_accuracy import PublishedAccuracy as PublishedAccuracy
from clubface.evaluation.published_accuracy import published as published

__all__ = ["Evaluation", "PublishedAccuracy", "evaluate", "published"]
