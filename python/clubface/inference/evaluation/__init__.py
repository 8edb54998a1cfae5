"""How well models predict measured shots: their errors, what the errors depend on, and which model is best."""

from clubface.inference.evaluation.evaluation import Evaluation as Evaluation, evaluate as evaluate
from clubface.inference.evaluation.model_errors import PublishedAccuracy as PublishedAccuracy, published as published
