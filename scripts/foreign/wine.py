"""A folder in which Wine keeps its Windows, with a library that older Wines lack."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

LACKING = "bcryptprimitives"


def wine_variables(folder: Path, wine: str) -> dict[str, str]:
    """Return the variables with which Wine runs Rust's programs, having made its folder.

    Raises
    ------
    SystemExit
        Wine does not start.
    """
    variables = {"WINEPREFIX": str(folder), "WINEDEBUG": "-all"}
    system = folder / "drive_c" / "windows" / "system32"
    if not system.is_dir():
        folder.mkdir(parents=True, exist_ok=True)
        started = subprocess.run([wine, "wineboot", "--init"], env={**os.environ, **variables}, capture_output=True)
        if started.returncode:
            raise SystemExit("wine does not start: install wine and wine64 (Debian's names)")
    library = system / f"{LACKING}.dll"
    if not library.exists():
        source = Path(__file__).with_name(f"{LACKING}.c")
        compiler = [sys.executable, "-m", "ziglang", "cc", "-target", "x86_64-windows-gnu", "-shared"]
        subprocess.run([*compiler, "-o", str(library), str(source), "-ladvapi32"], check=True)
    return variables
