"""A wheel in the Python of another machine: a first session, then the tests that compare with stored numbers."""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
import time
import tomllib
from collections.abc import Sequence
from itertools import chain
from pathlib import Path
from typing import Any

from targets import FOLDER, ROOT, Runner, Target
from windows_python import windows_python

PACKAGES = ("python3.11", "libstdc++6")
"""Debian's Python, and what NumPy's wheels ask of a system."""
TOOLS = ("fmpy", "hypothesis", "pytest")
"""What the tests need."""
ON_WINDOWS = ("colorama", "tzdata", "httpx2")
"""What dependencies need there alone, which pip leaves out on another system, and what tests of the studio need."""
EXTRAS_ON_WINDOWS = ("excel", "tables", "plots", "fem", "capture", "fit", "studio")
SESSION = """\
import platform
import clubface
from clubface.export.fmu import write_fmu

print(platform.machine(), platform.python_version(), *platform.libc_ver(), clubface.__file__)
shot = clubface.impact("driver", speed="105 mph", loft="13 deg")
print(f"ball speed {float(shot.ball_speed):.9f} m/s, carry {float(clubface.fly(shot).carry):.9f} m")
struck = clubface.impact("driver", speed="105 mph", loft="13 deg", model="fem")
print(f"by finite elements {float(struck.ball_speed):.9f} m/s")
print(write_fmu("impact.fmu", "driver", model="volumetric").stat().st_size, "bytes of a unit for co-simulation")
"""
TESTS = (
    "tests/cli/test_golden_numbers.py",
    "tests/export/test_fmu.py",
    "tests/simulation/test_flight_published.py",
)
"""What compares with stored and published numbers, and units for co-simulation: minutes under an emulator."""
TESTS_ON_WINDOWS = (
    *TESTS,
    "tests/cli/test_commands.py",
    "tests/cli/test_monitor.py",
    "tests/cli/test_process.py",
    "tests/jobs",
    "tests/shots/prediction/test_resume.py",
    "tests/shots/test_live.py",
    "tests/studies",
    "tests/studio",
    "tests/support",
)
"""Besides, whatever is about files, processes, terminals and sockets."""
COUNTS = re.compile(r"(\d+) (passed|failed|error|skipped)")


def try_wheel(
    target: Target, runner: Runner, wheel: Path, program: Sequence[str], pytest: Sequence[str], version: str = "3.11"
) -> dict[str, Any]:
    """Install a wheel with its dependencies into a folder and use it in another machine's Python.

    ``program`` is that Python's command where it is neither Debian's nor the one for Windows of this ``version``;
    ``pytest`` what to run in place of the usual tests.

    Raises
    ------
    SystemExit
        The wheel or a dependency cannot be installed, or the first session fails.
    """
    folder = FOLDER / target.triple
    site = folder / "site"
    python = python_command(folder, target, runner, program, version)
    install(target, wheel, site, version)
    drive = "Z:" if target.system == "Windows" else ""  # on which Wine shows the files of this machine
    if not drive:
        # Under an emulator Python's own path is no program of this machine: processes that it starts need the command.
        (site / "sitecustomize.py").write_text(f"import sys\nsys.executable = {str(python)!r}\n", encoding="utf-8")
    variables = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    variables |= {"PYTHONPATH": f"{drive}{site}", "PYTHONPYCACHEPREFIX": f"{drive}{folder / 'cache'}"}
    variables |= {"PYTHONUNBUFFERED": "1", "OPENBLAS_NUM_THREADS": "1", **runner.variables}
    variables["PYTHONUTF8"] = "1"  # tests read files as 3.15 does; one asks what is written otherwise
    status, _ = _ran([str(python), "-c", SESSION], folder, variables)
    if status:
        raise SystemExit(f"{wheel.name}: its first session failed")
    command = [str(python), "-m", "pytest", "--color=no", "-p", "no:cacheprovider"]
    command += pytest or (TESTS_ON_WINDOWS if target.system == "Windows" else TESTS)
    print("+", shlex.join(command), flush=True)
    counts: dict[str, int] = dict.fromkeys(("passed", "failed", "skipped"), 0)
    began = time.monotonic()
    status, closing = _ran(command, ROOT, variables)
    for number, word in COUNTS.findall(closing):
        counts["failed" if word == "error" else word] += int(number)
    if status and not counts["failed"]:
        counts["failed"] = 1
    return {"tests": "a selection", **counts, "seconds": round(time.monotonic() - began)}


def _ran(command: Sequence[str], folder: Path, variables: dict[str, str]) -> tuple[int, str]:
    """Run a command, show what it prints, and return its status and the last line that tells of a time."""
    closing = ""
    # Through a pipe: in Wine Python for Windows does not start where its output is a file.
    with subprocess.Popen(
        command, cwd=folder, env=variables, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
        encoding="utf-8", errors="replace",
    ) as process:  # fmt: skip
        assert process.stdout is not None
        for line in process.stdout:
            print(line, end="", flush=True)
            closing = line if re.search(r" in [\d.]+s", line) else closing
    return process.returncode, closing


def python_command(folder: Path, target: Target, runner: Runner, program: Sequence[str], version: str) -> Path:
    """Write a program that starts the other machine's Python, and return its path."""
    if target.system == "Windows":
        command = [*program] or [*runner.command, str(windows_python(folder, version))]
    else:
        command = [*program] or [*runner.command, f"{runner.root}/usr/bin/python3.11"]
    python = folder / "python"
    folder.mkdir(parents=True, exist_ok=True)
    python.write_text(f'#!/bin/sh\nexec {shlex.join(command)} "$@"\n', encoding="utf-8")
    python.chmod(0o755)
    return python


def platforms(target: Target) -> list[str]:
    """Return the tags of the wheels that a machine takes; Debian 12 has glibc 2.36, Alpine since 3.12 musl 1.2."""
    if target.system == "Windows":
        return ["win_amd64"]
    if target.c_library == "musl":
        return [f"musllinux_1_{minor}_{target.processor}" for minor in (2, 1)]
    return [f"manylinux_2_{minor}_{target.processor}" for minor in range(36, 16, -1)] + [
        f"manylinux2014_{target.processor}"
    ]


def install(target: Target, wheel: Path, site: Path, version: str) -> None:
    """Put a wheel, its dependencies and the tools of the tests into a folder, as pip does on that machine."""
    shutil.rmtree(site, ignore_errors=True)
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    options = ["--quiet", "--target", str(site), "--python-version", version, "--only-binary", ":all:"]
    options += [each for tag in platforms(target) for each in ("--platform", tag)]
    packages = [*project["dependencies"], *TOOLS]
    if target.system == "Windows":
        packages += [*ON_WINDOWS, *chain(*(project["optional-dependencies"][each] for each in EXTRAS_ON_WINDOWS))]
    for what in ((str(wheel), "--no-deps"), packages):
        done = subprocess.run([sys.executable, "-m", "pip", "install", *options, *what], check=False)
        if done.returncode:
            raise SystemExit(f"{target.triple}: pip cannot install {' '.join(what)}")
