"""``clubface monitor``: files of launch monitors, their summaries and reports, and shots over a socket.

``clubface monitor``: files of launch monitors.

``clubface monitor listen`` and ``send``: shots over a socket of this machine.

``clubface monitor report``: a report for a player, in plain language.

``clubface monitor summary``: what a session says of each club, as a table and a picture.
"""

from __future__ import annotations

import time
from collections.abc import Iterable
from contextlib import closing, nullcontext
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output, reporting
from clubface.cli.failures import say
from clubface.cli.output import print_numbers, print_words
from clubface.cli.recorded import READING, Files, read_shots
from clubface.errors import FileError, InputError, UnknownNameError
from clubface.jobs.lock import Lock
from clubface.quantities import display_unit
from clubface.support.checks import check_count
from clubface.support.files import same_file, whole_file
from clubface.units import from_si, parse, size

if TYPE_CHECKING:
    from clubface.shots.loft_origin import LoftOrigin
    from clubface.shots.open_connect_messages import Message
    from clubface.shots.recorded import RecordedShots
    from clubface.shots.session_summary import ClubSummary


Port = Annotated[int, typer.Option("--port", metavar="NUMBER", help="Port on this machine.")]
LONGEST = 30 * 86400.0
"""Seconds that anything is waited for."""
MOST_SHOTS = 1_000_000
SHOWN = (("ball_speed", "mph", 1), ("launch", "deg", 1), ("azimuth", "deg", 1), ("total_spin", "rpm", 0))
"""What is printed of a shot: quantity, unit, digits."""


def listen(
    port: Port = 921,
    target: Annotated[
        str | None, options.output("FILE", "Write the shots to a new table, CSV or Parquet, kept up to date.")
    ] = None,
    hand: Annotated[
        str | None,
        options.option("--hand", metavar="right|left", text="Hand of the player, which the monitor is told."),
    ] = None,
    club: Annotated[
        str, typer.Option("--club", metavar="NAME", help="Club that the monitor is told, such as DR.")
    ] = "",
    count: Annotated[
        int | None, options.option("--shots", metavar="NUMBER", text="End after this number of shots.")
    ] = None,
    timeout: Annotated[
        str | None, typer.Option("--timeout", metavar='"60 s"', help="End when nothing has come for so long.")
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON document for each shot.")] = False,
) -> None:
    """Receive the shots of launch monitors that speak GSPro Open Connect, as the simulator does."""
    from clubface.shots.open_connect import Listener
    from clubface.shots.open_connect_messages import recorded
    from clubface.shots.tables.writer import KINDS

    output.check_target("--output", target, KINDS)
    if target is not None and Path(target).exists():
        raise FileError(target, None, "this file exists already; give a new one, so that no shots are lost")
    wait = _seconds("--timeout", timeout, above=0.0) if timeout is not None else None
    if count is not None:
        check_count("--shots", count, 1, MOST_SHOTS)
    got: list[Message] = []

    def keep(message: Message) -> None:
        """Bring a shot to the disk, so that none is acknowledged that could be lost."""
        if target is not None:
            recorded([*got, message], hand=hand).write(target)
        got.append(message)

    held = nullcontext() if target is None else closing(Lock(Path(f"{target}.lock"), Path(target)))
    with held, Listener(port, hand=hand, club=club, keep=keep, on_problem=say) as listener:
        say(f"listening on 127.0.0.1:{listener.port}; Ctrl-C ends")
        try:
            for message in listener.messages(timeout=wait):
                if message.kind != "shot":
                    continue
                _tell_shot(message, as_json)
                if count is not None and len(got) >= count:
                    break
        except KeyboardInterrupt:
            _say_notes(got)
            raise KeyboardInterrupt(_kept(len(got), target)) from None
    _say_notes(got)
    say(_kept(len(got), target))


@options.takes(READING)
def send(
    file: Annotated[str, typer.Argument(metavar="FILE", help="Shots: a monitor's file, or a table of clubface.")],
    port: Port = 921,
    which: Annotated[
        str | None,
        typer.Option("--shot", metavar="FIRST:LAST", help="Send only these, counted from 1; all unless given."),
    ] = None,
    pause: Annotated[str, typer.Option("--pause", metavar='"2 s"', help="Pause between two shots.")] = "0 s",
    timeout: Annotated[
        str, typer.Option("--timeout", metavar='"5 s"', help="How long to wait for each answer.")
    ] = "5 s",
    **texts: Any,
) -> None:
    """Send the launches of a table to a simulator by GSPro Open Connect, as a launch monitor does."""
    from clubface.shots.open_connect import Sender

    shots = read_shots(file, texts | {"hand": None}, where=True)
    first, last = _range(which, len(shots))
    seconds = _seconds("--pause", pause)
    refused = sent = 0
    with Sender(port, timeout=_seconds("--timeout", timeout, above=0.0)) as sender:
        for row in range(first - 1, last):
            launch, delivery = _measured_row(shots.launches, row), _measured_row(shots.deliveries, row)
            if "ball_speed" not in launch or "launch" not in launch:
                say(f"shot {row + 1} has no ball speed or launch angle: not sent")
                refused += 1
                continue
            if sent and seconds > 0.0:
                time.sleep(seconds)
            try:
                answer = sender.send(launch, delivery)
            except InputError as error:
                say(f"shot {row + 1}: {error}: not sent")
                refused += 1
                continue
            sent += 1
            refused += not answer.was_taken
            print(f"shot {row + 1}: {answer.code} {answer.message}", flush=True)
    if refused:
        say(f"{refused} of {last - first + 1} shots were not taken")
        raise typer.Exit(2)


def _seconds(option: str, text: str, above: float | None = None) -> float:
    """Return a time to wait [s], 0 too unless it must be above."""
    value = parse(text, "time", name=option)
    if value < 0.0 or value == above or value > LONGEST:
        least = "above 0" if above is not None else "from 0"
        raise InputError(option, text, f"a time {least} to {LONGEST / 86400:g} days")
    return value


def _say_notes(got: list[Message]) -> None:
    from clubface.shots.open_connect_messages import recorded

    for note in recorded(got).notes:
        say(f"note: {note}")


def _tell_shot(message: Message, as_json: bool) -> None:
    if as_json:
        told = {"device": message.device, "shot": message.shot_number, **message.delivery, **message.launch}
        print(output.json_text(told), flush=True)
        return
    launch = message.launch
    parts = [f"shot {message.shot_number}"]
    for name, unit, digits in SHOWN:
        if name in launch:
            parts.append(f"{name.replace('_', ' ')} {output.number(from_si(launch[name], unit), digits)} {unit}")
    print(", ".join(parts), flush=True)


def _kept(count: int, target: str | None) -> str:
    return output.counted(count, "shot") + (f" in {target}" if target is not None and count else "")


def _range(text: str | None, count: int) -> tuple[int, int]:
    if text is None:
        return 1, count
    first, _, last = text.partition(":")
    if _is_place(first) and _is_place(last or first) and 1 <= int(first) <= int(last or first) <= count:
        return int(first), int(last or first)
    raise InputError("--shot", text, f"a number or FIRST:LAST, from 1 to {count}")


def _is_place(text: str) -> bool:
    return text.isdecimal() and len(text) < 10


def _measured_row(columns: Any, row: int) -> dict[str, float]:
    return {name: float(values[row]) for name, values in columns.items() if values[row] == values[row]}


@options.takes(READING)
def report(
    files: Files,
    target: Annotated[str, options.output("FILE", "The report to write: .html or .md, with its pictures inside.")],
    hand: Annotated[str | None, options.option("--hand", metavar="right|left", text="Hand of the player.")] = None,
    club: Annotated[
        str | None, options.option("--club", metavar="NAME", text="The club, where the shots name none: 7-iron.")
    ] = None,
    **texts: Any,
) -> None:
    """Write for a player, in plain language: what was measured, what it means, and how sure that is."""
    from dataclasses import replace

    import numpy as np

    from clubface.present.document import ENDINGS
    from clubface.present.player_report import write_report

    output.check_target("--output", target, ENDINGS, [*files, texts["mapping"]])
    import clubface.plots  # noqa: F401  (a missing library is told before any work)

    shots = read_shots(files, texts | {"hand": hand}, where=True)
    if club is not None:
        shots = replace(shots, clubs=np.full(len(shots), club, dtype=object))
    say(f"wrote {write_report(shots, target, more=reporting.repeat())}")


SURE = 2.0
"""Standard errors that a gap must have to be one."""
DIGITS = {"1": 2, "rpm": 0}
Hand = Annotated[str | None, options.option("--hand", metavar="right|left", text="Hand of the player.")]


@options.takes(READING)
def summary(
    files: Files,
    hand: Hand = None,
    picture: Annotated[str | None, options.picture("where each club lands and the gaps between clubs")] = None,
    as_json: options.Json = False,
    **texts: Any,
) -> None:
    """Sum up the shots of each club: counts, means, spreads, and the gaps in carry."""
    output.check_picture(picture, [*files, texts["mapping"]])
    from clubface.shots.session_summary import QUANTITIES, summarised

    shots = read_shots(files, texts | {"hand": hand}, where=True)
    clubs = summarised(shots)
    measured = [name for name in QUANTITIES if any(name in each.spreads for each in clubs)]
    if picture is not None:
        from clubface import plots
        from clubface.shots.session_picture import session_figure

        say(f"wrote {plots.save(session_figure(shots, clubs), picture)}")
    if as_json:
        output.print_json(
            {
                "source": shots.source,
                "shots": len(shots),
                "clubs": [_document(each) for each in clubs],
                "rejected": [each._asdict() for each in shots.rejected],
                "notes": shots.notes,
            }
        )
        return
    several = any(each.player for each in clubs)
    heads = [*(["player"] if several else []), "club", "shots"]
    for name in measured:
        heads += [f"{name.replace('_', ' ')}\n{'' if QUANTITIES[name] == '1' else QUANTITIES[name]}", "\n±"]
    gaps = any(each.gap for each in clubs)
    rows = [_summary_row(each, measured, gaps, several) for each in clubs]
    print_numbers([*heads, "gap\nyd"] if gaps else heads, rows, title=f"{shots.source} ({shots.format})")
    output.print_rejected(shots.rejected, "rejected", "--json lists all")
    output.print_notes([*shots.notes, *_remarks(clubs)])


def _summary_row(of: ClubSummary, measured: list[str], gaps: bool, several: bool) -> list[str]:
    from clubface.shots.session_summary import QUANTITIES

    cells = [*([of.player or "not named"] if several else []), of.club or "without a name", str(of.places.size)]
    for name in measured:
        unit, spread = QUANTITIES[name], of.spreads.get(name)
        digits = DIGITS.get(unit, 1)
        cells.append(output.number(from_si(spread.mean, unit) if spread else None, digits))
        cells.append(output.number(spread.deviation / size(unit) if spread else None, digits))
    return [*cells, output.number(from_si(of.gap.length, "yd") if of.gap else None)] if gaps else cells


def _remarks(clubs: list[ClubSummary]) -> list[str]:
    found = ["± is the standard deviation from shot to shot"]
    for name in dict.fromkeys(name for each in clubs for name in each.spreads):
        some = {(each.player, each.club): each.spreads[name].shots for each in clubs if name in each.spreads}
        few = [
            f"{some[each.player, each.club]} of {each.places.size} of {_called(each)}"
            for each in clubs
            if 0 < some.get((each.player, each.club), 0) < each.places.size
        ]
        if few:
            found.append(f"{name.replace('_', ' ')} was not measured in every shot: {', '.join(few)}")
    for longer, shorter in pairwise(clubs):
        if longer.gap is not None and not longer.gap.length > SURE * longer.gap.error:
            error = output.number(from_si(longer.gap.error, "yd"))
            told = f"a standard error of {error} yd" if error else "a single shot, so that its error is not known"
            found.append(
                f"the gap between {_called(longer)} and {_called(shorter)} is not sure: "
                f"{from_si(longer.gap.length, 'yd'):.1f} yd with {told}"
            )
    return found


def _called(of: ClubSummary) -> str:
    club = of.club or "the shots"
    return f"{of.player}'s {club}" if of.player else club


def _document(of: ClubSummary) -> dict[str, Any]:
    return {
        "player": of.player,
        "club": of.club,
        "shots": of.places.size,
        "quantities": {name: each._asdict() for name, each in of.spreads.items()},
        "gap": of.gap._asdict() if of.gap else None,
    }


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
    from clubface.shots.loft_origin import AT_LAUNCH, loft_origins, origin_notes
    from clubface.shots.tables.writer import KINDS

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
    from clubface.shots.monitors import FORMATS

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
        return options.pairs(texts, "--club")
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

    from clubface.shots.loft_origin import AT_LAUNCH, origin_notes

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
    from clubface.shots.tables.writer import csv_lines

    with whole_file(path) as file:
        file.write(csv_lines([("line", "reason"), *shots.rejected], ","))
