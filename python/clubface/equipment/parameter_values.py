"""Values of parameters: texts with units to SI, and their bounds."""

from __future__ import annotations

from typing import Any

from clubface import units
from clubface.equipment.models import Parameter
from clubface.errors import InputError


def _dimension(parameter: Parameter) -> str:
    return units.unit(parameter.unit, name=parameter.name).dimension


def parsed(value: Any, parameter: Parameter) -> Any:
    """Return a value, which may be an array, in SI."""
    return units.parse_values(value, _dimension(parameter), name=parameter.name)


def parsed_scalar(value: Any, parameter: Parameter) -> float:
    """Return a single value in SI."""
    return units.parse(value, _dimension(parameter), name=parameter.name)


def checked(value: Any, parameter: Parameter) -> Any:
    """Return ``value`` as float or float64 array, refused where it is outside the bounds of ``parameter``."""
    value = parsed(value, parameter)
    low = value if isinstance(value, float) else value.min(initial=parameter.upper)
    high = value if isinstance(value, float) else value.max(initial=parameter.lower)
    if not (low >= parameter.lower and high <= parameter.upper):
        outside = low if not low >= parameter.lower else high
        symbol = parameter.unit
        allowed = f"from {units.show(parameter.lower, symbol)} to {units.show(parameter.upper, symbol)}"
        raise InputError(parameter.name, units.show(float(outside), symbol), allowed)
    return value
