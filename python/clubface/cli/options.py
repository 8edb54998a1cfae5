"""Options and arguments that commands share, in groups a command takes as a whole."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from typing import Annotated, Any

import typer

from clubface.equipment.models import DEFAULT_MODEL

Group = Mapping[str, tuple[Any, Any]]
"""Options by the name of their value: annotation and default."""


def option(*names: str, metavar: str, text: str, panel: str | None = None) -> Any:
    """Return an option whose default is told, if at all, in its help ``text``."""
    return typer.Option(*names, metavar=metavar, rich_help_panel=panel, help=text, show_default=False)


def output(metavar: str, text: str) -> Any:
    """Return the option that names what a command writes."""
    return option("--output", "-o", metavar=metavar, text=text)


def text_option(name: str, panel: str, metavar: str, text: str) -> tuple[Any, None]:
    """Return the annotation and default of an option whose value is text or None."""
    return Annotated[str | None, option(name, panel=panel, metavar=metavar, text=text)], None


def _quantities(of: str, **examples: tuple[str, str]) -> dict[str, tuple[Any, None]]:
    """Return options for quantities, each with an example and a help text."""
    return {
        name: text_option(f"--{name.replace('_', '-')}", f"{of} (a value with its unit)", f'"{example}"', text)
        for name, (example, text) in examples.items()
    }


ClubArgument = Annotated[str, typer.Argument(metavar="CLUB", help="Name of a built-in club, or a TOML file.")]
Json = Annotated[bool, typer.Option("--json", help="Print one JSON document instead.")]
Folder = Annotated[str | None, output("FOLDER", "Write tables and pictures to this folder.")]
Template = Annotated[str | None, output("FILE", "Write it to this file instead of the screen.")]
Format = Annotated[str | None, option("--format", metavar="NAME", text="Layout of the file; recognised unless given.")]
ColumnsFile = Annotated[
    str | None, option("--mapping", metavar="FILE", text="TOML file that names the columns of any other CSV file.")
]
Resume = Annotated[
    bool, typer.Option("--resume", help="Refuse to begin anew where a run with other inputs was interrupted.")
]
AtLaunch = Annotated[
    bool,
    typer.Option(
        "--at-launch", help="Compare at the measured launch: loft and face are solved, not taken from the file."
    ),
]
Seed = Annotated[int, typer.Option("--seed", metavar="N", help="Seed of the random numbers.")]

Report = Annotated[
    str | None,
    option("--report", metavar="FILE", text="Write a report with words, pictures and sources: .html or .md."),
]


def picture(of: str) -> Any:
    """Return the option that names a picture."""
    return option("--plot", metavar="FILE", text=f"Draw {of}: .png, .svg or .pdf.")


_CLUB_DATA = {
    "speed": ("113 mph", "Speed of the clubhead's CG."),
    "attack": ("-1.3 deg", "Attack angle: up is positive."),
    "path": ("2 deg", "Club path: to the right is positive."),
    "loft": ("12.8 deg", "Dynamic loft."),
    "face": ("1 deg", "Face angle: to the right is positive."),
    "lie": ("1 deg", "Lie: toe up is positive."),
    "toe": ("8 mm", "Impact point: towards the toe is positive."),
    "high": ("-3 mm", "Impact point: towards the crown is positive."),
    "closure": ("2400 deg/s", "Rate at which the face closes."),
    "pitch_rate": ("500 deg/s", "Rate at which the loft grows."),
    "lie_rate": ("100 deg/s", "Rate at which the toe rises."),
}
DELIVERY: Group = _quantities(
    "Delivery",
    **_CLUB_DATA
    | {
        "speed": ("113 mph", "Speed of the clubhead's CG. Required."),
        "loft": ("12.8 deg", "Dynamic loft; the club's static loft unless given."),
        "ball_backspin": ("300 rpm", "Backspin of the ball before impact."),
        "ball_sidespin": ("300 rpm", "Sidespin of the ball before impact."),
        "ball_riflespin": ("300 rpm", "Spin of the ball before impact about the line to the target."),
    },
)
MEASURED_CLUB: Group = _quantities("Club data, as much of it as was measured", **_CLUB_DATA)
_DIRECTION_AND_SPIN = {
    "azimuth": ("1 deg", "Azimuth: to the right is positive."),
    "backspin": ("2700 rpm", "Backspin; two of backspin, sidespin, total spin and spin axis give the others."),
    "sidespin": ("-200 rpm", "Sidespin: curving to the right is positive."),
    "total_spin": ("2700 rpm", "Total spin; it needs the axis or another of the spins with it."),
    "spin_axis": ("3 deg", "Axis of the spin: tilted to the right is positive."),
}
LAUNCH: Group = _quantities(
    "Launch",
    ball_speed=("167 mph", "Speed of the ball. Required."),
    launch=("10.9 deg", "Launch angle. Required."),
    **_DIRECTION_AND_SPIN,
)
MEASURED_LAUNCH: Group = _quantities(
    "Launch, as much of it as was measured",
    ball_speed=("159 mph", "Speed of the ball."),
    launch=("14.5 deg", "Launch angle: up is positive."),
    **_DIRECTION_AND_SPIN,
)

_EQUIPMENT, _MODEL, _AIR = "Club and ball", "Model", "Air"
Ball = Annotated[
    str | None,
    option(
        "--ball", panel=_EQUIPMENT, metavar="NAME|FILE", text="A built-in ball or a TOML file; modern unless given."
    ),
]
BALL: Group = {"ball": (Ball, None)}
EQUIPMENT: Group = {
    "hand": text_option("--hand", _EQUIPMENT, "right|left", "Hand of the club; its own unless given."),
    **BALL,
}

MODELS_TEXT = "A model, or several with commas or repeated; all unless given."
Models = Annotated[list[str] | None, option("--model", panel=_MODEL, metavar="NAME", text=MODELS_TEXT)]
_MODEL_NAMES = f"A model, or several with commas or repeated, or all; {DEFAULT_MODEL} unless given."
_ModelNames = Annotated[list[str] | None, option("--model", panel=_MODEL, metavar="NAME", text=_MODEL_NAMES)]
_ONE_MODEL_TEXT = f"The model; {DEFAULT_MODEL} unless given."
_ONE_MODEL = Annotated[str, option("--model", panel=_MODEL, metavar="NAME", text=_ONE_MODEL_TEXT)]
_SET_TEXT = "Change a model parameter: friction=0.4. Repeatable."
_ACCURACY_TEXT = "Relative tolerance of a step of a contact model, 1e-13 to 1e-2."
Setting = Annotated[list[str] | None, option("--set", panel=_MODEL, metavar="NAME=VALUE", text=_SET_TEXT)]
_PARAMETERS: Group = {
    "parameters": text_option("--parameters", _MODEL, "NAME|FILE", "A published parameter set or a TOML file."),
    "setting": (Setting, None),
    "accuracy": (
        Annotated[float | None, option("--accuracy", panel=_MODEL, metavar="TOLERANCE", text=_ACCURACY_TEXT)],
        None,
    ),
}
_FITTED_MODEL = Annotated[str | None, option("--model", panel=_MODEL, metavar="NAME", text="The model. Required.")]
ONE_MODEL: Group = {"model": (_ONE_MODEL, DEFAULT_MODEL), **_PARAMETERS}
FITTED_MODEL: Group = {"model": (_FITTED_MODEL, None), **_PARAMETERS}
MODELS: Group = {"model": (_ModelNames, None), **_PARAMETERS}

AIR: Group = {
    "air": text_option("--air", _AIR, "TEXT", 'All of these in one text: "temperature=30 degC, altitude=1600 m".'),
    "temperature": text_option("--temperature", _AIR, '"30 degC"', "Temperature of the air; 25 degC unless given."),
    "altitude": text_option("--altitude", _AIR, '"1600 m"', "Altitude of the course, which sets the pressure."),
    "pressure": text_option("--pressure", _AIR, '"840 hPa"', "Pressure at the course; that at sea level unless given."),
    "humidity": text_option("--humidity", _AIR, '"40 %"', "Relative humidity; 50 % unless given."),
    "wind": text_option("--wind", _AIR, '"5 m/s"', 'Tailwind, or wind along and to the right: "5 m/s, -2 m/s".'),
}

GROUND: Group = {
    "ground": text_option("--ground", "Ground", '"firm fairway"', "Where the ball lands; a fairway unless given."),
}


def takes(*groups: Group) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Give a command the options of ``groups``, which reach its keyword arguments, after its own required ones."""
    added = {name: each for group in groups for name, each in group.items()}

    def with_options(command: Callable[..., None]) -> Callable[..., None]:
        own = inspect.signature(command, eval_str=True).parameters.values()
        plain = [each.replace(kind=each.KEYWORD_ONLY) for each in own if each.kind is not each.VAR_KEYWORD]
        shared = [
            inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)
            for name, (annotation, default) in added.items()
        ]
        required = [each for each in plain if each.default is each.empty]
        rest = [each for each in plain if each.default is not each.empty]
        command.__signature__ = inspect.Signature([*required, *shared, *rest])  # pyright: ignore[reportFunctionMemberAccess]
        return command

    return with_options
