"""Shared options and arguments, in groups for commands, and parsing of their values."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Annotated, Any

import typer

from clubface import units
from clubface.cli.failures import print_note
from clubface.equipment.models import DEFAULT_MODEL, model, models, models_with
from clubface.errors import ClubfaceError, InputError, UnknownNameError
from clubface.support.checks import check_choice, check_names
from clubface.support.renamed import warn_renamed

Group = Mapping[str, tuple[Any, Any]]
"""Annotation and default of options, by name of the value."""


def option(*names: str, metavar: str, text: str, panel: str | None = None) -> Any:
    """Return an option; its help ``text`` describes the default, if any."""
    return typer.Option(*names, metavar=metavar, rich_help_panel=panel, help=text, show_default=False)


def output(metavar: str, text: str) -> Any:
    """Return the option for the output file of a command."""
    return option("--output", "-o", metavar=metavar, text=text)


def argument(metavar: str, text: str) -> Any:
    """Return an argument with its help ``text``."""
    return typer.Argument(metavar=metavar, help=text)


Text, Texts = str | None, list[str] | None
"""Types of options for a text or several."""


def group(panel: str | None, /, **rows: tuple[Any, Any, str | None, str]) -> Group:
    """Return the options of one help panel, each given as name, type, default, placeholder and help."""
    options = {}
    for name, (kind, default, metavar, text) in rows.items():
        flag = f"--{name.replace('_', '-')}"
        flag = f"{flag}/--no-{flag[2:]}" if kind is bool and default else flag
        shown = typer.Option(flag, metavar=metavar, rich_help_panel=panel, help=text, show_default=default is not None)
        options[name] = (Annotated[kind, shown], default)
    return options


def renamed(**names: str) -> Group:
    """Return hidden text options under old names; :func:`take_renamed` moves their values."""
    return {
        old: (Annotated[str | None, typer.Option(f"--{old.replace('_', '-')}", hidden=True)], None) for old in names
    }


def take_renamed(texts: dict[str, Any], **names: str) -> None:
    """Move values given under an old name to the new one, with a warning."""
    for old, new in names.items():
        text = texts.pop(old)
        if text is not None:
            flags = [f"--{name.replace('_', '-')}" for name in (old, new)]
            if texts[new] is not None:
                raise InputError(flags[0], text, f"left out: it is the old name of {flags[1]}, which is given as well")
            warn_renamed(*flags)
            texts[new] = text


def _quantities(subject: str, **examples: tuple[str, str]) -> Group:
    """Return options for physical quantities, each with an example and a help text."""
    rows = {name: (Text, None, f'"{example}"', text) for name, (example, text) in examples.items()}
    return group(f"{subject} (a value with its unit)", **rows)


ClubArgument = Annotated[str, argument("CLUB", "Name of a built-in club, or a TOML file.")]
Template = Annotated[str | None, output("FILE", "Write it to this file instead of the screen.")]
LAYOUT = group(
    None,
    format=(Text, None, "NAME", "Layout of the file; recognised by default."),
    mapping=(Text, None, "FILE", "TOML file that names the columns of any other CSV file."),
)
RESUME_TEXT = "Stop, instead of starting over, if the interrupted run had other inputs."
RESUME = group(None, resume=(bool, False, None, RESUME_TEXT))
AT_LAUNCH_TEXT = "Compare at the measured launch: solve loft and face angle instead of reading them."
AT_LAUNCH = group(None, at_launch=(bool, False, None, AT_LAUNCH_TEXT))
SEED = group(None, seed=(int, 0, "N", "Random seed."))


_CLUB_DATA = {
    "speed": ("113 mph", "Speed of the clubhead's CG."),
    "attack": ("-1.3 deg", "Attack angle: up is positive."),
    "path": ("2 deg", "Club path: to the right is positive."),
    "loft": ("12.8 deg", "Dynamic loft."),
    "face": ("1 deg", "Face angle: to the right is positive."),
    "lie": ("1 deg", "Lie: toe up is positive; does not change the face angle."),
    "toe": ("8 mm", "Impact point: towards the toe is positive."),
    "high": ("-3 mm", "Impact point: towards the crown is positive."),
    "closure": ("2400 deg/s", "Rate at which the face closes."),
    "pitch_rate": ("500 deg/s", "Rate at which the loft increases."),
    "lie_rate": ("100 deg/s", "Rate at which the toe rises."),
}
DELIVERY: Group = _quantities(
    "Delivery",
    **_CLUB_DATA
    | {
        "speed": ("113 mph", "Speed of the clubhead's CG. Required."),
        "loft": ("12.8 deg", "Dynamic loft; default: the club's static loft."),
        "ball_backspin": ("300 rpm", "Backspin of the ball before impact."),
        "ball_sidespin": ("300 rpm", "Sidespin of the ball before impact."),
        "ball_riflespin": ("300 rpm", "Spin of the ball before impact about the target line."),
    },
)
MEASURED_CLUB: Group = _quantities("Club data, as far as measured", **_CLUB_DATA)
_DIRECTION_AND_SPIN = {
    "azimuth": ("1 deg", "Azimuth: to the right is positive."),
    "backspin": ("2700 rpm", "Backspin; any two of backspin, sidespin, total spin and spin axis are enough."),
    "sidespin": ("-200 rpm", "Sidespin: curving to the right is positive."),
    "total_spin": ("2700 rpm", "Total spin; also give the spin axis or another spin."),
    "spin_axis": ("3 deg", "Spin axis: tilted to the right is positive."),
}
LAUNCH: Group = _quantities(
    "Launch",
    ball_speed=("167 mph", "Speed of the ball. Required."),
    launch=("10.9 deg", "Launch angle. Required."),
    **_DIRECTION_AND_SPIN,
)
MEASURED_LAUNCH: Group = _quantities(
    "Launch, as far as measured",
    ball_speed=("159 mph", "Speed of the ball."),
    launch=("14.5 deg", "Launch angle: up is positive."),
    **_DIRECTION_AND_SPIN,
)

_EQUIPMENT, _MODEL = "Club and ball", "Model"
BALL = group(_EQUIPMENT, ball=(Text, None, "NAME|FILE", "A built-in ball or a TOML file; default modern."))
EQUIPMENT = {
    **group(_EQUIPMENT, hand=(Text, None, "right|left", "Hand of the club; default: as in the club's file.")),
    **BALL,
}
SHAFT = group(_EQUIPMENT, shaft=(Text, None, "NAME|FILE", "A built-in shaft or a TOML file; default: a free head."))

MODELS_TEXT = "A model, or several, comma-separated or repeated; default: all."
_SET_TEXT = "Change a model parameter: friction=0.4. Repeatable."
SETTING: Group = {
    "setting": (Annotated[Texts, option("--set", panel=_MODEL, metavar="NAME=VALUE", text=_SET_TEXT)], None)
}
_SET: Group = {
    **group(_MODEL, parameters=(Text, None, "NAME|FILE", "A published parameter set or a TOML file.")),
    **SETTING,
}
_ACCURACY_TEXT = "Relative step tolerance of a contact model, 1e-13 to 1e-2."
_ACCURACY = group(_MODEL, accuracy=(float | None, None, "TOLERANCE", _ACCURACY_TEXT))
_MODEL_NAMES = f"A model, or several, comma-separated or repeated, or all; default {DEFAULT_MODEL}."
ONE_SET = {**group(_MODEL, model=(str, DEFAULT_MODEL, "NAME", "The model.")), **_SET}
ONE_MODEL = {**ONE_SET, **_ACCURACY}
CONTACT_MODEL = {
    **group(_MODEL, model=(str, "volumetric", "NAME", "A contact model: volumetric, rings or area.")),
    **_SET,
}
FITTED_MODEL = {**group(_MODEL, model=(Text, None, "NAME", "The model. Required.")), **_SET, **_ACCURACY}
MODELS = {**group(_MODEL, model=(Texts, None, "NAME", _MODEL_NAMES)), **_SET, **_ACCURACY}

AIR = group(
    "Air",
    air=(Text, None, "TEXT", 'All of these in one text: "temperature=30 degC, altitude=1600 m".'),
    temperature=(Text, None, '"30 degC"', "Air temperature; default 25 degC."),
    altitude=(Text, None, '"1600 m"', "Altitude of the course, which sets the pressure."),
    pressure=(Text, None, '"840 hPa"', "Pressure at the course; default: sea level."),
    humidity=(Text, None, '"40 %"', "Relative humidity; default 50 %."),
    wind=(Text, None, '"5 m/s"', 'Tailwind, or wind along and to the right: "5 m/s, -2 m/s".'),
)
GROUND = group("Ground", ground=(Text, None, '"firm fairway"', "Where the ball lands; default: a fairway."))
_WORTH = (
    'The smallest difference worth a change: "carry=3 yd". Default: 2 yd of carry and total, 1 yd of side_spread and '
    "0.01 strokes. Repeatable."
)
WORTH = group(None, worth=(Texts, None, "NAME=VALUE", _WORTH))
"""Option for differences too small to notice, which are not ranked."""


OUTPUT = ("--unit", "--output", "--plot", "--report", "--resume", "--json")
"""Options that stand last in the help, since they do not change what is computed."""


def _flag(parameter: inspect.Parameter) -> str:
    """Return the name of an option on the command line."""
    # In an annotation, Typer takes the first of several names for the default.
    info = parameter.annotation.__metadata__[-1]
    declared = (each for each in (info.default, *(info.param_decls or ())) if str(each).startswith("--"))
    return next(declared, f"--{parameter.name}")


def takes(*groups: Group) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Add the options of ``groups`` to a command, after its own arguments, as keyword arguments."""
    added = {name: each for group in groups for name, each in group.items()}

    def with_options(command: Callable[..., None]) -> Callable[..., None]:
        own = inspect.signature(command, eval_str=True).parameters.values()
        plain = [each.replace(kind=each.KEYWORD_ONLY) for each in own if each.kind is not each.VAR_KEYWORD]
        shared = [
            inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)
            for name, (annotation, default) in added.items()
        ]
        required = [each for each in plain if each.default is each.empty]
        rest = [*(each for each in plain if each.default is not each.empty), *shared]
        rest.sort(key=lambda each: OUTPUT.index(_flag(each)) if _flag(each) in OUTPUT else -1)
        command.__signature__ = inspect.Signature([*required, *rest])  # pyright: ignore[reportFunctionMemberAccess]
        return command

    return with_options


USUAL = {
    "speed": (0.0, 115.0, "mph"), "angle": (0.0, 1.3, "deg"), "length": (0.0, 0.2, "mm"),
    "angular rate": (0.0, 2000.0, "rpm"), "temperature": (200.0, 330.0, "degC"), "pressure": (4e4, 1.2e5, "hPa"),
}  # fmt: skip
"""Usual range of magnitudes of each dimension in golf [SI], and the display unit."""
USUAL_OF = {
    "--speed": (0.0, 75.0, "mph"), "--wind": (0.0, 40.0, "mph"), "--altitude": (0.0, 5000.0, "ft"),
    **dict.fromkeys(("--attack", "--path", "--face", "--lie", "--azimuth"), (0.0, 0.8, "deg")),
    **dict.fromkeys(("--hole", "--fairway", "--rough"), (0.0, 0.0, "yd")),
    **dict.fromkeys(("--closure", "--pitch-rate", "--lie-rate"), (0.0, 250.0, "deg/s")),
}  # fmt: skip
"""Usual ranges for options with a narrower range than their dimension."""


ONCE = ("--delivery", "--air", "--unit", "--assume")
"""Options in which no name may occur twice; in --set, the last one applies."""


def parsed(option: str, text: str, dimension: str) -> float:
    """Return a value in SI.

    A note says that a number without a unit is read in SI. If no shot has such a value in SI, an error asks for the
    unit.
    """
    number = text.strip()
    has_unit = number[-1:] not in "0123456789."
    try:
        value = units.parse(text if has_unit else float(number), dimension, name=option)
    except ValueError:
        value = units.parse(text, dimension, name=option)  # raises an error if it is invalid
    if has_unit or value == 0.0 or dimension == units.DIMENSIONLESS:
        return value
    si = units.SI_UNITS[dimension]
    least, most, unit = USUAL_OF.get(option) or USUAL.get(dimension) or (0.0, math.inf, si)
    if not least <= abs(value) <= most:
        raise ClubfaceError(
            f'{option} {number} has no unit; give it, as in {option} "{number} {unit}": a bare number is in {si}'
        )
    print_note(f"note: {option} {text} has no unit and is read in {si}")
    return value


def quantities(
    given: Mapping[str, str | None], dimensions: Mapping[str, str], required: Mapping[str, str]
) -> dict[str, float]:
    """Return the values given, in SI; the ``required`` ones, each with an example, must be among them."""
    result = {}
    for name, dimension in dimensions.items():
        option, text = f"--{name.replace('_', '-')}", given[name]
        if text is not None:
            result[name] = parsed(option, text, dimension)
        elif name in required:
            raise ClubfaceError(f'{option} is missing; give it with its unit, as in {option} "{required[name]}"')
    return result


def delivery(given: Mapping[str, str | None]) -> dict[str, float]:
    """Return the delivery values given, in SI; the speed must be among them."""
    from clubface.simulation.inputs import DIMENSIONS

    return quantities(given, DIMENSIONS, {"speed": "113 mph"})


def club_of(name: str, hand: str | None = None, model: str | Iterable[str] | None = None) -> Any:
    """Return the club ``name``, for ``hand`` if given; ``model`` computes its shots."""
    from clubface.equipment.clubs import club

    result = club(name)
    computed = [model] if isinstance(model, str) else [*(model or ())]
    if hasattr(result, "head") and not result.characteristic_time and computed != ["fem"]:
        print_note(
            f"note: every model except fem treats the face of {result.name} as rigid, or as included in its parameters;"
            f" clubface fem head {name} --measure simulates how it gives, and prints the line to add to the file"
        )
    return result if hand is None else result.replace(hand=hand)


def model_names(given: Iterable[str] | None, unless_given: str = "all") -> list[str]:
    """Return the requested models in order; "all" means every model of the registry."""
    asked = names(given or [unless_given])
    if not asked:
        raise UnknownNameError("model", "", models())
    spread = [each for name in asked for each in (models() if name == "all" else [name])]
    return [model(name).name for name in dict.fromkeys(spread)]


def names(texts: Iterable[str] | None) -> list[str]:
    """Return the distinct names in texts that hold one name or several, separated by commas."""
    return list(dict.fromkeys(name.strip() for each in texts or () for name in each.split(",") if name.strip()))


def check_accuracy(names: Iterable[str], accuracy: float | None) -> None:
    """Raise InputError for an accuracy that none of the models uses."""
    if accuracy is not None and all(model(name).kind == "impulse" for name in names):
        contact = [name for name in models() if model(name).kind == "contact"]
        words = f"leave it out: {', '.join(names)} has no time steps; models with time steps: {', '.join(contact)}"
        raise InputError("--accuracy", accuracy, words)


def one_set(head: Any, texts: Mapping[str, Any]) -> Any:
    """Return the parameter set chosen for a club by the options in ``options.ONE_MODEL``."""
    model = texts["model"]
    check_accuracy([model], texts.get("accuracy"))
    return parameter_sets([model], head.parameters, texts["parameters"], texts["setting"])[model]


def setup(club: str, texts: Mapping[str, Any]) -> dict[str, Any]:
    """Return club, model, parameters, ball and accuracy, as an impact takes them, as far as a command has options."""
    head = club_of(club, texts["hand"], texts["model"])
    head = head if texts.get("shaft") is None else head.on_shaft(texts["shaft"])
    given = {name: texts[name] for name in ("model", "ball", "accuracy") if name in texts}
    return {"club": head, "parameters": one_set(head, texts), **given}


def parameter_sets(
    names: Sequence[str], family: str, chosen: str | Iterable[str] | None = None, settings: Sequence[str] | None = None
) -> dict[str, Any]:
    """Return the parameter set of each model for a family of clubs.

    Sets and settings apply to the models that they fit, the others keep their defaults; one that fits none of the
    models is an error, and of several for a model the last applies.
    """
    from clubface.equipment.parameters import ParameterSet

    sets = {name: ParameterSet.builtin(name, family) for name in names}
    for each in [chosen] if isinstance(chosen, str) else chosen or ():
        sets.update(_chosen_sets(names, family, each))
    for key, value in pairs(settings or (), "--set").items():
        holders = [name for name in names if key in sets[name].values]
        if not holders and (others := models_with(key)):
            raise InputError("--set", key, f"a parameter of {', '.join(names)}; {_models_to_name(others)}")
        if not holders:
            raise UnknownNameError("parameter", key, dict.fromkeys(k for name in names for k in sets[name].values))
        sets.update({name: sets[name].replace(**{key: value}) for name in holders})
    return sets


def _chosen_sets(names: Sequence[str], family: str, chosen: str) -> dict[str, Any]:
    from clubface.equipment.parameters import ParameterSet, builtin_sets, read_sets
    from clubface.schema import Document
    from clubface.support.files import is_path

    if is_path(chosen) and chosen not in {each.name for each in builtin_sets()}:
        models = {each.model for each in read_sets(Document.read(chosen))}
        fitting = [name for name in names if name in models]
        if not fitting:
            raise InputError("--parameters", chosen, f"a file for {' or '.join(names)}; it holds {', '.join(models)}")
        return {name: ParameterSet.from_toml(chosen, model=name, club=family) for name in fitting}
    others = {each.model: None for each in builtin_sets() if each.name == chosen and each.club in (family, "any")}
    if others and not others.keys() & set(names):
        raise InputError("--parameters", chosen, f"a set of {', '.join(names)}; {_models_to_name(others)}")
    known = {each.name: None for name in names for each in builtin_sets(name) if each.club in (family, "any")}
    check_choice(f"parameter set for {family}", chosen, known)
    fitting = [
        name
        for name in names
        if any(each.name == chosen and each.club in (family, "any") for each in builtin_sets(name))
    ]
    return {name: ParameterSet.builtin(name, family, chosen) for name in fitting}


def _models_to_name(having: Iterable[str]) -> str:
    return f"name a model that has it: --model {' or '.join(having)}"


def conditions(given: Mapping[str, str | None]) -> dict[str, Any]:
    """Return air, wind and, if the command takes one, ground; single options take precedence over ``air``."""
    words = pairs(given["air"].split(","), "--air") if given["air"] is not None else {}
    single = [name for name in AIR if name != "air"]
    check_names("value of --air", words, single)
    words.update({name: text for name in single if (text := given[name]) is not None})
    wind = words.pop("wind", None)
    air = {name: parsed(f"--{name}", text, _air_dimension(name)) for name, text in words.items()}
    ground = {"ground": given["ground"]} if "ground" in given else {}
    return {"air": air, "wind": _wind(wind) if wind is not None else None, **ground}


def _air_dimension(name: str) -> str:
    from clubface.simulation.results import flight_inputs

    return "length" if name == "altitude" else flight_inputs()[name].dimension


def _wind(text: str) -> tuple[float, float, float]:
    """Return the wind components towards the target, up and to the right from "along" or "along, right"."""
    parts = text.split(",")
    if len(parts) > 2:
        raise InputError("--wind", text, 'a tailwind, or "along, right" as in "-5 m/s, 2 m/s"')
    speeds = [parsed("--wind", part, "speed") for part in parts]
    return speeds[0], 0.0, speeds[1] if len(speeds) == 2 else 0.0


def pairs(texts: Iterable[str], option: str) -> dict[str, str]:
    """Return names and values from texts like name=value; ``option`` is the name used in errors."""
    result = {}
    for text in texts:
        key, equals, value = text.partition("=")
        if not (equals and key.strip() and value.strip()):
            raise InputError(option, text, "of the form name=value")
        if key.strip() in result and option in ONCE:
            raise InputError(option, text, f"with {key.strip()} given once")
        result[key.strip()] = value.strip()
    return result
