"""``clubface study``: inputs swept over a computation, on any number of processes and machines."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, show
from clubface.cli.output import progress_bar
from clubface.errors import InputError

app = typer.Typer(
    add_completion=False, no_args_is_help=True, help="Studies: sweep any inputs, on one machine or a cluster."
)

StudyOrStore = Annotated[str, options.argument("STUDY", "TOML file of a study, or the folder with its finished parts.")]
STORE = options.group(None, store=(str | None, None, "FOLDER", "Folder for finished parts; default STUDY.store."))
WHERE = options.group(
    None,
    workers=(int | None, None, "N", "Number of processes; default: one per processor."),
    shard=(str | None, None, "K/N", "Compute only share K of N; slurm or kubernetes/N in an array job."),
    scheduler=(str | None, None, "ADDRESS", "Compute on the Dask cluster with this scheduler."),
)


@app.command("run")
@options.takes(WHERE, STORE, show.JSON)
def run(study: Annotated[str, options.argument("STUDY", "TOML file of a study.")], **texts: Any) -> None:
    """Compute the missing parts of a study; finished parts are kept, whatever happens."""
    from clubface.studies.running import run as compute

    shown = show.Output.check(texts)
    with progress_bar("chunks") as progress:
        done = compute(study, **{name: texts[name] for name in ("store", *WHERE)}, progress=progress)
    shown.show(done.to_result())


@app.command("status")
@options.takes(
    options.group(None, check=(bool, False, None, "Read every part and list the damaged ones.")), STORE, show.JSON
)
def status(study: StudyOrStore, **texts: Any) -> None:
    """Show the progress of a study."""
    from clubface.studies.running import status as state

    shown = show.Output.check(texts)
    with progress_bar("parts") as progress:
        result = state(study, store=texts["store"], check=texts["check"], progress=progress)
    shown.show(result.to_result())


@app.command("join")
@options.takes(show.table_option("Write the table to this Parquet or CSV file."), STORE, show.JSON)
def join(study: StudyOrStore, **texts: Any) -> None:
    """Join all parts in the order of the tasks, and print the SHA-256 of every column."""
    from clubface.studies.joining import join as put_together

    shown = show.Output.check(texts, (study,))
    with progress_bar("parts") as progress:
        joined = put_together(study, shown.target, store=texts["store"], progress=progress)
    shown.show(joined.to_result(), write_table=False)


@app.command("summary")
@options.takes(
    show.plot_option("means, spreads and extremes along every input"), show.REPORT, STORE, show.JSON,
    options.group(None,
        output=(options.Texts, None, "NAMES", "Quantities, comma-separated or repeated; default: all."),
    ),
)  # fmt: skip
def summary(study: StudyOrStore, **texts: Any) -> None:
    """Print means, spreads and extremes of all tasks and along every swept input."""
    from clubface.studies.summaries import summary as sum_up

    shown = show.Output.check(texts, [study])
    names = options.names(texts["output"]) if texts["output"] else None
    if names == []:
        raise InputError("--output", texts["output"], "names of quantities, as in carry,backspin")
    with progress_bar("parts") as progress:
        result = sum_up(study, quantities=names, store=texts["store"], progress=progress)
    shown.show(result.to_result())
