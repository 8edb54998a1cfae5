"""Run the Rust tests, then the Python tests, and end with one line that sums both: ``N passed, N failed``."""

from __future__ import annotations

import os
import re
import subprocess
import sys

# The profile of the build, so that what was compiled for it is linked, and what people run is tested. The bindings hold
# no physics and are tested from Python; their test binary could not link without an interpreter.
RUST = ["cargo", "test", "--release", "--workspace", "--exclude", "clubface-python", "--locked", "--no-fail-fast"]
PYTHON = [sys.executable, "-m", "pytest", "--color=no", "-n", str(min(os.cpu_count() or 1, 8)), "--dist", "worksteal"]

RUST_RESULT = re.compile(r"^test result: .*?(\d+) passed; (\d+) failed")
PYTEST_COUNT = re.compile(r"(\d+) (passed|failed|error)")


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


def main() -> int:
    """Return 0 only if both runs succeeded; no tests found at all (pytest's status 5) is a failure."""
    passed = failed = 0
    for command, count in ((RUST, count_rust), (PYTHON, count_python)):
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
