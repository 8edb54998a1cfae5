"""``clubface tour``: every club of the published tour averages by every model, beside what was published."""

from __future__ import annotations

from pathlib import Path

import typer

from clubface.cli import given, options, output
from clubface.cli.failures import say_written
from clubface.cli.tables import print_numbers

app = typer.Typer(add_completion=False)


@app.command()
def tour(
    folder: options.Folder = None,
    model: options.Models = None,
    ball: options.Ball = "published",
    as_json: options.Json = False,
) -> None:
    """Compare every model with the published tour averages, club by club."""
    names = given.model_names(model)
    output.prepare_folder(folder)
    from clubface.tour import averages, report, tables

    result = averages.tour(names, ball=ball)
    files = report.write(result, Path(folder)) if folder is not None else []
    if as_json:
        output.print_json(tables.document(result))
    else:
        for quantity, unit in result.units.items():
            heads, rows = tables.comparison(result, quantity, signed=True)
            title = f"{tables.TITLES[quantity]} ({unit}): published, and model less published"
            print_numbers(heads, rows, title=title, summary=True)
            print()
        output.print_notes(tables.notes(result))
    say_written(files)
