"""Validation: what a model makes of published deliveries, plates and heads, compared with what was published of them.

Each check compares published figures with the same figures computed from the published conditions, with built-in clubs
and one ball. A tolerance says how close is good enough, and why. Averages are intervals of what they leave open.
"""

from clubface.validation.check import Check, Figure
from clubface.validation.run import Validation, validate

__all__ = [
    "Check",
    "Figure",
    "Validation",
    "validate",
]
