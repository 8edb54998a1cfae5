"""Studies by finite elements: cases as of ``clubface fem run``, and tests of meshed heads over faces and designs."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

from clubface.equipment.clubs import club as club_of
from clubface.errors import InputError, RunError
from clubface.fem import head_tests
from clubface.fem.balls import ball as ball_of
from clubface.fem.case import HEADS, MESHED, PLANE, Case, case as case_of, delivery_keys
from clubface.fem.heads import head as head_of
from clubface.fem.heads.driver import INERTIA, SHAPE, TARGETS, WALLS
from clubface.fem.heads.iron import GROOVES, SHAPE as IRON_SHAPE
from clubface.fem.heads.meshed import MeshedHead
from clubface.fem.heads.read import FOLDER, from_toml
from clubface.fem.heads.user_mesh import MeshHead
from clubface.fem.stress import BLOW, peak_stress
from clubface.schema import PhysicalValue
from clubface.simulation.results import inputs, outputs
from clubface.studies.axes import Swept, number
from clubface.studies.kinds.kind import ONE_NAME, OUTPUTS, Column, DescribedStudy, Kind, OneByOne, resolved
from clubface.support.files import input_file, path_of

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
USUAL_OF_CASES = (
    "ball_speed", "launch", "backspin", "sidespin", "normal_velocity", "tangential_velocity", "peak_force",
    "contact_time", "contraction", "energy_error",
)  # fmt: skip


def _swept_cases(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    keys = dict.fromkeys(key for head in HEADS for key in delivery_keys(head))
    delivered = {name: Swept(inputs()[name].unit if name in inputs() else "rad") for name in keys}
    own = {"friction": Swept("1"), **{name: Swept(unit) for name, unit in SETTINGS.items()}}
    return {**delivered, **own, **{name: Swept(None) for name in NAMED}}


def _case_task(study: DescribedStudy) -> OneByOne:
    if "case" not in study.table:
        raise InputError("case", None, 'a case of finite elements, as in case = "paper"')
    base = case_of(resolved(study.table["case"], study.folder))
    launched = {name: Column(each.unit, each.meaning) for name, each in outputs().items()}
    every = {**(THROWN if base.head == PLANE else launched), **CONTACT}

    swept = {each.name for each in study.design.axes}
    readers: dict[str, Callable[[Any], Any]] = {"ball": ball_of, "club": head_of if base.head == MESHED else club_of}
    parts = {name: study.load(name, read) for name, read in readers.items() if name in swept}

    def compute(task: Mapping[str, Any]) -> dict[str, Any]:
        impact = _varied(base, {**task, **{name: each[task[name]] for name, each in parts.items()}}).run()
        if impact.stopped:
            raise RunError(impact.stopped)
        return {**{name: getattr(impact, name) for name in CONTACT}, **impact.outcome()}

    columns = study.columns(every, tuple(name for name in USUAL_OF_CASES if name in every))
    return OneByOne(study, columns, compute, elements=True)


def _varied(base: Case, task: Mapping[str, Any]) -> Case:
    """Return a case with what a task sweeps, ball and club as such."""
    changes = {name: each for name, each in task.items() if name not in SETTINGS}
    settings = {"threads": 1, **{name: task[name] for name in SETTINGS if name in task}}
    return base.replace(settings=settings, **changes)


CASES = Kind(name="fem", keys={"case": ONE_NAME, "outputs": OUTPUTS}, swept=_swept_cases, task=_case_task)


PLACE = {"toe": "m", "high": "m", "speed": "m/s", "striker_speed": "m/s", "blow": "m/s", "friction": "1", "safety": "1"}
"""Units of where a head is struck, of the speeds of ball, striker and blow, and of what else the tests take."""
METAL = {"youngs": "Pa", "poisson": "1", "density": "kg/m3", "yield_stress": "Pa"}
COLUMNS = {
    "restitution": Column("1", "coefficient of restitution of ball and free head"),
    "characteristic_time": Column("s", "time in which the face throws back a small steel sphere"),
    "stress": Column("Pa", "largest stress of a part under a blow, elastic"),
    "margin": Column("1", "least share by which the stress of a part may grow before it yields"),
    "mass": Column("kg", "mass of the head"),
    "cg_x": Column("m", "from the CG to the face centre, towards the target"),
    "cg_y": Column("m", "the same, up"),
    "cg_z": Column("m", "the same, towards the toe"),
    "ixx": Column("kg m2", "moment of inertia about the CG, axis to the target"),
    "iyy": Column("kg m2", "the same, vertical axis"),
    "izz": Column("kg m2", "the same, axis from heel to toe"),
}
USUAL_OF_HEADS = ("restitution", "characteristic_time")
TABLES = ("shape", "thickness", "target", "grooves")


def _design_units() -> dict[str, str]:
    """Return the SI unit of every number of a parametric design, by table and name."""
    other = {
        "shape_loft": "rad",
        "shape_rim": "1",
        "target_mass": "kg",
        **{f"target_{name}": "kg m2" for name in INERTIA},
    }
    tables = {"shape": (*SHAPE, *IRON_SHAPE), "thickness": WALLS, "target": TARGETS, "grooves": GROOVES}
    units = {f"{table}_{name}": "m" for table, names in tables.items() for name in names}
    return {**units, **other, **{f"metal_{name}": unit for name, unit in METAL.items()}}


def _swept_heads(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    numbers = {name: Swept(unit) for name, unit in {**PLACE, **_design_units()}.items()}
    return {**numbers, "head": Swept(None), "ball": Swept(None)}


def _head_task(study: DescribedStudy) -> OneByOne:
    table, designed = study.table, _design_units()
    swept = {each.name for each in study.design.axes}
    if "head" not in {*swept, *table}:
        raise InputError("head", None, 'give it, as in head = "paper"')
    designs = study.load("head", lambda each: from_toml(path_of("head", each, FOLDER)))
    for each in designs.values():
        if isinstance(each, MeshHead):
            input_file(each.file)
    balls = study.load("ball", ball_of)
    held = {name: number(name, table[name], unit) for name, unit in PLACE.items() if name in table}
    columns = study.columns(COLUMNS, USUAL_OF_HEADS)

    @lru_cache(maxsize=1)
    def meshed(name: str, changes: tuple[tuple[str, float], ...]) -> MeshedHead:
        return _changed(designs[name], changes).mesh()

    def compute(task: Mapping[str, Any]) -> dict[str, Any]:
        how = {**held, **task}
        changes = tuple((name, each) for name, each in task.items() if name in designed)
        made = meshed(task.get("head", table.get("head")), changes)
        ball = balls[task.get("ball", table.get("ball"))]
        place = {name: how[name] for name in ("toe", "high") if name in how}
        given = {name: how[name] for name in ("friction", "safety") if name in how}
        safety = {name: given[name] for name in ("safety",) if name in given}
        rigid = made.club

        @lru_cache
        def blow() -> list[Any]:
            return peak_stress(made, ball=ball, speed=how.get("blow", BLOW), threads=1, **given, **place)

        return {
            "restitution": lambda: head_tests.restitution(
                made, ball=ball, speed=how.get("speed", head_tests.COR_SPEED), threads=1, **given, **place
            ),
            "characteristic_time": lambda: head_tests.characteristic_time(
                made, speed=how.get("striker_speed", head_tests.STRIKER_SPEED), threads=1, **safety, **place
            ),
            "stress": lambda: max(part.stress for part in blow()),
            "margin": lambda: min(math.nan if part.margin is None else part.margin for part in blow()),
            **{name: getattr(rigid, name) for name in ("mass", "cg_x", "cg_y", "cg_z", "ixx", "iyy", "izz")},
        }  # fmt: skip

    return OneByOne(study, columns, compute, elements=True)


def _changed(design: Any, changes: tuple[tuple[str, float], ...]) -> Any:
    """Return a design with some of its numbers changed, each by table and name."""
    for path, value in changes:
        table, _, name = path.partition("_")
        held = getattr(design, table, None)
        if table == "metal" and held is not None:
            design = replace(design, metal=replace(held, **{name: value}))
        elif isinstance(held, Mapping) and (name in held or table == "target"):
            design = replace(design, **{table: {**held, name: value}})
        else:
            raise InputError(path, value, f"left out: the design of {design.name} has no {name} under {table}")
    return design


HEAD_KEYS = {
    "head": ONE_NAME,
    "ball": ONE_NAME,
    **{name: PhysicalValue(unit) for name, unit in PLACE.items()},
    "outputs": OUTPUTS,
}
MESHED_HEADS = Kind(name="head", keys=HEAD_KEYS, swept=_swept_heads, task=_head_task)
