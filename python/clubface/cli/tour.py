"""``clubface tour``: every club of the published tour averages by every model, beside what was published."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clubface.cli import option_values, options, output
from clubface.cli.failures import say, say_written
from clubface.cli.progress import progress_bar
from clubface.cli.tables import print_numbers
from clubface.errors import RangeWarning

if TYPE_CHECKING:
    from clubface.tour.tour import Tour

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
    from clubface.tour import averages as published, tour as job

    names = option_values.model_names(model)
    wanted = option_values.names([averages or published.DEFAULT_TABLE])
    which = list(dict.fromkeys(name for each in wanted for name in (published.TABLES if each == "all" else [each])))
    for each in which:
        published.averages(each)  # before the work: a name that does not exist is found at once
    output.prepare_folder(folder)
    from clubface.simulation.outside import Tally
    from clubface.support.warning import without_warnings
    from clubface.tour import report, tables

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
            files += report.write(result, own)
    if as_json:
        documents = [tables.document(each) for each in results]
        together = {"averages": documents, "mean_absolute_error": tables.mean_errors(results)}
        output.print_json(together if len(results) > 1 else documents[0])
    else:
        for result in results:
            title = f"{result.table.title}, by {tables.first_model(result)}"
            print_numbers(*tables.answer(result), title=title, summary=True)
            print()
        for result in results:
            _print(result)
        if len(results) > 1:
            title = "Mean absolute error over all rows of these tables"
            print_numbers(*tables.summary(results), title=title)
    say_written(files)


def _print(result: Tour) -> None:
    from clubface.tour import tables

    for title, table in ((tables.LOFTS, tables.lofts(result)), (tables.RATIOS, tables.ratios(result))):
        print_numbers(*table, title=f"{result.table.title}: {title}")
        print()
    for quantity, unit in tables.compared(result).items():
        heads, rows = tables.comparison(result, quantity, signed=True)
        title = f"{result.table.title}: {tables.TITLES[quantity].lower()} ({unit}), published and model less published"
        print_numbers(heads, rows, title=title, summary=True)
        print()
    output.print_notes(tables.notes(result))
    print()
