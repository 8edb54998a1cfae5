"""The finite elements as one more impact model: the same shots in, the same launch out."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from clubface.equipment.balls import DEFAULT_BALL as PUBLISHED
from clubface.equipment.balls import Ball as RigidBall
from clubface.errors import InputError
from clubface.fem.balls import Ball, ball
from clubface.fem.result import Impact
from clubface.fem.run import Settings, rigid_ball, simulate

if TYPE_CHECKING:
    from numpy.typing import NDArray

DEFAULT_BALL = "reference"
"""The meshed ball where none is named."""


def meshed_ball(given: Any) -> tuple[Ball, Any]:
    """Return the meshed ball that ``given`` names, or the default, and its mass properties as a rigid ball.

    Given may be a :class:`Ball`, a name, the path of a TOML file, a rigid ball made from a built-in one, or the ball of
    the published models, in whose place the default stands.
    """
    if isinstance(given, RigidBall):
        given = given.name
    made = ball(DEFAULT_BALL if given in (None, PUBLISHED) else given)
    return made, rigid_ball(made)


def force_history(found: Impact) -> dict[str, NDArray[Any]]:
    """Return the forces on the ball under the names of :class:`clubface.History` [s, N]."""
    contact = found.contact
    touching = contact["time"] <= found.last_touch
    named = {"time": contact["time"], "normal_force": contact["normal"],
             "force_y": -contact["tangential"], "force_z": contact["toe"]}  # fmt: skip
    return {name: values[touching] for name, values in named.items()}


def launches(
    made: Ball, columns: Sequence[Any], friction: Any, n: int, progress: Callable[[int], object] | None
) -> tuple[NDArray[Any], list[tuple[int, str, str]]]:
    """Return outputs by shots, and what kept shots from being computed: (row, name, message)."""
    import numpy as np

    from clubface import _core
    from clubface.simulation.quantities import outputs

    found = np.full((len(outputs()), n), np.nan)
    problems: list[tuple[int, str, str]] = []
    how = Settings(until_separation=True)
    for row in range(n):
        inputs = [float(_at(each, row)) for each in columns]
        try:
            result, _ = simulate(_core.fem_head, made.values(), inputs, float(_at(friction, row)), how=how)
        except InputError as error:
            problems.append((row, error.parameter, error.allowed))
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
        raise InputError("accuracy", accuracy, "leave it out for fem, whose accuracy is that of the mesh")


def _at(value: Any, row: int) -> float:
    return value if isinstance(value, (int, float)) else value[row]
