"""Options and arguments shared by commands, and how their texts become clubs, models and parameter sets."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Annotated, Any

import typer

from clubface.cli.failures import say
from clubface.errors import ClubfaceError, InputError, UnknownNameError


def _option(*names: str, panel: str, metavar: str, text: str) -> Any:
    return typer.Option(*names, metavar=metavar, rich_help_panel=panel, help=text, show_default=False)


def _delivery(name: str, example: str, text: str) -> Any:
    return _option(name, panel="Delivery (a value with its unit)", metavar=f'"{example}"', text=text)


ClubArgument = Annotated[str, typer.Argument(metavar="CLUB", help="Name of a built-in club, or a TOML file.")]
Speed = Annotated[str | None, _delivery("--speed", "113 mph", "Speed of the clubhead's CG. Required.")]
Attack = Annotated[str | None, _delivery("--attack", "-1.3 deg", "Attack angle: up is positive.")]
Path = Annotated[str | None, _delivery("--path", "2 deg", "Club path: to the right is positive.")]
Loft = Annotated[str | None, _delivery("--loft", "12.8 deg", "Dynamic loft; the club's static loft unless given.")]
Face = Annotated[str | None, _delivery("--face", "1 deg", "Face angle: to the right is positive.")]
Lie = Annotated[str | None, _delivery("--lie", "1 deg", "Lie: toe up is positive.")]
Toe = Annotated[str | None, _delivery("--toe", "8 mm", "Impact point: towards the toe.")]
High = Annotated[str | None, _delivery("--high", "-3 mm", "Impact point: towards the crown.")]
Closure = Annotated[str | None, _delivery("--closure", "2400 deg/s", "Rate at which the face closes.")]
PitchRate = Annotated[str | None, _delivery("--pitch-rate", "500 deg/s", "Rate at which the loft grows.")]
LieRate = Annotated[str | None, _delivery("--lie-rate", "100 deg/s", "Rate at which the toe rises.")]

_EQUIPMENT, _MODEL, _AIR = "Club and ball", "Model", "Air"
Hand = Annotated[str | None, _option("--hand", panel=_EQUIPMENT, metavar="right|left", text="Hand of the club.")]
BallName = Annotated[
    str, _option("--ball", panel=_EQUIPMENT, metavar="NAME|FILE", text="The ball: a built-in name or a TOML file.")
]
Models = Annotated[
    list[str] | None,
    _option("--model", panel=_MODEL, metavar="NAME", text="A model, several with commas or repeated, or all."),
]
OneModel = Annotated[str, _option("--model", panel=_MODEL, metavar="NAME", text="The model.")]
Parameters = Annotated[
    str | None,
    _option("--parameters", panel=_MODEL, metavar="NAME|FILE", text="A published parameter set or a TOML file."),
]
Settings = Annotated[
    list[str] | None,
    _option("--set", panel=_MODEL, metavar="NAME=VALUE", text="Change a model parameter: friction=0.4. Repeatable."),
]
Accuracy = Annotated[
    float | None,
    _option(
        "--accuracy", panel=_MODEL, metavar="TOLERANCE", text="Relative tolerance of the contact integration: 1e-10."
    ),
]
AirText = Annotated[
    str | None,
    _option("--air", panel=_AIR, metavar="TEXT", text='All of the air in one: "temperature=30 degC, altitude=1600 m".'),
]
Temperature = Annotated[str | None, _option("--temperature", panel=_AIR, metavar='"30 degC"', text="Of the air.")]
Altitude = Annotated[str | None, _option("--altitude", panel=_AIR, metavar='"1600 m"', text="Sets the pressure.")]
Pressure = Annotated[str | None, _option("--pressure", panel=_AIR, metavar='"840 hPa"', text="At the course.")]
Humidity = Annotated[str | None, _option("--humidity", panel=_AIR, metavar='"40 %"', text="Relative humidity.")]
Wind = Annotated[
    str | None,
    _option("--wind", panel=_AIR, metavar='"5 m/s"', text='Tailwind, or "along, right" as in "5 m/s, -2 m/s".'),
]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON document instead.")]


def delivery(given: dict[str, str | None]) -> dict[str, float]:
    """Return the delivery values that were given, SI; the speed must be among them."""
    from clubface import units
    from clubface.delivery import DIMENSIONS

    if given.get("speed") is None:
        raise ClubfaceError('--speed is missing; give it with its unit, as in --speed "113 mph"')
    found = {}
    for name, text in given.items():
        if text is None:
            continue
        option = f"--{name.replace('_', '-')}"
        found[name] = units.parse(text, DIMENSIONS[name], name=option)
        note_bare_number(option, text, DIMENSIONS[name])
    return found


def note_bare_number(option: str, text: str, dimension: str) -> None:
    """Say in which unit a number without one was taken, since degrees are easily meant where radians are read."""
    from clubface import units

    if text.strip()[-1:] in "0123456789." and float(text) != 0.0 and dimension != units.DIMENSIONLESS:
        say(f"note: {option} {text} has no unit and is taken in {units.SI_UNITS[dimension]}")


def club_of(which: str, hand: str | None = None) -> Any:
    """Return the club called ``which``, turned to ``hand`` where one is given."""
    from clubface.clubs import club

    found = club(which)
    return found if hand is None else found.replace(hand=hand)


def model_names(given: Iterable[str] | None) -> list[str]:
    """Return the models asked for, in the order asked; all of the registry where none or "all" is given."""
    from clubface.models import model, models

    names = [name.strip() for each in given or ["all"] for name in each.split(",") if name.strip()]
    if not names:
        raise UnknownNameError("model", "", models())
    spread = [each for name in names for each in (models() if name == "all" else [name])]
    return [model(name).name for name in dict.fromkeys(spread)]


def one_model(name: str) -> str:
    """Return the name of a model if there is one of that name."""
    from clubface.models import model

    return model(name).name


def parameter_sets(
    names: Sequence[str], family: str, chosen: str | None = None, settings: Sequence[str] | None = None
) -> dict[str, Any]:
    """Return the parameter set of each model for a family of clubs.

    A set named or read from a file serves the models it fits, the others keep their default; so does each setting. One
    that fits none of the models is an error.
    """
    from clubface.parameters import ParameterSet

    sets = {name: ParameterSet.builtin(name, family) for name in names}
    if chosen is not None:
        sets.update(_chosen(names, family, chosen))
    for key, value in _pairs(settings or (), "--set").items():
        holders = [name for name in names if key in sets[name].values]
        if not holders:
            raise UnknownNameError("parameter", key, dict.fromkeys(k for name in names for k in sets[name].values))
        sets.update({name: sets[name].replace(**{key: value}) for name in holders})
    return sets


def _chosen(names: Sequence[str], family: str, chosen: str) -> dict[str, Any]:
    from clubface.equipment import is_path
    from clubface.parameters import ParameterSet, builtin_sets, read_sets
    from clubface.strict_toml import Document

    if is_path(chosen):
        models = {each.model for each in read_sets(Document.read(chosen))}
        fitting = [name for name in names if name in models]
        if not fitting:
            raise InputError("--parameters", chosen, f"a file for {' or '.join(names)}; it holds {', '.join(models)}")
        return {name: ParameterSet.from_toml(chosen, model=name, club=family) for name in fitting}
    known = {each.name: None for name in names for each in builtin_sets(name) if each.club in (family, "any")}
    if chosen not in known:
        raise UnknownNameError(f"parameter set for {family}", chosen, known)
    fitting = [
        name
        for name in names
        if any(each.name == chosen and each.club in (family, "any") for each in builtin_sets(name))
    ]
    return {name: ParameterSet.builtin(name, family, chosen) for name in fitting}


def conditions(
    air: str | None,
    wind: str | None,
    temperature: str | None,
    altitude: str | None,
    pressure: str | None,
    humidity: str | None,
) -> dict[str, Any]:
    """Return the air and wind of a flight, from one text and from single options, which win."""
    from clubface import units

    single = {
        "temperature": temperature,
        "altitude": altitude,
        "pressure": pressure,
        "humidity": humidity,
        "wind": wind,
    }
    given = _pairs(air.split(","), "--air") if air is not None else {}
    for key in given:
        if key not in single:
            raise UnknownNameError("value of --air", key, single)
    given.update({key: value for key, value in single.items() if value is not None})
    found = {}
    for key, text in given.items():
        option = f"--{key}"
        if key == "wind":
            continue
        dimension = {"temperature": "temperature", "altitude": "length", "pressure": "pressure"}.get(
            key, units.DIMENSIONLESS
        )
        found[key] = units.parse(text, dimension, name=option)
        note_bare_number(option, text, dimension)
    return {"air": found, "wind": _wind(given["wind"]) if "wind" in given else None}


def _wind(text: str) -> tuple[float, float, float]:
    """Return the wind to the target, up and right from "along" or "along, right"."""
    from clubface import units

    parts = text.split(",")
    if len(parts) > 2:
        raise InputError("--wind", text, 'a tailwind, or "along, right" as in "-5 m/s, 2 m/s"')
    speeds = [units.parse(part, "speed", name="--wind") for part in parts]
    for part in parts:
        note_bare_number("--wind", part, "speed")
    return speeds[0], 0.0, speeds[1] if len(speeds) == 2 else 0.0


def _pairs(texts: Iterable[str], option: str) -> dict[str, str]:
    found = {}
    for text in texts:
        key, equals, value = text.partition("=")
        if not (equals and key.strip() and value.strip()):
            raise InputError(option, text, "of the form name=value")
        found[key.strip()] = value.strip()
    return found
