"""``clubface monitor``: files of launch monitors."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import option_values, options, output
from clubface.cli.monitor_live import listen, send
from clubface.cli.monitor_report import report
from clubface.cli.monitor_summary import Hand, summary
from clubface.cli.recorded import READING, Files, read_shots
from clubface.cli.tables import print_numbers, print_words
from clubface.errors import InputError, UnknownNameError
from clubface.support.input_files import same_file
from clubface.support.whole_file import whole_file
from clubface.units import display_unit, from_si

if TYPE_CHECKING:
    from clubface.recorded.loft_origin import LoftOrigin
    from clubface.recorded.shots import RecordedShots

app = typer.Typer(
    add_completion=False, no_args_is_help=True, help="Launch monitors: their files, and their shots live."
)
app.command("listen")(listen)
app.command("send")(send)
app.command("summary")(summary)
app.command("report")(report)


@app.command("read")
@options.takes(READING)
def read(
    files: Files,
    hand: Hand = None,
    club: Annotated[
        list[str] | None,
        options.option(
            "--club",
            metavar="CLUB|NAME=CLUB",
            text="Refer club data to this club, or NAME=CLUB for each name in the file.",
        ),
    ] = None,
    target: Annotated[str | None, options.output("FILE", "Write one table, CSV or Parquet by its ending.")] = None,
    rejects: Annotated[
        str | None,
        options.option("--rejects", metavar="FILE", text="Write the rows without a shot, with line and reason."),
    ] = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Read a launch monitor's file and write its shots in the units and signs of clubface."""
    from clubface.recorded.loft_origin import AT_LAUNCH, loft_origins, origin_notes
    from clubface.tables.writer import KINDS

    read_files = [*files, texts["mapping"]]
    output.check_target("--output", target, KINDS, read_files)
    output.check_target("--rejects", rejects, (".csv",), read_files)
    if target is not None and rejects is not None and same_file(target, rejects):
        raise InputError("--rejects", rejects, "another file than the output")
    shots = read_shots(files, texts | {"hand": hand}, _clubs(club or []), where=True)
    if target is not None:
        shots.write(target)
    if rejects is not None:
        _write_rejects(shots, Path(rejects))
    origins = loft_origins(shots)
    if as_json:
        output.print_json(_described(shots, origins) | {"output": target, "rejects": rejects})
        return
    _print(shots)
    print(output.counted(len(shots), "shot") + (f": {target}" if target is not None else ""))
    output.print_rejected(
        shots.rejected, "rejected" + (f": {rejects}" if rejects is not None else ""), "--rejects FILE keeps all"
    )
    output.print_notes([*origin_notes(origins, AT_LAUNCH), *shots.notes])


@app.command("formats")
def formats(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="Show the columns of this layout.", show_default=False)
    ] = None,
    as_json: options.Json = False,
) -> None:
    """List the layouts that are read, or show the columns of one."""
    from clubface.launch_monitor import FORMATS

    if name is not None and name not in FORMATS:
        raise UnknownNameError("format", name, FORMATS)
    chosen = list(FORMATS.values()) if name is None else [FORMATS[name]]
    if as_json:
        documents = [_layout(each) for each in chosen]
        output.print_json(documents if name is None else documents[0])
    elif name is None:
        print_words(["format", "written by"], [[each.name, each.title] for each in chosen])
        output.print_notes(["clubface monitor formats NAME shows the columns; any other file is read with --mapping."])
    else:
        layout = _layout(chosen[0])
        rows = [
            [quantity, ", ".join(each["headings"]), each["unit"] or "as the file says", each["positive"] or ""]
            for quantity, each in layout["columns"].items()
        ]
        print_words(["quantity", "columns", "unit, unless the file names it", "positive"], rows)
        print(f"{layout['title']}; {layout['source']}")


def _clubs(texts: list[str]) -> Any:
    """Return a club, clubs by name in the file, or None."""
    if any("=" in each for each in texts):
        return option_values.pairs(texts, "--club")
    if len(texts) > 1:
        raise InputError("--club", texts[1], "one club, or NAME=CLUB for each name in the file")
    return texts[0] if texts else None


def _print(shots: RecordedShots) -> None:
    import numpy as np

    rows = []
    for name, si_unit in shots.units().items():
        unit = "mph" if si_unit == "m/s" else display_unit(name, si_unit)
        values = from_si((shots.deliveries | shots.launches)[name], unit)
        told = values[~np.isnan(values)]
        numbers = (told.min(), told.mean(), told.max()) if told.size else (None,) * 3
        rows.append([name, "" if unit == "1" else unit, str(told.size), *(output.number(each, 2) for each in numbers)])
    title = f"{shots.source} ({shots.format})"
    if shots.clubs is not None:
        title += ": " + ", ".join(f"{count} {name or 'without a name'}" for name, count in _counts(shots).items())
    print_numbers(("", "unit", "shots", "least", "mean", "greatest"), rows, title=title)


def _counts(shots: RecordedShots) -> dict[str, int]:
    names = [] if shots.clubs is None else shots.clubs.tolist()
    return {name: names.count(name) for name in dict.fromkeys(names)}


def _described(shots: RecordedShots, origins: Iterable[LoftOrigin]) -> dict[str, Any]:
    import numpy as np

    from clubface.recorded.loft_origin import AT_LAUNCH, origin_notes

    values = shots.deliveries | shots.launches
    return {
        "source": shots.source,
        "format": shots.format,
        "shots": len(shots),
        "clubs": _counts(shots),
        "quantities": {
            name: {"unit": unit, "shots": int((~np.isnan(values[name])).sum()), "mean": _mean(values[name])}
            for name, unit in shots.units().items()
        },
        "loft_origins": [each._asdict() for each in origins],
        "rejected": [each._asdict() for each in shots.rejected],
        "notes": [*origin_notes(origins, AT_LAUNCH), *shots.notes],
    }


def _mean(values: Any) -> float | None:
    told = values[values == values]
    return float(told.mean()) if told.size else None


def _layout(of: Any) -> dict[str, Any]:
    return {
        "name": of.name,
        "title": of.title,
        "columns": {
            quantity: {"headings": field.shown, "unit": field.unit, "positive": field.positive}
            for quantity, field in of.fields.items()
        },
        "speed_at": of.speed_at,
        "face_at": of.face_at,
        "source": of.source,
    }


def _write_rejects(shots: RecordedShots, path: Path) -> None:
    from clubface.tables.writer import csv_lines

    with whole_file(path) as file:
        file.write(csv_lines([("line", "reason"), *shots.rejected], ","))
