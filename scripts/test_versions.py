"""Run the tests of Python on the oldest or the newest versions of every dependency, in fresh environments.

``python scripts/test_versions.py oldest python3.11 python3.13`` installs, for each interpreter in turn, the lowest
versions that pyproject.toml allows and that have a wheel for it, and the wheel of the package, into out/versions, and
runs the tests there. ``newest`` takes the highest versions allowed, ``beyond`` the highest there are, whatever
pyproject.toml says, to tell early what will break. Arguments after ``--`` go to pytest, as in ``-- tests/cli -n0``.

An extra without wheels for an interpreter is left out, and its tests are skipped. So are the tests that need PyTorch
with its gigabytes, Sphinx, or the libraries that `make test` links: pytest's summary names them with the reason.
``--record`` puts the results into docs/tested-versions.json, which the page on installation shows. The last line is
"N passed, N failed".
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import tomllib
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).parent.parent
FOLDER = ROOT / "out" / "versions"
RECORD = ROOT / "docs" / "tested-versions.json"
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
LEFT_OUT = {"all", "cli", "dev", "torch"}
"""Extras that bring nothing of their own, and PyTorch with its gigabytes."""
TOOLS = ("docutils", "httpx2", "hypothesis", "ipykernel", "nbclient", "nbformat", "pytest", "pytest-xdist")
"""What the tests need besides, in the versions of constraints-dev.txt."""
FREE_TOOLS = ("casadi", "fmpy", "httpx")
"""The same, in versions that agree with the dependencies: their newest ask for a newer NumPy than the package."""
RESOLUTIONS = {"oldest": "lowest-direct", "newest": "highest", "beyond": "highest"}
UPPER = re.compile(r",?<[\d.]+")
COUNTS = re.compile(r"(\d+) (passed|failed|error|skipped)")
COUNTED = ("passed", "failed", "skipped")
REPORT = "import platform, sys; print(platform.python_version(), getattr(sys, '_is_gil_enabled', lambda: True)())"


class Interpreter(NamedTuple):
    """An interpreter of Python.

    Attributes
    ----------
    path
        Its program.
    version
        As in "3.13.0".
    free_threaded
        Whether it runs without the global lock, for which packages have wheels of their own.
    """

    path: str
    version: str
    free_threaded: bool

    @property
    def name(self) -> str:
        """As in "3.13" or "3.14t"."""
        return self.version.rpartition(".")[0] + "t" * self.free_threaded


def interpreter(program: str) -> Interpreter:
    """Return the interpreter behind the name of a program."""
    path = shutil.which(program)
    if path is None:
        raise SystemExit(f"{program} is no program that can be run here; give interpreters as in python3.11 python3.13")
    done = subprocess.run([path, "-c", REPORT], capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"{program} does not run: {done.stderr.strip()}")
    version, locked = done.stdout.split()
    return Interpreter(path, version, locked == "False")


def requirements(versions: str) -> dict[str, list[str]]:
    """Return the requirements of the package itself, under "", and of each extra."""
    extras = {name: lines for name, lines in PROJECT["optional-dependencies"].items() if name not in LEFT_OUT}
    groups = {"": PROJECT["dependencies"], **extras}
    if versions == "beyond":
        groups = {name: [UPPER.sub("", line) for line in lines] for name, lines in groups.items()}
    return groups


def uv(*arguments: str, given: str = "") -> subprocess.CompletedProcess[str]:
    """Run uv, outside every virtual environment but the one that its arguments name."""
    environment = {name: value for name, value in os.environ.items() if name != "VIRTUAL_ENV"}
    return subprocess.run(["uv", *arguments], input=given, capture_output=True, text=True, env=environment, check=False)


def resolve(lines: list[str], versions: str, python: Interpreter) -> tuple[list[str], str]:
    """Return the exact versions that satisfy requirements, or none of them and why there are none."""
    options = ["--quiet", "--no-header", "--no-annotate", "--only-binary", ":all:", "--python", python.path]
    options += ["--resolution", RESOLUTIONS[versions]]
    done = uv("pip", "compile", *options, "-", given="\n".join(lines))
    return done.stdout.split(), " ".join(done.stderr.split())


def resolve_all(versions: str, python: Interpreter) -> tuple[list[str], dict[str, str]]:
    """Return exact versions for the package with all extras that can be installed, and why the others cannot."""
    groups = requirements(versions)
    taken = groups.pop("")
    left_out: dict[str, str] = {}
    together, _ = resolve(sum(groups.values(), taken), versions, python)
    if together:
        return together, left_out
    exact, problem = resolve(taken, versions, python)
    if not exact:
        raise SystemExit(f"the package cannot be installed for Python {python.name}: {problem}")
    for name, lines in groups.items():
        more, problem = resolve(taken + lines, versions, python)
        if more:
            taken, exact = taken + lines, more
        else:
            left_out[name] = problem
    return exact, left_out


def built_wheel(python: Interpreter) -> Path:
    """Build the wheel for an interpreter; the stable interface makes it one for all that have the global lock."""
    folder = FOLDER / ("wheel-free-threaded" if python.free_threaded else "wheel")
    options = ["--interpreter", python.path] if python.free_threaded else []
    command = ["maturin", "build", "--release", "--quiet", *options, "--out", str(folder)]
    subprocess.run(command, cwd=ROOT, check=True)
    return max(folder.glob("*.whl"), key=lambda path: path.stat().st_mtime)


def environment(versions: str, python: Interpreter, wheel: Path) -> tuple[Path, dict[str, str]]:
    """Make an environment with exact versions; return its folder and the extras left out, with reasons."""
    exact, left_out = resolve_all(versions, python)
    pins = dict(line.split("==") for line in (ROOT / "constraints-dev.txt").read_text().splitlines() if "==" in line)
    folder = FOLDER / f"{versions}-{python.name}"
    program = folder / "bin" / "python"
    for arguments, given in (
        (["venv", "--quiet", "--clear", "--python", python.path, str(folder)], []),
        (["pip", "install", "--requirements", "-"], exact + [f"{tool}=={pins[tool]}" for tool in TOOLS]),
        (["pip", "install", "--no-deps", "--reinstall", str(wheel)], []),
    ):
        options = ["--quiet", "--python", str(program)] if arguments[0] == "pip" else []
        done = uv(*arguments, *options, given="\n".join(given))
        if done.returncode:
            raise SystemExit(f"{folder.name}: {done.stderr.strip()}")
    # Tools that this interpreter lacks are no reason to stop: their tests are skipped.
    for tool in FREE_TOOLS:
        given = "\n".join([*exact, tool])
        uv("pip", "install", "--quiet", "--only-binary", ":all:", "--python", str(program), "-r", "-", given=given)
    return folder, left_out


def installed(folder: Path) -> dict[str, str]:
    """Return the version of each direct dependency in an environment."""
    direct = {re.split(r"[<>=!~]", line)[0] for lines in requirements("newest").values() for line in lines}
    listed = json.loads(uv("pip", "list", "--format", "json", "--python", str(folder / "bin" / "python")).stdout)
    return {each["name"]: each["version"] for each in listed if each["name"] in direct}


def run_tests(folder: Path, arguments: list[str]) -> tuple[dict[str, int], float]:
    """Run pytest in an environment; return its counts and the seconds it took."""
    variables = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PIP_CONSTRAINT")}
    variables |= {"VIRTUAL_ENV": str(folder), "PATH": os.pathsep.join([str(folder / "bin"), os.environ["PATH"]])}
    workers = ["-n", str(min(os.cpu_count() or 1, 8)), "--dist", "worksteal"]
    command = [str(folder / "bin" / "python"), "-m", "pytest", "--color=no", *workers, *arguments]
    print("+", *command, flush=True)
    closing = ""
    with subprocess.Popen(command, cwd=ROOT, env=variables, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        for line in process.stdout:
            print(line, end="", flush=True)
            closing = line if re.search(r" in [\d.]+s", line) else closing
    counts: dict[str, int] = dict.fromkeys(COUNTED, 0)
    for number, word in COUNTS.findall(closing):
        counts["failed" if word == "error" else word] += int(number)
    if process.returncode and not counts["failed"]:
        counts["failed"] = 1  # nothing was collected, or pytest itself stopped
    seconds = re.search(r" in ([\d.]+)s", closing)
    return counts, float(seconds[1]) if seconds else 0.0


def record(run: dict[str, Any]) -> None:
    """Put a run into the file of the documentation, in place of an earlier one of the same kind."""
    kind = ("versions", "python", "machine")
    runs = json.loads(RECORD.read_text(encoding="utf-8")) if RECORD.exists() else []
    runs = [each for each in runs if any(each[key] != run[key] for key in kind)]
    runs = sorted([*runs, run], key=lambda each: [each[key] for key in kind])
    RECORD.write_text(json.dumps(runs, indent=1) + "\n", encoding="utf-8")


def main(versions: str, programs: list[str], arguments: list[str], wheel: Path | None, recorded: bool) -> int:
    """Run the tests for every interpreter and return how many failed."""
    total = {"passed": 0, "failed": 0}
    for python in [interpreter(program) for program in programs]:
        folder, left_out = environment(versions, python, wheel or built_wheel(python))
        packages = installed(folder)
        print(f"Python {python.version}, {versions}:", *(f"{name} {packages[name]}" for name in sorted(packages)))
        for name, problem in left_out.items():
            print(f"the extra {name} is left out: {problem}")
        counts, seconds = run_tests(folder, arguments)
        run = {
            "versions": versions,
            "python": python.name,
            "release": python.version,
            "machine": f"{platform.system()} {platform.machine()}",
            "date": datetime.now(UTC).date().isoformat(),
            "tests": " ".join(each for each in arguments if not each.startswith("-")) or "all",
            **counts,
            "seconds": round(seconds),
            "left_out": sorted(left_out),
            "packages": packages,
        }
        (FOLDER / f"{folder.name}.json").write_text(json.dumps(run, indent=1) + "\n", encoding="utf-8")
        if recorded:
            record(run)
        total = {word: total[word] + counts[word] for word in total}
    print(f"{total['passed']} passed, {total['failed']} failed")
    return total["failed"]


if __name__ == "__main__":
    given = sys.argv[1:]
    own, for_pytest = (given[: given.index("--")], given[given.index("--") + 1 :]) if "--" in given else (given, [])
    parser = argparse.ArgumentParser(description="Run the tests on the oldest or newest versions of all dependencies.")
    parser.add_argument("versions", choices=RESOLUTIONS)
    parser.add_argument("programs", nargs="+", metavar="PYTHON", help="an interpreter, as in python3.13")
    parser.add_argument("--wheel", type=Path, help="a wheel of the package; built if not given")
    parser.add_argument("--record", action="store_true", help="put the results into docs/tested-versions.json")
    options = parser.parse_args(own)
    sys.exit(main(options.versions, options.programs, for_pytest, options.wheel, options.record) > 0)
