"""``clubface infer``: from launches back to the deliveries that can have made them."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.failures import say
from clubface.cli.output import print_numbers, progress_bar
from clubface.cli.recorded import RECORDED, recorded_shots
from clubface.errors import ClubfaceError
from clubface.shots.tables.writer import KINDS
from clubface.simulation.results import outputs
from clubface.support.checks import check_choice

app = typer.Typer(add_completion=False)

_PRIOR = options.option(
    "--prior",
    metavar="NAME|FILE",
    text="Deliveries believed before: elite, tour, wide or a TOML file; elite, or else tour, unless given.",
)
_NOISE = options.option(
    "--noise", metavar="NAME=VALUE", text='Standard deviation of a measurement: "backspin=100 rpm". Repeatable.'
)
_DELIVERY_NOISE = options.option(
    "--delivery-noise", metavar="NAME=VALUE", text='The same of measured club data: "attack=2 deg". Repeatable.'
)
_IGNORE = options.option(
    "--ignore",
    metavar="NAME",
    text="Club data of a file that is not used, several with commas or repeated, or all.",
)
_OUTPUT = options.output(
    "FILE", "Write the draws, CSV or Parquet; for a file of launches, a CSV file with a row for each."
)


@app.command()
@options.takes(options.MEASURED_LAUNCH, options.MEASURED_CLUB, RECORDED, options.ONE_MODEL)
def infer(
    shots: Annotated[
        str | None, typer.Argument(metavar="[SHOTS]", help="A file of launches, in place of the options of one launch.")
    ] = None,
    prior: Annotated[str | None, _PRIOR] = None,
    noise: Annotated[list[str] | None, _NOISE] = None,
    delivery_noise: Annotated[list[str] | None, _DELIVERY_NOISE] = None,
    ignore: Annotated[list[str] | None, _IGNORE] = None,
    samples: Annotated[
        int | None,
        typer.Option("--samples", metavar="N", help="Number of deliveries drawn; 2000, or 400 a shot of a file."),
    ] = None,
    seed: options.Seed = 0,
    target: Annotated[str | None, _OUTPUT] = None,
    picture: Annotated[str | None, options.picture("every pair of quantities")] = None,
    resume: options.Resume = False,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Sample the deliveries that can have made a launch, and say what the launch leaves open."""
    from clubface.simulation.inputs import OF_CLUB

    dimensions = {name: outputs()[name].dimension for name in options.MEASURED_LAUNCH}
    launch, delivery = options.quantities(texts, dimensions, {}), options.quantities(texts, OF_CLUB, {})
    settings: dict[str, Any] = {
        "model": texts["model"], "ball": texts["ball"], "prior": prior, "seed": seed, "accuracy": texts["accuracy"],
        "noise": options.pairs(noise or (), "--noise"),
        "delivery_noise": options.pairs(delivery_noise or (), "--delivery-noise"),
        **({} if samples is None else {"samples": samples}),
    }  # fmt: skip
    if shots is not None:
        if launch or delivery or picture:
            option = "plot" if picture else next(iter({**launch, **delivery})).replace("_", "-")
            raise ClubfaceError(f"--{option} is for one launch; leave out either --{option} or the file {shots}")
        recorded = recorded_shots(shots, texts)
        for note in recorded.notes:
            say(f"note: {note}")
        settings |= {"club": recorded.club, "parameters": options.one_set(recorded.club, texts)}
        _whole_file(_without(recorded, options.names(ignore)), settings, target, resume, as_json)
        return
    if ignore:
        raise ClubfaceError("--ignore is for a file of shots; of one launch, leave out the club data itself")
    if texts["club"] is None:
        raise ClubfaceError("--club is missing; give the club, as in --club driver")
    head = options.club_of(texts["club"], texts["hand"], texts.get("model"))
    output.check_target("--output", target, KINDS)
    output.check_picture(picture)
    from clubface.inference import posterior
    from clubface.inference.run import infer as compute

    if not launch:
        measured = ", ".join(f"--{name.replace('_', '-')}" for name in options.MEASURED_LAUNCH)
        raise ClubfaceError(f"no launch is given; give at least one of {measured}")
    found = compute(launch, club=head, delivery=delivery, parameters=options.one_set(head, texts), **settings)
    if target is not None:
        found.shots().write(target)
        say(f"wrote {target}")
    if picture is not None:
        from clubface import plots
        from clubface.inference.picture import pairs_figure

        say(f"wrote {plots.save(pairs_figure(found), picture)}")
    if as_json:
        output.print_json(posterior.document(found))
    else:
        heads, rows = posterior.summary(found)
        print_numbers(heads, rows, title=f"Deliveries that make this launch: {head.name}, {found.model}")
        print()
        output.print_notes(posterior.notes(found))


def _without(recorded: Any, ignored: list[str]) -> Any:
    """Return the shots without the club data ``ignored``."""
    from dataclasses import replace

    from clubface.simulation.inputs import OF_CLUB

    for name in ignored:
        check_choice("--ignore", name, (*OF_CLUB, "all"))
    left = {
        name: values
        for name, values in recorded.deliveries.items()
        if name not in OF_CLUB or not {name, "all"} & set(ignored)
    }
    return replace(recorded, deliveries=left)


def _whole_file(recorded: Any, settings: dict[str, Any], target: str | None, resume: bool, as_json: bool) -> None:
    if target is None:
        raise ClubfaceError("--output is missing; give the CSV file to write, as in --output deliveries.csv")
    from clubface.inference.file import infer_shots

    with progress_bar("launches") as progress:
        report = infer_shots(recorded, target, resume=resume, progress=progress, **settings)
    if as_json:
        output.print_json(report._asdict())
        return
    print(f"{report.shots - report.without} of {report.shots} launches inferred: {report.output}")
    if report.used:
        say(f"note: measured club data counted, too: {', '.join(report.used)}")
    if report.warned:
        say(f"note: {report.warned} with a remark in the last column")
