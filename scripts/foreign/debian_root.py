"""A folder with the system files of another machine: packages of Debian, fetched and unpacked, not installed."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

SETTINGS = """\
Dir "{folder}";
Dir::State::status "{folder}/status";
Dir::Etc::sourcelist "/etc/apt/sources.list";
Dir::Etc::sourceparts "/etc/apt/sources.list.d";
Dir::Etc::trustedparts "/etc/apt/trusted.gpg.d";
APT::Architecture "{processor}";
APT::Architectures {{ "{processor}"; }};
APT::Install-Recommends "false";
APT::Sandbox::User "";
Debug::NoLocking "true";
"""
"""apt looks for packages where the machine's own does, and keeps everything in a folder of its own."""
ALWAYS = ("libc6",)


def debian_root(folder: Path, processor: str, packages: tuple[str, ...]) -> Path:
    """Return a folder with packages for a processor, and what they depend on, unpacked.

    Raises
    ------
    SystemExit
        The tools of Debian are missing, or a package cannot be had.
    """
    wanted = sorted({*ALWAYS, *packages})
    root, unpacked = folder / "root", folder / "unpacked"
    if unpacked.is_file() and set(wanted) <= set(unpacked.read_text(encoding="utf-8").split()):
        return root
    for tool in ("apt-get", "dpkg-deb"):
        if shutil.which(tool) is None:
            raise SystemExit(f"there is no {tool}: files of another machine are taken from Debian's packages")
    apt = folder / "apt"
    for each in (
        "etc/apt/apt.conf.d",
        "etc/apt/preferences.d",
        "var/lib/apt/lists/partial",
        "var/cache/apt/archives/partial",
    ):
        (apt / each).mkdir(parents=True, exist_ok=True)
    (apt / "status").touch()
    settings = apt / "apt.conf"
    settings.write_text(SETTINGS.format(folder=apt, processor=processor), encoding="utf-8")
    environment = {**os.environ, "APT_CONFIG": str(settings), "DEBIAN_FRONTEND": "noninteractive"}
    # A source that has nothing for this processor is no reason to stop.
    subprocess.run(["apt-get", "update", "-qq"], env=environment, capture_output=True, check=False)
    command = ["apt-get", "install", "--download-only", "--yes", "-qq", *wanted]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"{' '.join(wanted)} for {processor} cannot be had from Debian: {done.stderr.strip()[-500:]}")
    for archive in sorted((apt / "var/cache/apt/archives").glob("*.deb")):
        subprocess.run(["dpkg-deb", "--extract", str(archive), str(root)], check=True)
    unpacked.write_text("\n".join(wanted), encoding="utf-8")
    return root
