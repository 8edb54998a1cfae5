"""Run the tests of Rust, Python and the studio, and end with one line that sums them: ``N passed, N failed``."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

# The profile of the build, so that what was compiled for it is linked, and what people run is tested. The bindings hold
# no physics and are tested from Python; their test binary could not link without an interpreter.
# The benchmarks are compiled by their own command.
EXCLUDED = ("--exclude", "clubface-python", "--exclude", "clubface-benches")
RUST = ["cargo", "test", "--release", "--workspace", *EXCLUDED, "--locked", "--no-fail-fast"]
PYTHON = [sys.executable, "-m", "pytest", "--color=no", "-n", str(min(os.cpu_count() or 1, 8)), "--dist", "worksteal"]

STUDIO = ["npm", "--prefix", "studio", "run", "--silent", "test"]

# The tests of Rust build the C library, which tests in Python install and compile programs against.
LIBRARY = Path(os.environ.get("CARGO_TARGET_DIR", "target")) / "release" / "deps"

RUST_RESULT = re.compile(r"^test result: .*?(\d+) passed; (\d+) failed")
PYTEST_COUNT = re.compile(r"(\d+) (passed|failed|error)")
VITEST_RESULT = re.compile(r"^\s*Tests\s.*\(\d+\)\s*$")
COLOUR = re.compile(r"\x1b\[[\d;]*m")


def run(command: list[str]) -> tuple[int, list[str]]:
    """Run a command, show its output as it comes, and return its exit status and its lines."""
    print("+", *command, flush=True)
    lines: list[str] = []
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", env=os.environ
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            print(line, end="", flush=True)
            lines.append(line)
    return process.returncode, lines


def count_rust(lines: list[str]) -> tuple[int, int]:
    """Add up the passed and failed tests of every test binary, documentation tests included."""
    counts = [tuple(map(int, match.groups())) for line in lines if (match := RUST_RESULT.match(line))]
    return sum(passed for passed, _ in counts), sum(failed for _, failed in counts)


def count_python(lines: list[str]) -> tuple[int, int]:
    """Read pytest's closing line; an error in collection or set-up counts as a failure."""
    closing = next((line for line in reversed(lines) if re.search(r" in [\d.]+s", line)), "")
    counts = {word: int(number) for number, word in PYTEST_COUNT.findall(closing)}
    return counts.get("passed", 0), counts.get("failed", 0) + counts.get("error", 0)


def count_studio(lines: list[str]) -> tuple[int, int]:
    """Read vitest's line on all tests; skipped ones count as neither."""
    plain = (COLOUR.sub("", line) for line in reversed(lines))
    closing = next((line for line in plain if VITEST_RESULT.match(line)), "")
    counts = {word: int(number) for number, word in PYTEST_COUNT.findall(closing)}
    return counts.get("passed", 0), counts.get("failed", 0)


def has_studio() -> bool:
    """Return whether the packages of the studio are installed, which `make test` does where Node is new enough."""
    return shutil.which("npm") is not None and Path("studio/node_modules/.package-lock.json").is_file()


def main() -> int:
    """Return 0 only if all runs succeeded; no tests found at all (pytest's status 5) is a failure."""
    passed = failed = 0
    os.environ["CLUBFACE_LIBRARY"] = str(LIBRARY.resolve())
    # Tests start hundreds of commands: with their bytecode kept, each of them starts in two thirds of the time.
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    runs = [(RUST, count_rust), (PYTHON, count_python)]
    if has_studio():
        runs.append((STUDIO, count_studio))
    else:
        print("the studio is not tested: that needs Node 20.19 or newer and npm", flush=True)
    for command, count in runs:
        status, lines = run(command)
        run_passed, run_failed = count(lines)
        if status != 0 and run_failed == 0:
            run_failed = 1  # did not compile, could not start, or found nothing to run
        passed += run_passed
        failed += run_failed
    print(f"{passed} passed, {failed} failed", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
