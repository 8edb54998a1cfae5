"""Studies of face maps: sweet spot, area and forgiveness of a face, with any input of club, delivery and air swept."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from clubface.equipment.backends import MODULES
from clubface.errors import InputError, Told
from clubface.studies.axes import Swept, number
from clubface.studies.kinds.kind import Column, Described, Kind, chosen_columns
from clubface.studies.kinds.one_by_one import OneByOne, Values
from clubface.studies.kinds.shot_inputs import KEYS, ShotInputs, swept_shots

PLACE = {"spread_toe": "m", "spread_high": "m", "about_toe": "m", "about_high": "m", "share": "1"}
"""Unit of what says how impacts scatter, about which point, and which share of the best ball speed counts."""
FACE = {
    "face_area": Column("m2", "area of the face"),
    "area": Column("m2", "area on which the ball speed is at least a share of the best, 0.98 unless given"),
    "sweet_spot_toe": Column("m", "where the ball speed is greatest, towards the toe"),
    "sweet_spot_high": Column("m", "the same, upwards"),
    "best_ball_speed": Column("m/s", "ball speed there"),
    "longest_toe": Column("m", "where the carry is greatest, towards the toe"),
    "longest_high": Column("m", "the same, upwards"),
    "longest_carry": Column("m", "carry there"),
}
SCATTERED = ("missed", "ball_speed_loss", "carry_mean", "carry_deviation", "carry_loss", "side_deviation")


def _columns() -> dict[str, Column]:
    from clubface.design.comparison.quantities import quantities

    found = {**FACE, "missed": Column("1", "share of the swings that miss the face")}
    for name, each in quantities().items():
        found[f"{name}_mean"] = Column(each.unit, f"mean over impacts that scatter: {each.meaning}")
        found[f"{name}_deviation"] = Column(each.unit, f"standard deviation over them: {each.meaning}")
        found[f"{name}_loss"] = Column(each.unit, f"how much the mean is below the value at the centre: {each.meaning}")
    return found


def _swept(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    shots = {name: each for name, each in swept_shots(table, sweep).items() if name not in ("toe", "high")}
    return {**shots, **{name: Swept(unit) for name, unit in PLACE.items()}}


def _task(study: Described) -> OneByOne:
    from clubface.design.face_map.face_map import SHARE, checked_grid, map_face

    shot_inputs, table = ShotInputs(study), study.table
    for name in ("toe", "high"):
        if name in table.get("held", {}):
            raise InputError(name, table["held"][name], "left out: a map strikes the whole face")
    held = {"share": SHARE, "about_toe": 0.0, "about_high": 0.0}
    held |= {name: number(name, table[name], unit) for name, unit in PLACE.items() if name in table}
    given = {*held, *(each.name for each in study.design.axes)}
    scatters = {"spread_toe", "spread_high"} <= given
    columns = chosen_columns(table, _columns(), (*FACE, *(SCATTERED if scatters else ())))
    if not scatters and (named := [name for name in columns if name not in FACE]):
        raise InputError("spread_toe", None, f'give it and spread_high, as in spread_toe = "10 mm", for {named[0]}')
    if not scatters and (idle := [each for each in PLACE if each != "share" and each in {*table, *study.sweep}]):
        raise InputError(idle[0], Told("given"), "left out unless both spread_toe and spread_high are given")
    if (grid := table.get("grid")) is not None:
        grid = checked_grid(grid)

    def compute(task: Values) -> dict[str, Any]:
        place = {**held, **task}
        shot = shot_inputs.single(task)
        alone: dict[str, Any] = {"workers": 1} if shot["model"] in MODULES else {}
        found = map_face(**shot, **shot_inputs.conditions.at(task), grid=grid, **alone)
        best, longest = found.best(), found.best("carry")
        figures: dict[str, Any] = {
            "face_area": found.outline.area, "area": lambda: found.area(place["share"]),
            "sweet_spot_toe": best.toe, "sweet_spot_high": best.high, "best_ball_speed": best.value,
            "longest_toe": longest.toe, "longest_high": longest.high, "longest_carry": longest.value,
        }  # fmt: skip
        if scatters:
            spread = (place["spread_toe"], place["spread_high"])
            of = found.forgiveness(spread, toe=place["about_toe"], high=place["about_high"])
            for part in ("mean", "deviation", "loss"):
                figures |= {f"{name}_{part}": each for name, each in getattr(of, part).items()}
            figures["missed"] = of.missed
        return figures

    return OneByOne(study, columns, compute, elements=bool(shot_inputs.depends_on))


KIND = Kind(name="map", keys=(*KEYS, *PLACE, "grid", "outputs"), swept=_swept, task=_task)
