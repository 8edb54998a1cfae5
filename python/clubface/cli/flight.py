"""``clubface flight``: the flight of a ball whose launch is known."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.tables import print_numbers
from clubface.errors import ClubfaceError

app = typer.Typer(add_completion=False)

LAUNCH = {
    "ball_speed": "speed", "launch": "angle", "azimuth": "angle", "backspin": "angular rate",
    "sidespin": "angular rate", "total_spin": "angular rate", "spin_axis": "angle",
}  # fmt: skip
"""The dimension of each launch value."""

SHOWN = {
    "carry_m": ("carry", "m", "yd", 1), "side_m": ("side", "m", "yd", 1), "total_m": ("total", "m", "yd", 1),
    "total_side_m": ("total_side", "m", "yd", 1), "apex_m": ("apex", "m", "yd", 1),
    "landing_deg": ("landing_angle", "deg", "deg", 1), "flight_time_s": ("flight_time", "s", "s", 2),
    "landing_speed_mps": ("landing_speed", "m/s", "mph", 1), "landing_spin_rpm": ("landing_spin", "rpm", "rpm", 0),
}  # fmt: skip
"""Keys of the JSON object: quantity, its unit there and in the table, and digits in the table."""


def _launch(name: str, example: str, text: str) -> Any:
    return typer.Option(
        name, metavar=f'"{example}"', help=text, rich_help_panel="Launch (a value with its unit)", show_default=False
    )


BallSpeed = Annotated[str | None, _launch("--ball-speed", "167 mph", "Required.")]
LaunchAngle = Annotated[str | None, _launch("--launch", "10.9 deg", "Launch angle. Required.")]
Azimuth = Annotated[str | None, _launch("--azimuth", "1 deg", "To the right is positive.")]
Backspin = Annotated[str | None, _launch("--backspin", "2700 rpm", "Or the total spin and its axis.")]
Sidespin = Annotated[str | None, _launch("--sidespin", "-200 rpm", "Curves right is positive.")]
TotalSpin = Annotated[str | None, _launch("--total-spin", "2700 rpm", "In place of back- and sidespin.")]
SpinAxis = Annotated[str | None, _launch("--spin-axis", "3 deg", "Tilted to the right is positive.")]


@app.command()
def flight(
    ball_speed: BallSpeed = None,
    launch: LaunchAngle = None,
    azimuth: Azimuth = None,
    backspin: Backspin = None,
    sidespin: Sidespin = None,
    total_spin: TotalSpin = None,
    spin_axis: SpinAxis = None,
    ball: options.BallName = "published",
    air: options.AirText = None,
    temperature: options.Temperature = None,
    altitude: options.Altitude = None,
    pressure: options.Pressure = None,
    humidity: options.Humidity = None,
    wind: options.Wind = None,
    as_json: options.Json = False,
) -> None:
    """Compute where a launched ball flies, bounces and rolls."""
    from clubface import units
    from clubface.balls import ball as ball_of
    from clubface.flight import fly

    given = {
        "ball_speed": ball_speed, "launch": launch, "azimuth": azimuth, "backspin": backspin, "sidespin": sidespin,
        "total_spin": total_spin, "spin_axis": spin_axis,
    }  # fmt: skip
    values = {}
    for name, text in given.items():
        option = f"--{name.replace('_', '-')}"
        if text is not None:
            values[name] = units.parse(text, LAUNCH[name], name=option)
            options.note_bare_number(option, text, LAUNCH[name])
        elif name in ("ball_speed", "launch"):
            raise ClubfaceError(f'{option} is missing; give it, as in --ball-speed "167 mph" --launch "10.9 deg"')
    conditions = options.conditions(air, wind, temperature, altitude, pressure, humidity)
    flown = fly({**values, **ball_of(ball).inputs()}, **conditions)
    if as_json:
        output.print_json({key: float(flown.get(name, unit)) for key, (name, unit, _, _) in SHOWN.items()})
        return
    heads = [f"{name.replace('_', chr(10))}\n{unit}" for name, _, unit, _ in SHOWN.values()]
    cells = [output.number(float(flown.get(name, unit)), digits) for name, _, unit, digits in SHOWN.values()]
    print_numbers(heads, [cells])
    if flown.outside_fit:
        output.print_notes(["the spin leaves the range to which the aerodynamics were fitted"])
