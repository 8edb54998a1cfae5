"""A folder in which Wine keeps its Windows, with what older Wines lack."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

LACKING = "bcryptprimitives"
"""A library of Windows."""
COMPLEX = "ucrt_complex"
"""Functions of its C library."""
START = f"""\
import ctypes
import errno
import msvcrt
import struct
import sys

sys.modules["_wmi"] = None  # what newer Pythons ask about the system ends the process too
library, system = ctypes.CDLL("{COMPLEX}"), ctypes.CDLL("ucrtbase")
for name in "cabs carg catan ccos ccosh cexp cimag clog cpow creal csin csinh csqrt ctan ctanh".split():
    for each in (name, name + "f", name + "l"):
        lacking = ctypes.cast(getattr(system, each), ctypes.c_void_p)
        address = ctypes.cast(getattr(library, "wine_" + each), ctypes.c_void_p).value
        jump = b"\\x48\\xb8%b\\xff\\xe0" % struct.pack("<Q", address)  # mov rax, address; jmp rax
        ctypes.windll.kernel32.VirtualProtect(lacking, ctypes.c_size_t(len(jump)), 0x40, ctypes.byref(ctypes.c_ulong()))
        ctypes.memmove(lacking, jump, len(jump))


def locking(*arguments, locking=msvcrt.locking):
    try:
        locking(*arguments)
    except OSError as error:
        raise OSError(error.errno or errno.EACCES, "Permission denied") from None


msvcrt.locking = locking
"""
"""What a Python does first: the C library of Wine stops the process at these functions, and then goes on to ours; where
a part of a file is locked already, it does not say why it cannot lock it."""


def wine_variables(folder: Path, wine: str) -> dict[str, str]:
    """Return the variables with which Wine runs Rust's programs and Python, having made its folder.

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
    for name in (LACKING, COMPLEX):
        library = system / f"{name}.dll"
        if not library.exists():
            source = Path(__file__).with_name(f"{name}.c")
            compiler = [sys.executable, "-m", "ziglang", "cc", "-target", "x86_64-windows-gnu", "-shared", "-O2"]
            subprocess.run([*compiler, "-o", str(library), str(source), "-ladvapi32"], check=True)
    return variables
