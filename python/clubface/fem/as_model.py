"""The finite elements as one more impact model: the same shots in, the same launch out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from clubface.errors import InputError
from clubface.fem.balls import Ball, ball, ball_names
from clubface.fem.run import Settings, rigid_ball

if TYPE_CHECKING:
    from numpy.typing import NDArray

DEFAULT_BALL = "reference"
"""The meshed ball where none is named."""


def meshed_ball(given: Any) -> tuple[Ball, Any]:
    """Return the meshed ball that ``given`` names, or the default, and its mass properties as a rigid ball."""
    named = isinstance(given, Ball) or (isinstance(given, str) and given in ball_names())
    made = ball(given if named else DEFAULT_BALL)
    return made, rigid_ball(made)


def launches(
    made: Ball, columns: Sequence[Any], friction: Any, n: int, progress: Callable[[int], object] | None
) -> tuple[NDArray[Any], list[tuple[int, str, str]]]:
    """Return outputs by shots, and what kept shots from being computed: (row, name, message)."""
    import numpy as np

    from clubface import _core
    from clubface.quantities import outputs

    found = np.full((len(outputs()), n), np.nan)
    problems: list[tuple[int, str, str]] = []
    settings = Settings(until_separation=True).values()
    for row in range(n):
        inputs = [float(_at(each, row)) for each in columns]
        try:
            result = _core.fem_head(made.values(), inputs, float(_at(friction, row)), settings)
        except ValueError as error:
            if len(error.args) != 3:
                raise
            name, value, allowed = error.args
            problems.append((row, name, f"{value} {allowed}".strip()))
            continue
        if result["interrupted"]:
            raise KeyboardInterrupt
        if result["stopped"]:
            problems.append((row, "fem", result["stopped"]))
            continue
        found[:, row] = result["launch"]
        if progress is not None:
            progress(row + 1)
    return found, problems


def check_no_accuracy(accuracy: float | None) -> None:
    """Refuse an accuracy: the mesh sets that of finite elements."""
    if accuracy is not None:
        raise InputError("accuracy", accuracy, "left out for fem, whose accuracy is that of the mesh")


def _at(value: Any, row: int) -> float:
    return value if isinstance(value, (int, float)) else value[row]
