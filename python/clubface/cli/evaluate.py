"""``clubface evaluate``: models beside measured shots."""

from __future__ import annotations

import sys
from typing import Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.failures import say, say_written
from clubface.cli.output import print_numbers
from clubface.cli.recorded import RECORDED, recorded_shots

app = typer.Typer(add_completion=False)

_MODELS = options.option("--models", "--model", metavar="NAME", text=options.MODELS_TEXT)
_PARAMETERS = options.option(
    "--parameters",
    metavar="NAME|FILE",
    text="A published parameter set or a TOML file; models that it does not fit keep theirs. Repeatable.",
)
_NOISE = options.option(
    "--noise", metavar="NAME=VALUE", text='Of the monitor, standard deviation: "launch=0.2 deg". Repeatable.'
)
_DELIVERY_NOISE = options.option(
    "--delivery-noise", metavar="NAME=VALUE", text='Of the measured delivery: "face=0.3 deg". Repeatable.'
)


@app.command()
@options.takes(RECORDED)
def evaluate(
    shots: Annotated[
        str, typer.Argument(metavar="SHOTS", help="Deliveries and launches: CSV, Parquet or a launch monitor's file.")
    ],
    models: Annotated[list[str] | None, _MODELS] = None,
    parameters: Annotated[list[str] | None, _PARAMETERS] = None,
    setting: options.Setting = None,
    noise: Annotated[list[str] | None, _NOISE] = None,
    delivery_noise: Annotated[list[str] | None, _DELIVERY_NOISE] = None,
    at_launch: options.AtLaunch = False,
    resamples: Annotated[int, typer.Option("--resamples", metavar="N", help="Number of bootstrap samples.")] = 2000,
    seed: options.Seed = 0,
    folder: options.Folder = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Compare models with measured shots: how large their errors are, what these depend on, which model is best."""
    names = options.model_names(models)
    output.prepare_folder(folder)
    from clubface.inference.evaluation import report, tables
    from clubface.inference.evaluation.evaluation import evaluate as compute

    if folder is not None:
        report.refuse_input(folder, shots)

    recorded = recorded_shots(shots, texts)
    sets = options.parameter_sets(names, recorded.club.parameters, parameters, setting)
    result = compute(
        recorded, models=names, parameters=sets, ball=texts["ball"],
        noise=options.pairs(noise or (), "--noise"),
        delivery_noise=options.pairs(delivery_noise or (), "--delivery-noise"),
        compared_at="launch" if at_launch else "delivery", resamples=resamples, seed=seed, progress=_progress(),
    )  # fmt: skip
    files = result.write(folder) if folder is not None else []
    if as_json:
        output.print_json(report.document(result))
    else:
        if remarks := tables.remarks(result):
            output.print_notes(remarks)
            print()
        shown = [*tables.in_published_form(result), *tables.published_form(result)]
        for table in [*shown, tables.best_models(result), tables.noise_floor(result)]:
            print_numbers(table.heads, table.rows, title=table.title)
            print()
        output.print_notes(tables.notes(result))
    say_written(files)


def _progress() -> Any:
    """Tell on a terminal which model is being computed."""
    return (lambda name: say(f"computing {name}")) if sys.stderr.isatty() else None
