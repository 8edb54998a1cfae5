"""Values that somebody states for what was not measured: ``{"toe": "0 mm"}``."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, TypeVar

import numpy as np

from clubface import units
from clubface.errors import InputError
from clubface.recorded.possible import can_be
from clubface.recorded.shots import RecordedShots
from clubface.simulation.delivery import DIMENSIONS
from clubface.support.checks import check_names

Shots = TypeVar("Shots", bound=RecordedShots)


def with_assumed(shots: Shots, assume: Mapping[str, Any]) -> Shots:
    """Return the shots with stated values where those of a delivery were not measured, and notes that count them.

    Parameters
    ----------
    shots
        The shots.
    assume
        Values by the names of :class:`clubface.Delivery`, as text with units or as SI numbers. What was measured stays.
    """
    check_names("quantity in assume", assume, DIMENSIONS)
    deliveries, notes = dict(shots.deliveries), []
    for name, stated in assume.items():
        value = units.parse(stated, DIMENSIONS[name], name=f"assume {name}")
        if not can_be(name, value):
            raise InputError(f"assume {name}", stated, "a value with its unit that a shot can have")
        measured = deliveries.get(name, np.full(len(shots), np.nan))
        lacking = np.isnan(measured)
        deliveries[name] = np.where(lacking, value, measured)
        shown = stated if _has_unit(stated) else units.show(value, units.SI_UNITS[DIMENSIONS[name]])
        if count := int(lacking.sum()):
            notes.append(
                f"{name} was not measured in {count} of {len(shots)} shots, which take {shown} for it, as stated"
            )
        else:
            notes.append(f"{name} was measured in every shot: the {shown} stated for it is not used")
    return replace(shots, deliveries=deliveries, notes=(*shots.notes, *notes))


def _has_unit(stated: Any) -> bool:
    return isinstance(stated, str) and stated.strip()[-1:] not in "0123456789."
