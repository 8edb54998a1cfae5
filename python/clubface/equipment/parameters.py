"""Parameter sets of the models, published or your own: values, bounds, files, and the range they cover.

Each file holds the sets of one source as ``[[set]]`` tables, each with the model and club that it was fitted to, its
values with units, and caveats::

    title = "My range session"
    reference = "42 drives, June"

    [[set]]
    model = "volumetric"
    club = "driver"                       # driver, 7-iron or any
    [set.range]                           # optional: the shots it was fitted to
    speed = ["101 mph", "118 mph"]
    [set.values]
    stiffness = "6.25e9 N/m3"
    ...
    [set.value_caveats]
    stiffness = "not identifiable from launch data"

Outside the range of a model or parameter set, its error is unknown.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from typing import TYPE_CHECKING, Any, Self, TypeVar

from clubface import units
from clubface.equipment.models import MODULES, OWN, Model, Parameter, model, model_names, models
from clubface.errors import FileError, InputError, UnknownNameError
from clubface.schema.document import Document, Place
from clubface.schema.tables import check_values, decode, encode, file_key
from clubface.schema.values import FLAG, TEXT, Choice, Interval, Items, PhysicalValue, Record, Simple, Tables, Value
from clubface.support.checks import Frozen, check_choice
from clubface.support.files import DATA

if TYPE_CHECKING:
    from clubface.support.arrays import NumberOrArray, ValueLike


def _dimension(parameter: Parameter) -> str:
    return units.unit(parameter.unit, name=parameter.name).dimension


def parsed(value: Any, parameter: Parameter) -> Any:
    """Return a value, or array of values, in SI."""
    return units.parse_values(value, _dimension(parameter), name=parameter.name)


def checked(value: Any, parameter: Parameter) -> Any:
    """Return ``value`` as float or float64 array; raise InputError outside the bounds of ``parameter``."""
    value = parsed(value, parameter)
    low = value if isinstance(value, float) else value.min(initial=parameter.upper)
    high = value if isinstance(value, float) else value.max(initial=parameter.lower)
    if not (low >= parameter.lower and high <= parameter.upper):
        outside = low if not low >= parameter.lower else high
        symbol = parameter.unit
        allowed = f"from {units.show(parameter.lower, symbol)} to {units.show(parameter.upper, symbol)}"
        raise InputError(parameter.name, units.show(float(outside), symbol), allowed)
    return value


@dataclass(frozen=True)
class ParameterValue(Value):
    """Type of a single value of a model parameter."""

    parameter: Parameter

    def read(self, given: Any, place: Place) -> float:
        """Read a value [SI] and check its bounds."""
        return checked(units.parse(given, _dimension(self.parameter), name=self.parameter.name), self.parameter)

    def json(self) -> dict[str, Any]:
        """Return the JSON schema: text or a number."""
        return PhysicalValue(self.parameter.unit).json()

    def words(self) -> str:
        """Describe the bounds with their unit."""
        return PhysicalValue(self.parameter.unit, self.parameter.lower, self.parameter.upper).words()


Range = Mapping[str, tuple[float, float]]
"""Minimum and maximum value [SI] by quantity."""


QUANTITIES = {each.name: each for declared in models().values() for each in declared.valid}
"""Quantities that a range may refer to: inputs of a shot, the parameter ``friction``, and ``incidence``, the angle
between clubhead velocity and the normal at the face centre."""

RANGES: Mapping[str, Range] = Frozen({
    name: Frozen({each.name: (each.lower, each.upper) for each in declared.valid})
    for name, declared in models().items()
    if declared.valid
})  # fmt: skip
"""Ranges by model: the strikes from which its parameters were derived, for every ball. The finite element strikes to
which ``response`` is fitted were generated from its range. Positions on the face are not limited: a head gives way more
easily off centre, but the small heads among the strikes do so as much as built-in clubs 30 mm off the face centre."""


EXAMPLE = '["101 mph", "118 mph"]'
RANGE = Record(
    {name: Interval(PhysicalValue(each.reading), EXAMPLE, is_range=False) for name, each in QUANTITIES.items()}
)
"""Type of a table of ranges."""


def in_words(limits: Range) -> str:
    """Describe a range: "clubhead speed 101 to 118 mph"."""
    return ", ".join(f"{QUANTITIES[name].label} {ends_in_words(name, limits)}" for name in limits)


def ends_in_words(name: str, limits: Range) -> str:
    """Describe the limits of one quantity in a range: "101 to 118 mph"."""
    least, most = (units.show(each, QUANTITIES[name].reading, 4) for each in limits[name])
    return f"{least.split()[0]} to {most}"


FAMILIES = ("driver", "7-iron", "any")
INCLUDED_TIME = PhysicalValue("us", above=0, allowed="above 0; for values of the ball alone set includes_face to false")


def _make_set(given: dict[str, Any], place: Place) -> dict[str, Any]:
    """Return the contents of a table [[set]], with values checked for its model."""
    kinds = {each.name: ParameterValue(each) for each in model(given["model"]).parameters}
    given["values"] = Record(kinds, kinds).read(given["values"], place.key("values"))
    caveats = Record(dict.fromkeys(kinds, TEXT))
    return {**given, "value_caveats": caveats.read(given.get("value_caveats", {}), place.key("value_caveats"))}


SET = Record(
    {
        "model": Choice(model_names),
        "club": Choice(FAMILIES),
        "variant": TEXT,
        "source": TEXT,
        "default": FLAG,
        "includes_face": FLAG,
        "characteristic_time": PhysicalValue("us"),
        "caveats": Items(TEXT),
        "range": RANGE,
        "values": Record(Simple()),
        "value_caveats": Record(TEXT),
    },
    required=("model", "club", "values"),
    make=_make_set,
)


@dataclass(frozen=True, kw_only=True)
class ParameterFile:
    """A file of parameter sets."""

    title: str = file_key(TEXT, "name of the source")
    reference: str = file_key(TEXT, "the publication, or the origin of the values")
    set: tuple[Mapping[str, Any], ...] = file_key(Tables(SET, least=1), "parameter sets, each with its model and club")

    def __post_init__(self) -> None:
        check_values(self)


T = TypeVar("T")
_MOST_NAMES = 5
"""Maximum number of changed values that are listed by name."""


@dataclass(frozen=True, kw_only=True)
class ParameterSet:
    """Values of all parameters of a model.

    Attributes
    ----------
    model
        Name of the model.
    club
        Family of clubs they were found for: "driver", "7-iron" or "any".
    name
        Name of the set: the source, followed by a slash and a variant if there are several.
    values
        Value of every parameter [SI]; an array if it varies over a batch.
    source
        Location of the values in the publication.
    reference
        The publication.
    caveats
        Caveats of the set, shown with every result.
    value_caveats
        Caveats of single parameters, by name.
    default
        Whether this is the default set.
    includes_face
        Whether the values describe ball and face together, as all values found from shots with a club do; the club's
        characteristic time must then not count twice, see :meth:`with_included_face`. False if they describe the ball
        alone. Sets for finite elements never include the face.
    characteristic_time
        Characteristic time of the included face [s]; None if unknown or if no face is included.
    range
        Range of strikes for which the values were made; default: the model's.
    unchosen
        Parameters left at their defaults, for which a ball may have its own values.
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
        object.__setattr__(
            self, "range", Frozen(RANGE.read(self.range or RANGES.get(self.model, {}), Place(name="range")))
        )
        if self.model in MODULES:
            object.__setattr__(self, "includes_face", False)
        time = self.characteristic_time if self.includes_face else None
        if time is not None:
            time = INCLUDED_TIME.read(time, Place(name="characteristic_time"))
        object.__setattr__(self, "characteristic_time", time)

    @property
    def units(self) -> dict[str, str]:
        """SI unit of each value."""
        return {each.name: each.unit for each in model(self.model).parameters}

    def with_included_face(self, club: Mapping[str, T]) -> dict[str, T | float]:
        """Return the inputs of a club in the core's format, adapted to these parameters.

        Models use the flexibility of the club's face beyond that included in the values. If the included characteristic
        time is unknown, it is assumed to be the club's. A club with a characteristic time of 0, the default in a file,
        is assumed to have the included face.
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

    def columns(self) -> list[NumberOrArray]:
        """Return the values in the order of the registry, for the core."""
        return list(self.values.values())

    def replace(self, **changes: ValueLike) -> Self:
        """Return a copy with values changed: text with a unit, SI numbers or arrays, as in ``friction="0.4"``."""
        declared: Model = model(self.model)
        new = {key: parsed(value, declared.parameter(key)) for key, value in changes.items()}
        kept = {key: text for key, text in self.value_caveats.items() if key not in changes}
        source = self.source + (f"; changed: {', '.join(changes)}" if changes else "")
        values, unchosen = {**self.values, **new}, self.unchosen - changes.keys()
        return replace(self, values=values, value_caveats=kept, source=source, default=False, unchosen=unchosen)

    def of_ball(self, name: str, values: Mapping[str, float]) -> Self:
        """Return the set with values of the ball ``name`` in place of parameters left at their defaults."""
        own = {key: value for key, value in values.items() if key in self.unchosen}
        if not own:
            return self
        # The face is included in one parameter; if the ball gives that one, the face is no longer included.
        includes_face = self.includes_face and model(self.model).face_in not in own
        if own.items() <= self.values.items():
            return replace(self, includes_face=includes_face)
        words = ", ".join(own) if len(own) <= _MOST_NAMES else f"{len(own)} values"
        source = f"{self.source}; of the ball {name}: {words}"
        return replace(self, values={**self.values, **own}, source=source, default=False, includes_face=includes_face)

    @classmethod
    def defaults(cls, model_name: str, club: str = "any") -> Self:
        """Return the registry defaults, with the face of the published driver set if they include it."""
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
        """Return the default published set for a model and family of clubs, or the set called ``name``."""
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
        """Read the set in a file; if there are several, ``model`` and ``club`` select one."""
        sets = read_sets(document := Document.read(path))
        fitting = [
            each for each in sets if model in (None, each.model) and (club is None or each.club in (club, "any"))
        ]
        if len(fitting) == 1:
            return fitting[0]
        held = "; ".join(f"{each.model} for {each.club}" for each in sets)
        message = f"{'no' if not fitting else 'more than one'} set fits; the file contains: {held}"
        raise FileError(document.path, None, message)

    def to_toml(self) -> str:
        """Return the set as TOML that :meth:`from_toml` reads back exactly; values must be scalars."""
        for key, value in self.values.items():
            if not isinstance(value, float):
                raise InputError(key, value, "a single number to be written to a file")
        name, _, variant = self.name.partition("/")
        values = {
            key: f"{value!r} {unit}"
            for (key, value), unit in zip(self.values.items(), self.units.values(), strict=True)
        }
        table = {
            "model": self.model, "club": self.club, "variant": variant, "source": self.source,
            "includes_face": None if self.includes_face else False, "characteristic_time": self.characteristic_time,
            "caveats": self.caveats, "range": self.range, "values": values, "value_caveats": self.value_caveats,
        }  # fmt: skip
        given = {key: value for key, value in table.items() if value is False or value}
        return encode(ParameterFile(title=name, reference=self.reference, set=(given,)))


@cache
def builtin_sets(model_name: str | None = None) -> tuple[ParameterSet, ...]:
    """Return the published sets, optionally of one model, default sets first."""
    if model_name is not None:
        model(model_name)
        return tuple(each for each in builtin_sets() if each.model == model_name)
    paths = sorted((DATA / "parameters").glob("*.toml"))
    every = [each for path in paths for each in read_sets(Document.read(path), path.stem)]
    return tuple(sorted(every, key=lambda each: not each.default))


def read_sets(document: Document, name: str | None = None) -> list[ParameterSet]:
    """Read all sets of a document; they are named by ``name``, or else its title."""
    file = decode(ParameterFile, document)
    sets = []
    for index, given in enumerate(file.set):
        variant = f"/{given['variant']}" if "variant" in given else ""
        values = {key: each for key, each in given.items() if key != "variant"}
        with Place(document).key("set").item(index).errors():
            sets.append(ParameterSet(name=(name or file.title) + variant, reference=file.reference, **values))
    return sets
