"""Plant errors in the Python package, a sample of all that can be planted, and see whether a test notices each.

``make mutants`` runs it. Every error is planted alone, in a copy of the sources, and the tests that run its line are
run until one fails, the quickest first. An error that none notices is printed with its place: either a test is missing,
or the line does the same with the error in it, which ``equivalent.toml`` then says with the reason. The same seed
plants the same errors.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from fnmatch import fnmatch
from pathlib import Path
from queue import SimpleQueue
from typing import NamedTuple

from coverage import CoverageData
from mutations import Mutation, mutations

ROOT = Path(__file__).parents[2]
PACKAGE = "python/clubface"
LEFT_OUT = (
    "*/plots.py", "*/pictures.py", "*_picture.py", "*/picture.py", "*/benchmark_recipe.py", "*/__main__.py",
)  # fmt: skip
"""Pictures, whose looks no test can judge, and studies that take minutes, of which a page shows the results."""
MOST_SECONDS = 60.0
"""What the tests of an error may take at a time, as recorded; the slowest are left out beyond that."""


class Planted(NamedTuple):
    """An error in a file of the package."""

    path: str
    mutation: Mutation
    text: str

    def __str__(self) -> str:
        return f"{self.path}:{self.mutation.line}: {self.mutation}    {self.text}"


def candidates(only: str) -> list[Planted]:
    """Return every error that can be planted in the files that match ``only``, but for those that change nothing."""
    same = tomllib.loads((Path(__file__).parent / "equivalent.toml").read_text(encoding="utf-8"))["equivalent"]
    known = {(each["path"], each["line"], each["change"]) for each in same}
    planted_errors = []
    for path in sorted((ROOT / PACKAGE).rglob("*.py")):
        name = path.relative_to(ROOT).as_posix()
        if any(fnmatch(name, each) for each in LEFT_OUT) or not fnmatch(name, only):
            continue
        source = path.read_text(encoding="utf-8")
        lines = source.splitlines()
        for each in mutations(source):
            planted = Planted(name, each, lines[each.line - 1].strip())
            if (what := (name, planted.text, str(each))) not in known:
                known.add(what)  # the same error twice in a line, or in lines that are alike, is planted once
                planted_errors.append(planted)
    return planted_errors


def copy_sources(target: Path) -> Path:
    """Copy what git knows, or would, and the compiled core."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT, capture_output=True, check=True, text=True,
    ).stdout.split("\0")  # fmt: skip
    core = [path.relative_to(ROOT).as_posix() for path in (ROOT / PACKAGE).glob("_core*")]
    for name in {*filter(None, listed), *core}:
        if (ROOT / name).is_file():
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, target / name)
    return target


def pytest_in(copy: Path, *arguments: str, timeout: float | None = None, **environment: str) -> int:
    """Run tests of a copy on the package of that copy; return the status, 1 where they took too long."""
    env = os.environ | {"PYTHONPATH": str(copy / "python"), "PYTHONDONTWRITEBYTECODE": "1"} | environment
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *arguments]
    try:
        with (copy / "tests.log").open("w") as log:
            return subprocess.run(command, cwd=copy, env=env, stdout=log, stderr=log, timeout=timeout).returncode
    except subprocess.TimeoutExpired:
        return 1


class Records:
    """Which tests run a line, and how long they take.

    Parameters
    ----------
    copy
        The sources that are tested.
    folder
        Where the records lie while they are made.
    workers
        Tests run at a time.
    kept
        A file that keeps the records for other runs on the same sources, or has them already; None for none.
    """

    def __init__(self, copy: Path, folder: Path, workers: int, kept: Path | None) -> None:
        self.times: dict[str, float] = {}
        self.lines: dict[str, dict[int, list[str]]] = {}
        self.rooms: dict[str, list[str]] = {}
        if kept is not None and kept.exists():
            records = json.loads(kept.read_text(encoding="utf-8"))
            self.times = records["times"]
            self.lines = {
                path: {int(line): tests for line, tests in lines.items()} for path, lines in records["lines"].items()
            }
            self._take_newer(kept.stat().st_mtime)
        else:
            self._make(copy, folder, workers)
            if kept is not None:
                kept.write_text(json.dumps({"times": self.times, "lines": self.lines}), encoding="utf-8")
        for test in self.times:
            self.rooms.setdefault(test.partition("::")[0].rpartition("/")[0] + "/", []).append(test)

    def _take_newer(self, since: float) -> None:
        """Take test files that are newer than the records as tests of their whole room."""
        for path in sorted((ROOT / "tests").rglob("test_*.py")):
            if path.stat().st_mtime > since:
                self.times[path.relative_to(ROOT).as_posix()] = 0.0

    def _make(self, copy: Path, folder: Path, workers: int) -> None:
        env = {"MUTANTS_RECORDS": str(folder), "MUTANTS_PACKAGE": str(copy / PACKAGE)}
        paths = f"{copy / 'python'}{os.pathsep}{Path(__file__).parent}"
        status = pytest_in(copy, "-p", "recorder", "-n", str(workers), **env | {"PYTHONPATH": paths})
        if status != 0:
            last_lines = (copy / "tests.log").read_text(encoding="utf-8").splitlines()[-20:]
            sys.exit("\n".join([*last_lines, "the tests must pass before errors are planted"]))
        for path in folder.glob("times-*.json"):
            self.times |= json.loads(path.read_text(encoding="utf-8"))
        for part in folder.glob("lines.*"):
            data = CoverageData(str(part))
            data.read()
            for file in data.measured_files():
                by_line = self.lines.setdefault(Path(file).relative_to(copy).as_posix(), {})
                for line, tests in data.contexts_by_lineno(file).items():
                    by_line.setdefault(line, []).extend(filter(None, tests))

    def tests_of(self, planted: Planted) -> Iterator[list[str]]:
        """Yield the tests that run a line, then those that run anything of its file, then all of its room and of none.

        What is computed once for several tests, or on import, is recorded with the first of them or with none.
        """
        lines = self.lines.get(planted.path, {})
        of_line = set(lines.get(planted.mutation.line, ()))
        of_file = {test for tests in lines.values() for test in tests} - of_line
        room = f"tests/{Path(planted.path).relative_to(PACKAGE).parts[0]}/"
        of_room = {*self.rooms.get(room, ()), *self.rooms.get("tests/", ())} - of_line - of_file
        for tests in (of_line, of_file, of_room):
            ranked = sorted(tests, key=lambda test: (not test.startswith(room), self.times.get(test, 0.0)))
            spent, chosen = 0.0, []
            for test in ranked:
                spent += self.times.get(test, 0.0)
                if spent < MOST_SECONDS:
                    chosen.append(test)
            if chosen:
                yield chosen


def survives(planted: Planted, records: Records, copy: Path) -> bool:
    """Plant an error in a copy, run its tests, and take it out again."""
    path = copy / planted.path
    source = path.read_text(encoding="utf-8")
    chosen = copy / "chosen-tests"
    path.write_text(planted.mutation.apply(source), encoding="utf-8")
    try:
        for tests in records.tests_of(planted):
            chosen.write_text("\n".join(tests), encoding="utf-8")
            seconds = 60.0 + 5.0 * sum(records.times.get(test, 0.0) for test in tests)
            if pytest_in(copy, "-x", f"@{chosen}", timeout=seconds) != 0:
                return False
        return True
    finally:
        path.write_text(source, encoding="utf-8")


def main() -> None:
    """Sample, plant, and report."""
    parser = argparse.ArgumentParser(prog="mutants", description=__doc__.partition("\n")[0])
    parser.add_argument("--count", type=int, default=150, help="errors to plant")
    parser.add_argument("--seed", type=int, default=1, help="which errors the sample holds")
    parser.add_argument("--only", default="*", help="files in which to plant, as python/clubface/shots/*")
    parser.add_argument("--records", type=Path, help="file that keeps which tests run a line, for further runs")
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1, help="errors tried at a time")
    given = parser.parse_args()
    every = candidates(given.only)
    # By what an error is and not by its number, so that the sample stays where other lines change.
    drawn = {each: hashlib.sha256(f"{given.seed} {each.path} {each.text} {each.mutation}".encode()) for each in every}
    sample = sorted(every, key=lambda each: drawn[each].hexdigest())[: given.count]
    print(
        f"{len(sample)} of {len(every)} errors that can be planted; first all tests, to record what they run",
        flush=True,
    )
    with tempfile.TemporaryDirectory(prefix="mutants-") as folder:
        base = Path(folder)
        (base / "records").mkdir()
        copies: SimpleQueue[Path] = SimpleQueue()
        for number in range(given.workers):
            copies.put(copy_sources(base / f"copy-{number}"))
        first = copies.get()
        records = Records(first, base / "records", given.workers, given.records)
        copies.put(first)

        def tried(planted: Planted) -> bool:
            copy = copies.get()
            try:
                return survives(planted, records, copy)
            finally:
                copies.put(copy)

        left = []
        with ThreadPoolExecutor(given.workers) as pool:
            for planted, survived in zip(sample, pool.map(tried, sample), strict=True):
                if survived:
                    left.append(planted)
                    print(f"survived  {planted}", flush=True)
    share = 100.0 * len(left) / max(len(sample), 1)
    print(f"{len(sample) - len(left)} of {len(sample)} noticed, {len(left)} survived: {share:.1f}%")


if __name__ == "__main__":
    main()
