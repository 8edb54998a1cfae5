"""``clubface predict``: launches for a file of deliveries."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import fields
from typing import Annotated, Any

import typer

from clubface.cli import given, options, output
from clubface.cli.failures import say

app = typer.Typer(add_completion=False)


@app.command()
@options.takes(options.EQUIPMENT, options.ONE_MODEL, options.AIR)
def predict(
    deliveries: Annotated[
        str,
        typer.Argument(
            metavar="DELIVERIES",
            help="CSV or Parquet file whose columns have names with units, such as club_speed_mph.",
        ),
    ],
    club: Annotated[str, typer.Option("--club", metavar="CLUB", help="Name of a built-in club, or a TOML file.")],
    target: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="FILE",
            help="Write the launches, CSV or Parquet by its ending.",
            show_default=False,
        ),
    ] = None,
    rejects: Annotated[
        str | None,
        typer.Option(
            "--rejects", metavar="FILE", help="Write the rows that cannot be used, with reasons.", show_default=False
        ),
    ] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Go on where an interrupted run stopped.")] = False,
    carry: Annotated[bool, typer.Option("--carry/--no-carry", help="Compute the flight too.")] = True,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Compute the launch of every delivery in a file."""
    head = given.club_of(club, texts["hand"])
    chosen = given.one_model(texts["model"])
    sets = given.parameter_sets([chosen], head.parameters, texts["parameters"], texts["setting"])
    conditions = given.conditions(texts)

    from clubface.prediction.predict import predict as compute

    with _progress() as progress:
        report = compute(
            deliveries, club=head, model=chosen, parameters=sets[chosen], ball=texts["ball"],
            accuracy=texts["accuracy"], carry=carry, output=target, rejects=rejects, resume=resume,
            progress=progress, **conditions,
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
