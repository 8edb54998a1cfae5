"""What pip builds clubface with from its sources: maturin, and before it the library of units for co-simulation.

``build-backend`` of pyproject.toml names this module (PEP 517). Wheels of a release are built by `make wheel`.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import maturin
from maturin import (
    build_sdist as build_sdist,
    get_requires_for_build_editable as get_requires_for_build_editable,
    get_requires_for_build_sdist as get_requires_for_build_sdist,
    get_requires_for_build_wheel as get_requires_for_build_wheel,
    prepare_metadata_for_build_editable as prepare_metadata_for_build_editable,
    prepare_metadata_for_build_wheel as prepare_metadata_for_build_wheel,
)

PACKAGE = Path("python") / "clubface"


def build_wheel(directory: str, settings: dict[str, Any] | None = None, metadata: str | None = None) -> str:
    """Build a wheel into a directory and return its name."""
    build_units()
    return maturin.build_wheel(directory, settings, metadata)


def build_editable(directory: str, settings: dict[str, Any] | None = None, metadata: str | None = None) -> str:
    """Build a wheel that refers to this folder, and return its name."""
    build_units()
    return maturin.build_editable(directory, settings, metadata)


def build_units() -> None:
    """Build the native library of units and put it into the package."""
    command = ["rustc", "--profile", "release", "--locked", "--package", "clubface-fmi"]
    command += ["--crate-type", "cdylib", "--message-format", "json-render-diagnostics", "--", "-C", "strip=symbols"]
    # Without Rust at hand, maturin asks pip for one, and knows where that is.
    environment = getattr(maturin, "_get_env", lambda: None)()
    program = shutil.which("cargo", path=(environment or os.environ).get("PATH"))
    if program is None:
        raise SystemExit("clubface is compiled by Rust, 1.89 or newer: install it from https://rustup.rs")
    done = subprocess.run([program, *command], stdout=subprocess.PIPE, text=True, env=environment, check=False)
    if done.returncode:
        raise SystemExit("the library of units for co-simulation could not be compiled; the compiler says above why")
    native = PACKAGE / "export" / "native"
    native.mkdir(parents=True, exist_ok=True)
    for message in map(json.loads, done.stdout.splitlines()):
        if message["reason"] == "compiler-artifact" and message["target"]["name"] == "clubface_fmi":
            for library in map(Path, message["filenames"]):
                if library.suffix in (".so", ".dylib", ".dll"):
                    shutil.copy(library, native / library.name.removeprefix("lib"))
