"""``clubface identify``: model parameters from measured shots, and how well they are known."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Annotated, Any

import typer

from clubface.cli import options, output, show
from clubface.cli.output import progress_bar
from clubface.cli.recorded import RECORDED, recorded_shots
from clubface.equipment.models import model as model_named
from clubface.errors import ClubfaceError, InputError
from clubface.support.files import file_stem, write_text

app = typer.Typer(add_completion=False)


FIT = options.group("What is fitted",
    free=(options.Texts, None, "NAME",
          "Parameter to identify; several: comma-separated or repeated, or all. Default: as published."),
    tie=(options.Texts, None, "A=B", "Let parameter A take the value of the free B. Repeatable."),
    bounds=(options.Texts, None, "NAME=LOW:HIGH", "Narrower bounds of a parameter. Repeatable."),
    cost=(str, "published", None,
          "What is minimised: published (Caldwell and McPhee, Eq. 22), least-squares or robust."),
    normaliser=(str, "absolute", None, "Means in the denominators of Eq. 22: absolute or signed."),
    noise=(options.Texts, None, "NAME=VALUE", 'Noise of the monitor: backspin="80 rpm". Repeatable.'),
    quantity=(options.Texts, None, "NAME",
              "Launch quantity to compare. Repeatable; default: the five of Caldwell and McPhee."),
)  # fmt: skip
SEARCH = options.group(
    "Search and intervals",
    population=(int, 200, None, "Population of the genetic algorithm."),
    generations=(int, 100, None, "Generations of the genetic algorithm."),
    refined=(int, 5, None, "Number of best points to refine with derivatives."),
    folds=(int, 5, None, "Number of hold-out folds; 0 for none."),
    bootstrap=(int, 200, None, "Number of bootstrap samples; 0 for none."),
    profiles=(bool, True, None, "Compute profile likelihoods."),
    confidence=(float, 0.95, None, "Confidence of the intervals."),
    seed=(int, 1, None, "Random seed."),
    threads=(int | None, None, "N", "Number of threads; default: all cores."),
)
FILES = options.group(None,
    checkpoint=(str | None, None, "FOLDER",
                "Folder that keeps finished work; default SHOTS-CLUB-MODEL.checkpoint."),
)  # fmt: skip
_PASSED_ON = ("cost", "normaliser", *(name for name in SEARCH if name != "profiles"), "ball", "accuracy", "resume")
"""Options that are passed on to the fit unchanged."""


@app.command()
@options.takes(
    RECORDED, options.FITTED_MODEL, FIT, SEARCH, FILES, show.plot_option("profiles and intervals"), show.JSON,
    options.AT_LAUNCH, options.RESUME,
    show.table_option("Write the parameters to this TOML file, for --parameters of other commands."),
)  # fmt: skip
def identify(
    shots: Annotated[
        str, options.argument("SHOTS", "Recorded shots: a launch monitor's file, or a table, CSV or Parquet.")
    ],
    **texts: Any,
) -> None:
    """Identify model parameters from shots with measured delivery and launch."""
    ties = {name: value.strip() for name, value in options.pairs(texts["tie"] or (), "--tie").items()}
    read = [shots, *(texts[name] for name in ("club", "ball", "parameters", "mapping"))]
    output.check_target("--output", target := texts.pop("target"), (".toml",), read)
    shown = show.Output.check(texts, read)
    if texts["model"] is None:
        raise ClubfaceError("--model is missing; name the model to fit, as in --model slip")
    model = model_named(texts["model"]).name

    from clubface.inference.identification.run import identify as fit

    recorded = recorded_shots(shots, texts)
    head = recorded.club
    free = options.names(texts["free"])
    kept = texts["checkpoint"] or f"{file_stem(f'{Path(shots).stem}-{head.name}-{model}')}.checkpoint"
    with progress_bar(lambda done, whole, stage, best: f"{stage}, {done} of {whole}, least cost {best:.6g}") as update:
        identification = fit(
            recorded, club=head, model=model, parameters=options.one_set(head, texts),
            free="all" if free == ["all"] else free or None, tied=ties or None, bounds=_bounds(texts["bounds"]),
            quantities=options.names(texts["quantity"]) or None, checkpoint=kept,
            compared_at="launch" if texts["at_launch"] else "delivery",
            noise=options.pairs(texts["noise"] or (), "--noise"), profiles=None if texts["profiles"] else (),
            **{name: texts[name] for name in _PASSED_ON},
            progress=update and (lambda stage, done, whole, best: update(done, whole, stage, best)),
        )  # fmt: skip
    written = []
    try:
        if target is not None:
            written = [str(write_text(target, identification.to_toml()))]
    finally:  # show long computations even if the disk is full
        shown.show(identification.to_result(), more=written)


def _bounds(texts: Iterable[str] | None) -> dict[str, tuple[str, str]]:
    bounds = {}
    for name, value in options.pairs(texts or (), "--bounds").items():
        low, colon, high = value.partition(":")
        if not (colon and low.strip() and high.strip()):
            raise InputError("--bounds", f"{name}={value}", "of the form name=low:high")
        bounds[name] = (low.strip(), high.strip())
    return bounds
