"""Studies of golfers: dispersion, and optimisation with changing bounds, golfers, holes or air."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from clubface import units
from clubface.design.dispersion import COUNT, FLOWN, LAUNCHED, MOST as MOST_SHOTS, dispersion
from clubface.design.golfer import Golfer, golfer as golfer_of
from clubface.design.optimisation.landings import FREE, JUDGED
from clubface.design.optimisation.run import optimise
from clubface.design.optimisation.study import COUNTS, UNITS, DesignStudy, read
from clubface.design.strokes import Hole
from clubface.equipment.balls import ball as ball_of
from clubface.equipment.clubs import club as club_of
from clubface.errors import InputError
from clubface.schema import Items, Record, count, entries
from clubface.simulation.inputs import DIMENSIONS, OF_CLUB
from clubface.simulation.results import flight_outputs, inputs, outputs
from clubface.studies.axes import Swept, held_number
from clubface.studies.kinds.kind import ONE_NAME, OUTPUTS, Column, DescribedStudy, Kind, OneByOne
from clubface.studies.kinds.shot_inputs import BY_GROUP, KEYS, ShotInputs, swept_conditions, swept_shots
from clubface.support.checks import MOST_SEED

HOLE = ("length", "fairway", "rough", "green")


def swept_golfers() -> dict[str, Swept]:
    """Return the sweepable inputs of golfers and holes: means and spreads, mishits, and lengths."""
    swept = {f"{part}_{name}": Swept(inputs()[name].unit) for part in ("mean", "spread") for name in OF_CLUB}
    swept |= {name: Swept("1") for name in ("spread_factor", "mishit_share", "mishit_scale")}
    return swept | {f"hole_{name}": Swept("m") for name in HOLE} | {"golfer": Swept(None)}


def changed_golfer(golfer: Golfer, task: Mapping[str, Any]) -> Golfer:
    """Return a golfer with the swept figures of a task; correlations do not change."""
    mean, spread = np.array(golfer.mean), np.array(golfer.spread)
    for place, name in enumerate(golfer.variables):
        mean[place] = task.get(f"mean_{name}", mean[place])
        spread[place] = task.get(f"spread_{name}", spread[place])
    for name in task:
        part, _, variable = name.partition("_")
        if part in ("mean", "spread") and variable in OF_CLUB and variable not in golfer.variables:
            raise InputError(
                name, task[name], f"left out, since {variable} is not among the variables of {golfer.name}"
            )
    spread = spread * task.get("spread_factor", 1.0)
    if (spread < 0.0).any():
        raise InputError("spread", float(spread.min()), "at least 0")
    correlation = np.array(golfer.correlation)
    np.fill_diagonal(correlation, 1.0)
    mishits = {name: task[name] for name in ("mishit_share", "mishit_scale") if name in task}
    if not mishits and (spread == golfer.spread).all() and (mean == golfer.mean).all():
        return golfer
    # Figures that are not swept stay identical, bit for bit.
    same = (spread == golfer.spread)[:, None] & (spread == golfer.spread)
    covariance = np.where(same, golfer.covariance, correlation * np.outer(spread, spread))
    return golfer.replace(mean=mean, covariance=covariance, **mishits)


def changed_hole(hole: Hole | None, task: Mapping[str, Any]) -> Hole | None:
    """Return a hole with the swept lengths of a task; a swept length is enough to create one."""
    changes = {name: task[f"hole_{name}"] for name in HOLE if f"hole_{name}" in task}
    if not changes:
        return hole
    if hole is None and "length" not in changes:
        raise InputError("hole_length", None, 'sweep it, or give hole = { length = "400 yd" }')
    return Hole(**changes) if hole is None else replace(hole, **changes)


PERCENTILES = (10, 50, 90)
SHARE = 90
"""Default percentage of landings inside the ellipse."""
USUAL = (
    "carry_mean", "carry_deviation", "side_mean", "side_deviation", "total_mean", "total_deviation", "ball_speed_mean",
    "ellipse_area", "lost",
)  # fmt: skip
SEED = Swept("1", limits=(0, MOST_SEED))
ON_A_HOLE = ("strokes", "gained", "green", "fairway", "rough", "recovery")


def _columns(percentiles: tuple[int, ...]) -> dict[str, Column]:
    every = {**outputs(), **flight_outputs()}
    columns: dict[str, Column] = {}
    for name in (*LAUNCHED, *FLOWN):
        unit, meaning = every[name].unit, every[name].meaning
        columns[f"{name}_mean"] = Column(unit, f"mean over the shots: {meaning}")
        columns[f"{name}_deviation"] = Column(unit, f"standard deviation over the shots: {meaning}")
        for share in percentiles:
            columns[f"{name}_p{share}"] = Column(unit, f"what {share}% of the shots are below: {meaning}")
    columns |= {
        "ellipse_area": Column("m2", "area of the ellipse of the landings"),
        "ellipse_long": Column("m", "half its long axis"),
        "ellipse_short": Column("m", "half its short axis"),
        "lost": Column("1", "share of the shots without a result"),
        "strokes": Column("1", "strokes expected after the shot"),
        "gained": Column("1", "strokes gained on the average of the PGA Tour"),
    }
    return columns | {name: Column("1", f"share of the shots at rest: {name}") for name in ON_A_HOLE[2:]}


def _swept_dispersions(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    equipment = {name: each for name, each in swept_shots(table, sweep).items() if name not in DIMENSIONS}
    return {**equipment, **swept_golfers(), "seed": SEED}


def _of_golfer(name: str, value: Any) -> InputError:
    return InputError(name, value, "left out: the golfer says how the club is delivered")


def _dispersion_task(study: DescribedStudy) -> OneByOne:
    table = study.table
    swept = {each.name: each for each in study.design.axes}
    shot_inputs = ShotInputs(study, needs=())
    seed = held_number("seed", table.get("seed", 0), SEED)
    shots, share = table.get("shots", COUNT), table.get("ellipse", SHARE)
    percentiles = table.get("percentiles", PERCENTILES)
    if "golfer" not in table and "golfer" not in swept:
        raise InputError("golfer", None, 'give it, as in golfer = "tour-driver"')
    for name, value in table.get("held", {}).items():
        if name in DIMENSIONS:
            raise _of_golfer(name, value)
    golfers = study.load("golfer", golfer_of)
    clubs = {} if "club" in {*table, *swept} else {name: club_of(each.club) for name, each in golfers.items()}
    held = None
    if "hole" in table:
        if not {"length", "hole_length"} & {*table["hole"], *swept}:
            raise InputError("hole", table["hole"], 'a table with the length, as in hole = { length = "400 yd" }')
        held = Hole(**{"length": "400 yd", **table["hole"]})
    plays = held is not None or "hole_length" in swept
    columns = study.columns(_columns(tuple(percentiles)), (*USUAL, *(ON_A_HOLE if plays else ())))
    if not plays and (named := [name for name in ON_A_HOLE if name in columns]):
        raise InputError("hole", None, f'give it, as in hole = {{ length = "400 yd" }}, for {named[0]}')

    def compute(task: Mapping[str, Any]) -> dict[str, Any]:
        name = task.get("golfer", table.get("golfer"))
        golfer, own = changed_golfer(golfers[name], task), clubs.get(name)
        options = shot_inputs.single(task, None if own is None else own.replace(hand=golfer.hand))
        if delivery := options.pop("delivery"):
            raise _of_golfer(*next(iter(delivery.items())))
        result = dispersion(
            golfer, **options, **shot_inputs.conditions.at(task), count=shots, threads=1,
            seed=int(task.get("seed", seed)),
            hole=changed_hole(held, task),
        )  # fmt: skip
        figures: dict[str, Any] = {"lost": result.lost / result.count, **result.lies}
        figures |= {"strokes": result.strokes, "gained": result.gained}
        for name in result.quantities:
            figures |= {f"{name}_mean": result.mean(name), f"{name}_deviation": result.spread(name)}
            figures |= {f"{name}_p{each}": result.quantile(name, each / 100) for each in percentiles}
        long, short = result.ellipse(share / 100).half_axes.tolist()
        return {**figures, "ellipse_long": long, "ellipse_short": short, "ellipse_area": math.pi * long * short}

    return OneByOne(study, columns, compute, elements=bool(shot_inputs.depends_on))


DISPERSIONS = Kind(
    name="dispersion",
    keys={
        **KEYS, "golfer": ONE_NAME, "shots": count(1, MOST_SHOTS), "seed": count(0, MOST_SEED),
        "hole": Record({name: each.value for name, each in entries(Hole).items()}, example='{ length = "400 yd" }'),
        "percentiles": Items(count(1, 99)), "ellipse": count(1, 99), "outputs": OUTPUTS,
    },
    swept=_swept_dispersions, task=_dispersion_task,
)  # fmt: skip


ENDS = ("least", "most")
READERS: Mapping[str, Callable[[Any], Any]] = {"golfer": golfer_of, "club": club_of, "ball": ball_of}
"""Readers of inputs given by name or file."""
NAMED = (*READERS, "model")
COUNTED = ("shots", "seed", "starts")
"""Counts in ``COUNTS`` that may be swept."""


def _swept_optimisations(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    """Return the sweepable inputs: ends of bounds and limits, figures of golfers and holes, conditions, and names."""
    known = {**JUDGED, **UNITS}
    bounds = {f"variables_{name}_{end}": Swept(_unit(known[name])) for name in FREE for end in ENDS}
    limits = {f"limits_{name}_{end}": Swept(_unit(each)) for name, each in known.items() for end in ENDS}
    single = {"speed_exponent": Swept("1"), "discretionary_mass": Swept("kg")}
    single |= {name: Swept("1", limits=COUNTS[name]) for name in COUNTED}
    conditions, named = swept_conditions(), {name: Swept(None) for name in NAMED}
    return {**bounds, **limits, **swept_golfers(), **conditions, **single, **named}


def _unit(shown: str) -> str:
    """Return the SI unit with the dimension of a unit."""
    return units.SI_UNITS[units.unit(shown).dimension]


def _optimisation_task(study: DescribedStudy) -> OneByOne:
    if "file" not in study.table:
        raise InputError("file", None, 'the file of an optimisation, as in file = "better.toml"')
    asked = read(study.folder / study.table["file"])
    if not isinstance(asked, DesignStudy):
        raise InputError("file", study.table["file"], "an optimisation with variables, not a fitting")
    swept = {each.name for each in study.design.axes}
    parts = {name: study.load(name, read) for name, read in READERS.items() if name in swept}
    every = {
        name: Column(_unit(UNITS[name]), f"of the best club: {name.replace('_', ' ')}")
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

    def compute(task: Mapping[str, Any]) -> dict[str, Any]:
        changed = changed_study(asked, {**task, **{name: each[task[name]] for name, each in parts.items()}})
        optimum = optimise(changed, others=())
        figures = {**optimum.club, "alike": optimum.alike / optimum.starts}
        for name in asked.objectives:
            figures |= {f"{name}_{club}": optimum.fresh.value(club, name) for club in optimum.fresh.clubs}
            figures[f"{name}_error"] = optimum.fresh.error("start", name)
        return figures

    return OneByOne(study, study.columns(every, tuple(every)), compute)


def changed_study(study: DesignStudy, task: Mapping[str, Any]) -> DesignStudy:
    """Return an optimisation with the swept inputs of a task; all golfers change in the same way."""
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
                raise InputError(name, value, f"such that the lower bound of {field} is below its upper bound")
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


OPTIMISATIONS = Kind(
    name="optimise", keys={"file": ONE_NAME, "outputs": OUTPUTS}, swept=_swept_optimisations, task=_optimisation_task
)
