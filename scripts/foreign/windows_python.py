"""CPython for Windows, unpacked from the archives that Bytedeco publishes in Maven Central, and not installed."""

from __future__ import annotations

import hashlib
import io
import re
import shutil
import subprocess
import sys
import urllib.request
import zipfile
from pathlib import Path

from wine import START

ADDRESS = "https://repo1.maven.org/maven2/org/bytedeco/cpython/{0}/cpython-{0}-windows-x86_64.jar"
ARCHIVES = {
    "3.11": ("3.11.3-1.5.9", "3263a50b256447bb7b9e604d6587627e419891370fc33b94469e6a06ff4de834"),
    "3.14": ("3.14.3-1.5.13", "3291bf3d8f405335ac21dbe55780521fdfd295b0f9f43f7e6e8c55bedd709cb3"),
}
"""Version and SHA-256 of each archive."""
INSIDE = "org/bytedeco/cpython/windows-x86_64"


def windows_python(folder: Path, version: str) -> Path:
    """Return the path of python.exe, having unpacked it into a folder.

    Raises
    ------
    SystemExit
        The archive cannot be had, or is another one.
    """
    python = folder / f"python-{version}"
    program = python / INSIDE / "python.exe"
    if program.exists():
        return program
    release, expected = ARCHIVES[version]
    address = ADDRESS.format(release)
    try:
        with urllib.request.urlopen(address) as answer:
            content = answer.read()
    except OSError as error:
        raise SystemExit(f"{address} cannot be fetched: {error}") from None
    if hashlib.sha256(content).hexdigest() != expected:
        raise SystemExit(f"{address} is not the archive that was looked at: its SHA-256 is another")
    shutil.rmtree(python, ignore_errors=True)
    with zipfile.ZipFile(io.BytesIO(content)) as archive:
        archive.extractall(python)
    # Windows looks for libraries next to the program.
    for library in (python / INSIDE / "lib").glob("vcruntime140*.dll"):
        shutil.copy(library, program.parent)
    _write_stable_library(program.parent, f"python{version.replace('.', '')}")
    packages = python / INSIDE / "lib" / "site-packages"
    (packages / "wine_start.py").write_text(START, encoding="utf-8")
    (packages / "wine_start.pth").write_text("import wine_start\n", encoding="utf-8")
    return program


def _write_stable_library(folder: Path, own: str) -> None:
    """Write python3.dll, which the archive lacks: by it modules of the stable interface find what a version has."""
    listed = (folder / "libs" / "python3.lib").read_bytes()
    names = {each.decode("ascii") for each in re.findall(rb"(\w+)\0python3\.dll\0", listed)}
    definition, empty = folder / "python3.def", folder / "python3.c"
    lines = (f"{name}={own}.{name}\n" for name in sorted(names))
    definition.write_text(f"LIBRARY python3\nEXPORTS\n{''.join(lines)}", encoding="utf-8")
    empty.touch()
    compiler = [sys.executable, "-m", "ziglang", "cc", "-target", "x86_64-windows-gnu", "-shared"]
    subprocess.run([*compiler, "-o", str(folder / "python3.dll"), str(empty), str(definition)], check=True)
