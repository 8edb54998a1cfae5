"""Studies of cases of finite elements, as of ``clubface fem run``: launch, forces and deformation of single impacts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from clubface.equipment.clubs import club as club_of
from clubface.errors import InputError, RunError
from clubface.fem.balls import ball as ball_of
from clubface.fem.case import HEADS, MESHED, PLANE, Case, case as case_of, delivery_keys
from clubface.fem.heads import head as head_of
from clubface.simulation.quantities import inputs, outputs
from clubface.studies.axes import Swept
from clubface.studies.kinds.kind import Column, Described, Kind, chosen_columns, loaded, resolved
from clubface.studies.kinds.one_by_one import OneByOne, Values

SETTINGS = {"duration": "s", "interval": "s", "safety": "1", "bulk_viscosity": "1"}
"""Units of the numbers among the settings."""
CONTACT = {
    "peak_force": Column("N", "largest force between ball and face"),
    "peak_force_time": Column("s", "when it is reached"),
    "contact_time": Column("s", "from first to last touch"),
    "tangential_max": Column("N", "largest force along the face"),
    "tangential_min": Column("N", "smallest force along the face"),
    "reversal_time": Column("s", "when the force along the face turns round"),
    "spin_max": Column("rad/s", "largest spin on the way"),
    "contraction": Column("1", "largest contraction of the ball over its diameter"),
    "contraction_time": Column("s", "when it is reached"),
    "energy_error": Column("1", "energy that appeared or vanished over that before"),
    "steps": Column("1", "steps in time"),
}
THROWN = {
    "normal_velocity": Column("m/s", "velocity off the plane"),
    "tangential_velocity": Column("m/s", "velocity along the plane"),
    "backspin": Column("rad/s", "spin about the toe direction"),
}
NAMED = ("ball", "club")
USUAL = ("ball_speed", "launch", "backspin", "sidespin", "normal_velocity", "tangential_velocity", "peak_force",
         "contact_time", "contraction", "energy_error")  # fmt: skip


def _swept(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    keys = dict.fromkeys(key for head in HEADS for key in delivery_keys(head))
    delivered = {name: Swept(inputs()[name].unit if name in inputs() else "rad") for name in keys}
    own = {"friction": Swept("1"), **{name: Swept(unit) for name, unit in SETTINGS.items()}}
    return {**delivered, **own, **{name: Swept(None) for name in NAMED}}


def _task(study: Described) -> OneByOne:
    if not isinstance(study.table.get("case"), str):
        raise InputError("case", study.table.get("case"), 'a case of finite elements, as in case = "paper"')
    base = case_of(resolved(study.table["case"], study.folder))
    launched = {name: Column(each.unit, each.meaning) for name, each in outputs().items()}
    every = {**(THROWN if base.head == PLANE else launched), **CONTACT}

    swept = {each.name for each in study.design.axes}
    readers: dict[str, Callable[[Any], Any]] = {"ball": ball_of, "club": head_of if base.head == MESHED else club_of}
    parts = {name: loaded(study, name, read) for name, read in readers.items() if name in swept}

    def compute(task: Values) -> dict[str, Any]:
        found = _varied(base, {**task, **{name: each[task[name]] for name, each in parts.items()}}).run()
        if found.stopped:
            raise RunError(found.stopped)
        return {**{name: getattr(found, name) for name in CONTACT}, **found.outcome()}

    columns = chosen_columns(study.table, every, tuple(name for name in USUAL if name in every))
    return OneByOne(study, columns, compute, elements=True)


def _varied(base: Case, task: Values) -> Case:
    """Return a case with what a task sweeps, ball and club as such."""
    changes = {name: each for name, each in task.items() if name not in SETTINGS}
    settings = {"threads": 1, **{name: task[name] for name in SETTINGS if name in task}}
    return base.replace(settings=settings, **changes)


KIND = Kind(name="fem", keys=("case", "outputs"), swept=_swept, task=_task)
