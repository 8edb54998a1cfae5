"""Every long command killed at random moments and resumed: the results are the bytes of an undisturbed run.

``python studies/kills.py [KILLS [NAME ...]]`` kills each command, or those named, that often (50 unless given), every
second time by SIGKILL and otherwise by SIGINT, at moments drawn over the time that the whole command takes. Some are
also run three at a time, as often, and of some an input is edited while they run: the results are those of one of both
inputs, or none. ``--seconds 3600`` ends after that time, when every command has had about as many kills. It exits with
1 if any result differs or anything but the results is left.
"""

from __future__ import annotations

import argparse
import math
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

EXAMPLES = Path(__file__).parents[1] / "examples"
MAIN = "from clubface.cli import main; main()"
FINDINGS = (
    f"import sys; sys.path.insert(0, {str(Path(__file__).parent)!r})"
    + """
import benchmark_findings as findings

def untimed(value):
    if isinstance(value, dict):
        return {key: untimed(each) for key, each in value.items() if key not in ("seconds", "wall_s")}
    return [untimed(each) for each in value] if isinstance(value, list) else value

findings.MODELS, findings.OWN, findings.RESAMPLES = ("standard", "slip"), ("slip",), 400
findings.FREE = {"standard": findings.FREE["standard"]}
findings.EVERY = {f"{club}-slip": 20 for club in findings.CLUBS}
findings.BOOTSTRAP = dict.fromkeys(findings.MODELS, 10)
run = findings.run
findings.run = lambda *given, **options: untimed(run(*given, **options))
sys.exit(findings.main(sys.argv[1:]))
"""
)
"""The findings on the benchmark shots, which take hours, of two models only, one of them on a part of the shots, and
without the times that it took, which differ from run to run."""
UNSTARTED = "Fatal Python error: init_import_site"
"""What Python says, with status 1, where Ctrl-C comes before it has started and so before the command."""
GOING_ON = 600
"""A command that still does not end after so many kills makes no progress."""


class Command(NamedTuple):
    """A command of the study.

    Attributes
    ----------
    name
        For people.
    arguments
        Of the command line, in a folder of its own with the ``INPUTS``; those in ``again`` are added after a kill.
    again
        What resumes it.
    results
        The files it makes.
    program
        What runs it.
    at_once
        Whether to run it three times at the same time as well, as often.
    edits
        The input that is edited while it runs, as often, and what by.
    """

    name: str
    arguments: Sequence[str]
    again: Sequence[str]
    results: Sequence[str]
    program: str = MAIN
    at_once: bool = False
    edits: tuple[str, Callable[[str], str]] | None = None


def deliveries(rows: int) -> str:
    """Return a file of deliveries in which every seventh row cannot be used."""
    lines = (f"{90 + i % 30},{'bad' if i % 7 == 3 else i % 5},{12 + i % 3},{i % 9}\n" for i in range(rows))
    return "club_speed_mph,attack_deg,loft_deg,toe_mm\n" + "".join(lines)


def launches(rows: int) -> str:
    """Return a file of launches."""
    lines = (f"{150 + i % 15},{11 + i % 4},{2500 + 50 * (i % 20)}\n" for i in range(rows))
    return "ball_speed_mph,launch_deg,backspin_rpm\n" + "".join(lines)


def study_file() -> str:
    """Return a study of 40 chunks with a club of one's own, a copy of whose file the store keeps."""
    return """
[study]
chunk = 4000
[impact]
club = "mine.toml"
[sweep]
speed = { from = "90 mph", to = "120 mph", count = 16 }
loft = { from = "8 deg", to = "14 deg", count = 100 }
toe = { from = "-20 mm", to = "20 mm", count = 100 }
"""


def club_file() -> str:
    """Return the file of a club."""
    import clubface

    return clubface.club("driver").replace(name="mine").to_toml()


def comparison_file() -> str:
    """Return a study of comparisons, of which the other shot has what is swept, in 20 chunks of whole values."""
    return """
[study]
kind = "comparison"
chunk = 1000
[comparison]
club = "mine.toml"
model = "area"
held = { loft = "12 deg" }
outputs = ["ball_speed", "backspin"]
other = { parameters = { friction = 0.1 } }
[sweep]
speed = { from = "90 mph", to = "119 mph", step = "1 mph" }
friction = { from = 0.05, to = 0.4, count = 36 }
toe = { from = "-9 mm", to = "9 mm", step = "1 mm" }
"""


def swings_file() -> str:
    """Return a study of swings, whose numbers are whole, in 15 chunks."""
    return """
[study]
kind = "capture"
chunk = 2
[capture]
outputs = ["speed_error", "face_error"]
[sweep]
swing = { from = 0, to = 29, step = 1 }
"""


def heavier(text: str) -> str:
    """Return a file of a club with another mass."""
    return text.replace('mass = "', 'mass = "1', 1)


def faster(text: str) -> str:
    """Return a table with other speeds in its first row."""
    head, first, rest = text.split("\n", 2)
    return f"{head}\n1{first}\n{rest}"


def shots(count: int) -> str:
    """Return a file of measured shots."""
    import numpy as np

    import clubface

    speed, attack, loft = np.linspace(103, 116, count), np.arange(count) % 5 - 2.0, 11.0 + np.arange(count) % 4
    made = clubface.impact(
        "driver", model="slip", speed=speed * 0.44704, attack=np.radians(attack), loft=np.radians(loft)
    )
    columns = [
        speed,
        attack,
        loft,
        made.get("ball_speed", "mph"),
        made.get("launch", "deg"),
        made.get("backspin", "rpm"),
    ]
    head = "club_speed_mph,attack_deg,loft_deg,ball_speed_mph,launch_deg,backspin_rpm\n"
    return head + "".join(",".join(f"{value:.4f}" for value in row) + "\n" for row in zip(*columns, strict=True))


INPUTS: dict[str, Callable[[], str]] = {
    "deliveries.csv": lambda: deliveries(200_000),
    "launches.csv": lambda: launches(2_000),
    "shots.csv": lambda: shots(40),
    "study.toml": study_file,
    "mine.toml": club_file,
    "comparison.toml": comparison_file,
    "swings.toml": swings_file,
    "fitting.toml": lambda: (EXAMPLES / "fitting.toml").read_text(encoding="utf-8"),
    "few.csv": lambda: deliveries(400),
}
COMMANDS = (
    Command(
        "predict to CSV", ("predict", "deliveries.csv", "--club", "driver", "--model", "area", "-o", "out.csv"),
        (), ("out.csv", "out.rejects.csv"), at_once=True, edits=("deliveries.csv", faster),
    ),
    Command(
        "predict to Parquet",
        ("predict", "deliveries.csv", "--club", "driver", "--model", "area", "-o", "out.parquet"),
        ("--resume",), ("out.parquet", "out.rejects.csv"), at_once=True,
    ),
    Command(
        "infer", ("infer", "launches.csv", "--club", "driver", "--samples", "200", "-o", "out.csv"),
        (), ("out.csv",), at_once=True,
    ),
    Command(
        "identify",
        (
            "identify", "shots.csv", "--club", "driver", "--model", "slip", "--population", "40", "--generations", "20",
            "--bootstrap", "400", "-o", "fit.toml",
        ),
        ("--resume",), ("fit.toml",),
    ),
    Command(
        "fem sweep", ("fem", "sweep", "--speed", "30:45:15", "--loft", "8,10", "-o", "sweep"), (),
        ("sweep/sweep.csv",), at_once=True,
    ),
    Command(
        "fem face", ("fem", "face", "paper", "--toe", "-10:10:20", "--high", "0", "-o", "face"), (), ("face/face.csv",)
    ),
    Command(
        "capture study", ("capture", "study", "--count", "100", "--plot", "study.svg", "--checkpoint", "kept"), (),
        ("study.svg",),
    ),
    Command(
        "capture synthesize", ("capture", "synthesize", "--count", "20", "-o", "swings"), (),
        ("swings/swing-001.c3d", "swings/swing-020.c3d", "swings/markers.toml", "swings/truth.csv"),
    ),
    Command("optimise, a fitting", ("optimise", "fitting.toml", "-o", "parts.csv"), (), ("parts.csv",)),
    Command("findings", ("found", "found.json"), (), ("found.json",), FINDINGS),
    Command(
        "study run", ("study", "run", "study.toml", "--workers", "2"), (),
        tuple(f"study.store/parts/0000/{chunk:08d}.parquet" for chunk in range(40)), edits=("mine.toml", heavier),
    ),
    Command(
        "study of comparisons", ("study", "run", "comparison.toml", "--workers", "1"), (),
        tuple(f"comparison.store/parts/0000/{chunk:08d}.parquet" for chunk in range(21)), edits=("mine.toml", heavier),
    ),
    Command(
        "study of swings", ("study", "run", "swings.toml", "--workers", "1"), (),
        tuple(f"swings.store/parts/0000/{chunk:08d}.parquet" for chunk in range(15)),
    ),
    Command(
        "monitor read", ("monitor", "read", "shots.csv", "-o", "read.parquet", "--rejects", "left.csv"), (),
        ("read.parquet", "left.csv"), edits=("shots.csv", faster),
    ),
    Command("tour", ("tour", "-o", "tour"), (), ("tour/tour.csv", "tour/tour-launch.svg", "tour/tour-errors.png")),
)  # fmt: skip
SMALL = COMMANDS[0]._replace(arguments=[*COMMANDS[0].arguments[:1], "few.csv", *COMMANDS[0].arguments[2:]])


def start(command: Command, folder: Path, again: bool) -> subprocess.Popen[str]:
    """Start a command in a folder."""
    arguments = [sys.executable, "-c", command.program, *command.arguments, *(command.again if again else ())]
    return subprocess.Popen(arguments, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def undisturbed(command: Command, folder: Path) -> tuple[dict[str, bytes], float]:
    """Run a command; return its results and the time it took [s]."""
    begun = time.monotonic()
    child = start(command, folder, False)
    _, message = child.communicate()
    if child.returncode:
        raise RuntimeError(f"{command.name} failed: {message}")
    return results(command, folder), time.monotonic() - begun


def results(command: Command, folder: Path) -> dict[str, bytes]:
    """Return the bytes of the results that are there."""
    return {name: (folder / name).read_bytes() for name in command.results if (folder / name).exists()}


def prepared(folder: Path) -> Path:
    """Return a new folder with the inputs."""
    folder.mkdir()
    for name, content in INPUTS.items():
        (folder / name).write_text(content(), encoding="utf-8")
    return folder


def disturbed(
    command: Command, folder: Path, whole: dict[str, bytes], seconds: float, random_: random.Random, kills: int
) -> list[str]:
    """Kill a command so many times, begun anew whenever it has ended; return what was wrong."""
    wrong: list[str] = []
    done, again, tries = 0, False, 0
    while done < kills and tries < GOING_ON + kills:
        tries += 1
        child = start(command, folder, again)
        kill = signal.SIGKILL if tries % 2 else signal.SIGINT
        try:
            _, message = child.communicate(timeout=random_.uniform(0.0, 1.1 * seconds))
        except subprocess.TimeoutExpired:
            child.send_signal(kill)
            _, message = child.communicate()
            done += 1
        if half := [name for name, content in results(command, folder).items() if content != whole[name]]:
            wrong.append(f"{command.name}: {', '.join(half)} differ after a kill")
        if child.returncode == 1 and message.startswith(UNSTARTED):
            continue
        if child.returncode not in (0, 130, -signal.SIGKILL, -signal.SIGINT):
            wrong.append(f"{command.name}: status {child.returncode}: {message.strip()}")
            return wrong
        again = child.returncode != 0
        if not again:
            remove(command, folder)
    child = start(command, folder, again)
    _, message = child.communicate()
    if child.returncode or results(command, folder) != whole:
        wrong.append(f"{command.name}: the last run is not as the undisturbed one: {message.strip()}")
    left = [each.name for each in folder.rglob("*") if each.name.endswith((".unfinished", ".checkpoint", "kept"))]
    return [*wrong, *(f"{command.name}: {name} is left" for name in left)]


def together(
    command: Command, folder: Path, whole: dict[str, bytes], seconds: float, random_: random.Random
) -> list[str]:
    """Start a command three times within its duration and kill one of them or none; return what was wrong."""
    children = []
    for _ in range(3):
        children.append(start(command, folder, False))
        time.sleep(random_.uniform(0.0, 0.5 * seconds))
    killed = random_.choice([None, *children])
    if killed is not None:
        killed.send_signal(signal.SIGKILL)
    messages = {child: child.communicate()[1] for child in children}
    wrong = [
        f"{command.name}, three at a time: status {child.returncode}: {messages[child].strip()}"
        for child in children
        if child is not killed
        and child.returncode
        and not (child.returncode == 2 and "is writing this" in messages[child])
    ]
    if results(command, folder) != whole:  # where the one that was killed was the one that wrote
        start(command, folder, False).communicate()
    if results(command, folder) != whole:
        wrong.append(f"{command.name}, three at a time: the results differ")
    start(command, folder, False).communicate()  # what one that was killed has left
    remove(command, folder)
    return wrong + [f"{command.name}: {each.name} is left" for each in folder.glob("*.unfinished")]


def remove(command: Command, folder: Path) -> None:
    """Remove what a command has made, so that the next begins at the beginning."""
    for name in command.results:
        top = folder / Path(name).parts[0]
        if top.is_dir():
            shutil.rmtree(top)
        else:
            top.unlink(missing_ok=True)


def edited(
    command: Command, folder: Path, whole: dict[str, bytes], seconds: float, random_: random.Random
) -> list[str]:
    """Edit an input while a command runs; return what was wrong. The results are those of one of both, or none."""
    assert command.edits is not None
    name, change = command.edits
    before = (folder / name).read_text(encoding="utf-8")
    (folder / name).write_text(change(before), encoding="utf-8")
    other, _ = undisturbed(command, folder)
    remove(command, folder)
    (folder / name).write_text(before, encoding="utf-8")
    child = start(command, folder, False)
    time.sleep(random_.uniform(0.0, seconds))
    (folder / name).write_text(change(before), encoding="utf-8")
    message = child.communicate()[1].strip()
    (folder / name).write_text(before, encoding="utf-8")
    made, wrong = results(command, folder), []
    if child.returncode not in (0, 2) or "Traceback" in message:
        wrong.append(f"{command.name}, {name} edited: status {child.returncode}: {message}")
    elif child.returncode == 0 and made not in (whole, other):
        wrong.append(f"{command.name}, {name} edited: the results are of neither: {message}")
    elif child.returncode == 2 and any(each not in (whole.get(file), other.get(file)) for file, each in made.items()):
        wrong.append(f"{command.name}, {name} edited: what is left is of neither: {message}")
    start(command, folder, False).communicate()  # what is unfinished
    remove(command, folder)
    return wrong


PER_ROUND = 5
"""Kills of a command before the next one has its turn."""


def study(commands: Sequence[Command], kills: int, seed: int = 1, seconds: float = math.inf) -> list[str]:
    """Kill some commands so many times each, in rounds, until the time is over; return what was wrong."""
    random_, wrong, begun = random.Random(seed), [], time.monotonic()
    known: dict[str, tuple[dict[str, bytes], float]] = {}
    with tempfile.TemporaryDirectory() as name:
        for done in range(0, kills, PER_ROUND):
            some = min(PER_ROUND, kills - done)
            for place, command in enumerate(commands):
                if time.monotonic() - begun > seconds:
                    return wrong
                folder = Path(name) / str(place)
                if command.name not in known:
                    known[command.name] = undisturbed(command, prepared(folder))
                    remove(command, folder)
                whole, long = known[command.name]
                faults = disturbed(command, folder, whole, long, random_, some)
                remove(command, folder)
                for _ in range(some if command.at_once else 0):
                    faults += together(command, folder, whole, long, random_)
                for _ in range(1 if command.edits else 0):
                    faults += edited(command, folder, whole, long, random_)
                print(f"{command.name}: {long:.1f} s undisturbed, {done + some} kills, {len(faults)} wrong", flush=True)
                if faults:
                    print("\n".join(faults), flush=True)
                wrong += faults
    return wrong


if __name__ == "__main__":
    os.environ["OMP_NUM_THREADS"] = "1"
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kills", type=int, nargs="?", default=50, help="of each command")
    parser.add_argument("names", nargs="*", metavar="NAME", help="commands; all unless given")
    parser.add_argument("--seconds", type=float, default=math.inf, help="end after this time, whatever the kills")
    asked = parser.parse_args()
    if unknown := set(asked.names) - {each.name for each in COMMANDS}:
        sys.exit(
            f"no such command: {', '.join(sorted(unknown))}; there are {', '.join(each.name for each in COMMANDS)}"
        )
    chosen = [each for each in COMMANDS if not asked.names or each.name in asked.names]
    faults = study(chosen, asked.kills if asked.seconds == math.inf else 10**6, seconds=asked.seconds)
    print(f"{len(faults)} faults")
    sys.exit(bool(faults))
