"""What studies of golfers have in common: the figures of a golfer and of a hole that may be swept."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from clubface.design.golfer.golfer import Golfer
from clubface.design.strokes import Hole
from clubface.errors import InputError
from clubface.simulation.delivery import OF_CLUB
from clubface.simulation.quantities import inputs
from clubface.studies.axes import Swept

HOLE = ("length", "fairway", "rough", "green")


def swept_golfers() -> dict[str, Swept]:
    """Return what of golfers and holes may be swept: means and spreads of their deliveries, mishits, and lengths."""
    found = {f"{part}_{name}": Swept(inputs()[name].unit) for part in ("mean", "spread") for name in OF_CLUB}
    found |= {name: Swept("1") for name in ("spread_factor", "mishit_share", "mishit_scale")}
    return found | {f"hole_{name}": Swept("m") for name in HOLE} | {"golfer": Swept(None)}


def changed_golfer(of: Golfer, task: Mapping[str, Any]) -> Golfer:
    """Return a golfer with the figures that a task sweeps; correlations stay.

    Raises
    ------
    InputError
        The golfer does not vary what is swept, or a figure is out of its range.
    """
    mean, spread = np.array(of.mean), np.array(of.spread)
    for place, name in enumerate(of.variables):
        mean[place] = task.get(f"mean_{name}", mean[place])
        spread[place] = task.get(f"spread_{name}", spread[place])
    for name in task:
        part, _, variable = name.partition("_")
        if part in ("mean", "spread") and variable in OF_CLUB and variable not in of.variables:
            raise InputError(name, task[name], f"left out, since {variable} is not among the variables of {of.name}")
    spread = spread * task.get("spread_factor", 1.0)
    if (spread < 0.0).any():
        raise InputError("spread", float(spread.min()), "at least 0")
    correlation = np.array(of.correlation)
    np.fill_diagonal(correlation, 1.0)
    mishits = {name: task[name] for name in ("mishit_share", "mishit_scale") if name in task}
    if not mishits and (spread == of.spread).all() and (mean == of.mean).all():
        return of
    # What is not swept keeps its bits.
    same = (spread == of.spread)[:, None] & (spread == of.spread)
    covariance = np.where(same, of.covariance, correlation * np.outer(spread, spread))
    return of.replace(mean=mean, covariance=covariance, **mishits)


def changed_hole(hole: Hole | None, task: Mapping[str, Any]) -> Hole | None:
    """Return a hole with the lengths that a task sweeps; a swept length alone makes one."""
    changes = {name: task[f"hole_{name}"] for name in HOLE if f"hole_{name}" in task}
    if not changes:
        return hole
    if hole is None and "length" not in changes:
        raise InputError("hole_length", None, 'sweep it, or give hole = { length = "400 yd" }')
    return Hole(**changes) if hole is None else replace(hole, **changes)
