"""Exports the inputs of a shot, in the order of the C interface, as a table that is easy to read in any language."""

from __future__ import annotations

import os
from collections.abc import Mapping

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL, reduced_model
from clubface.simulation.impact import Parameters
from clubface.simulation.inputs import HandLike, equipped, shots
from clubface.simulation.results import inputs
from clubface.support.arrays import ValueLike


def inputs_csv(
    club: str | os.PathLike[str] | Club,
    delivery: Mapping[str, ValueLike],
    *,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    hand: HandLike | None = None,
) -> str:
    """Return a table with the columns ``kind``, ``name``, ``value`` and ``unit``.

    Rows of the kind ``input`` come first, the inputs of ``clubface_launches`` in their order, SI; then follow rows of
    the kind ``parameter``, the parameters of the model. Numbers keep all digits.

    Parameters
    ----------
    club, model, parameters, ball, hand
        As for :func:`clubface.impact`.
    delivery
        Values by name, SI or text with a unit; the speed is required.

    Raises
    ------
    InputError
        A value is missing, unknown or not allowed.
    """
    described = reduced_model(model, "one of the C interface")
    setup, chosen = equipped(model, club, ball, parameters)
    values = shots(setup, delivery, hand=hand).columns
    numbers = zip(
        ("input",) * len(values) + ("parameter",) * len(chosen.values),
        (*inputs().values(), *described.parameters),
        (*values, *chosen.columns()),
        strict=True,
    )
    rows = [f"{kind},{each.name},{float(value)!r},{each.unit}\n" for kind, each, value in numbers]
    return "".join(["kind,name,value,unit\n", *rows])
