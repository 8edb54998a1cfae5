"""Numbers of optima and fittings as tables and sentences have them."""

from __future__ import annotations

import math
import re

from clubface import units
from clubface.design.optimisation.objectives import Objective

HEADS = {"side_spread": "side ±", "ellipse": "90% ellipse"}
"""What stands over columns of objectives whose names are no words."""
CERTAIN = 2.0
"""Standard errors beyond which a difference is called one."""


def number(value: float | None, unit: str) -> str:
    """Return a number of a unit, nothing for None."""
    return "" if value is None else f"{units.from_si(value, unit):.4g}"


def at_an_end(value: float | None, limits: tuple[float, float]) -> bool:
    """Return whether a value is at an end of its limits."""
    low, high = limits
    return value is not None and min(value - low, high - value) < 1e-3 * (high - low)


def short(allowed: str) -> str:
    """Return what a limit allows, such that the table fits a terminal: "≤ 20 yd", "8 to 14 deg"."""
    text = allowed.replace("at most", "≤").replace("at least", "≥")
    return re.sub(r"(\S+) (\S+) to (\S+ \2)$", r"\1 to \3", text)


def heading(judge: Objective) -> str:
    """Return what stands over a column of an objective."""
    name = HEADS.get(judge.name, judge.name)
    return name if judge.unit == "1" else f"{name}\n({judge.unit})"


def written(value: float, judge: Objective) -> str:
    """Return what an objective says, in its unit."""
    digits = 4 if judge.unit == "1" else 0 if judge.unit == "m2" else 2
    return f"{units.from_si(value, judge.unit):.{digits}f}"


def written_error(value: float, judge: Objective) -> str:
    """Return the error of that; ? where it is not known."""
    return "?" if math.isnan(value) else written(value, judge)


def signed(value: float, judge: Objective) -> str:
    """Return a difference with its sign."""
    text = written(value, judge)
    return text if text.startswith("-") else f"+{text}"
