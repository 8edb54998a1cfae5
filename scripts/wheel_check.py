"""Check a wheel as its users meet it: its size, its symbols, and what it does in fresh environments.

``python scripts/wheel_check.py WHEEL`` installs it with NumPy alone, then as `pip install clubface` does, then with
every extra by itself, and runs in each what that installation is for. The last line is "N passed, N failed".
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
import venv
import zipfile
from pathlib import Path
from typing import Any
from urllib.parse import urljoin
from urllib.request import urlopen

ROOT = Path(__file__).parent.parent
LARGEST = 15e6
"""Bytes that a wheel may have."""
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
VARIABLES = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
"""Those of the environment without what would let another package through."""


class Environment:
    """A fresh virtual environment outside the checkout."""

    def __init__(self, folder: Path) -> None:
        venv.create(folder, with_pip=True)
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
        """Install by pip, without what pip says of itself."""
        self.run("python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *what)


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
    """Check that the wheel keeps to Python's stable interface, and on Linux which systems it runs on."""
    tools = Environment(folder)
    tools.install("abi3audit", *(["auditwheel"] if sys.platform == "linux" else []))
    result = tools.run("abi3audit", "--strict", str(wheel))
    if sys.platform == "linux":
        result += tools.run("auditwheel", "show", str(wheel))
    return " ".join(result.split())[:300]


def check_alone(wheel: Path, folder: Path) -> str:
    """Compute a shot with NumPy alone."""
    alone = Environment(folder)
    alone.install("--no-deps", str(wheel))
    alone.install("numpy")
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
    environment.install(f"{wheel}[{extra}]")
    environment.run("python", "-W", "ignore", "-c", TRIED.get(extra, SHOT))
    return "installed and used"


def main(wheel: Path) -> int:
    """Run every check, print each result, and return how many failed."""
    checks = {
        "contents": lambda folder: check_contents(wheel),
        "symbols": lambda folder: check_symbols(wheel, folder),
        "NumPy alone": lambda folder: check_alone(wheel, folder),
        "command": lambda folder: check_command(wheel, folder),
        "studio": lambda folder: check_studio(wheel, folder),
        **{f"extra {name}": lambda folder, name=name: check_extra(wheel, name, folder) for name in extras()},
    }
    failed = 0
    for name, check in checks.items():
        with tempfile.TemporaryDirectory(prefix="clubface-wheel-") as folder:
            try:
                print(f"{name:<16} {check(Path(folder))}", flush=True)
            except RuntimeError as error:
                failed += 1
                print(f"{name:<16} FAILED: {error}", flush=True)
    print(f"{len(checks) - failed} passed, {failed} failed")
    return failed


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()) > 0)
