"""Check a wheel as its users meet it: its size, its symbols, and what it does in fresh environments.

``python scripts/wheel_check.py WHEEL`` installs it with NumPy alone, then as `pip install clubface` does, then with
every extra by itself, and runs in each what that installation is for. In place of a wheel it takes a package of
sources, of which pip makes a wheel first, with Rust and what pyproject.toml asks for. ``--python PROGRAM`` names the
interpreter; one without the global lock may leave out extras that have no wheels for it. Of a wheel for another kind of
machine it looks at size, files and symbols. ``--record`` puts the result into docs/tested-machines.json, which
docs/versions.md shows. The last line is "N passed, N failed".
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
import zipfile
from pathlib import Path
from typing import Any
from urllib.parse import urljoin
from urllib.request import urlopen

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT / "scripts" / "foreign"))
from record import record  # noqa: E402
from targets import TARGETS  # noqa: E402

LARGEST = 15e6
"""Bytes that a wheel may have."""
NO_LOCK = "import sys, clubface._core; assert not sys._is_gil_enabled(), 'clubface turned the global lock on'"
SHOT = "import clubface; print(clubface.fly(clubface.impact('driver', speed='105 mph', loft='13 deg')).carry)"
TRIED = {
    "excel": "from clubface import read_shots; import openpyxl",
    "tables": "import clubface; clubface.impact('driver', speed=45.0).to_xarray(); clubface.models()",
    "plots": "from clubface import plots",
    "fem": "from clubface import fem; import meshlane; print(fem.head('paper'))",
    "capture": "from clubface import capture; import ezc3d",
    "fit": "import clubface, pymoo; clubface.history('driver', speed=45.0, model='volumetric')",
    "cluster": "from clubface import studies; import distributed",
    "jax": "import jax, clubface.jax; jax.grad(lambda v: clubface.jax.impact('driver', speed=v)['ball_speed'])(45.0)",
    "chain": "import clubface.chain",
}
"""What an installation with each extra is asked for, a shot unless it stands here."""
LEFT_OUT = {"all", "cli", "dev", "studio", "torch"}
"""Extras that bring nothing of their own or have a check of their own, and PyTorch with its gigabytes."""
PARTS = ("_core", "export/native/", "py.typed", "studio_site/index.html", "studio_site/assets/clubface-fem")
"""What a wheel has besides Python."""
LIBRARIES = r"""
import io, json, sys, zipfile
from macholib.mach_o import LC_BUILD_VERSION, LC_ID_DYLIB, LC_VERSION_MIN_MACOSX
from macholib.MachO import MachO

wheel, result = zipfile.ZipFile(sys.argv[1]), []
for name in wheel.namelist():
    if name.endswith((".so", ".dylib")):
        path = wheel.extract(name)
        for header in MachO(path).headers:
            oldest, names = [0, 0], [each for _, _, each in header.walkRelocatables()]
            for load, command, data in header.commands:
                if load.cmd in (LC_BUILD_VERSION, LC_VERSION_MIN_MACOSX):
                    version = int(command.minos if load.cmd == LC_BUILD_VERSION else command.version)
                    oldest = [version >> 16, version >> 8 & 255]
                elif load.cmd == LC_ID_DYLIB:
                    names.append(data.rstrip(b"\0").decode())
            result.append((name, oldest, names))
print(json.dumps(result))
"""
"""Prints, of each library of a wheel for macOS, its name, the oldest system, and what it names: itself and others."""
VARIABLES = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
"""Those of the environment without what would let another package through."""


class MissingWheelError(Exception):
    """An extra that needs what has no wheel for the interpreter."""


class Environment:
    """A fresh virtual environment outside the checkout."""

    python = sys.executable
    """The interpreter that makes it."""
    free_threaded = False
    """Whether that runs without the global lock."""

    def __init__(self, folder: Path) -> None:
        subprocess.run([self.python, "-m", "venv", str(folder)], env=VARIABLES, check=True)
        self.folder = folder
        self.bin = folder / ("Scripts" if sys.platform == "win32" else "bin")

    def run(self, *command: str) -> str:
        """Run a command of the environment, in its folder, and return what it printed."""
        program = shutil.which(command[0], path=str(self.bin)) or command[0]
        done = subprocess.run(
            [program, *command[1:]], cwd=self.folder, env=VARIABLES, capture_output=True, text=True, check=False
        )
        if done.returncode:
            raise RuntimeError(f"{' '.join(command)}: {(done.stderr or done.stdout).strip()[-2000:]}")
        return done.stdout

    def install(self, *what: str) -> None:
        """Install by pip, and compile nothing where many packages have no wheels for the interpreter."""
        options = ["--only-binary", ":all:"] if self.free_threaded else []
        self.run("python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *options, *what)


def extras() -> list[str]:
    """Return the extras that are tried one by one."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    return [name for name in project["optional-dependencies"] if name not in LEFT_OUT]


def check_contents(wheel: Path) -> str:
    """Check size and files of a wheel."""
    size = wheel.stat().st_size
    names = zipfile.ZipFile(wheel).namelist()
    missing = [part for part in PARTS if not any(part in name for name in names)]
    if size > LARGEST or missing:
        raise RuntimeError(f"{size / 1e6:.1f} MB, at most {LARGEST / 1e6:.0f} allowed; missing: {missing or 'nothing'}")
    return f"{size / 1e6:.1f} MB, {len(names)} files"


def check_symbols(wheel: Path, folder: Path) -> str:
    """Check that a wheel keeps to Python's stable interface and, on Linux, to the systems that its name promises."""
    tools = Environment(folder)
    tools.install("abi3audit", *(["auditwheel"] if sys.platform == "linux" else []))
    result = tools.run("abi3audit", "--strict", str(wheel)) if "-abi3-" in wheel.name else ""
    if "linux" in wheel.name and sys.platform == "linux":
        # No libraries of this machine are looked at, whose C library may be another.
        audit = json.loads(tools.run("auditwheel", "show", "--json", "--ldpaths", str(folder), str(wheel)))
        # By this name, too, musl knows itself, which auditwheel knows by that of Alpine alone.
        only_musl = "musllinux" in wheel.name and [*audit["external_libs"]] == ["libc.so"]
        tag = audit["sym_tag" if only_musl else "overall_tag"]
        if "-linux_" not in wheel.name and tag not in wheel.name:  # what pip built promises nothing
            raise RuntimeError(f"it keeps to {tag}; libraries of the system: {audit['external_libs']}")
        result += tag
    if "macosx" in wheel.name:
        tools.install("macholib")
        result += check_libraries(json.loads(tools.run("python", "-c", LIBRARIES, str(wheel))), wheel.name)
    return " ".join(result.split())[:300]


def check_libraries(libraries: list[tuple[str, list[int], list[str]]], wheel: str) -> str:
    """Check that the libraries of a wheel for macOS start on the systems that its name promises, wherever they lie."""
    promised = [int(each) for each in re.findall(r"macosx_(\d+)_(\d+)", wheel)[0]]
    for library, oldest, names in libraries:
        if oldest > promised:
            raise RuntimeError(f"{library} asks for macOS {'.'.join(map(str, oldest))}")
        if strange := [each for each in names if not each.startswith(("@rpath/", "/usr/lib/", "/System/"))]:
            raise RuntimeError(f"{library} names {', '.join(strange)}, which other machines lack")
    return f"{len(libraries)} libraries, from macOS {'.'.join(map(str, max(each[1] for each in libraries)))}"


def check_alone(wheel: Path, folder: Path) -> str:
    """Compute a shot with NumPy alone."""
    alone = Environment(folder)
    alone.install("--no-deps", str(wheel))
    alone.install("numpy")
    if alone.free_threaded:
        alone.run("python", "-c", NO_LOCK)
    return f"carry {float(alone.run('python', '-c', SHOT)):.1f} m"


def check_command(wheel: Path, folder: Path) -> str:
    """Install as users do and run the first lines of the README; return the time it took."""
    began = time.monotonic()
    base = Environment(folder)
    base.install(str(wheel))
    shot = base.run("clubface", "shot", "driver", "--speed", "105 mph")
    if "ball speed" not in shot:
        raise RuntimeError(shot)
    base.run("clubface", "export", "fmu", "driver", "--model", "volumetric", "--output", "impact.fmu")
    first = time.monotonic() - began
    return f"installed and first shot in {first:.0f} s"


def check_studio(wheel: Path, folder: Path) -> str:
    """Install the studio, write a report of a shot and open the studio's page; return the time it took."""
    began = time.monotonic()
    environment = Environment(folder)
    environment.install(f"{wheel}[studio]")
    environment.run("clubface", "shot", "driver", "--speed", "105 mph", "--report", "shot.html")
    command = [environment.bin / "clubface", "studio", "--port", "0"]
    how: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL, "text": True}
    with subprocess.Popen(command, cwd=folder, env=VARIABLES, **how) as server:
        try:
            assert server.stdout is not None
            address = server.stdout.readline().strip()
            page = urlopen(address, timeout=30).read().decode()
            scripts = re.findall(r'src="(?:\./)?(assets/[^"]+\.js)"', page)
            if "clubface-api" not in page or not scripts:
                raise RuntimeError(f"this page is not the studio's: {page[:300]}")
            for script in scripts:
                urlopen(urljoin(address, script), timeout=30).read()
        finally:
            server.terminate()
    return f"installed, report and studio in {time.monotonic() - began:.0f} s"


def check_extra(wheel: Path, extra: str, folder: Path) -> str:
    """Install one extra alone and use it."""
    environment = Environment(folder)
    try:
        environment.install(f"{wheel}[{extra}]")
    except RuntimeError as error:
        missing = re.search(r"No matching distribution found for ([\w-]+)|ResolutionImpossible", str(error))
        if environment.free_threaded and missing:
            raise MissingWheelError(f"no wheel of {missing[1] or 'what it needs'} for this Python") from None
        raise
    environment.run("python", "-W", "ignore", "-c", TRIED.get(extra, SHOT))
    return "installed and used"


def build(sources: Path, folder: Path) -> Path:
    """Return the wheel that pip makes of a package of sources."""
    builder = Environment(folder / "builder")
    builder.run("python", "-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", str(folder), str(sources))
    (wheel,) = folder.glob("*.whl")
    return wheel


def runs_here(wheel: Path, folder: Path) -> bool:
    """Return whether pip would install a wheel for the interpreter."""
    probe = Environment(folder)
    try:
        probe.run("python", "-m", "pip", "install", "--dry-run", "--no-deps", "--quiet", str(wheel))
    except RuntimeError:
        return False
    return True


def main(given: Path, folder: Path, recorded: bool) -> int:
    """Run every check of a wheel or a package of sources, print each result, and return how many failed."""
    wheel = given
    if given.suffix != ".whl":
        began = time.monotonic()
        try:
            wheel = build(given, folder)
        except RuntimeError as error:
            print(f"{'build':<16} FAILED: {error}", "0 passed, 1 failed", sep="\n")
            return 1
        print(f"{'build':<16} {wheel.name} in {time.monotonic() - began:.0f} s", flush=True)
    checks = {
        "contents": lambda folder: check_contents(wheel),
        "symbols": lambda folder: check_symbols(wheel, folder),
    }
    installed = runs_here(wheel, folder / "probe")
    if installed:
        checks |= {
            "NumPy alone": lambda folder: check_alone(wheel, folder),
            "command": lambda folder: check_command(wheel, folder),
            "studio": lambda folder: check_studio(wheel, folder),
            **{f"extra {name}": lambda folder, name=name: check_extra(wheel, name, folder) for name in extras()},
        }
    else:
        print(f"{wheel.name} is for another kind of machine: it is not installed")
    counts = {"passed": 0, "failed": 0}
    for name, check in checks.items():
        with tempfile.TemporaryDirectory(prefix="clubface-wheel-") as place:
            try:
                print(f"{name:<16} {check(Path(place))}", flush=True)
                counts["passed"] += 1
            except MissingWheelError as error:
                print(f"{name:<16} left out: {error}", flush=True)
            except RuntimeError as error:
                print(f"{name:<16} FAILED: {error}", flush=True)
                counts["failed"] += 1
    if recorded:
        (target,) = (each for each in TARGETS.values() if each.takes(wheel.name))
        results = {"wheel": wheel.name, "megabytes": round(wheel.stat().st_size / 1e6, 1), **counts}
        record(target, "contents", "installed" if installed else "not installed", results)
    print(f"{counts['passed']} passed, {counts['failed']} failed")
    return counts["failed"]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Check a wheel, or a package of sources, as its users meet it.")
    parser.add_argument("package", type=Path, help="a wheel or a package of sources")
    parser.add_argument("--python", default=sys.executable, help="the interpreter of the environments")
    parser.add_argument("--record", action="store_true", help="put the result into docs/tested-machines.json")
    options = parser.parse_args()
    if not options.package.is_file():
        parser.error(f"{options.package} is no file")
    Environment.python = options.python
    report = "import sysconfig; print(bool(sysconfig.get_config_var('Py_GIL_DISABLED')))"
    done = subprocess.run([options.python, "-c", report], capture_output=True, text=True, check=True)
    Environment.free_threaded = done.stdout.strip() == "True"
    with tempfile.TemporaryDirectory(prefix="clubface-wheel-") as place:
        sys.exit(main(options.package.resolve(), Path(place), options.record) > 0)
