"""How well models predict measured shots: their errors, what the errors depend on, and which model is best."""

from clubface.inference.evaluation.evaluation import evaluate as evaluate
from clubface.inference.evaluation.published_accuracy import (
    Pair as Pair,
    PublishedAccuracy as PublishedAccuracy,
    contradictions as contradictions,
    pairs as pairs,
    published as published,
)
from clubface.inference.evaluation.result import Evaluation as Evaluation
from clubface.inference.evaluation.statistics import (
    Best as Best,
    ErrorSize as ErrorSize,
    Rival as Rival,
    Trend as Trend,
)

__all__ = [
    "Best", "ErrorSize", "Evaluation", "Pair", "PublishedAccuracy", "Rival", "Trend", "contradictions", "evaluate",
    "pairs", "published",
]  # fmt: skip
