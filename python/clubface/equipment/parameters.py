"""Parameter sets of the models: values with units and bounds, their files, and the strikes they were made for.

Sets of model parameters: the published ones, and the user's own.

Files of parameter sets, one file a source.

A file names its source and holds one or more ``[[set]]``, each with the model and club it was found for, its
values with units, and what must be said of them::

    title = "My range session"
    reference = "42 drives, June"

    [[set]]
    model = "volumetric"
    club = "driver"                       # driver, 7-iron or any
    [set.range]                           # optional: the shots it was found from
    speed = ["101 mph", "118 mph"]
    [set.values]
    stiffness = "6.25e9 N/m3"
    ...
    [set.value_caveats]
    stiffness = "not identifiable from launch data"

Values of parameters: texts with units to SI, and their bounds.

The strikes that models and parameter sets were made for; outside, nothing tells how near they are.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any, NamedTuple, Self, TypeVar

from clubface import units
from clubface.equipment.backends import MODULES, OWN
from clubface.equipment.models import Model, Parameter, model
from clubface.errors import ClubfaceError, InputError, UnknownNameError
from clubface.support.checks import Frozen, check_choice
from clubface.support.files import DATA
from clubface.support.strict_toml import Document, quoted


def _dimension(parameter: Parameter) -> str:
    return units.unit(parameter.unit, name=parameter.name).dimension


def parsed(value: Any, parameter: Parameter) -> Any:
    """Return a value, which may be an array, in SI."""
    return units.parse_values(value, _dimension(parameter), name=parameter.name)


def parsed_scalar(value: Any, parameter: Parameter) -> float:
    """Return a single value in SI."""
    return units.parse(value, _dimension(parameter), name=parameter.name)


def checked(value: Any, parameter: Parameter) -> Any:
    """Return ``value`` as float or float64 array, refused where it is outside the bounds of ``parameter``."""
    value = parsed(value, parameter)
    low = value if isinstance(value, float) else value.min(initial=parameter.upper)
    high = value if isinstance(value, float) else value.max(initial=parameter.lower)
    if not (low >= parameter.lower and high <= parameter.upper):
        outside = low if not low >= parameter.lower else high
        symbol = parameter.unit
        allowed = f"from {units.show(parameter.lower, symbol)} to {units.show(parameter.upper, symbol)}"
        raise InputError(parameter.name, units.show(float(outside), symbol), allowed)
    return value


Range = Mapping[str, tuple[float, float]]
"""Least and greatest value [SI] by quantity."""


class Bounded(NamedTuple):
    """A quantity of a strike: in words, and the unit people read it in."""

    words: str
    unit: str


QUANTITIES = {
    "speed": Bounded("clubhead speed", "mph"),
    "incidence": Bounded("angle between path and face normal", "deg"),
    "friction": Bounded("friction", "1"),
    "club_mass": Bounded("mass of the head", "g"),
    "characteristic_time": Bounded("characteristic time", "us"),
    "ball_backspin": Bounded("backspin before impact", "rpm"),
    "ball_sidespin": Bounded("sidespin before impact", "rpm"),
    "ball_riflespin": Bounded("riflespin before impact", "rpm"),
}
"""What a range can be of: inputs of a shot, ``friction`` of the model's parameters, and ``incidence``, the angle
between the velocity of the clubhead and the normal at the face centre."""

RANGES: Mapping[str, Range] = {
    "response": {
        "speed": (10.0, 65.0),
        "incidence": (0.0, math.radians(72.0)),
        "friction": (0.05, 0.6),
        "club_mass": (0.16, 5.0),
        "characteristic_time": (0.0, 350e-6),
        **dict.fromkeys(("ball_backspin", "ball_sidespin", "ball_riflespin"), (-100.0 * math.pi, 100.0 * math.pi)),
    }
}
"""Ranges by model: the strikes from which its parameters come for every ball. The strikes by finite elements to which
``response`` is fitted are made from its range. Places on the face are not bounded: off centre a head gives way more
easily, and the small heads among the strikes do so as much as the built-in clubs 30 mm beside the face centre."""


OF_THE_RANGE = " of the range"
"""How an error about one quantity of a range names it."""


def checked_range(given: Mapping[str, Any]) -> Range:
    """Return a range in SI from pairs of values, each text with a unit or an SI number."""
    found = {}
    for name, ends in given.items():
        check_choice("quantity of a range", name, QUANTITIES)
        if not (isinstance(ends, (list, tuple)) and len(ends) == 2):
            raise InputError(name + OF_THE_RANGE, ends, "two values, the least and the greatest")
        dimension = units.unit(QUANTITIES[name].unit).dimension
        least, most = (units.parse(each, dimension, name=name + OF_THE_RANGE) for each in ends)
        if not least <= most:
            raise InputError(name + OF_THE_RANGE, list(ends), "two values, the least first")
        found[name] = (least, most)
    return Frozen(found)


def in_words(of: Range) -> str:
    """Return a range in words: "clubhead speed 101 to 118 mph"."""
    return ", ".join(f"{QUANTITIES[name].words} {ends_in_words(name, of)}" for name in of)


def ends_in_words(name: str, of: Range) -> str:
    """Return the ends of one quantity of a range: "101 to 118 mph"."""
    least, most = of[name]
    return f"{units.show(least, QUANTITIES[name].unit, 4).split()[0]} to {units.show(most, QUANTITIES[name].unit, 4)}"


FILE_KEYS = ("title", "reference", "set")
TEXTS = ("model", "club", "variant", "source")
FLAGS = {"default": False, "includes_face": True}
"""Keys of yes or no, and what is taken where they are left out."""
SET_KEYS = (*TEXTS, *FLAGS, "characteristic_time", "caveats", "range", "values", "value_caveats")


def entries(document: Document) -> list[dict[str, Any]]:
    """Return the tables [[set]] of a document, whose own keys are checked."""
    data = document.data
    document.check_keys(data, FILE_KEYS, ("title", "reference", "set"))
    document.check_text(data, ("title", "reference"))
    found = data["set"]
    if not (isinstance(found, list) and found and all(isinstance(each, dict) for each in found)):
        raise document.error("there must be at least one [[set]]", "set")
    return found


def check_entry(document: Document, entry: dict[str, Any], index: int) -> Model:
    """Check the keys and kinds of one [[set]], its numbers not yet; return its model."""
    document.check_keys(entry, SET_KEYS, ("model", "club", "values"), "set", index)
    document.check_text(entry, TEXTS, "set", index)
    caveats = entry.get("caveats", [])
    if not (isinstance(caveats, list) and all(isinstance(each, str) for each in caveats)):
        raise document.error("caveats must be a list of texts", "caveats", "set", index)
    for key, usual in FLAGS.items():
        if not isinstance(entry.get(key, usual), bool):
            raise document.error(f"{key} must be true or false", key, "set", index)
    values, value_caveats, within = entry["values"], entry.get("value_caveats", {}), entry.get("range", {})
    if not all(isinstance(each, dict) for each in (values, value_caveats, within)):
        raise document.error("values, value_caveats and range must be tables", "values", "set", index)
    try:
        declared = model(entry["model"])
    except ClubfaceError as error:
        raise document.wrap(error, "set", index) from error
    names = [each.name for each in declared.parameters]
    document.check_keys(values, names, names, "set.values", index)
    document.check_keys(value_caveats, names, (), "set.value_caveats", index)
    document.check_text(value_caveats, value_caveats, "set.value_caveats", index)
    document.check_keys(within, QUANTITIES, (), "set.range", index)
    return declared


FAMILIES = ("driver", "7-iron", "any")
T = TypeVar("T")
_TOLD = 5
"""How many names of values are told one by one."""


@dataclass(frozen=True, kw_only=True)
class ParameterSet:
    """Values of all parameters of one model.

    Attributes
    ----------
    model
        Name of the model.
    club
        The family of clubs they were found for: "driver", "7-iron" or "any".
    name
        Name of the set: the source, with a variant after a slash where it has several.
    values
        Value of every parameter, SI; an array where a batch varies it.
    source
        Where in the publication the values stand.
    reference
        The publication.
    caveats
        What a reader of results must know of the set.
    value_caveats
        The same for single parameters, by name.
    default
        Whether this is the set used where none is named.
    includes_face
        Whether the values describe ball and face together, as all do that were found from shots of a club: its
        characteristic time must not count twice, see :meth:`beside`. False if they describe the ball alone. The sets of
        finite elements never include the face.
    characteristic_time
        That of the face which the values include [s]; None where nobody said, and where they include none.
    range
        The strikes that the values were made for; that of the model unless given.
    unchosen
        The parameters whose values nobody chose, neither themselves nor with a set: a ball may have its own.
    """

    model: str
    club: str
    name: str
    values: Mapping[str, Any]
    source: str = ""
    reference: str = ""
    caveats: tuple[str, ...] = ()
    value_caveats: Mapping[str, str] = field(default_factory=dict)
    default: bool = False
    includes_face: bool = True
    characteristic_time: float | None = None
    range: Range = field(default_factory=dict)
    unchosen: frozenset[str] = field(default=frozenset(), compare=False, repr=False)

    def __post_init__(self) -> None:
        declared = model(self.model)
        check_choice("club", self.club, FAMILIES)
        for key in (*self.values, *self.value_caveats):
            declared.parameter(key)
        missing = [each.name for each in declared.parameters if each.name not in self.values]
        if missing:
            raise InputError("values", dict(self.values), f"complete for {self.model}; missing: {', '.join(missing)}")
        ordered = {each.name: checked(self.values[each.name], each) for each in declared.parameters}
        object.__setattr__(self, "values", Frozen(ordered))
        object.__setattr__(self, "value_caveats", Frozen(self.value_caveats))
        object.__setattr__(self, "caveats", tuple(self.caveats))
        object.__setattr__(self, "range", checked_range(self.range or RANGES.get(self.model, {})))
        if self.model in MODULES:
            object.__setattr__(self, "includes_face", False)
        object.__setattr__(self, "characteristic_time", self._included())

    def _included(self) -> float | None:
        """Return the characteristic time of the face that the values include, checked."""
        if self.characteristic_time is None or not self.includes_face:
            return None
        time = units.parse(self.characteristic_time, "time", name="characteristic_time")
        if not time > 0.0:
            allowed = "above 0; for values of the ball alone set includes_face to false"
            raise InputError("characteristic_time", units.show(time, "us"), allowed)
        return time

    @property
    def units(self) -> dict[str, str]:
        """The SI unit of each value."""
        return {each.name: each.unit for each in model(self.model).parameters}

    def beside(self, club: Mapping[str, T]) -> dict[str, T | float]:
        """Return the inputs of a club as the core takes them together with these parameters.

        Models use what its face gives beyond the one that the values include. Where nobody said which that is, it is
        the club's own; and of a club whose characteristic time is 0, which is also what a file means that has none, it
        is taken that it has the included one.
        """
        if not self.includes_face:
            return {**club, "included_time": 0.0}
        own: Any = club["characteristic_time"]
        if self.characteristic_time is None:
            return {**club, "included_time": own}
        if isinstance(own, float):
            own = own or self.characteristic_time
        else:
            own = own + (own == 0.0) * self.characteristic_time
        return {**club, "characteristic_time": own, "included_time": self.characteristic_time}

    def columns(self) -> list[Any]:
        """Return the values in the order of the registry, as the core takes them."""
        return list(self.values.values())

    def replace(self, **changes: Any) -> Self:
        """Return the set with values changed, each text with a unit, an SI number or an array: ``friction="0.4"``."""
        declared: Model = model(self.model)
        new = {key: parsed(value, declared.parameter(key)) for key, value in changes.items()}
        kept = {key: text for key, text in self.value_caveats.items() if key not in changes}
        source = self.source + (f"; changed: {', '.join(changes)}" if changes else "")
        return replace(
            self,
            values={**self.values, **new},
            value_caveats=kept,
            source=source,
            default=False,
            unchosen=self.unchosen - changes.keys(),
        )

    def of_ball(self, name: str, values: Mapping[str, float]) -> Self:
        """Return the set with the values that the ball called ``name`` has for the model, where nobody chose one."""
        own = {key: value for key, value in values.items() if key in self.unchosen}
        if not own:
            return self
        # The face is in one of the values: with that of the ball it is out.
        includes_face = self.includes_face and model(self.model).face_in not in own
        if own.items() <= self.values.items():
            return replace(self, includes_face=includes_face)
        told = ", ".join(own) if len(own) <= _TOLD else f"{len(own)} values"
        source = f"{self.source}; of the ball {name}: {told}"
        return replace(self, values={**self.values, **own}, source=source, default=False, includes_face=includes_face)

    @classmethod
    def defaults(cls, model_name: str, club: str = "any") -> Self:
        """Return the defaults of the registry, with the face of the published set for a driver if they include it."""
        declared = model(model_name)
        values = {each.name: each.default for each in declared.parameters}
        includes_face = declared.face_in is not None or model_name in OWN
        return cls(
            model=model_name,
            club=club,
            name="registry defaults",
            values=values,
            source="defaults of the registry",
            includes_face=includes_face,
            characteristic_time=cls.builtin(model_name, "driver").characteristic_time if declared.face_in else None,
            unchosen=frozenset(values),
        )

    @classmethod
    def builtin(cls, model_name: str, club: str, name: str | None = None) -> ParameterSet:
        """Return the default published set of a model and family of clubs, or the one called ``name``."""
        check_choice("club", club, FAMILIES)
        fitting = [each for each in builtin_sets(model_name) if club in (each.club, "any") or each.club == "any"]
        if name is None:
            fitting = [each for each in fitting if each.default]
        elif name in (known := dict.fromkeys(each.name for each in fitting)):
            fitting = [each for each in fitting if each.name == name]
        else:
            raise UnknownNameError(f"parameter set of {model_name} for {club}", name, known)
        if not fitting:
            return cls.defaults(model_name, club)
        return fitting[0] if name is not None else replace(fitting[0], unchosen=frozenset(fitting[0].values))

    @classmethod
    def from_toml(
        cls, path: str | os.PathLike[str], *, model: str | None = None, club: str | None = None
    ) -> ParameterSet:
        """Read the set in a file; where it holds several, ``model`` and ``club`` choose one."""
        document = Document.read(path)
        return _choose(read_sets(document), document, model, club)

    def to_toml(self) -> str:
        """Write the set, whose values must be scalars, as TOML that :meth:`from_toml` reads back exactly."""
        for key, value in self.values.items():
            if not isinstance(value, float):
                raise InputError(key, value, "a single number to be written to a file")
        name, _, variant = self.name.partition("/")
        lines = [f"title = {quoted(name)}", f"reference = {quoted(self.reference)}", "", "[[set]]"]
        lines += [
            f"model = {quoted(self.model)}",
            f"club = {quoted(self.club)}",
            f"source = {quoted(self.source)}",
        ]
        lines += [f"variant = {quoted(variant)}"] if variant else []
        lines += [] if self.includes_face else ["includes_face = false"]
        if self.characteristic_time is not None:
            lines += [f'characteristic_time = "{self.characteristic_time!r} s"']
        lines += ["caveats = [" + ", ".join(quoted(text) for text in self.caveats) + "]"]
        lines += ["[set.range]"] if self.range else []
        lines += [f"{name} = [{least!r}, {most!r}]" for name, (least, most) in self.range.items()]
        lines += ["[set.values]"]
        lines += [
            f"{key} = {quoted(f'{value!r} {unit}')}"
            for (key, value), unit in zip(self.values.items(), self.units.values(), strict=True)
        ]
        lines += [
            "[set.value_caveats]",
            *(f"{key} = {quoted(text)}" for key, text in self.value_caveats.items()),
        ]
        return "\n".join(lines) + "\n"


@cache
def builtin_sets(model_name: str | None = None) -> tuple[ParameterSet, ...]:
    """Return the published sets (of one model), those used by default first."""
    if model_name is not None:
        model(model_name)
        return tuple(each for each in builtin_sets() if each.model == model_name)
    found = [
        each
        for path in sorted((DATA / "parameters").glob("*.toml"))
        for each in read_sets(Document.read(path), path.stem)
    ]
    return tuple(sorted(found, key=lambda each: not each.default))


def read_sets(document: Document, name: str | None = None) -> list[ParameterSet]:
    """Read all sets of a document; ``name`` (else the title) names them."""
    found = entries(document)
    return [_read_set(document, each, index, name or document.data["title"]) for index, each in enumerate(found)]


def _read_set(document: Document, entry: dict[str, Any], index: int, name: str) -> ParameterSet:
    declared = check_entry(document, entry, index)
    variant = f"/{entry['variant']}" if "variant" in entry else ""
    try:
        return ParameterSet(
            model=entry["model"],
            club=entry["club"],
            name=name + variant,
            values={key: parsed_scalar(value, declared.parameter(key)) for key, value in entry["values"].items()},
            source=entry.get("source", ""),
            reference=document.data["reference"],
            caveats=tuple(entry.get("caveats", [])),
            value_caveats=entry.get("value_caveats", {}),
            characteristic_time=entry.get("characteristic_time"),
            range=entry.get("range", {}),
            **{key: entry.get(key, usual) for key, usual in FLAGS.items()},
        )
    except ClubfaceError as error:
        at = str(getattr(error, "parameter", ""))
        names = [each.name for each in declared.parameters]
        table = "set.values" if at in names else "set.range" if at.endswith(OF_THE_RANGE) else "set"
        raise document.wrap(error, table, index) from error


def _choose(sets: list[ParameterSet], document: Document, model_name: str | None, club: str | None) -> ParameterSet:
    fitting = [
        each for each in sets if model_name in (None, each.model) and (club is None or each.club in (club, "any"))
    ]
    if len(fitting) == 1:
        return fitting[0]
    held = "; ".join(f"{each.model} for {each.club}" for each in sets)
    raise document.error(f"{'no' if not fitting else 'more than one'} set fits; the file holds: {held}")
