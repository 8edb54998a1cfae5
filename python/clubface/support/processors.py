"""How many processors there are to use, and what of them may change the last bits of a result."""

from __future__ import annotations

import os
import platform
from functools import cache
from pathlib import Path


def processors() -> int:
    """Return how many processors this process may use, which a job of a cluster is told in this way."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not Linux
        return os.cpu_count() or 1


@cache
def vector_units() -> str:
    """Return the kind of processor, with the widest vectors that finite elements use on it, as in "x86_64 avx2"."""
    machine = platform.machine() or "unknown"
    flags: set[str] = set()
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("flags"):
                flags = set(line.partition(":")[2].split())
                break
    except OSError:
        return machine  # not Linux
    if {"avx512f", "avx512dq"} <= flags:
        return f"{machine} avx512"
    return f"{machine} avx2" if {"avx2", "fma"} <= flags else machine
