"""How much memory there is, so that a request too large for it is refused before anything is allocated."""

from __future__ import annotations

import os
from pathlib import Path

from clubface.errors import InputError

UNKNOWN = 4 * 2**30
"""Bytes assumed where the system does not say."""

SHARE = 0.5
"""Part of the free memory one request may take: tables made of the result need room as well."""

FAILED = 400
"""Bytes that say why one shot has no result: its row, the parameter at fault and a sentence."""
_SMALL = 64 * 2**20
"""Bytes nobody needs to ask for."""


def available_memory() -> int:
    """Return the bytes that can still be allocated, by the limits of system, container and process."""
    limits = [_of_system(), *_of_container()]
    return max(0, min(limits))


def check_request(shots: int, bytes_a_shot: int) -> None:
    """Refuse ``shots`` that would need more than ``SHARE`` of the free memory."""
    needed = shots * bytes_a_shot
    if needed <= _SMALL:
        return
    allowed = int(SHARE * available_memory())
    if needed > allowed:
        fit = allowed // bytes_a_shot
        raise InputError(
            "the number of shots",
            shots,
            f"at most {fit} with the memory free here ({needed / 1e9:.1f} GB needed): compute it in pieces, or from"
            " a file of any length with clubface.predict",
        )


def _of_system() -> int:
    try:
        for line in Path("/proc/meminfo").read_text().splitlines():
            if line.startswith("MemAvailable:"):
                return int(line.split()[1]) * 1024
    except (OSError, ValueError, IndexError):
        pass
    try:
        return os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") // 2
    except (AttributeError, OSError, ValueError):
        return UNKNOWN


def _of_container() -> list[int]:
    root = Path("/sys/fs/cgroup")
    found = []
    for limit, used in (
        (root / "memory.max", root / "memory.current"),
        (root / "memory" / "memory.limit_in_bytes", root / "memory" / "memory.usage_in_bytes"),
    ):
        try:
            found.append(int(limit.read_text()) - int(used.read_text()))
        except (OSError, ValueError):
            continue
    return found
