"""``clubface evaluate``: models compared with measured shots."""

from __future__ import annotations

import sys
from typing import Annotated, Any

import typer

from clubface.cli import options, output, show
from clubface.cli.failures import print_note
from clubface.cli.recorded import RECORDED, recorded_shots

app = typer.Typer(add_completion=False)

EVALUATION = options.group(None,
    parameters=(options.Texts, None, "NAME|FILE", "A published parameter set or a TOML file; models that it does not"
                " fit keep their own. Repeatable."),
    noise=(options.Texts, None, "NAME=VALUE",
           'Standard deviation of the monitor: "launch=0.2 deg". Repeatable.'),
    delivery_noise=(options.Texts, None, "NAME=VALUE",
                    'Standard deviation of the measured delivery: "face=0.3 deg". Repeatable.'),
    resamples=(int, 2000, "N", "Number of bootstrap samples."),
)  # fmt: skip


@app.command()
@options.takes(RECORDED, EVALUATION, options.SETTING, options.AT_LAUNCH, options.SEED, show.FOLDER, show.JSON)
def evaluate(
    shots: Annotated[
        str, options.argument("SHOTS", "Deliveries and launches: CSV, Parquet or a launch monitor's file.")
    ],
    models: Annotated[
        list[str] | None, options.option("--models", "--model", metavar="NAME", text=options.MODELS_TEXT)
    ] = None,
    **texts: Any,
) -> None:
    """Compare models with measured shots: the errors, what they depend on, and which model is best."""
    names, folder = options.model_names(models), texts["folder"]
    output.prepare_folder(folder)
    from clubface.inference.evaluation.evaluation import evaluate as compute
    from clubface.inference.evaluation.result import refuse_input

    if folder is not None:
        refuse_input(folder, shots)
    recorded = recorded_shots(shots, texts)
    evaluation = compute(
        recorded, models=names, ball=texts["ball"],
        parameters=options.parameter_sets(names, recorded.club.parameters, texts["parameters"], texts["setting"]),
        noise=options.pairs(texts["noise"] or (), "--noise"),
        delivery_noise=options.pairs(texts["delivery_noise"] or (), "--delivery-noise"),
        compared_at="launch" if texts["at_launch"] else "delivery", resamples=texts["resamples"], seed=texts["seed"],
        progress=(lambda name: print_note(f"computing {name}")) if sys.stderr.isatty() else None,
    )  # fmt: skip
    written = [] if folder is None else evaluation.write(folder)
    show.Output(texts["as_json"]).show(evaluation.to_result(), more=[str(each) for each in written])
