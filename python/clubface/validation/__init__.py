"""Validation: models compared with published measurements of shots, plates and heads.

Each check compares published figures with those computed for the published conditions, with built-in clubs and one
ball. Each tolerance states how close is good enough, and why. Published averages are given as intervals that cover what
they leave open.
"""

from clubface.validation.check import Check, Figure
from clubface.validation.run import Validation, validate

__all__ = ["Check", "Figure", "Validation", "validate"]
