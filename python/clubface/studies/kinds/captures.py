"""Studies of motion capture: errors for synthetic swings with known truth, in any laboratory."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

from clubface.capture.estimators import ESTIMATORS, ROUGHNESS
from clubface.capture.reduction import QUANTITIES
from clubface.capture.setup import prepare
from clubface.capture.study import read_swing
from clubface.capture.synthetic.laboratory import Cameras, positions_map
from clubface.capture.synthetic.synthetic_swing import club_of_hand
from clubface.equipment.clubs import club as club_of
from clubface.equipment.described import HANDS
from clubface.errors import InputError
from clubface.schema import Choice, PhysicalValue, count
from clubface.simulation.results import inputs
from clubface.studies.axes import Swept, held_number
from clubface.studies.kinds.kind import ONE_NAME, OUTPUTS, Column, DescribedStudy, Kind, OneByOne
from clubface.support.checks import MOST_SEED

COUNTED = Swept("1", limits=(0, MOST_SEED))
UNITS = {"rate": "1", "noise": "m", "gaps": "1", "gap": "1", "roughness": "1"}
NUMBERS = {"swing": COUNTED, "seed": COUNTED, **{name: Swept(unit) for name, unit in UNITS.items()}}
"""Inputs that may be fixed or swept: the swing and the laboratory; the rate is in frames per second."""
NAMES = ("club", "hand", "estimator")
OF_CAMERAS = ("rate", "noise", "gaps", "gap")


def _columns() -> dict[str, Column]:
    columns: dict[str, Column] = {}
    for name in QUANTITIES:
        unit, meaning = inputs()[name].unit, inputs()[name].meaning
        columns[f"{name}_error"] = Column(unit, f"captured less true: {meaning}")
        columns[f"{name}_stated"] = Column(unit, f"standard deviation that the reading states: {meaning}")
    return columns | {"touch_error": Column("s", "error of the instant of first touch")}


def _swept(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    named = {"club": Swept(None), "hand": Swept(None, tuple(HANDS)), "estimator": Swept(None, tuple(ESTIMATORS))}
    return {**NUMBERS, **named}


def _task(study: DescribedStudy) -> OneByOne:
    table = study.table
    held: dict[str, Any] = {"seed": 1, "roughness": ROUGHNESS, "club": "driver", "hand": None}
    held |= {"estimator": next(iter(ESTIMATORS))}
    held |= {name: held_number(name, table[name], each) for name, each in NUMBERS.items() if name in table}
    held |= {name: table[name] for name in NAMES if name in table}
    if "swing" not in {*held, *(each.name for each in study.design.axes)}:
        raise InputError("swing", None, "sweep it, as in swing = { from = 0, to = 199, step = 1 }")

    clubs = study.load("club", club_of, held["club"])

    @lru_cache(maxsize=len(ESTIMATORS))
    def reader(club: str, hand: str | None, cameras: Cameras, estimator: str, roughness: float) -> Any:
        made = club_of_hand(clubs[club], hand)
        return made, prepare(positions_map(made, cameras), made, estimator=estimator, roughness=roughness)

    def compute(task: Mapping[str, Any]) -> dict[str, Any]:
        how = {**held, **task}
        cameras = replace(Cameras(), **{name: how[name] for name in OF_CAMERAS if name in how})
        club, ready = reader(how["club"], how["hand"], cameras, how["estimator"], how["roughness"])
        _, errors, stated, touch = read_swing(
            int(how["swing"]), seed=int(how["seed"]), club=club, cameras=cameras, ready=(ready,)
        )
        figures = {f"{name}_error": each for name, each in zip(QUANTITIES, errors[0], strict=True)}
        figures |= {f"{name}_stated": each for name, each in zip(QUANTITIES, stated[0], strict=True)}
        return {**figures, "touch_error": touch[0]}

    columns = _columns()
    usual = tuple(name for name in columns if name.endswith("_error"))
    return OneByOne(study, study.columns(columns, usual), compute)


KEYS = {
    "club": ONE_NAME,
    "hand": Choice(HANDS),
    "estimator": Choice(tuple(ESTIMATORS)),
    **{name: count(*each.limits) if each.limits else PhysicalValue(each.unit or "1") for name, each in NUMBERS.items()},
    "outputs": OUTPUTS,
}
CAPTURES = Kind(name="capture", keys=KEYS, swept=_swept, task=_task)
