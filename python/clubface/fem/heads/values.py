"""The tables of numbers that describe a head."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.support.checks import check_names


def parsed(
    table: str,
    values: Mapping[str, Any],
    known: Sequence[str],
    required: Sequence[str],
    dimension: Callable[[str], str],
) -> dict[str, float]:
    """Return the values of a table [SI]; errors call them by table and key, such as "thickness.crown".

    Parameters
    ----------
    table
        Its name.
    values
        Text with units or SI, by key.
    known, required
        Keys that it may have, and those that it must.
    dimension
        That of a key, as of :mod:`clubface.units`.
    """
    check_names(f"value of {table}", values, known)
    for key in required:
        if key not in values:
            raise InputError(f"{table}.{key}", None, "give it with its unit")
    return {key: units.parse(value, dimension(key), name=f"{table}.{key}") for key, value in values.items()}
