"""Numbers that programs write where nothing was measured, and what follows from face angle, path and face to path."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from clubface.launch_monitor.cells import FACE_TO_PATH
from clubface.recorded.possible import can_be
from clubface.recorded.wrong_units import Unit
from clubface.support.arrays import Floats
from clubface.units import from_si, size, to_si

SENTINELS = (
    999.0, 999.9, 9999.0, 9999.9, 99999.0, 32767.0, 32768.0, 65535.0, 65536.0, 8388607.0, 16777215.0, 16777216.0,
    2147483647.0, 2147483648.0, 4294967295.0,
)  # fmt: skip
"""With either sign: the greatest and least numbers of so many digits or bits."""
NEVER = {"sidespin": 9000.0, "closure": 9000.0, "backspin": 9000.0}
"""From which number [rpm, deg/s] a sentinel is no measurement, though within the limits; backspin only below zero."""
ROUNDING = to_si(1.6, "deg")
"""Difference of three angles that are rounded to whole degrees."""


def without_sentinels(columns: Mapping[str, Floats], units: Mapping[str, Unit]) -> tuple[dict[str, Floats], str]:
    """Return columns [SI] without sentinels that may pass for a measurement but are none, and a note on them, or "".

    ``units`` are those in which each quantity was written. Sentinels that no shot can have are left to
    :func:`clubface.recorded.possible.without_impossible`, which takes out all such values.
    """
    kept, counted = dict(columns), []
    for name in (each for each in (*NEVER, FACE_TO_PATH) if each in columns and each in units):
        values, symbol = columns[name], units[name].symbol
        written = values / size(symbol)
        if name == FACE_TO_PATH:
            is_none = ~can_be("face", values)
        else:
            is_none = _are_sentinels(written) & ((-written if name == "backspin" else np.abs(written)) >= NEVER[name])
        if is_none.any():
            kept[name] = np.where(is_none, np.nan, values)
            shown = f"{units[name].heading} in {int(is_none.sum())} of {values.size} shots"
            counted.append(f"{shown}, such as {written[is_none][0]:.10g} {symbol}")
    note = f"numbers that programs write for nothing measured were taken as not measured: {'; '.join(counted)}"
    return kept, note if counted else ""


def without_any_sentinels(columns: Mapping[str, Floats], units: Mapping[str, Unit]) -> dict[str, Floats]:
    """Return columns [SI] without whatever looks like a sentinel and no shot can have: it says nothing of the unit."""
    return {
        name: np.where(_are_sentinels(values / size(units[name].symbol)) & ~can_be(name, values), np.nan, values)
        if name in units
        else values
        for name, values in columns.items()
    }


def _are_sentinels(written: Floats) -> NDArray[np.bool_]:
    return np.isin(np.abs(written).round(3), SENTINELS)


def with_face_and_path(columns: Mapping[str, Floats], lines: list[int]) -> tuple[dict[str, Floats], str]:
    """Return columns [SI] without face to path but with what follows from it, and a note on contradictions, or "".

    With the path it gives the face angle, and with the face angle the path, where they were not measured. Where all
    three were measured and do not go together, face angle and path stay.
    """
    completed = dict(columns)
    if FACE_TO_PATH not in completed:
        return completed, ""
    to_path = completed.pop(FACE_TO_PATH)
    nothing = np.full_like(to_path, np.nan)
    face, path = completed.get("face", nothing), completed.get("path", nothing)
    apart = np.abs(face - path - to_path) > ROUNDING
    for name, values, other in (("face", face, path + to_path), ("path", path, face - to_path)):
        filled = np.where(np.isnan(values), other, values)
        if not np.isnan(filled).all():
            completed[name] = filled
    if not apart.any():
        return completed, ""
    first = int(np.flatnonzero(apart)[0])
    shown = ", ".join(
        f"{what} {float(from_si(each[first], 'deg')):.3g}"
        for what, each in (("face angle", face), ("path", path), ("face to path", to_path))
    )
    return completed, (
        f"face angle, path and face to path contradict each other in {int(apart.sum())} of {apart.size} shots, such as "
        f"line {lines[first]}: {shown} deg; face to path is not used there"
    )
