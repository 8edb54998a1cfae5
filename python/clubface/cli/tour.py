"""``clubface tour``: every club of the published tour averages by every model, beside what was published."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clubface.cli import options, output
from clubface.cli.failures import say, say_written
from clubface.cli.output import print_numbers, progress_bar
from clubface.errors import RangeWarning

if TYPE_CHECKING:
    from clubface.validation.tour import Tour


app = typer.Typer(add_completion=False)

TABLES_TEXT = "pga-2023, pga-2019, lpga-2019, or several with commas; all means every one. pga-2023 unless given."


@app.command()
def tour(
    folder: options.Folder = None,
    averages: Annotated[str, typer.Option(metavar="NAME", help=TABLES_TEXT, show_default=False)] = "",
    model: options.Models = None,
    ball: options.Ball = None,
    as_json: options.Json = False,
) -> None:
    """Compute the published tour averages, club by club, by the default model, then by every model."""
    from clubface.validation import tour as job, tour as published

    names = options.model_names(model)
    wanted = options.names([averages or published.DEFAULT_TABLE])
    which = list(dict.fromkeys(name for each in wanted for name in (published.TABLES if each == "all" else [each])))
    for each in which:
        published.averages(each)  # before the work: a name that does not exist is found at once
    output.prepare_folder(folder)
    from clubface.simulation.impact import Tally
    from clubface.support.checks import without_warnings
    from clubface.validation import tour_report, tour_tables

    results = []
    for table in which:
        with progress_bar(table) as progress, without_warnings(RangeWarning):
            results.append(job.tour(names, table=table, ball=ball, progress=progress))
    launches = (launch for each in results for found in each.launches.values() for launch in found)
    if remark := Tally().add_all(launches).remark():
        say(f"note: {remark}")
    files = []
    if folder is not None:
        for result in results:
            own = Path(folder) / result.table.name if len(results) > 1 else Path(folder)
            files += tour_report.write(result, own)
    if as_json:
        documents = [tour_tables.document(each) for each in results]
        together = {"averages": documents, "mean_absolute_error": tour_tables.mean_errors(results)}
        output.print_json(together if len(results) > 1 else documents[0])
    else:
        for result in results:
            title = f"{result.table.title}, by {tour_tables.first_model(result)}"
            print_numbers(*tour_tables.answer(result), title=title, summary=True)
            print()
        for result in results:
            _print(result)
        if len(results) > 1:
            title = "Mean absolute error over all rows of these tables"
            print_numbers(*tour_tables.summary(results), title=title)
    say_written(files)


def _print(result: Tour) -> None:
    from clubface.validation import tour_tables

    for title, table in (
        (tour_tables.LOFTS, tour_tables.lofts(result)),
        (tour_tables.RATIOS, tour_tables.ratios(result)),
    ):
        print_numbers(*table, title=f"{result.table.title}: {title}")
        print()
    for quantity, unit in tour_tables.compared(result).items():
        heads, rows = tour_tables.comparison(result, quantity, signed=True)
        title = (
            f"{result.table.title}: {tour_tables.TITLES[quantity].lower()} ({unit}), published and model less published"
        )
        print_numbers(heads, rows, title=title, summary=True)
        print()
    output.print_notes(tour_tables.notes(result))
    print()
