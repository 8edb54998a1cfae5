"""``clubface identify``: model parameters from measured shots, and how well they are known."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.output import print_numbers, progress_bar
from clubface.cli.recorded import RECORDED, recorded_shots
from clubface.equipment.models import model as model_named
from clubface.errors import ClubfaceError, InputError
from clubface.support.files import write_text

app = typer.Typer(add_completion=False)

_FIT, _SEARCH = "What is fitted", "Search and intervals"


def _option(*names: str, panel: str, metavar: str | None = None, text: str) -> Any:
    return typer.Option(*names, metavar=metavar, rich_help_panel=panel, help=text, show_default=metavar is None)


@app.command()
@options.takes(RECORDED, options.FITTED_MODEL)
def identify(
    shots: Annotated[
        str,
        typer.Argument(metavar="SHOTS", help="Recorded shots: a launch monitor's file, or a table, CSV or Parquet."),
    ],
    free: Annotated[
        list[str] | None,
        _option(
            "--free",
            panel=_FIT,
            metavar="NAME",
            text="Parameter to identify; several with commas or repeated, or all. As published unless given.",
        ),
    ] = None,
    tie: Annotated[
        list[str] | None,
        _option("--tie", panel=_FIT, metavar="A=B", text="Let parameter A take the value of the free B. Repeatable."),
    ] = None,
    bounds: Annotated[
        list[str] | None,
        _option("--bounds", panel=_FIT, metavar="NAME=LOW:HIGH", text="Narrower bounds of a parameter. Repeatable."),
    ] = None,
    at_launch: options.AtLaunch = False,
    cost: Annotated[
        str,
        _option(
            "--cost",
            panel=_FIT,
            text="What is minimised: published (Caldwell and McPhee, Eq. 22), least-squares or robust.",
        ),
    ] = "published",
    normaliser: Annotated[
        str, _option("--normaliser", panel=_FIT, text="Means by which Eq. 22 divides: absolute or signed.")
    ] = "absolute",
    noise: Annotated[
        list[str] | None,
        _option(
            "--noise", panel=_FIT, metavar="NAME=VALUE", text='Noise of the monitor: backspin="80 rpm". Repeatable.'
        ),
    ] = None,
    quantities: Annotated[
        list[str] | None,
        _option(
            "--quantity",
            panel=_FIT,
            metavar="NAME",
            text="Launch quantity to compare. Repeatable; the five of Caldwell and McPhee unless given.",
        ),
    ] = None,
    population: Annotated[
        int, _option("--population", panel=_SEARCH, text="Population of the genetic algorithm.")
    ] = 200,
    generations: Annotated[
        int, _option("--generations", panel=_SEARCH, text="Generations of the genetic algorithm.")
    ] = 100,
    refined: Annotated[
        int, _option("--refined", panel=_SEARCH, text="How many of the best points are refined by derivatives.")
    ] = 5,
    folds: Annotated[int, _option("--folds", panel=_SEARCH, text="Folds of the hold-out; 0 for none.")] = 5,
    bootstrap: Annotated[int, _option("--bootstrap", panel=_SEARCH, text="Bootstrap samples; 0 for none.")] = 200,
    profiles: Annotated[
        bool, _option("--profiles/--no-profiles", panel=_SEARCH, text="Compute profile likelihoods.")
    ] = True,
    confidence: Annotated[float, _option("--confidence", panel=_SEARCH, text="Confidence of the intervals.")] = 0.95,
    seed: Annotated[int, _option("--seed", panel=_SEARCH, text="Seed of the random numbers.")] = 1,
    threads: Annotated[
        int | None, _option("--threads", panel=_SEARCH, metavar="N", text="Number of threads; all cores unless given.")
    ] = None,
    target: Annotated[
        str | None,
        options.output("FILE", "Write the parameters to this TOML file, which --parameters takes elsewhere."),
    ] = None,
    plot: Annotated[str | None, options.picture("profiles and intervals")] = None,
    checkpoint: Annotated[
        str | None,
        options.option(
            "--checkpoint",
            metavar="FOLDER",
            text="Folder that keeps what is finished; SHOTS-CLUB-MODEL.checkpoint unless given.",
        ),
    ] = None,
    resume: options.Resume = False,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Identify parameters of a model from shots whose delivery and launch were measured."""
    ties = {name: value.strip() for name, value in options.pairs(tie or (), "--tie").items()}
    read = [shots, *(texts[name] for name in ("club", "ball", "parameters", "mapping"))]
    output.check_target("--output", target, (".toml",), read)
    output.check_picture(plot, read)
    if texts["model"] is None:
        raise ClubfaceError("--model is missing; name the model whose parameters to find, as in --model slip")
    model = model_named(texts["model"]).name

    from clubface.inference.identification.run import identify as fit

    recorded = recorded_shots(shots, texts)
    head = recorded.club
    kept = checkpoint or f"{Path(shots).stem}-{head.name}-{model}.checkpoint".replace("/", " ")
    with progress_bar(lambda done, whole, stage, best: f"{stage}, {done} of {whole}, least cost {best:.6g}") as update:
        found = fit(
            recorded, club=head, model=model, parameters=options.one_set(head, texts), free=_free(free),
            tied=ties or None, bounds=_bounds(bounds), ball=texts["ball"],
            quantities=options.names(quantities) or None,
            compared_at="launch" if at_launch else "delivery", cost=cost, normaliser=normaliser,
            noise=options.pairs(noise or (), "--noise"), population=population,
            generations=generations, refined=refined, folds=folds, bootstrap=bootstrap,
            profiles=None if profiles else (), confidence=confidence, seed=seed, accuracy=texts["accuracy"],
            threads=threads, checkpoint=kept, resume=resume,
            progress=update and (lambda stage, done, whole, best: update(done, whole, stage, best)),
        )  # fmt: skip
    try:
        _write(found, target, plot)
    finally:  # what took long is shown even where a disk is full
        if as_json:
            output.print_json(found.to_dict())
        else:
            _print(found)


def _write(found: Any, target: str | None, plot: str | None) -> None:
    if target is not None:
        write_text(target, found.to_toml())
    if plot is not None:
        from clubface.inference.identification.picture import identification_figure
        from clubface.plots import save

        save(identification_figure(found), plot)


def _print(found: Any) -> None:
    from clubface.inference.identification import result as report

    share = f"{100 * found.confidence:g}% interval"
    heads = ["parameter", "value", f"{share}\nfrom", "\nto", "profile\nlikelihood", "\nidentified"]
    print_numbers(heads, report.parameter_rows(found), title=report.headline(found))
    print()
    print_numbers([each.replace(" ", "\n") for each in report.DEVIATION_HEADS], report.deviation_rows(found))
    output.print_notes([*report.remarks(found), report.effort(found)])


def _free(texts: Iterable[str] | None) -> str | list[str] | None:
    names = options.names(texts)
    return "all" if names == ["all"] else names or None


def _bounds(texts: Iterable[str] | None) -> dict[str, tuple[str, str]]:
    found = {}
    for name, value in options.pairs(texts or (), "--bounds").items():
        low, colon, high = value.partition(":")
        if not (colon and low.strip() and high.strip()):
            raise InputError("--bounds", f"{name}={value}", "of the form name=low:high")
        found[name] = (low.strip(), high.strip())
    return found
