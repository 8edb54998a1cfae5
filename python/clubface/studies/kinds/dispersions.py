"""Studies of where the shots of golfers go: means, spreads, percentiles, ellipses, lies and strokes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from clubface.design.strokes import Hole
from clubface.equipment.clubs import club as club_of
from clubface.errors import InputError
from clubface.simulation.delivery import DIMENSIONS
from clubface.simulation.quantities import flight_outputs, outputs
from clubface.studies.axes import Swept, held_number
from clubface.studies.kinds.golfer_inputs import changed_golfer, changed_hole, swept_golfers
from clubface.studies.kinds.kind import Column, Described, Kind, chosen_columns, loaded
from clubface.studies.kinds.one_by_one import OneByOne, Values
from clubface.studies.kinds.shot_inputs import KEYS, ShotInputs, swept_shots
from clubface.support.checks import MOST_SEED, check_names, is_count

PERCENTILES = (10, 50, 90)
SHARE = 90
"""Percent of the landings that the ellipse holds, unless given."""
USUAL = (
    "carry_mean", "carry_deviation", "side_mean", "side_deviation", "total_mean", "total_deviation", "ball_speed_mean",
    "ellipse_area", "lost",
)  # fmt: skip
SEED = Swept("1", limits=(0, MOST_SEED))
ON_A_HOLE = ("strokes", "gained", "green", "fairway", "rough", "recovery")


def _columns(percentiles: tuple[int, ...]) -> dict[str, Column]:
    from clubface.design.dispersion.tally import FLOWN, LAUNCHED

    every = {**outputs(), **flight_outputs()}
    found: dict[str, Column] = {}
    for name in (*LAUNCHED, *FLOWN):
        unit, meaning = every[name].unit, every[name].meaning
        found[f"{name}_mean"] = Column(unit, f"mean over the shots: {meaning}")
        found[f"{name}_deviation"] = Column(unit, f"standard deviation over the shots: {meaning}")
        for share in percentiles:
            found[f"{name}_p{share}"] = Column(unit, f"what {share}% of the shots are below: {meaning}")
    found |= {
        "ellipse_area": Column("m2", "area of the ellipse of the landings"),
        "ellipse_long": Column("m", "half its long axis"),
        "ellipse_short": Column("m", "half its short axis"),
        "lost": Column("1", "share of the shots without a result"),
        "strokes": Column("1", "strokes expected after the shot"),
        "gained": Column("1", "strokes gained on the average of the PGA Tour"),
    }
    return found | {name: Column("1", f"share of the shots at rest: {name}") for name in ON_A_HOLE[2:]}


def _swept(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    equipment = {name: each for name, each in swept_shots(table, sweep).items() if name not in DIMENSIONS}
    return {**equipment, **swept_golfers(), "seed": SEED}


def _of_golfer(name: str, value: Any) -> InputError:
    return InputError(name, value, "left out: the golfer says how the club is delivered")


def _task(study: Described) -> OneByOne:
    from clubface.design.dispersion.sampling import COUNT, MOST, dispersion
    from clubface.design.golfer.golfers import golfer as golfer_of

    table = study.table
    swept = {each.name: each for each in study.design.axes}
    shot_inputs = ShotInputs(study, needs=())
    seed = held_number("seed", table.get("seed", 0), SEED)
    if not isinstance(count := table.get("shots", COUNT), int) or not is_count(count, 1, MOST):
        raise InputError("shots", count, f"a whole number from 1 to {MOST}")
    percentiles = table.get("percentiles", PERCENTILES)
    if not isinstance(percentiles, list | tuple) or not all(is_count(each, 1, 99) for each in percentiles):
        raise InputError("percentiles", percentiles, "a list of whole numbers from 1 to 99")
    if not is_count(share := table.get("ellipse", SHARE), 1, 99):
        raise InputError("ellipse", share, "a whole number of percent from 1 to 99")
    if "golfer" not in table and "golfer" not in swept:
        raise InputError("golfer", None, 'give it, as in golfer = "tour-driver"')
    for name, value in table.get("held", {}).items():
        if name in DIMENSIONS:
            raise _of_golfer(name, value)
    golfers = loaded(study, "golfer", golfer_of)
    clubs = {} if "club" in {*table, *swept} else {name: club_of(each.club) for name, each in golfers.items()}
    held = None
    if "hole" in table:
        if not isinstance(table["hole"], Mapping):
            raise InputError("hole", table["hole"], 'a table, as in hole = { length = "400 yd" }')
        check_names("value of the hole", table["hole"], Hole.__dataclass_fields__)
        if not {"length", "hole_length"} & {*table["hole"], *swept}:
            raise InputError("hole", table["hole"], 'a table with the length, as in hole = { length = "400 yd" }')
        held = Hole(**{"length": "400 yd", **table["hole"]})
    plays = held is not None or "hole_length" in swept
    columns = chosen_columns(table, _columns(tuple(percentiles)), (*USUAL, *(ON_A_HOLE if plays else ())))
    if not plays and (named := [name for name in ON_A_HOLE if name in columns]):
        raise InputError("hole", None, f'give it, as in hole = {{ length = "400 yd" }}, for {named[0]}')

    def compute(task: Values) -> dict[str, Any]:
        name = task.get("golfer", table.get("golfer"))
        golfer, own = changed_golfer(golfers[name], task), clubs.get(name)
        options = shot_inputs.single(task, None if own is None else own.replace(hand=golfer.hand))
        if delivery := options.pop("delivery"):
            raise _of_golfer(*next(iter(delivery.items())))
        found = dispersion(
            golfer, **options, **shot_inputs.conditions.at(task), count=count, threads=1,
            seed=int(task.get("seed", seed)),
            hole=changed_hole(held, task),
        )  # fmt: skip
        figures: dict[str, Any] = {"lost": found.lost / found.count, "strokes": found.strokes, "gained": found.gained}
        figures |= found.lies
        for name in found.quantities:
            figures |= {f"{name}_mean": found.mean(name), f"{name}_deviation": found.spread(name)}
            figures |= {f"{name}_p{each}": found.quantile(name, each / 100) for each in percentiles}
        long, short = found.ellipse(share / 100).half_axes.tolist()
        return {**figures, "ellipse_long": long, "ellipse_short": short, "ellipse_area": math.pi * long * short}

    return OneByOne(study, columns, compute, elements=bool(shot_inputs.depends_on))


KIND = Kind(
    name="dispersion", keys=(*KEYS, "golfer", "shots", "seed", "hole", "percentiles", "ellipse", "outputs"),
    swept=_swept, task=_task,
)  # fmt: skip
