"""``clubface validate``: models beside published figures, with tolerances."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.failures import say_written
from clubface.cli.output import print_numbers, progress_bar
from clubface.equipment.models import DEFAULT_MODEL

if TYPE_CHECKING:
    from clubface.validation.own_monitor import OwnMonitor
    from clubface.validation.run import Validation


app = typer.Typer(add_completion=False)

_MODEL_TEXT = (
    f"A model, or several with commas or repeated; all means every reduced model. {DEFAULT_MODEL} unless given."
)
_MODEL = options.option("--model", metavar="NAME", text=_MODEL_TEXT)
_CHECK_TEXT = "Only this check, or several with commas or repeated, with every figure and its source."
_WITH_TEXT = "A monitor's file whose spins are set beside the model and both camps of published irons. Repeatable."
_WITH = options.option("--with", metavar="FILE", text=_WITH_TEXT)
_CHECK = options.option("--check", metavar="NAME", text=_CHECK_TEXT)
_CAUSES_TEXT = "Also strikes off the centre with one thing changed: closure, inertia or depth of the mass centre."
_CAUSES = typer.Option("--causes", help=_CAUSES_TEXT)


@app.command()
def validate(
    folder: options.Folder = None,
    check: Annotated[list[str] | None, _CHECK] = None,
    model: Annotated[list[str] | None, _MODEL] = None,
    causes: Annotated[bool, _CAUSES] = False,
    session: Annotated[list[str] | None, _WITH] = None,
    ball: options.Ball = None,
    as_json: options.Json = False,
) -> None:
    """Compare models with published figures, and say which of them they meet."""
    from clubface.validation import report, run, tables
    from clubface.validation.catalogue import check_named

    models = options.model_names(model, DEFAULT_MODEL)
    checks = options.names(check) or None
    for each in checks or ():
        check_named(each)  # before the work: a name that does not exist is found at once
    output.prepare_folder(folder)
    own = None
    if session:
        from clubface.validation.own_monitor import own_monitor

        own = own_monitor(session, model=models[0], ball=ball)
    with progress_bar("checks") as progress:
        result = run.validate(models, checks=checks, ball=ball, progress=progress)
    files = report.write(result, Path(folder)) if folder is not None else []
    if as_json:
        document = tables.document(result)
        if causes:
            document["off_centre"] = {
                name: [dict(zip(heads, row, strict=True)) for row in rows]
                for name, heads, rows in _causes(models, ball)
            }
        if own is not None:
            document["own_monitor"] = _own_document(own)
        output.print_json(document)
    else:
        if checks:
            _print_figures(result)
        print_numbers(tables.SUMMARY_HEADS, tables.summary_rows(result), title=f"Published figures, ball {result.ball}")
        print()
        output.print_notes(tables.verdicts(result))
        if causes:
            _print_causes(models, ball)
        if own is not None:
            _print_own(own)
    say_written(files)


def _print_figures(result: Validation) -> None:
    from clubface.validation import tables

    for each in result.checks:
        for model in result.models:
            title = f"{each.title}, by {model}"
            print_numbers(tables.FIGURE_HEADS, tables.figure_rows(result.figures[model][each.name]), title=title)
            print()
        output.print_notes(tables.notes(each))
        print()


def _print_causes(models: Sequence[str], ball: str | None) -> None:
    for model, heads, rows in _causes(models, ball):
        print()
        print_numbers(heads, rows, title=f"Strikes off the centre with one thing changed, by {model}")


def _causes(models: Sequence[str], ball: str | None) -> Iterator[tuple[str, list[str], list[list[str]]]]:
    """Yield each model with the headings and rows of its strikes off the centre."""
    from clubface.validation import off_centre

    for model in models:
        yield model, off_centre.HEADS, off_centre.causes(model, ball)


def _own_document(own: OwnMonitor) -> dict[str, Any]:
    from clubface.validation.own_monitor import document

    return document(own)


def _print_own(own: OwnMonitor) -> None:
    from clubface.validation.own_monitor import HEADS, remarks, table_rows

    print()
    print_numbers(HEADS, table_rows(own), title=f"{own.source} beside {own.model} at its own measured launch")
    output.print_notes(remarks(own))
