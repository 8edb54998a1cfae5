"""Studies of the dynamic loft with which a ball is carried farthest, with any other input of a shot swept."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from clubface.errors import InputError
from clubface.studies.axes import Swept
from clubface.studies.kinds.kind import Column, Described, Kind, chosen_columns
from clubface.studies.kinds.one_by_one import OneByOne, Values
from clubface.studies.kinds.shot_inputs import KEYS, ShotInputs, swept_shots

COLUMNS = {
    "best_loft": Column("rad", "dynamic loft of the longest carry"),
    "ball_speed": Column("m/s", "ball speed with it"),
    "launch": Column("rad", "launch angle with it"),
    "spin": Column("rad/s", "total spin with it"),
    "carry": Column("m", "carry with it"),
    "total": Column("m", "total distance with it"),
    "within_below": Column("rad", "how much less loft costs a yard of carry"),
    "within_above": Column("rad", "how much more loft costs a yard of carry"),
}


def _swept(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    return {name: each for name, each in swept_shots(table, sweep).items() if name != "loft"}


def _task(study: Described) -> OneByOne:
    from clubface.design.best_loft import best_loft

    shot_inputs = ShotInputs(study)
    if "loft" in study.table.get("held", {}):
        raise InputError("loft", study.table["held"]["loft"], "left out: the best is looked for")

    def compute(task: Values) -> dict[str, Any]:
        options = shot_inputs.single(task)
        found = best_loft(**options.pop("delivery"), **options, **shot_inputs.conditions.at(task))
        within = found.within[0]
        figures = {name: getattr(found, name)[0] for name in ("ball_speed", "launch", "spin", "carry", "total")}
        return {**figures, "best_loft": found.loft[0], "within_below": within[0], "within_above": within[1]}

    return OneByOne(study, chosen_columns(study.table, COLUMNS, tuple(COLUMNS)), compute)


KIND = Kind(name="best-loft", keys=(*KEYS, "outputs"), swept=_swept, task=_task)
