"""Inputs common to all studies of shots: club, ball, model, and conditions, fixed or swept."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeGuard

from clubface.equipment.balls import RIGID, ball as ball_of
from clubface.equipment.clubs import CLUB_PROPERTIES, Club, club as club_of
from clubface.equipment.described import FLAT, HANDS
from clubface.equipment.models import DEFAULT_MODEL, MODULES, OWN, model as model_of, models
from clubface.equipment.parameters import ParameterSet, read_sets
from clubface.errors import InputError, UnknownNameError
from clubface.schema import Choice, Document, PhysicalValue, Record, Simple, Value
from clubface.simulation.flight import LEVEL, Air, check_conditions, conditions, ground_of
from clubface.simulation.inputs import parameter_set, tolerance
from clubface.simulation.results import flight_inputs, inputs
from clubface.studies.axes import Swept, number
from clubface.studies.kinds.kind import ONE_NAME, DescribedStudy, resolved
from clubface.support.files import is_path
from clubface.support.processes import vector_units

CHOSEN = ("model", "club", "ball", "hand")
"""Inputs with names; shots are grouped by them, as they cannot vary within an array."""
CONDITIONS = ("air", "wind", "ground")
WANTED = {
    "club": 'give it, as in club = "driver"',
    "speed": 'give it under [sweep], or hold it, as in held = { speed = "113 mph" }',
}  # fmt: skip
OF_CLUB = {"club_mass": "mass", "static_loft": "loft"}
OF_CLUB |= {name: name for name in CLUB_PROPERTIES if name not in ("mass", "loft", "cor")}
"""Field of a club, by the shot input with its value."""
OF_WIND = {"wind_x": "m/s", "wind_y": "m/s", "wind_z": "m/s", "wind_speed": "m/s", "wind_direction": "rad"}
OF_AIR = {name: "m" if name == "altitude" else flight_inputs()[name].unit for name in Air.__dataclass_fields__}
OF_GROUND = {name: each.unit for name, each in flight_inputs().items() if each.group == "ground"}
"""Units of numeric conditions."""
HELD = {
    name: PhysicalValue(each.unit, special={FLAT: math.inf} if name in ("bulge", "roll") else {})
    for name, each in inputs().items()
    if name != "hand"
}
KEYS: Mapping[str, Value] = {
    **dict.fromkeys(("club", "ball", "model"), ONE_NAME),
    "hand": Choice(HANDS),
    "parameters": Simple("a set by name, a file, or a table of values"),
    "accuracy": Simple("a number"),
    "held": Record(HELD, example='{ speed = "113 mph" }'),
    **dict.fromkeys(CONDITIONS, Simple("a table of numbers")),
}
"""Keys common to the tables of all studies of shots."""
BY_GROUP = dict(zip(CONDITIONS, (OF_AIR, OF_WIND, OF_GROUND), strict=True))


def swept_conditions() -> dict[str, Swept]:
    """Return the sweepable numbers of air, wind and ground."""
    return {name: Swept(unit, group=group) for group, known in BY_GROUP.items() for name, unit in known.items()}


def swept_shots(table: Mapping[str, Any], sweep: Mapping[str, Any]) -> dict[str, Swept]:
    """Return the sweepable inputs of a shot: inputs, parameters of its models, conditions, and names."""
    named = {"club": Swept(None), "ball": Swept(None), "model": Swept(None, tuple(models()))}
    numbers = {name: Swept(each.unit) for name, each in inputs().items() if name != "hand"}
    given = sweep.get("model", table.get("model", DEFAULT_MODEL))
    parameters: dict[str, Swept] = {}
    for each in given if isinstance(given, list) else [given]:
        if isinstance(each, str) and each in OWN:
            raise InputError("model", each, "one of the package: a law of your own is known only in one process")
        parameters |= {parameter.name: Swept(parameter.unit) for parameter in model_of(each).parameters}
    return {**parameters, **numbers, **swept_conditions(), **named, "hand": Swept(None, tuple(HANDS))}


def is_parameter(name: str) -> bool:
    """Return whether a sweepable input of a shot is a model parameter."""
    return name not in {*inputs(), *CHOSEN, *swept_conditions()}


class Conditions:
    """Air, wind and ground of flights, fixed or swept."""

    def __init__(self, study: DescribedStudy) -> None:
        self._held = {group: study.table.get(group) for group in CONDITIONS}
        for group, known in BY_GROUP.items():
            held = self._held[group]
            swept = [each.name for each in study.design.axes if each.name in known]
            if swept and not isinstance(held or {}, Mapping):
                raise InputError(group, held, f"a table of {', '.join(known)}, since {swept[0]} is swept")
            if isinstance(held, Mapping):
                for name, value in held.items():
                    if name in known:
                        number(name, value, known[name])
        # Swept values may leave their range in some tasks; whether they fit the fixed inputs is known now.
        first = self.at({name: float(each[0]) for name, each in study.design.values(range(1)).items()})
        conditions(**first)
        check_conditions(**{group: None if first[group] != held else held for group, held in self._held.items()})

    def at(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return air, wind and ground as a flight takes them, for swept ``values``; other values are ignored."""
        groups = dict(self._held)
        for group, known in BY_GROUP.items():
            if changed := {name: each for name, each in values.items() if name in known}:
                groups[group] = {**(groups[group] or {}), **changed}
        return groups


class ShotInputs:
    """Shots of a study with fixed and swept inputs."""

    def __init__(self, study: DescribedStudy, *, needs: Sequence[str] = ("club", "speed")) -> None:
        _check(study, needs)
        self._folder = study.folder
        self.table = table = study.table
        axes = {each.name: each for each in study.design.axes}
        self.choices = {name: axes[name].choices for name in CHOSEN if name in axes}
        # Files are read once; later changes would make another study.
        named = self.choices.get
        self._clubs = study.load("club", club_of) if {"club"} & {*axes, *table} else {}
        self._balls = study.load("ball", _ball)
        self.conditions = Conditions(study)
        self._held = {name: number(name, each, inputs()[name].unit) for name, each in table.get("held", {}).items()}
        known = swept_shots(table, study.sweep)
        self._parameters = [name for name in axes if name in known and is_parameter(name)]
        self._accuracy = tolerance(table.get("accuracy"))
        names = named("model") or (table.get("model", DEFAULT_MODEL),)
        for name in names:
            if is_path(given := _given(table, name, self._folder)):
                read_sets(Document.read(given))
        self.depends_on = {"processor": vector_units()} if any(name in MODULES for name in names) else {}
        for name in names:
            given = _given(table, name, self._folder)
            if isinstance(given, Mapping):
                dimensions = {each.name: each.unit for each in model_of(name).parameters}
                given = {key: number(key, each, dimensions.get(key, "1")) for key, each in given.items()}
            if self._clubs or isinstance(given, Mapping):
                try:
                    parameter_set(name, next(iter(self._clubs.values()), None) or club_of("driver"), given)
                except UnknownNameError as error:
                    known_sets = not isinstance(given, Mapping)
                    raise InputError("parameters", given, error.allowed) if known_sets else error from None

    def equipped(self, names: Mapping[str, str], values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the options of :func:`clubface.impact` for names and swept parameters."""
        table = {**self.table, **names}
        club = self._clubs.get(table.get("club"))
        model = table.get("model", DEFAULT_MODEL)
        given = _given(table, model, self._folder)
        changed = {name: values[name] for name in self._parameters}
        if changed:
            base: ParameterSet = parameter_set(model, club or club_of("driver"), given)
            given = base.replace(**changed)
        return {
            "club": club, "model": model, "parameters": given, "ball": self._balls[table.get("ball")],
            "accuracy": self._accuracy,
        }  # fmt: skip

    def single(self, task: Mapping[str, Any], club: Club | None = None) -> dict[str, Any]:
        """Return the options of :func:`clubface.impact` for one task, with swept properties of club and ball.

        ``club`` is used if neither the study nor the task names one.
        """
        names = {name: task[name] for name in self.choices}
        options = self.equipped(names, task)
        delivered = {name: each for name, each in task.items() if name in inputs() and name not in names}
        values = {**self._held, **delivered}
        of_club = {field: values.pop(name) for name, field in OF_CLUB.items() if name in values}
        of_ball = {name: values.pop(f"ball_{name}") for name in RIGID if f"ball_{name}" in values}
        hand = {**self.table, **names}.get("hand")
        of_club |= {} if hand is None else {"hand": HANDS[hand]}
        own: Any = options["club"] or club
        options["club"] = own.replace(**of_club) if of_club else own
        if of_ball:
            options["ball"] = ball_of(options["ball"]).replace(**of_ball)
        return {**options, "delivery": values}

    def delivered(self, names: Mapping[str, str], values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the fixed and swept inputs of shots."""
        hand = {**self.table, **names}.get("hand")
        swept = {name: each for name, each in values.items() if name in inputs()}
        return {**self.table.get("held", {}), **swept, **({} if hand is None else {"hand": HANDS[hand]})}


ALTERNATIVES = (("altitude",), ("pressure",)), (LEVEL, ("wind_x", "wind_z"))
"""Alternative ways to give the same condition, only one of which a flight takes."""


def changed_table(table: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return a kind's table with changes; all other entries stay."""
    changed = {**table, **changes}
    for group in ("held", "parameters", *CONDITIONS):
        first, other = _values(group, table.get(group)), changes.get(group)
        if not first or not isinstance(other, Mapping) or (group == "parameters" and "model" in changes):
            continue
        if _is_by_model(first) and _is_by_model(other):
            changed[group] = {name: {**first.get(name, {}), **other.get(name, {})} for name in {**first, **other}}
        elif not (_is_by_model(first) or _is_by_model(other)):
            gone = replaced_by(other)
            changed[group] = {**{name: each for name, each in first.items() if name not in gone}, **other}
    return changed


def replaced_by(names: Iterable[str]) -> set[str]:
    """Return inputs together with their alternatives."""
    replaced = {*names}
    for one, two in ALTERNATIVES:
        if replaced & {*one, *two}:
            replaced |= {*two} if replaced & {*one} else {*one}
    return replaced


def _values(group: str, given: Any) -> Mapping[str, Any]:
    """Return a table's values for a group, by name; empty for a named parameter set."""
    if group == "wind" and isinstance(given, list) and len(given) == 3:
        return dict(zip(("wind_x", "wind_y", "wind_z"), given, strict=True))
    if group == "ground" and isinstance(given, str):
        return ground_of(given)
    return given if isinstance(given, Mapping) else {}


def _ball(named: Any) -> Any:
    """Return the ball of a file, or a name unchanged, as each backend has its own ball of that name."""
    made = ball_of(named)
    return made if is_path(named) else named


def _check(study: DescribedStudy, needs: Sequence[str]) -> None:
    """Raise errors for impossible inputs, before any shot is computed."""
    table = study.table
    held = table.get("held", {})
    swept = {each.name for each in study.design.axes}
    for name in needs:
        if name not in held and name not in swept and name not in table:
            raise InputError(name, None, WANTED[name])


def _is_by_model(given: Any) -> TypeGuard[Mapping[str, Any]]:
    """Return whether a table of parameters has a table for each of several models rather than values."""
    return isinstance(given, Mapping) and given.keys() <= set(models())


def _given(table: Mapping[str, Any], model: str, folder: Path) -> Any:
    """Return the parameters given for a model; with several models, those under its name."""
    given = table.get("parameters")
    if _is_by_model(given):
        given = given.get(model)
    return resolved(given, folder)
