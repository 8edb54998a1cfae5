"""``clubface infer``: from launches back to the deliveries that could have produced them."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Any

import typer

from clubface.cli import options, show
from clubface.cli.failures import print_note
from clubface.cli.output import progress_bar
from clubface.cli.recorded import RECORDED, recorded_shots
from clubface.errors import ClubfaceError
from clubface.shots.tables.writer import KINDS
from clubface.simulation.results import outputs
from clubface.support.checks import check_choice

app = typer.Typer(add_completion=False)

INFERENCE = options.group(None,
    prior=(str | None, None, "NAME|FILE",
           "Prior of the deliveries: elite, tour, wide or a TOML file; the default depends on the club."),
    noise=(options.Texts, None, "NAME=VALUE",
           'Standard deviation of a measurement: "backspin=100 rpm". Repeatable.'),
    delivery_noise=(options.Texts, None, "NAME=VALUE",
                    'The same for measured club data: "attack=2 deg". Repeatable.'),
    ignore=(options.Texts, None, "NAME",
            "Club data in the file to ignore; several: comma-separated or repeated, or all."),
    samples=(int | None, None, "N", "Number of deliveries drawn; 2000, or 400 for each shot of a file."),
)  # fmt: skip


@app.command()
@options.takes(
    options.MEASURED_LAUNCH, options.MEASURED_CLUB, RECORDED, options.ONE_MODEL, INFERENCE,
    show.plot_option("every pair of quantities"), show.JSON, options.SEED, options.RESUME,
    show.table_option("Write the draws, CSV or Parquet; for a file of launches, a CSV file with one row per launch."),
)  # fmt: skip
def infer(
    shots: Annotated[
        str | None, options.argument("[SHOTS]", "A file of launches, instead of the options for one launch.")
    ] = None,
    **texts: Any,
) -> None:
    """Sample the deliveries that could have produced a launch, and say what the launch does not determine."""
    from clubface.simulation.inputs import OF_CLUB

    dimensions = {name: outputs()[name].dimension for name in options.MEASURED_LAUNCH}
    launch, delivery = options.quantities(texts, dimensions, {}), options.quantities(texts, OF_CLUB, {})
    settings: dict[str, Any] = {
        **{name: texts[name] for name in ("model", "ball", "prior", "accuracy", "seed")},
        "noise": options.pairs(texts["noise"] or (), "--noise"),
        "delivery_noise": options.pairs(texts["delivery_noise"] or (), "--delivery-noise"),
        **({} if texts["samples"] is None else {"samples": texts["samples"]}),
    }  # fmt: skip
    if shots is not None:
        if launch or delivery or texts["plot"]:
            option = "plot" if texts["plot"] else next(iter({**launch, **delivery})).replace("_", "-")
            raise ClubfaceError(f"--{option} is for one launch; leave out either --{option} or the file {shots}")
        _infer_file(shots, texts, settings)
        return
    if texts["ignore"]:
        raise ClubfaceError("--ignore is for a file of shots; for a single launch, leave out the club data itself")
    if texts["club"] is None:
        raise ClubfaceError("--club is missing; give the club, as in --club driver")
    head = options.club_of(texts["club"], texts["hand"], texts.get("model"))
    shown = show.Output.check(texts, kinds=KINDS)
    if not launch:
        measured = ", ".join(f"--{name.replace('_', '-')}" for name in options.MEASURED_LAUNCH)
        raise ClubfaceError(f"no launch is given; give at least one of {measured}")
    from clubface.inference.run import infer as compute

    posterior = compute(launch, club=head, delivery=delivery, parameters=options.one_set(head, texts), **settings)
    if shown.target is not None:
        posterior.shots().write(shown.target)
    shown.show(posterior.to_result(), write_table=False)


def _infer_file(path: str, texts: dict[str, Any], settings: dict[str, Any]) -> None:
    from clubface.inference.file import infer_shots
    from clubface.simulation.inputs import OF_CLUB

    recorded = recorded_shots(path, texts)
    for remark in recorded.notes:
        print_note(f"note: {remark}")
    ignored = options.names(texts["ignore"])
    for name in ignored:
        check_choice("--ignore", name, (*OF_CLUB, "all"))
    left = set(recorded.deliveries) - set(OF_CLUB if "all" in ignored else ignored)
    used = replace(recorded, deliveries={name: each for name, each in recorded.deliveries.items() if name in left})
    if texts["target"] is None:
        raise ClubfaceError("--output is missing; give the CSV file to write, as in --output deliveries.csv")
    settings |= {"club": recorded.club, "parameters": options.one_set(recorded.club, texts)}
    with progress_bar("launches") as progress:
        report = infer_shots(used, texts["target"], resume=texts["resume"], progress=progress, **settings)
    show.Output(texts["as_json"]).show(report.to_result())
