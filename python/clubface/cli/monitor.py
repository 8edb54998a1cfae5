"""``clubface monitor``: files of launch monitors, their summaries and reports, and shots over a socket."""

from __future__ import annotations

import time
from contextlib import closing, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output, show
from clubface.cli.app import command as typed_command
from clubface.cli.failures import print_note
from clubface.cli.recorded import READING, Files, read_shots
from clubface.errors import FileError, InputError
from clubface.jobs.lock import Lock
from clubface.support.checks import check_count
from clubface.support.files import same_file
from clubface.units import parse

if TYPE_CHECKING:
    from clubface.shots.messages import Message

LONGEST = 30 * 86400.0
"""Maximum waiting time [s]."""
MOST_SHOTS = 1_000_000
SHOWN = ("ball_speed", "launch", "azimuth", "total_spin")
"""The quantities printed for a shot."""
PORT = options.group(None, port=(int, 921, "NUMBER", "Port on this machine."))
HAND = options.group(None, hand=(options.Text, None, "right|left", "Hand of the player."))
_CLUBS = "Convert club data for this club, or NAME=CLUB for each name in the file."
CONVERTED = options.group(
    None,
    club=(options.Texts, None, "CLUB|NAME=CLUB", _CLUBS),
    rejects=(options.Text, None, "FILE", "Write the rows without a shot, with reasons."),
)

app = typer.Typer(add_completion=False, no_args_is_help=True, help="Launch monitors: files and live shots.")


@app.command()
@options.takes(
    PORT,
    options.group(None,
        hand=(str | None, None, "right|left", "Hand of the player, to send to the monitor."),
        club=(str | None, None, "NAME", "Club to send to the monitor: DR."),
        shots=(int | None, None, "NUMBER", "End after this many shots."),
        timeout=(str | None, None, '"60 s"', "End when nothing has come for this long."),
        json=(bool, False, None, "Print one JSON document for each shot."),
    ),
    show.table_option("Write the shots to a new CSV or Parquet file, kept up to date."),
)  # fmt: skip
def listen(**texts: Any) -> None:
    """Receive shots from launch monitors over GSPro Open Connect, in place of the simulator."""
    from clubface.shots.messages import recorded
    from clubface.shots.open_connect import Listener
    from clubface.shots.tables.writer import KINDS

    target, hand, timeout, count = (texts[name] for name in ("target", "hand", "timeout", "shots"))
    output.check_target("--output", target, KINDS)
    if target is not None and Path(target).exists():
        raise FileError(target, None, "this file exists already; give a new one, so that no shots are lost")
    wait = _waiting_time("--timeout", timeout, above=0.0) if timeout is not None else None
    if count is not None:
        check_count("--shots", count, 1, MOST_SHOTS)
    kept: list[Message] = []

    def keep(message: Message) -> None:
        """Write a shot to disk before it is acknowledged, so that none is lost."""
        if target is not None:
            recorded([*kept, message], hand=hand).write(target)
        kept.append(message)

    def print_kept() -> str:
        for note in recorded(kept).notes:
            print_note(f"note: {note}")
        shots = f"{len(kept)} shot{'s' * (len(kept) != 1)}"
        return shots + (f" in {target}" if target is not None and kept else "")

    lock = nullcontext() if target is None else closing(Lock(Path(f"{target}.lock"), Path(target)))
    club = texts["club"] or ""
    with lock, Listener(texts["port"], hand=hand, club=club, keep=keep, on_problem=print_note) as listener:
        print_note(f"listening on 127.0.0.1:{listener.port}; Ctrl-C ends")
        try:
            for message in listener.messages(timeout=wait):
                if message.kind == "shot":
                    print(_shot_text(message, texts["json"]), flush=True)
                if count is not None and len(kept) >= count:
                    break
        except KeyboardInterrupt:
            raise KeyboardInterrupt(print_kept()) from None
    print_note(print_kept())


@app.command()
@options.takes(
    PORT, READING,
    options.group(None,
        shot=(str | None, None, "FIRST:LAST", "Send only these, counted from 1; default: all."),
        pause=(str, "0 s", '"2 s"', "Pause between shots."),
        timeout=(str, "5 s", '"5 s"', "How long to wait for each answer."),
    ),
)  # fmt: skip
def send(
    file: Annotated[str, options.argument("FILE", "Shots: a monitor's file, or a clubface table.")], **texts: Any
) -> None:
    """Send the launches of a table to a simulator over GSPro Open Connect, in place of a launch monitor."""
    from clubface.shots.open_connect import Sender

    shots = read_shots(file, texts | {"hand": None}, where=True)
    first, last = _range(texts["shot"], len(shots))
    seconds = _waiting_time("--pause", texts["pause"])
    refused = sent = 0
    with Sender(texts["port"], timeout=_waiting_time("--timeout", texts["timeout"], above=0.0)) as sender:
        for row in range(first - 1, last):
            launch, delivery = (
                {name: float(values[row]) for name, values in columns.items() if values[row] == values[row]}
                for columns in (shots.launches, shots.deliveries)
            )
            if "ball_speed" not in launch or "launch" not in launch:
                print_note(f"shot {row + 1} has no ball speed or launch angle: not sent")
                refused += 1
                continue
            if sent and seconds > 0.0:
                time.sleep(seconds)
            try:
                answer = sender.send(launch, delivery)
            except InputError as error:
                print_note(f"shot {row + 1}: {error}: not sent")
                refused += 1
                continue
            sent += 1
            refused += not answer.was_taken
            print(f"shot {row + 1}: {answer.code} {answer.message}", flush=True)
    if refused:
        print_note(f"{refused} of {last - first + 1} shots were not accepted")
        raise typer.Exit(2)


@app.command()
@options.takes(
    READING, HAND, show.plot_option("where each club lands and the gaps between clubs"), show.REPORT, show.JSON
)
def summary(files: Files, **texts: Any) -> None:
    """Sum up the shots of each club: counts, means, spreads, and the gaps in carry."""
    shown = show.Output.check(texts, [*files, texts["mapping"]])
    from clubface.shots.session_summary import session_result

    shown.show(session_result(read_shots(files, texts, where=True)))


@app.command()
@options.takes(
    READING,
    HAND,
    options.group(None, club=(options.Text, None, "NAME", "The club, if the shots do not name one: 7-iron.")),
)
def report(
    files: Files,
    target: Annotated[str, options.output("FILE", "The report to write: .html or .md, with its pictures inside.")],
    **texts: Any,
) -> None:
    """Write a report for a player, in plain language: what was measured, what it means, and how certain that is."""
    from dataclasses import replace

    import numpy as np

    from clubface.design.loft_fit import player_loft_notes
    from clubface.inference.player_report import player_result
    from clubface.present.report import write_report

    output.check_report(target, [*files, texts["mapping"]], "--output")
    shots = read_shots(files, texts, where=True)
    if texts["club"] is not None:
        shots = replace(shots, clubs=np.full(len(shots), texts["club"], dtype=object))
    result = player_result(shots, loft_notes=player_loft_notes)
    result = result.replace(provenance=result.provenance.with_files())
    print_note(f"wrote {write_report(result, target, command=typed_command())}")


@app.command()
@options.takes(READING, HAND, show.table_option("Write one CSV or Parquet file."), show.REPORT, show.JSON, CONVERTED)
def read(files: Files, **texts: Any) -> None:
    """Read a launch monitor's file and write its shots in the units and signs of clubface."""
    from clubface.present.report import write_table
    from clubface.shots.recorded_result import rejected_table, shots_result

    read_files, rejects = [*files, texts["mapping"]], texts["rejects"]
    shown = show.Output.check(texts, read_files)
    output.check_target("--rejects", rejects, (".csv",), read_files)
    if shown.target is not None and rejects is not None and same_file(shown.target, rejects):
        raise InputError("--rejects", rejects, "a file other than the output")
    shots = read_shots(files, texts, _clubs(texts["club"] or []), where=True)
    if shown.target is not None:
        shots.write(shown.target)
    if rejects is not None:
        write_table(rejected_table(shots.rejected), rejects)
    shown.show(shots_result(shots), write_table=False, more=[] if rejects is None else [rejects])


@app.command()
@options.takes(show.JSON)
def formats(
    name: Annotated[str | None, options.argument("[NAME]", "Show the columns of this layout.")] = None, **texts: Any
) -> None:
    """List the supported layouts, or show the columns of one."""
    from clubface.shots.monitors import format_result, formats_result

    show.Output.check(texts).show(formats_result() if name is None else format_result(name))


def _clubs(texts: list[str]) -> Any:
    """Return a club, a mapping of clubs by their name in the file, or None."""
    if any("=" in each for each in texts):
        return options.pairs(texts, "--club")
    if len(texts) > 1:
        raise InputError("--club", texts[1], "one club, or NAME=CLUB for each name in the file")
    return texts[0] if texts else None


def _waiting_time(option: str, text: str, above: float | None = None) -> float:
    """Return a waiting time [s], which may be 0 unless it must be positive."""
    value = parse(text, "time", name=option)
    if value < 0.0 or value == above or value > LONGEST:
        least = "above 0" if above is not None else "from 0"
        raise InputError(option, text, f"a time {least} to {LONGEST / 86400:g} days")
    return value


def _shot_text(message: Message, as_json: bool) -> str:
    """Return a shot as a line of text, or as JSON."""
    if as_json:
        from clubface.present.report import json_text

        shot = {"device": message.device, "shot": message.shot_number, **message.delivery, **message.launch}
        return json_text(shot, indent=None)
    from clubface.quantities import format_value, quantity

    values = [f"{quantity(name).label} {format_value(message.launch[name], quantity(name))}"
              for name in SHOWN if name in message.launch]  # fmt: skip
    return ", ".join([f"shot {message.shot_number}", *values])


def _range(text: str | None, count: int) -> tuple[int, int]:
    """Return the first and last shot of a range such as "2:9"."""
    if text is None:
        return 1, count
    first, _, last = text.partition(":")
    places = [int(each) for each in (first, last or first) if each.isdecimal() and len(each) < 10]
    if len(places) == 2 and 1 <= places[0] <= places[1] <= count:
        return places[0], places[1]
    raise InputError("--shot", text, f"a number or FIRST:LAST, from 1 to {count}")
