"""How much sooner threads of Python are done than one thread: single shots, flights, and impacts by finite elements.

``python benchmarks/threads.py 2`` computes everything on one thread and then, as many times in all, on two. With
Python's global lock, threads take turns wherever Python itself works, which is most of the time of a single shot.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import clubface
from clubface import fem
from clubface.fem.case import Case, case

REPEATS = 15
"""Measurements of each, of which the shortest counts."""
SHOT = {"speed": "105 mph", "loft": "13 deg", "toe": "8 mm"}


def coarse_case() -> Case:
    """Return Roh and Lee's drive with a ball of few elements, on one thread."""
    ball = fem.ball("paper")
    ball = replace(ball, cube=4, pieces=tuple(replace(piece, layers=1) for piece in ball.pieces))
    return case("paper-rigid").replace(ball=ball, settings={"threads": 1})


DRIVE = coarse_case()
LAUNCH = clubface.impact("driver", SHOT)
WORK: dict[str, tuple[int, Callable[[], object]]] = {
    "shots by response": (2000, lambda: clubface.impact("driver", SHOT)),
    "shots by rings": (400, lambda: clubface.impact("driver", SHOT, model="rings")),
    "flights": (2000, lambda: clubface.fly(LAUNCH)),
    "finite elements": (10, lambda: DRIVE.run()),
}
"""What is computed, and how often."""


def seconds(threads: int, count: int, compute: Callable[[], object]) -> float:
    """Return the time of computing something ``count`` times in all on some threads [s]."""

    def share(index: int) -> None:
        for _ in range(index, count, threads):
            compute()

    took = []
    with ThreadPoolExecutor(threads) as pool:
        for _ in range(REPEATS):
            began = time.perf_counter()
            list(pool.map(share, range(threads)))
            took.append(time.perf_counter() - began)
    return min(took)


if __name__ == "__main__":
    threads = int(sys.argv[1]) if len(sys.argv) > 1 else 2
    locked = getattr(sys, "_is_gil_enabled", lambda: True)()
    print(f"Python {sys.version.split()[0]}, {'with' if locked else 'without'} the global lock")
    print(f"{'':<20} {'1 thread':>10} {f'{threads} threads':>10} {'ratio':>6}")
    for name, (count, compute) in WORK.items():
        compute()
        alone, together = (1e3 * seconds(each, count, compute) / count for each in (1, threads))
        print(f"{name:<20} {alone:7.3f} ms {together:7.3f} ms {alone / together:6.2f}", flush=True)
