"""``clubface monitor listen`` and ``send``: shots over a socket of this machine."""

from __future__ import annotations

import time
from contextlib import closing, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.failures import say
from clubface.cli.recorded import READING, read_shots
from clubface.errors import FileError, InputError
from clubface.support.checks import check_count
from clubface.support.lock import Lock
from clubface.units import from_si, parse

if TYPE_CHECKING:
    from clubface.launch_monitor.open_connect import Message

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
    from clubface.launch_monitor.open_connect import Listener, recorded
    from clubface.tables.writer import KINDS

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
    from clubface.launch_monitor.open_connect import Sender

    shots = read_shots(file, texts | {"hand": None}, where=True)
    first, last = _range(which, len(shots))
    seconds = _seconds("--pause", pause)
    refused = sent = 0
    with Sender(port, timeout=_seconds("--timeout", timeout, above=0.0)) as sender:
        for row in range(first - 1, last):
            launch, delivery = _row(shots.launches, row), _row(shots.deliveries, row)
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
    from clubface.launch_monitor.open_connect import recorded

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


def _row(columns: Any, row: int) -> dict[str, float]:
    return {name: float(values[row]) for name, values in columns.items() if values[row] == values[row]}
