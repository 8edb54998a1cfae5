"""``clubface study``: inputs swept over a computation, on any number of processes and machines.

The summary of a study as ``clubface study summary`` prints and reports it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output, reporting
from clubface.cli.failures import say, say_written
from clubface.cli.output import print_numbers, progress_bar
from clubface.equipment.described import FLAT
from clubface.errors import InputError
from clubface.shots.tables.headings import heading_of
from clubface.units import from_si, size

if TYPE_CHECKING:
    from clubface.studies.summaries import Along, Figures, Summary


MOST_SHOWN = 8
"""Quantities whose means are printed along each input."""


def write_report(found: Summary, study: str, target: str) -> None:
    """Write the report of a summary; ``study`` is the file of the study, or the folder of its parts."""
    from clubface.studies.picture import draw

    reporting.write(
        target, title=f"The study {found.name}", words=_words(found),
        picture=("Means, spreads and extremes along every input", draw(found)), columns=_columns(found),
        show=lambda: print_summary(found), launches=(),
        given={"study": Path(study).name, "tasks": str(found.tasks)} | _held(study), **_flown(study),
    )  # fmt: skip


def _asked(study: str) -> Mapping[str, Any]:
    """Return what the file of a study of impacts holds fixed; nothing for other kinds, or for the folder of a study."""
    from clubface.studies.study import read_study

    asked = read_study(study) if Path(study).is_file() else None
    return asked.table if asked is not None and asked.kind.name == "impact" else {}


def _held(study: str) -> dict[str, str]:
    table = _asked(study)
    told = {name: table[name] for name in ("club", "ball", "hand", "model", "parameters") if name in table}
    return {name: str(value) for name, value in {**told, **table.get("held", {})}.items()}


def _flown(study: str) -> dict[str, Any]:
    """Return air, wind and ground of a study of impacts, and the sources of its club and ball."""
    from clubface.equipment.balls import ball
    from clubface.equipment.clubs import CLUB_NAMES, club
    from clubface.simulation.provenance import equipment_sources

    if not (table := _asked(study)):
        return {}
    clubs = [club(table["club"])] if table.get("club") in CLUB_NAMES else []
    return {
        "conditions": {name: table.get(name) for name in ("air", "wind", "ground")},
        "sources": equipment_sources(*clubs, *([ball(table.get("ball"))] if "ball" not in table else [])),
    }


def _words(found: Summary) -> Iterator[str]:
    """Say how much was computed, and over what the quantities range, in sentences."""
    from clubface.studies.summaries import shown_unit

    along = " and ".join(each.name.replace("_", " ") for each in found.along)
    yield f"The study has {output.counted(found.tasks, 'task')}, which differ in {along}."
    for place, (name, si) in enumerate(list(found.quantities.items())[:MOST_SHOWN]):
        unit = shown_unit(name, si)
        told = _shown(found.overall, place, unit)
        least, most = (_number(each, _decimals(told[1], max(map(abs, told)))) for each in told[2:])
        yield f"{name.replace('_', ' ').capitalize()} ranges from {least} to {most}{'' if unit == '1' else f' {unit}'}."


def _columns(found: Summary) -> dict[str, list[Any]]:
    """Return the figures as a long table: along which input, at which level, of which quantity."""
    rows = []
    for along in (None, *found.along):
        every = [found.overall] if along is None else along.figures
        labels = [""] if along is None else _level_texts(along)
        for label, figures in zip(labels, every, strict=True):
            for place, (name, si) in enumerate(found.quantities.items()):
                heading, unit = heading_of(name, si)
                told = (float(each) for each in _shown(figures, place, unit))
                rows.append(("all" if along is None else along.name, label, heading, *told))
    heads = ("along", "level", "quantity", "mean", "deviation", "least", "most")
    return {head: [row[place] for row in rows] for place, head in enumerate(heads)}


def print_summary(found: Summary) -> None:
    """Print the figures of all tasks, and the means along every input."""
    from clubface.studies.summaries import shown_unit

    units = {name: shown_unit(name, unit) for name, unit in found.quantities.items()}
    rows = []
    for place, (name, unit) in enumerate(units.items()):
        each = _shown(found.overall, place, unit)
        rows.append(
            [
                name,
                *(_number(value, _decimals(each[1], max(map(abs, each)))) for value in each),
                "" if unit == "1" else unit,
            ]
        )
    title = f"{found.name}, {output.counted(found.tasks, 'task')}"
    print_numbers(("", "mean", "deviation", "least", "most", "unit"), rows, title=title)
    shown = list(units.items())[:MOST_SHOWN]
    for along in found.along:
        heads = [f"{name}\n{'' if unit == '1' else unit}" for name, unit in shown]
        columns = []
        for place, (_, unit) in enumerate(shown):
            pairs = [_shown(figures, place, unit)[:2] for figures in along.figures]
            known = [pair for pair in pairs if pair[1] == pair[1]]
            digits = _decimals(
                max((spread for _, spread in known), default=0.0), max((abs(mean) for mean, _ in known), default=0.0)
            )
            columns.append([f"{_number(mean, digits)} ± {_number(spread, digits)}" for mean, spread in pairs])
        body = [[label, *cells] for label, *cells in zip(_level_texts(along), *columns, strict=True)]
        print()
        print_numbers(["", *heads], body, title=f"Mean and deviation along {along.name}")


def _level_texts(along: Along) -> list[str]:
    """Return the levels of an input as they are read, with their unit."""
    if along.unit is None:
        return list(along.levels)
    unit = heading_of(along.name, along.unit)[1]
    after = "" if unit == "1" else f" {unit}"

    def told(each: Any) -> str:
        if each == math.inf:
            return FLAT
        if not isinstance(each, tuple):
            return f"{from_si(each, unit):.6g}{after}"
        low, high = (float(from_si(value, unit)) for value in each)
        # The ends of a class are told to a tenth of its width, or a hundredth.
        digits = max(1 - math.floor(math.log10(high - low)), 0) if high - low > 1e-6 else None
        return f"{_number(low, digits)} to {_number(high, digits)}{after}"

    return [told(each) for each in along.levels]


def _shown(figures: Figures, place: int, unit: str) -> list[float]:
    """Return mean, deviation, least and most of a quantity in a unit."""
    values = [from_si(float(each[place]), unit) for each in (figures.mean, figures.least, figures.most)]
    return [values[0], float(figures.deviation[place]) / size(unit), *values[1:]]


def _decimals(spread: float, largest: float) -> int | None:
    """Return the decimals that show a spread to three digits, the ``largest`` value to six at most; None if none do."""
    if not 1e-6 <= spread < 1e7:
        return None
    enough = 2 - math.floor(math.log10(spread))
    most = 5 - math.floor(math.log10(max(abs(largest), spread)))
    return max(min(enough, most), 0)


def _number(value: float, decimals: int | None) -> str:
    if value != value:
        return ""
    return f"{value:.5g}" if decimals is None else f"{value:.{decimals}f}"


def document(found: Summary) -> dict[str, Any]:
    """Return a summary as JSON has it, in SI units."""

    def told(figures: Figures) -> dict[str, Any]:
        return {
            name: {key: getattr(figures, key)[place].item() for key in ("count", "mean", "deviation", "least", "most")}
            for place, name in enumerate(found.quantities)
        }

    along = {
        each.name: {
            "unit": each.unit,
            "levels": [
                {"level": FLAT if level == math.inf else level, **told(figures)}
                for level, figures in zip(each.levels, each.figures, strict=True)
            ],
        }
        for each in found.along
    }
    return {
        "name": found.name,
        "tasks": found.tasks,
        "units": dict(found.quantities),
        "overall": told(found.overall),
        "along": along,
        "failed": found.failed,
        "remark": found.remark,
    }


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
    from clubface.studies.running import status as state

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
    names = options.names(quantities) if quantities else None
    if names == []:
        raise InputError("--output", quantities, "names of quantities, as in carry,backspin")
    with progress_bar("parts") as progress:
        found = sum_up(study, quantities=names, store=store, progress=progress)
    _tell(found.failed, found.remark)
    if plot is not None:
        from clubface.plots import save
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
