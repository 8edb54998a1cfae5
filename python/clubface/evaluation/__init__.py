"""How well models predict measured shots: their errors, what the errors depend on, and which model is best."""

from clubface.evaluation.evaluation import Evaluation as Evaluation, evaluate as evaluate
from clubface.evaluation.published_accuracy import PublishedAccuracy as PublishedAccuracy, published as published
