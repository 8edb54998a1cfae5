"""``clubface study``: inputs swept over a computation, on any number of processes and machines."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated

import typer

from clubface.cli import option_values, options, output
from clubface.cli.failures import say, say_written
from clubface.cli.progress import progress_bar
from clubface.cli.study_summary import document, print_summary, write_report
from clubface.errors import InputError

app = typer.Typer(
    add_completion=False, no_args_is_help=True, help="Studies: any inputs of a shot swept, on one machine or a cluster."
)

StudyArgument = Annotated[str, typer.Argument(metavar="STUDY", help="TOML file of a study.")]
StudyOrStore = Annotated[
    str, typer.Argument(metavar="STUDY", help="TOML file of a study, or the folder of its finished parts.")
]
StoreOption = Annotated[
    str | None,
    options.option("--store", metavar="FOLDER", text="Folder of the finished parts; STUDY.store unless given."),
]
TABLES = (".parquet", ".pq", ".csv", ".tsv")


@app.command("run")
def run(
    study: StudyArgument,
    workers: Annotated[
        int | None,
        typer.Option("--workers", metavar="N", help="Processes at a time; one for each processor unless given."),
    ] = None,
    shard: Annotated[
        str | None,
        options.option("--shard", metavar="K/N", text="Compute share K of N; slurm or kubernetes/N in a job's array."),
    ] = None,
    scheduler: Annotated[
        str | None,
        options.option("--scheduler", metavar="ADDRESS", text="Compute on the Dask cluster with this scheduler."),
    ] = None,
    store: StoreOption = None,
    as_json: options.Json = False,
) -> None:
    """Compute what is missing of a study; what is finished stays, whatever happens."""
    from clubface.studies.running import run as compute

    with progress_bar("chunks") as progress:
        done = compute(study, store=store, workers=workers, shard=shard, scheduler=scheduler, progress=progress)
    count, shown = done.mended
    if count:
        chunks = (
            f"{output.counted(count, 'damaged part')} ({', '.join(map(str, shown))}{', ...' * (count > len(shown))})"
        )
        say(f"note: {chunks} {'was' if count == 1 else 'were'} computed again")
    _tell(done.failed, done.remark)
    if as_json:
        output.print_json(asdict(done))
        return
    kept = done.chunks - done.computed
    tasks, chunks = output.counted(done.tasks, "task"), output.counted(done.chunks, "chunk")
    print(f"{tasks} in {chunks}: {done.computed} computed, {kept} there already")
    if done.missing:
        print(f"{output.counted(done.missing, 'chunk')} of the whole study left to other runs; parts in {done.store}")
    else:
        print(f"the study is complete in {done.store}")


@app.command("status")
def status(
    study: StudyOrStore,
    check: Annotated[bool, typer.Option("--check", help="Read every part and tell the damaged ones.")] = False,
    store: StoreOption = None,
    as_json: options.Json = False,
) -> None:
    """Tell how far a study is."""
    from clubface.studies.state import status as state

    with progress_bar("parts") as progress:
        found = state(study, store=store, check=check, progress=progress)
    if as_json:
        output.print_json(asdict(found))
        return
    tasks, chunks = output.counted(found.tasks, "task"), output.counted(found.chunks, "chunk")
    done = "is done" if found.chunks == 1 else "are done"
    print(f"{found.name}: {found.done} of {chunks} {done}; {tasks}, {found.chunk} a chunk")
    size = f"{found.size / 1e6:.1f} MB" if found.size >= 1e6 else f"{found.size / 1e3:.1f} kB"
    print(f"parts in {found.store}, {size}")
    for what, chunks in (("missing", found.missing), ("damaged", found.damaged)):
        if chunks:
            print(f"{what}, the first of them: {', '.join(map(str, chunks))}")


@app.command("join")
def join(
    study: StudyOrStore,
    target: Annotated[str | None, options.output("FILE", "Write the table, Parquet or CSV by its ending.")] = None,
    store: StoreOption = None,
    as_json: options.Json = False,
) -> None:
    """Put all parts together in the order of the tasks, and print the SHA-256 of every column."""
    from clubface.studies.joining import join as put_together

    output.check_target("--output", target, TABLES, (study,))
    with progress_bar("parts") as progress:
        found = put_together(study, target, store=store, progress=progress)
    _tell(found.failed, found.remark)
    if len(found.processors) > 1:
        say(f"note: computed on {', '.join(found.processors)}, which agree to rounding, not in the last digits")
    if as_json:
        output.print_json(asdict(found))
    else:
        print(f"{output.counted(found.tasks, 'task')}; SHA-256 of their columns:")
        width = max(map(len, found.sums))
        for name, each in found.sums.items():
            print(f"{name.ljust(width)}  {each}")
    say_written([target] if target is not None else [])


@app.command("summary")
def summary(
    study: StudyOrStore,
    quantities: Annotated[
        list[str] | None,
        options.option("--output", metavar="NAMES", text="Quantities with commas or repeated; all unless given."),
    ] = None,
    plot: Annotated[str | None, options.picture("means, spreads and extremes along every input")] = None,
    report: options.Report = None,
    store: StoreOption = None,
    as_json: options.Json = False,
) -> None:
    """Print means, spreads and extremes, of all tasks and along every input that was swept."""
    from clubface.studies.summaries import summary as sum_up

    output.check_picture(plot, [study])
    output.check_report(report, [study])
    names = option_values.names(quantities) if quantities else None
    if names == []:
        raise InputError("--output", quantities, "names of quantities, as in carry,backspin")
    with progress_bar("parts") as progress:
        found = sum_up(study, quantities=names, store=store, progress=progress)
    _tell(found.failed, found.remark)
    if plot is not None:
        from clubface.plots.style import save
        from clubface.studies.picture import draw

        save(draw(found), plot)
    if report is not None:
        write_report(found, study, report)
    if as_json:
        output.print_json(document(found))
    else:
        print_summary(found)
    say_written([each for each in (plot, report) if each is not None])


def _tell(failed: tuple[int, str], remark: str) -> None:
    count, first = failed
    if count:
        say(f"note: {output.counted(count, 'task')} without a result; the first is {first}")
    if remark:
        say(f"note: {remark}")
