"""Studies of optimisations: the best club as a bound, a limit, a golfer, a hole or the air changes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from clubface import units
from clubface.design.golfer.golfers import golfer as golfer_of
from clubface.design.optimisation.landings import FREE
from clubface.design.optimisation.run import optimise
from clubface.design.optimisation.study import DIMENSIONS, DesignStudy
from clubface.design.optimisation.study_file import COUNTS, JUDGED, read
from clubface.equipment.balls import ball as ball_of
from clubface.equipment.clubs import club as club_of
from clubface.errors import InputError
from clubface.studies.axes import Swept
from clubface.studies.kinds.golfer_inputs import changed_golfer, changed_hole, swept_golfers
from clubface.studies.kinds.kind import Column, Described, Kind, chosen_columns, loaded
from clubface.studies.kinds.one_by_one import OneByOne, Values
from clubface.studies.kinds.shot_inputs import BY_GROUP, swept_conditions

ENDS = ("least", "most")
READERS: Mapping[str, Callable[[Any], Any]] = {"golfer": golfer_of, "club": club_of, "ball": ball_of}
"""What is named by a file or by a name, and what reads it."""
NAMED = (*READERS, "model")
COUNTED = ("shots", "seed", "starts")
"""Of the numbers of ``COUNTS``, those that may be swept."""


def _swept(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    """Return both ends of every bound and limit, figures of golfers and holes, the conditions, and what has names."""
    known = {**JUDGED, **DIMENSIONS}
    bounds = {f"variables_{name}_{end}": Swept(_unit(known[name])) for name in FREE for end in ENDS}
    limits = {f"limits_{name}_{end}": Swept(_unit(each)) for name, each in known.items() for end in ENDS}
    single = {"speed_exponent": Swept("1"), "discretionary_mass": Swept("kg")}
    single |= {name: Swept("1", limits=COUNTS[name]) for name in COUNTED}
    conditions, named = swept_conditions(), {name: Swept(None) for name in NAMED}
    return {**bounds, **limits, **swept_golfers(), **conditions, **single, **named}


def _unit(dimension: str) -> str:
    return units.SI_UNITS[dimension]


def _task(study: Described) -> OneByOne:
    if not isinstance(study.table.get("file"), str):
        raise InputError("file", study.table.get("file"), 'the file of an optimisation, as in file = "better.toml"')
    asked = read(study.folder / study.table["file"])
    if not isinstance(asked, DesignStudy):
        raise InputError("file", study.table["file"], "one with variables: a fitting chooses among parts")
    swept = {each.name for each in study.design.axes}
    parts = {name: loaded(study, name, read) for name, read in READERS.items() if name in swept}
    every = {
        name: Column(_unit(DIMENSIONS[name]), f"of the best club: {name.replace('_', ' ')}")
        for name in asked.variables.fields
    }
    for name in asked.objectives:
        unit, words = _unit(JUDGED[name]), f"{asked.objective(name).meaning}, on fresh shots"
        every |= {
            f"{name}_start": Column(unit, f"with the club at the start: {words}"),
            f"{name}_nominal": Column(unit, f"with the club that is best for the mean delivery: {words}"),
            f"{name}_optimum": Column(unit, f"with the best club: {words}"),
            f"{name}_error": Column(unit, "standard error of the difference of start and optimum"),
        }
    every["alike"] = Column("1", "share of the starts of the solver that end as well as the best")

    def compute(task: Values) -> dict[str, Any]:
        found = optimise(changed_study(asked, {**task, **{name: each[task[name]] for name, each in parts.items()}}))
        figures = {**found.club, "alike": found.alike / found.starts}
        for name in asked.objectives:
            figures |= {f"{name}_{club}": found.fresh.value(club, name) for club in found.fresh.clubs}
            figures[f"{name}_error"] = found.fresh.error("start", name)
        return figures

    return OneByOne(study, chosen_columns(study.table, every, tuple(every)), compute)


def changed_study(study: DesignStudy, task: Values) -> DesignStudy:
    """Return an optimisation with what a task sweeps, those of ``READERS`` read; golfers change all in the same way."""
    ends = {"variables": dict(study.bounds), "limits": dict(study.limits)}
    for name, value in task.items():
        table, _, rest = name.partition("_")
        if table in ends and rest.endswith(tuple(f"_{end}" for end in ENDS)):
            field, _, end = rest.rpartition("_")
            if field not in ends[table]:
                raise InputError(name, value, f"one of the {table} of the file, {', '.join(ends[table]) or 'none'}")
            least, most = ends[table][field]
            least, most = (value, most) if end == "least" else (least, value)
            if not least < most:
                raise InputError(name, value, f"so that {field} has a least value below its greatest")
            ends[table][field] = (least, most)
    head = study.head
    if "discretionary_mass" in task:
        if head is None:
            raise InputError("discretionary_mass", task["discretionary_mass"], "left out, since the file has no [head]")
        head = replace(head, discretionary=task["discretionary_mass"])
    golfers = study.golfers if "golfer" not in task else ((task["golfer"], 1.0),)
    setting = replace(study.setting, threads=1)
    for group, known in BY_GROUP.items():
        if changes := {name: task[name] for name in known if name in task}:
            setting = replace(setting, **{group: {**_mapping(group, getattr(setting, group)), **changes}})
    if "ball" in task:
        setting = replace(setting, ball=task["ball"])
    setting = replace(setting, **{name: task[name] for name in ("model", "speed_exponent") if name in task})
    return replace(
        study, bounds=ends["variables"], limits=ends["limits"], head=head, setting=setting,
        club=task.get("club", study.club),
        golfers=tuple((changed_golfer(each, task), weight) for each, weight in golfers),
        hole=changed_hole(study.hole, task),
        **{name: int(task[name]) for name in COUNTED if name in task},
    )  # fmt: skip


def _mapping(group: str, given: Any) -> Mapping[str, Any]:
    if given is not None and not isinstance(given, Mapping):
        raise InputError(group, given, "a table of numbers by name in the file, since one of them is swept")
    return given or {}


KIND = Kind(name="optimise", keys=("file", "outputs"), swept=_swept, task=_task)
