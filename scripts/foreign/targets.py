"""The machines that the package is built for, and what runs their programs here."""

from __future__ import annotations

import platform
import re
import shutil
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from debian_root import debian_root
from wine import wine_variables

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "out" / "foreign"
PROCESSORS = {"amd64": "x86_64", "arm64": "aarch64"}
"""Rust's names of processors that systems call otherwise."""

PLATFORMS = {"Windows": "-win_", "Darwin": "-macosx_"}
"""How the platform begins in the name of a wheel."""


class Target(NamedTuple):
    """A kind of machine.

    Attributes
    ----------
    triple
        Its name in Rust.
    system, processor, c_library
        Its parts, in words; only Linux has several C libraries.
    """

    triple: str
    system: str
    processor: str
    c_library: str

    @property
    def debian(self) -> str:
        """Debian's name of the processor."""
        return {processor: name for name, processor in PROCESSORS.items()}[self.processor]

    @property
    def native(self) -> bool:
        """Whether the system at hand is this one, on this processor."""
        machine = platform.machine().lower()
        return (self.system, self.processor) == (platform.system(), PROCESSORS.get(machine, machine))

    def takes(self, wheel: str) -> bool:
        """Whether the platform in the name of a wheel is this one."""
        system = {"glibc": "manylinux", "musl": "musllinux"}.get(self.c_library) or PLATFORMS[self.system]
        return system in wheel and any(wheel.endswith(f"{name}.whl") for name in (self.processor, self.debian))


TARGETS = {
    each.triple: each
    for each in (
        Target("x86_64-unknown-linux-gnu", "Linux", "x86_64", "glibc"),
        Target("aarch64-unknown-linux-gnu", "Linux", "aarch64", "glibc"),
        Target("x86_64-unknown-linux-musl", "Linux", "x86_64", "musl"),
        Target("aarch64-unknown-linux-musl", "Linux", "aarch64", "musl"),
        Target("x86_64-pc-windows-gnu", "Windows", "x86_64", ""),
        Target("x86_64-apple-darwin", "Darwin", "x86_64", ""),
        Target("aarch64-apple-darwin", "Darwin", "aarch64", ""),
    )
}


class Runner(NamedTuple):
    """How programs of a target run here.

    Attributes
    ----------
    command
        What stands before the path of a program; empty where it runs by itself.
    how
        "native", or the emulator with its version.
    root
        Folder with the files of that machine's system, or None.
    variables
        Of the environment, besides those that are set.
    """

    command: tuple[str, ...]
    how: str
    root: Path | None = None
    variables: Mapping[str, str] = {}

    @property
    def emulated(self) -> bool:
        """Whether every instruction is translated, which takes ten times as long and more."""
        return self.how.startswith("qemu")


def runner(target: Target, packages: tuple[str, ...] = ()) -> Runner:
    """Return how programs of a target run here.

    For Linux on another processor, its C library and these packages of Debian are unpacked into a folder; nothing is
    installed. Programs for musl have it in them.

    Raises
    ------
    SystemExit
        A program is missing: the message says what to install.
    """
    if target.native:
        return Runner((), "native")
    if target.system == "Windows":
        wine = find_program("wine", "wine and wine64")
        return Runner((wine,), f"Wine {_version(wine)}", variables=wine_variables(FOLDER / "wine", wine))
    if target.system != "Linux" or platform.system() != "Linux":
        raise SystemExit(f"nothing here runs programs of {target.triple}; its wheel can be built and checked")
    emulator = find_program(f"qemu-{target.processor}", "qemu-user")
    root = debian_root(FOLDER / f"debian-{target.debian}", target.debian, packages)
    return Runner((emulator, "-L", str(root)), f"qemu-user {_version(emulator)}", root)


def find_program(name: str, package: str) -> str:
    """Return the path of a program."""
    path = shutil.which(name)
    if path is None:
        raise SystemExit(f"there is no {name}: install {package} (Debian's names)")
    return path


def _version(program: str) -> str:
    printed = subprocess.run([program, "--version"], capture_output=True, text=True, check=False).stdout
    version = re.search(r"\d+(\.\d+)+", printed)
    return version[0] if version else "of unknown version"
