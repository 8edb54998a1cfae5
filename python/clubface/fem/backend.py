"""The impact model ``fem``: finite elements behind the interface shared by all impact models."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.models import Model
from clubface.errors import InputError
from clubface.fem.balls import ball
from clubface.fem.heads.meshed import mesh_of
from clubface.fem.paper import error_note
from clubface.fem.run import FRICTION, face_of, simulate, strike
from clubface.fem.settings import Settings
from clubface.results.notes import Note
from clubface.simulation.impact import Balls, Problems, Request
from clubface.simulation.results import outputs

MODEL = Model(
    name="fem",
    title="Explicit finite elements",
    kind="finite elements",
    summary="A meshed ball against a rigid or a meshed head: deformation, vibration, sticking and slipping computed,"
    " not assumed; takes tenths of a second a shot.",
    reference="W.-J. Roh and C.-W. Lee, Analysis of golf ball spin mechanism at impact by FEM",
    laws=("momentum", "angular_momentum", "energy", "friction_cone"),
    laws_without=None,
    parameters=(FRICTION,),
)

HOW = Settings(until_separation=True)


class FiniteElements:
    """Run shots one after another, each on the requested number of threads."""

    def balls(self, given: Any, accuracy: float | None) -> Balls:
        """Return the meshed ball for ``given``, as for :func:`clubface.fem.ball`, and the equivalent rigid ball.

        Raises InputError if an accuracy is given: the mesh determines it.
        """
        if accuracy is not None:
            raise InputError("accuracy", accuracy, "leave it out; the accuracy of fem depends on the mesh")
        made = ball(given)
        return Balls(made, made.rigid)

    def launches(self, shots: Request) -> tuple[NDArray[Any], Problems]:
        """Run the shots one by one; a shot that ends early has no launch."""
        (friction,) = shots.parameters
        head, how = mesh_of(shots.club), replace(HOW, threads=shots.threads)
        launches = np.full((len(outputs()), shots.size), np.nan)
        problems: Problems = []
        for row in range(shots.size):
            columns, mu = [_at(each, row) for each in shots.inputs], _at(friction, row)
            try:
                record, _ = simulate(shots.own, face_of(head, shots.club, columns), mu, how=how)
            except InputError as error:
                problems.append((row, error.parameter, error.allowed))
                continue
            if record.interrupted:
                raise KeyboardInterrupt
            if record.stopped:
                problems.append((row, MODEL.name, record.stopped))
                continue
            launches[:, row] = record.launch
            if shots.progress is not None:
                shots.progress(row + 1)
        return launches, problems

    def forces(self, launch: Any, delivery: Mapping[str, Any]) -> Mapping[str, Any]:
        """Run the shot again and return the times [s] and forces on the ball [N]."""
        made, _ = self.balls(launch.ball, None)
        friction = launch.parameters.values["friction"]
        run = strike(launch.club, delivery, ball=made, friction=friction, settings=HOW)
        touching = run.contact["time"] <= run.last_touch
        time, normal, tangential, toe = (run.contact[key][touching] for key in ("time", "normal", "tangential", "toe"))
        return {"time": time, "normal_force": normal, "force_y": -tangential, "force_z": toe}

    def notes(self) -> Sequence[Note]:
        """Return the note on the error of a launch."""
        return (error_note(),)


BACKEND = FiniteElements()


def _at(value: Any, row: int) -> float:
    return float(value if isinstance(value, (int, float)) else value[row])
