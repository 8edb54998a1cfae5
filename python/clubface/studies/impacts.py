"""Studies of impacts and the flights that follow: any input of a shot swept, by any model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeGuard

from clubface.equipment.backends import MODULES
from clubface.equipment.balls import ball as ball_of
from clubface.equipment.clubs import Club, club as club_of
from clubface.equipment.described import HANDS
from clubface.equipment.models import DEFAULT_MODEL, model as model_of, models
from clubface.equipment.parameters import ParameterSet
from clubface.errors import ClubfaceError, InputError, RangeWarning, RuleWarning, Told
from clubface.simulation.flight import fly
from clubface.simulation.flight_inputs import check_conditions
from clubface.simulation.impact import impact
from clubface.simulation.inputs import parameter_set
from clubface.simulation.outside import Tally
from clubface.simulation.quantities import flight_outputs, inputs, outputs
from clubface.simulation.run_options import tolerance
from clubface.studies.axes import Swept, number
from clubface.studies.kinds import Column, Computed, Described
from clubface.support.checks import check_choice, check_names
from clubface.support.processor import vector_units
from clubface.support.shipped import is_path
from clubface.support.warning import without_warnings

if TYPE_CHECKING:
    from numpy.typing import NDArray

USUAL = ("ball_speed", "launch", "azimuth", "backspin", "sidespin", "carry", "side", "total")
"""The quantities that are kept where nothing is said."""
CHOSEN = ("model", "club", "ball", "hand")
"""What has names: one shot after the other cannot have its own, so that shots are computed by these."""
CONDITIONS = ("air", "wind", "ground")
KEYS = ("model", "club", "ball", "hand", "parameters", "accuracy", "outputs", "held", *CONDITIONS)


class Impacts:
    """Launches and flights of a study. See :class:`clubface.studies.kinds.Task`."""

    columns: Mapping[str, Column]
    depends_on: Mapping[str, str]

    def __init__(self, study: Described) -> None:
        self._design, self._folder = study.design, study.folder
        self._table = table = study.table
        axes = {each.name: each for each in study.design.axes}
        self._choices = {name: axes[name].choices for name in CHOSEN if name in axes}
        for name in (each for each in axes if each in table or each in table.get("held", {})):
            raise InputError(name, Told("held and swept"), "given in one of both tables alone")
        if "club" not in axes and "club" not in table:
            raise InputError("club", None, 'give it, as in club = "driver"')
        # Files are read once: what they hold later is another study.
        named = self._choices.get
        self._clubs = {each: club_of(_resolved(each, self._folder)) for each in named("club") or [table["club"]]}
        self._balls = {
            each: ball_of(path) if is_path(path := _resolved(each, self._folder)) else each
            for each in named("ball") or [table.get("ball")]
        }
        every = {**outputs(), **flight_outputs()}
        self._outputs = tuple(table.get("outputs", USUAL))
        check_names("output", self._outputs, every)
        self.columns = {name: Column(every[name].unit, every[name].meaning) for name in self._outputs}
        self._flies = any(name in flight_outputs() for name in self._outputs)
        self._air = {name: table.get(name) for name in CONDITIONS}
        check_conditions(table.get("air"), table.get("wind"))
        self._parameters = [name for name in axes if name not in inputs() and name not in CHOSEN]
        self._accuracy = tolerance(table.get("accuracy"))
        names = _models(table, self._choices)
        self.depends_on = {"processor": vector_units()} if any(name in MODULES for name in names) else {}

    def run(self, indices: range) -> Computed:
        """Compute shots, those of the same club, ball, hand and model together."""
        import numpy as np

        values = self._design.values(indices)
        codes = {name: values.pop(name) for name in self._choices}
        found = {name: np.full(len(indices), np.nan) for name in self._outputs}
        failed: list[tuple[int, str]] = []
        tally = Tally()
        for chosen, rows in _alike(codes, len(indices)):
            names = {name: self._choices[name][code] for name, code in chosen.items()}
            launch, flight = self._shots(names, {name: each[rows] for name, each in values.items()})
            tally.add(launch)
            for name in self._outputs:
                found[name][rows] = (launch if name in outputs() else flight).get(name)
            reasons = {}
            for each in (*launch.problems, *(flight.problems if flight is not None else ())):
                reasons.setdefault(each.row[0] if each.row else 0, f"{each.parameter}: {each.reason}")
            places = np.arange(len(indices))[rows]
            failed += [(indices.start + int(places[row]), reason) for row, reason in reasons.items()]
        return Computed(found, sorted(failed), tally.counts())

    def _shots(self, names: Mapping[str, str], values: Mapping[str, NDArray[Any]]) -> tuple[Any, Any]:
        """Return launches and flights, None where none are asked for, with what has names held."""
        table = {**self._table, **names}
        which, ball = self._clubs[table["club"]], self._balls[table.get("ball")]
        model = table.get("model", DEFAULT_MODEL)
        delivery = {name: each for name, each in values.items() if name not in self._parameters}
        changed = {name: values[name] for name in self._parameters}
        with without_warnings(RangeWarning), without_warnings(RuleWarning):
            launch = impact(
                which, {**table.get("held", {}), **delivery}, model=model, ball=ball, hand=table.get("hand"),
                parameters=_changed(_given(table, model, self._folder), changed, model, which),
                accuracy=self._accuracy, threads=1, on_error="nan",
            )  # fmt: skip
        return launch, fly(launch, **self._air, threads=1, on_error="nan") if self._flies else None


class ImpactKind:
    """See :class:`clubface.studies.kinds.Kind`."""

    name = "impact"
    keys = KEYS

    def swept(self, table: Mapping[str, Any], sweep: Mapping[str, Any]) -> Mapping[str, Swept]:
        """Return the inputs of a shot, the parameters of the models, and what has names."""
        named = {"club": Swept(None), "ball": Swept(None), "model": Swept(None, tuple(models()))}
        numbers = {name: Swept(each.unit) for name, each in inputs().items() if name != "hand"}
        given = sweep.get("model", table.get("model", DEFAULT_MODEL))
        parameters: dict[str, Swept] = {}
        for each in given if isinstance(given, list) else [given]:
            parameters |= {of.name: Swept(of.unit) for of in model_of(each).parameters}
        return {**parameters, **numbers, **named, "hand": Swept(None, tuple(HANDS))}

    def files(self, study: Described) -> list[Path]:
        """Return the files of clubs, balls and parameters."""
        given = study.table.get("parameters")
        texts = [
            *(study.table.get(name) for name in ("club", "ball")),
            *(each for name in ("club", "ball") for each in study.sweep.get(name, ())),
            *([given] if isinstance(given, str) else given.values() if _is_by_model(given) else ()),
        ]
        return [study.folder / each for each in texts if isinstance(each, str) and is_path(each)]

    def prepare(self, study: Described) -> Impacts:
        """Return the task, when clubs, balls and parameters have been read once."""
        try:
            _check(study)
            return Impacts(study)
        except ClubfaceError as error:
            raise study.wrap(error) from None


KIND = ImpactKind()


def _check(study: Described) -> None:
    """Refuse what no shot can have, before one is computed."""
    table = study.table
    for name in ("club", "ball", "hand", "model"):
        if not isinstance(table.get(name, ""), str):
            raise InputError(name, table[name], "one name in quotes; several go to [sweep]")
    check_choice("hand", table.get("hand", "right"), HANDS)
    if not isinstance(table.get("outputs", []), list) or not table.get("outputs", USUAL):
        raise InputError("outputs", table["outputs"], 'a list of quantities, as in ["ball_speed", "carry"]')
    held = table.get("held", {})
    if not isinstance(held, Mapping):
        raise InputError("held", held, 'a table, as in held = { speed = "113 mph" }')
    check_names("input", held, [each for each in inputs() if each != "hand"])
    for name, value in held.items():
        number(name, value, inputs()[name].unit)
    swept = {each.name for each in study.design.axes}
    if "speed" not in held and "speed" not in swept:
        raise InputError("speed", None, 'give it under [sweep], or hold it, as in held = { speed = "113 mph" }')


def _models(table: Mapping[str, Any], choices: Mapping[str, Sequence[str]]) -> Sequence[str]:
    return choices.get("model", (table.get("model", DEFAULT_MODEL),))


def _resolved(which: Any, folder: Path) -> Any:
    """Return a name as it is, and the path of a file from the folder of the study."""
    return folder / which if isinstance(which, str) and is_path(which) else which


def _is_by_model(given: Any) -> TypeGuard[Mapping[str, Any]]:
    """Tell a table of parameters for each of several models from one of values."""
    return isinstance(given, Mapping) and given.keys() <= set(models())


def _given(table: Mapping[str, Any], model: str, folder: Path) -> Any:
    """Return the parameters that are given for a model: of several models, those under its name."""
    given = table.get("parameters")
    if _is_by_model(given):
        given = given.get(model)
    return _resolved(given, folder)


def _changed(given: Any, changed: Mapping[str, Any], model: str, which: Club) -> Any:
    """Return the parameters with those that are swept in place of their own."""
    if not changed:
        return given
    chosen: ParameterSet = parameter_set(model, which, given)
    return chosen.replace(**changed)


def _alike(codes: Mapping[str, NDArray[Any]], count: int) -> list[tuple[dict[str, int], Any]]:
    """Return each combination of names that occurs, and its rows."""
    import numpy as np

    if not codes:
        return [({}, slice(None))]
    rows, which = np.unique(np.stack([*codes.values()], axis=1), axis=0, return_inverse=True)
    return [
        (dict(zip(codes, map(int, row), strict=True)), np.flatnonzero(which.reshape(count) == place))
        for place, row in enumerate(rows)
    ]
