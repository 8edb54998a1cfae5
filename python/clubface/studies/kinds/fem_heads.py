"""Studies of meshed heads: restitution, characteristic time, stress and mass over the face and over their designs."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

from clubface.errors import InputError
from clubface.fem import head_tests
from clubface.fem.balls import ball as ball_of
from clubface.fem.heads.driver import INERTIA, SHAPE, TARGETS, WALLS
from clubface.fem.heads.iron import GROOVES, SHAPE as IRON_SHAPE
from clubface.fem.heads.meshed import MeshedHead
from clubface.fem.heads.read import FOLDER, from_toml
from clubface.fem.heads.user_mesh import MeshHead
from clubface.fem.stress import BLOW, peak_stress
from clubface.studies.axes import Swept, number
from clubface.studies.kinds.kind import Column, Described, Kind, chosen_columns, loaded
from clubface.studies.kinds.one_by_one import OneByOne, Values
from clubface.support.input_files import input_file
from clubface.support.shipped import path_of

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
USUAL = ("restitution", "characteristic_time")
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
    found = {f"{table}_{name}": "m" for table, names in tables.items() for name in names}
    return {**found, **other, **{f"metal_{name}": unit for name, unit in METAL.items()}}


def _swept(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    numbers = {name: Swept(unit) for name, unit in {**PLACE, **_design_units()}.items()}
    return {**numbers, "head": Swept(None), "ball": Swept(None)}


def _task(study: Described) -> OneByOne:
    table, designed = study.table, _design_units()
    swept = {each.name for each in study.design.axes}
    if "head" not in swept and not isinstance(table.get("head"), str):
        raise InputError("head", table.get("head"), 'give it, as in head = "paper"')
    designs = loaded(study, "head", lambda each: from_toml(path_of("head", each, FOLDER)))
    for each in designs.values():
        if isinstance(each, MeshHead):
            input_file(each.file)
    balls = loaded(study, "ball", ball_of)
    held = {name: number(name, table[name], unit) for name, unit in PLACE.items() if name in table}
    columns = chosen_columns(table, COLUMNS, USUAL)

    @lru_cache(maxsize=1)
    def meshed(which: str, changes: tuple[tuple[str, float], ...]) -> MeshedHead:
        return _changed(designs[which], changes).mesh()

    def compute(task: Values) -> dict[str, Any]:
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
            return peak_stress(made, which=ball, speed=how.get("blow", BLOW), threads=1, **given, **place)

        return {
            "restitution": lambda: head_tests.restitution(
                made, which=ball, speed=how.get("speed", head_tests.COR_SPEED), threads=1, **given, **place
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


KIND = Kind(name="head", keys=("head", "ball", *PLACE, "outputs"), swept=_swept, task=_task)
