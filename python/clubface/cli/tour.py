"""``clubface tour``: every club of the published tour averages by every model, beside what was published."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from clubface.cli import given, options, output
from clubface.cli.failures import say
from clubface.cli.fem_progress import progress_bar
from clubface.cli.tables import print_numbers

if TYPE_CHECKING:
    from clubface.tour.averages import Tour

app = typer.Typer(add_completion=False)

TABLES_TEXT = "pga-2023, pga-2019, lpga-2019, or several with commas; all means every one. pga-2023 unless given."


@app.command()
def tour(
    folder: Annotated[
        str | None,
        typer.Option(
            "--output", "-o", metavar="FOLDER", help="Write tables and pictures to this folder.", show_default=False
        ),
    ] = None,
    averages: Annotated[str, typer.Option(metavar="NAME", help=TABLES_TEXT, show_default=False)] = "",
    model: options.Models = None,
    ball: options.Ball = "published",
    as_json: options.Json = False,
) -> None:
    """Compare every model with the published tour averages, club by club."""
    from clubface.tour import averages as job

    names = given.model_names(model)
    wanted = [each.strip() for each in (averages or job.DEFAULT_TABLE).split(",")]
    which = list(dict.fromkeys(name for each in wanted for name in (job.TABLES if each == "all" else [each])))
    for each in which:
        job.averages(each)  # before the work: a name that does not exist is found at once
    if folder is not None:
        # So is a folder that cannot be made, or a missing library.
        Path(folder).mkdir(parents=True, exist_ok=True)
        import clubface.plots as plots  # noqa: F401
    from clubface.tour import report, tables

    results = []
    for table in which:
        with progress_bar() as bar:
            results.append(job.tour(names, table=table, ball=ball, progress=bar and _telling(bar, table)))
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
            _print(result)
        if len(results) > 1:
            title = "Mean absolute error over all rows of these tables"
            print_numbers(*tables.summary(results), title=title)
    if files:
        say(f"wrote {', '.join(str(each) for each in files)}")


def _telling(bar: Callable[[float, float, str], object], table: str) -> Callable[[int, int], object]:
    return lambda done, every: bar(done, every, table)


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
