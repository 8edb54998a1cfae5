"""Keep what every command of the command line prints and writes, and compare two such recordings.

``python scripts/golden_outputs.py record FOLDER`` runs the commands of ``golden_runs.toml``, each in a folder of its
own with the same input files, and keeps exit status, both streams and every file written. The package that runs is the
one that ``python -m clubface`` finds, so that one copy of this script can record several versions.

``python scripts/golden_outputs.py compare BEFORE AFTER`` says of every run whether its status, its texts and its
numbers are the same, prints a table and writes all differences to a Markdown file. A layout may change on purpose, so
it also says whether every number of BEFORE still occurs in AFTER, whatever its key, in the same or in another unit.
Its exit status is 0 unless a number changed or is lost, a status changed, or a run or a file is missing.
"""

from __future__ import annotations

import argparse
import base64
import csv
import hashlib
import html
import io
import json
import math
import os
import random
import re
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

from golden_comparison import compare, read_tree

ROOT = Path(__file__).resolve().parents[1]
RUNS = Path(__file__).with_name("golden_runs.toml")
LIMIT = 900.0
"""Longest time of one command [s]."""

# --- Runs and their input files ---------------------------------------------------------------------------------------


def read_runs(*, with_long: bool) -> dict[str, list[str]]:
    """Return the command lines of every run by its name, those of ``[long]`` only on request."""
    document = tomllib.loads(RUNS.read_text(encoding="utf-8"))
    runs = document["run"] | (document["long"] if with_long else {})
    return {name: [line for line in text.splitlines() if line.strip()] for name, text in runs.items()}


def write_inputs(folder: Path) -> None:
    """Write the files that the runs read: texts of the list, examples, monitors' files and generated tables."""
    folder.mkdir(parents=True)
    for name, text in tomllib.loads(RUNS.read_text(encoding="utf-8"))["files"].items():
        (folder / name).write_text(text, encoding="utf-8")
    for path in [*ROOT.glob("examples/*.toml"), *ROOT.glob("tests/data/launch_monitors/*")]:
        shutil.copy(path, folder)
    for path in ROOT.glob("python/clubface/data/benchmark/*.parquet"):
        shutil.copy(path, folder)
    write_deliveries(folder / "deliveries.csv")
    write_session(folder / "session.csv")
    write_mesh(folder / "box.inp")
    (folder / "empty.csv").write_text("")


def write_deliveries(path: Path, count: int = 30) -> None:
    """Write swings of a driver; two of the rows cannot be used."""
    draw = random.Random(1).gauss
    rows = [["id", "club_speed_mph", "attack_deg", "path_deg", "loft_deg", "face_deg", "toe_mm", "high_mm"]]
    for number in range(1, count + 1):
        spreads = ((105, 3), (1, 2), (0, 2), (13, 1.5), (0, 2), (0, 8), (1, 5))
        rows.append([str(number), *(f"{draw(mean, spread):.3f}" for mean, spread in spreads)])
    rows[5][1], rows[9][4] = "x", "91"
    path.write_text("\n".join(map(",".join, rows)) + "\n")


def write_session(path: Path, count: int = 24) -> None:
    """Write swings and launches of two clubs in clubface's own columns, made up so that they look like such shots."""
    draw = random.Random(2).gauss
    rows = ["club,player,club_speed_mph,attack_deg,path_deg,loft_deg,face_deg,toe_mm,high_mm,"
            "ball_speed_mph,launch_deg,azimuth_deg,backspin_rpm,sidespin_rpm,carry_yd,side_yd"]  # fmt: skip
    for club, speed, attack, loft, smash, spin in (
        ("driver", 100, 1, 13, 1.47, 210),
        ("7-iron", 80, -4, 25, 1.33, 210),
    ):
        for _ in range(count):
            v, a, p, d, f = draw(speed, 2), draw(attack, 1), draw(0, 2), draw(loft, 1.2), draw(0, 2)
            toe, high = draw(0, 6), draw(0, 4)
            ball = smash * v - 0.01 * (toe**2 + high**2) + draw(0, 0.3)
            launch, azimuth = 0.8 * d + 0.2 * a + draw(0, 0.2), 0.8 * f + 0.2 * p + draw(0, 0.2)
            backspin, sidespin = spin * (d - a) - 40 * high + draw(0, 50), 170 * (f - p) - 40 * toe + draw(0, 50)
            carry, side = 1.75 * ball - 8 + draw(0, 2), 4 * azimuth + 0.05 * sidespin + draw(0, 2)
            values = (v, a, p, d, f, toe, high, ball, launch, azimuth, backspin, sidespin, carry, side)
            rows.append(",".join([club, "A. Player", *(f"{value:.3f}" for value in values)]))
    path.write_text("\n".join(rows) + "\n")


def write_mesh(path: Path, cells: tuple[int, int, int] = (6, 6, 10)) -> None:
    """Write a head like a box with a lofted, curved face as an Abaqus file: face, crown, sole and skirt."""
    size, (deep, tall, wide) = (90.0, 50.0, 104.0), cells
    numbers: dict[tuple[int, int, int], int] = {}

    def node(at: tuple[int, int, int]) -> int:
        return numbers.setdefault(at, len(numbers) + 1)

    def grid(one: int, two: int, corner) -> list[list[int]]:
        at = [(a, b) for a in range(one) for b in range(two)]
        return [[node(corner(a + da, b + db)) for da, db in ((0, 0), (1, 0), (1, 1), (0, 1))] for a, b in at]

    parts = {
        "face": grid(tall, wide, lambda a, b: (0, a, b)),
        "crown": grid(deep, wide, lambda a, b: (a, tall, b)),
        "sole": [each[::-1] for each in grid(deep, wide, lambda a, b: (a, 0, b))],
        "skirt": [each[::-1] for each in grid(tall, wide, lambda a, b: (deep, a, b))]
        + grid(deep, tall, lambda a, b: (a, b, 0))
        + [each[::-1] for each in grid(deep, tall, lambda a, b: (a, b, wide))],
    }
    lines = ["*HEADING", " box", "*NODE"]
    for (a, b, c), number in numbers.items():
        y, z = size[1] * (b / tall - 0.5), size[2] * (c / wide - 0.5)
        x = -size[0] * a / deep - math.tan(math.radians(11.5)) * y - (y * y + z * z) / (2 * 305.0)
        lines.append(f"{number}, {x:.6f}, {y:.6f}, {z:.6f}")
    number = 0
    for name, quads in parts.items():
        lines.append(f"*ELEMENT, TYPE=S4R, ELSET={name}")
        for quad in quads:
            number += 1
            lines.append(", ".join(map(str, (number, *quad))))
    path.write_text("\n".join(lines) + "\n")


# --- Recording --------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Recorder:
    """What all runs of a recording share.

    Attributes
    ----------
    target
        Folder of the recording.
    inputs
        Folder of the input files, which every run gets a copy of.
    replaced
        Texts that differ from one recording to the next, as patterns with what stands in their place.
    """

    target: Path
    inputs: Path
    replaced: tuple[tuple[re.Pattern[str], str], ...]

    def run(self, name: str, lines: list[str]) -> float:
        """Run the command lines of one run one after the other, keep what they give, and return the time taken [s]."""
        kept, started = self.target / name, time.monotonic()
        kept.mkdir(parents=True)
        with tempfile.TemporaryDirectory(prefix="golden-") as made:
            folder = Path(made) / "run"
            shutil.copytree(self.inputs, folder)
            before = read_tree(folder)
            statuses: dict[int, dict[str, object]] = {}
            background = []
            port = str(free_port())
            for number, line in enumerate(lines, 1):
                command, text = shlex.split(line.replace("{port}", port)), line.removeprefix("& ")
                if command[0] == "&":
                    background.append((number, text, start_listener(command[1:], folder)))
                    continue
                process = subprocess.Popen(
                    [sys.executable, "-m", "clubface", *command],
                    cwd=folder, env=environment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                    stderr=subprocess.PIPE,
                )  # fmt: skip
                statuses[number] = self.keep(kept, number, text, *finish(process), folder, port)
            for number, text, (process, first) in background:
                status, out, err = finish(process, limit=90.0)
                statuses[number] = self.keep(kept, number, text, status, out, first + err, folder, port)
            after = read_tree(folder)
            for path in sorted(path for path in after if after[path] != before.get(path)):
                keep_file(kept / "files", path, after[path], lambda text: self.normalise(text, folder, port))
            if gone := sorted(set(before) - set(after)):
                (kept / "removed.txt").write_text("\n".join(gone) + "\n")
        (kept / "commands.json").write_text(
            json.dumps([statuses[number] for number in sorted(statuses)], indent=1) + "\n"
        )
        return time.monotonic() - started

    def keep(self, kept: Path, number: int, line: str, status: int, out: bytes, err: bytes, folder: Path, port: str):
        """Write both streams of a command, and return its line and its status."""
        for kind, content in (("out", out), ("err", err)):
            text = self.normalise(content.decode("utf-8", "backslashreplace"), folder, port)
            (kept / f"{number}.{kind}").write_text(text, encoding="utf-8")
        return {"command": line, "status": status}

    def normalise(self, text: str, folder: Path, port: str) -> str:
        """Return a text without folders, ports, versions and dates, which differ from one recording to the next."""
        text = text.replace(str(folder), "FOLDER").replace(f"--port {port}", "--port PORT")
        for pattern, other in self.replaced:
            text = pattern.sub(other, text)
        return text


def environment() -> dict[str, str]:
    """Return the environment of a command: a terminal of fixed width without colours, one thread for BLAS."""
    fixed = {"COLUMNS": "120", "NO_COLOR": "1", "TERM": "dumb", "OPENBLAS_NUM_THREADS": "1", "LC_ALL": "C.UTF-8"}
    return {**os.environ, **fixed}


def finish(process: subprocess.Popen[bytes], limit: float = LIMIT) -> tuple[int, bytes, bytes]:
    """Return status and streams of a command, which is ended where it takes too long."""
    try:
        out, err = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        process.send_signal(signal.SIGINT)
        try:
            out, err = process.communicate(timeout=20.0)
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
    return process.returncode, out, err


def start_listener(command: list[str], folder: Path) -> tuple[subprocess.Popen[bytes], bytes]:
    """Start a command in the background, wait for its first line on the error stream, and return both."""
    process = subprocess.Popen(
        [sys.executable, "-m", "clubface", *command],
        cwd=folder, env=environment(), stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
    )  # fmt: skip
    assert process.stderr is not None
    return process, process.stderr.readline()


def free_port() -> int:
    """Return a port of this machine that nothing listens on."""
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


PICTURES = {".png", ".pdf", ".gif"}
EMBEDDED = re.compile(r"data:([\w/+-]+)(?:;charset=[\w-]+)?;base64,([A-Za-z0-9+/=]+)")
DOWNLOAD = re.compile(r'download="([^"]*)" href="data:[\w/+-]+(?:;charset=[\w-]+)?;base64,([A-Za-z0-9+/=]+)"')


def keep_file(folder: Path, name: str, content: bytes, normalise) -> None:
    """Keep a written file as text that can be compared; of a picture that it is there, of other data its SHA-256."""
    path, ending = folder / name, Path(name).suffix.lower()
    path.parent.mkdir(parents=True, exist_ok=True)
    if ending == ".parquet":
        path.with_name(path.name + ".csv").write_text(table_text(content), encoding="utf-8")
        return
    if ending in PICTURES:
        path.with_name(path.name + ".txt").write_text(
            f"a picture of {'some' if len(content) > 500 else 'no'} content\n"
        )
        return
    try:
        text = content.decode("utf-8")
    except UnicodeDecodeError:
        text = ""
    if "\0" in text or (not text and content):
        path.with_name(path.name + ".txt").write_text(f"sha256 {hashlib.sha256(content).hexdigest()}\n")
    elif ending == ".svg":
        path.with_name(path.name + ".txt").write_text(normalise(picture_text(text)), encoding="utf-8")
    elif ending == ".html":
        for place, (title, data) in enumerate(DOWNLOAD.findall(text), 1):
            inner = re.sub(r"[^\w.-]+", "-", html.unescape(title)) or str(place)
            keep_file(path.with_name(path.name + ".saved"), inner, base64.b64decode(data), normalise)
        path.with_name(path.name + ".txt").write_text(normalise(page_text(text)), encoding="utf-8")
    else:
        path.write_text(normalise(EMBEDDED.sub(r"data:\1", text)), encoding="utf-8")


def table_text(content: bytes) -> str:
    """Return a Parquet table as CSV with every digit."""
    import pyarrow.parquet

    table = pyarrow.parquet.read_table(io.BytesIO(content))
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(table.column_names)
    writer.writerows(zip(*(column.to_pylist() for column in table.columns), strict=True))
    return out.getvalue()


def picture_text(text: str) -> str:
    """Return the texts that stand in a picture, which Matplotlib writes as comments beside their outlines."""
    texts = re.findall(r"<!--\s*(.*?)\s*-->|<text[^>]*>(.*?)</text>", text, re.DOTALL)
    return "".join(f"{html.unescape(one or other)}\n" for one, other in texts)


def page_text(text: str) -> str:
    """Return the words of a page: a line for each paragraph and each row of a table, cells parted by bars."""
    text = re.sub(r"<(style|script)\b.*?</\1>", "", text, flags=re.DOTALL)
    text = re.sub(r"</t[dh]>\s*<t[dh][^>]*>", " | ", text)
    text = re.sub(r"</?(p|h\d|tr|li|pre|figure|figcaption|table|div|ul|ol|title)\b[^>]*>", "\n", text)
    text = html.unescape(re.sub(r"<[^>]+>", "", text))
    return re.sub(r"\n\s*\n+", "\n", text).strip() + "\n"


def read_help(jobs: int) -> dict[tuple[str, ...], str]:
    """Return the help of the command line and of every command and subcommand below it."""
    pages: dict[tuple[str, ...], str] = {}
    waiting: list[tuple[str, ...]] = [()]
    while waiting:
        with ThreadPoolExecutor(jobs) as pool:
            texts = list(pool.map(help_of, waiting))
        pages |= dict(zip(waiting, texts, strict=True))
        waiting = [(*each, inner) for each, text in zip(waiting, texts, strict=True) for inner in subcommands(text)]
    return pages


def help_of(command: tuple[str, ...]) -> str:
    """Return what ``--help`` prints."""
    asked = [sys.executable, "-m", "clubface", *command, "--help"]
    return subprocess.run(asked, env=environment(), capture_output=True, text=True, check=True).stdout


def subcommands(text: str) -> list[str]:
    """Return the commands that a help page lists."""
    _, _, panel = text.partition("─ Commands ")
    return re.findall(r"^│ ([a-z][\w-]*) ", panel, re.MULTILINE)


def options_unused(pages: dict[tuple[str, ...], str], runs: dict[str, list[str]]) -> Iterator[str]:
    """Yield each command that no run covers, and each option of a command that none of its runs gives."""
    used: dict[tuple[str, ...], set[str]] = {}
    for line in (line for lines in runs.values() for line in lines):
        words = shlex.split(line.removeprefix("& "))
        command = max((each for each in pages if tuple(words[: len(each)]) == each), key=len)
        used.setdefault(command, set()).update(word for word in words if word.startswith("-"))
    for command, text in pages.items():
        if subcommands(text):
            continue
        name, given = " ".join(command), used.get(command)
        if given is None:
            yield f"{name}: no run"
            continue
        for row in re.findall(r"^│[ *]+(--[\w-]+.*)$", text, re.MULTILINE):
            names = re.findall(r"(?<![\w-])--?[a-z][\w-]*", re.split(r" {2,}(?=[A-Z\"<])", row)[0])
            if "--help" not in names and not given.intersection(names):
                yield f"{name}: {names[0]}"


def patterns() -> tuple[tuple[re.Pattern[str], str], ...]:
    """Return patterns of what differs between recordings: folder of the package, versions, dates, memory addresses."""
    asked = "import clubface, pathlib; print(pathlib.Path(clubface.__file__).parent); print(clubface.__version__)"
    package, version = subprocess.run(
        [sys.executable, "-c", asked], capture_output=True, text=True, check=True
    ).stdout.splitlines()
    normalised = [
        (re.escape(package), "PACKAGE"),
        (rf"\b{re.escape(version)}(\+\S+)?(?![\d.])", "VERSION"),
        (r"\b(Python|numpy|scipy|matplotlib) \d+\.\d+(\.\d+)?", r"\1 VERSION"),
        (r"\b\d{4}-\d\d-\d\d[T ]\d\d:\d\d(:\d\d(\.\d+)?)?(Z|[+-]\d\d:\d\d)?", "TIME"),
        (r"127\.0\.0\.1:\d+", "127.0.0.1:PORT"),
        (r"0x[0-9a-f]{8,}", "ADDRESS"),
        (r"golden-\w{8}", "golden"),
    ]
    return tuple((re.compile(pattern), other) for pattern, other in normalised)


def record(target: Path, *, jobs: int, with_long: bool, only: list[str], inputs: Path | None) -> int:
    """Record every run into an empty folder; return 0 if all could be started."""
    if target.exists() and any(target.iterdir()):
        raise SystemExit(f"{target} is not empty: name another folder")
    target.mkdir(parents=True, exist_ok=True)
    if inputs is None:
        write_inputs(target / "inputs")
    else:
        shutil.copytree(inputs, target / "inputs")
    runs = read_runs(with_long=with_long)
    pages = read_help(jobs)
    (target / "coverage.txt").write_text("".join(f"{line}\n" for line in options_unused(pages, runs)))
    recorder = Recorder(target=target, inputs=target / "inputs", replaced=patterns())
    for command, text in pages.items():
        kept = target / "help" / ("-".join(command) or "clubface")
        kept.mkdir(parents=True)
        (kept / "1.out").write_text(text, encoding="utf-8")
        (kept / "commands.json").write_text(json.dumps([{"command": shlex.join([*command, "--help"]), "status": 0}]))
    chosen = {name: lines for name, lines in runs.items() if not only or any(name.startswith(each) for each in only)}
    started = time.monotonic()
    with ThreadPoolExecutor(jobs) as pool:
        waiting = {name: pool.submit(recorder.run, name, lines) for name, lines in chosen.items()}
        seconds = {name: each.result() for name, each in waiting.items()}
    for name, taken in sorted(seconds.items(), key=lambda pair: -pair[1])[:12]:
        print(f"{taken:7.1f} s  {name}")
    print(f"{len(seconds)} runs in {time.monotonic() - started:.0f} s: {target}")
    return 0


def main() -> int:
    """Read the command line and record or compare."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    recording = commands.add_parser("record", help="run every command and keep its outputs")
    recording.add_argument("folder", type=Path, help="an empty or new folder")
    recording.add_argument("--jobs", type=int, default=2, help="runs at a time; 2 unless given")
    recording.add_argument("--long", action="store_true", help="also the runs that take long")
    recording.add_argument("--only", action="append", default=[], metavar="NAME", help="runs whose names begin so")
    recording.add_argument("--inputs", type=Path, metavar="FOLDER", help="input files of another recording")
    comparing = commands.add_parser("compare", help="compare two recordings")
    comparing.add_argument("before", type=Path)
    comparing.add_argument("after", type=Path)
    comparing.add_argument("--only", action="append", default=[], metavar="NAME", help="runs whose names begin so")
    comparing.add_argument("-o", "--output", type=Path, default=Path("golden-differences.md"), metavar="FILE")
    comparing.add_argument(
        "--most", type=int, default=40, help="items of each kind that the file lists; 40 unless given"
    )
    given = parser.parse_args()
    if given.command == "record":
        return record(
            given.folder, jobs=given.jobs, with_long=given.long, only=given.only,
            inputs=given.inputs,
        )  # fmt: skip
    return compare(given.before, given.after, given.output, given.most, tuple(given.only))


if __name__ == "__main__":
    sys.exit(main())
