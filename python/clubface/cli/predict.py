"""``clubface predict``: launches for a file of deliveries."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import fields
from typing import Annotated

import typer

from clubface.cli import options, output
from clubface.cli.failures import say

app = typer.Typer(add_completion=False)


@app.command()
def predict(
    deliveries: Annotated[
        str, typer.Argument(metavar="DELIVERIES", help="CSV or Parquet; columns by name and unit: club_speed_mph.")
    ],
    club: Annotated[str, typer.Option("--club", metavar="CLUB", help="Name of a built-in club, or a TOML file.")],
    target: Annotated[
        str | None,
        typer.Option("--output", "-o", metavar="FILE", help="CSV or Parquet, by its ending.", show_default=False),
    ] = None,
    rejects: Annotated[
        str | None,
        typer.Option(
            "--rejects", metavar="FILE", help="For rows that cannot be used, with reasons.", show_default=False
        ),
    ] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Go on where an interrupted run stopped.")] = False,
    hand: options.Hand = None,
    ball: options.BallName = "published",
    model: options.OneModel = "standard",
    parameters: options.Parameters = None,
    setting: options.Settings = None,
    accuracy: options.Accuracy = None,
    carry: Annotated[bool, typer.Option("--carry/--no-carry", help="Compute the flight too.")] = True,
    air: options.AirText = None,
    temperature: options.Temperature = None,
    altitude: options.Altitude = None,
    pressure: options.Pressure = None,
    humidity: options.Humidity = None,
    wind: options.Wind = None,
    as_json: options.Json = False,
) -> None:
    """Compute the launch of every delivery in a file."""
    head = options.club_of(club, hand)
    chosen = options.one_model(model)
    sets = options.parameter_sets([chosen], head.parameters, parameters, setting)
    conditions = options.conditions(air, wind, temperature, altitude, pressure, humidity)

    from clubface.predict import predict as compute

    with _progress() as progress:
        report = compute(
            deliveries, club=head, model=chosen, parameters=sets[chosen], ball=ball, accuracy=accuracy, carry=carry,
            output=target, rejects=rejects, resume=resume, progress=progress, **conditions,
        )  # fmt: skip
    if as_json:
        output.print_json({each.name: getattr(report, each.name) for each in fields(report)})
    else:
        print(report)
    if report.rejected and not report.written:
        say("not one delivery could be used")
        raise typer.Exit(2)


@contextmanager
def _progress() -> Iterator[Callable[[float, int], object] | None]:
    """Show a bar on the error stream where that is a terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task("starting", total=1.0)
        yield lambda part, rows: bar.update(task, completed=part, description=f"{rows} deliveries")
