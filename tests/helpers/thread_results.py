"""Compute many things on several threads at once, and then again on one; print as JSON what differs.

Run as a program, since nothing is computed or imported before: all threads come upon empty caches and registries
together. ``python thread_results.py 4 2`` starts four threads, each of which computes everything twice, in another
order.
"""

from __future__ import annotations

import hashlib
import json
import sys
import tempfile
import threading
import warnings
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

import clubface

HERE = Path(__file__).parent
SHOT = {"speed": "105 mph", "attack": "3 deg", "loft": "13 deg", "face": "1 deg", "toe": "12 mm", "high": "-6 mm"}
ROWS = 3000
"""Several chunks, which go to the threads that all batches share."""
ONE_AT_A_TIME = threading.Lock()


def values(result: Any) -> Any:
    """Return what was computed as arrays: of a launch or a flight all quantities."""
    return [np.asarray(getattr(result, name)) for name in result.quantities()]


def shots() -> Any:
    """Return a shot by each model."""
    return [values(each) for each in clubface.impact("driver", **SHOT, model="all").values()]


def batch() -> Any:
    """Return a batch of launches and their flights."""
    shot = clubface.impact("7-iron", speed=np.linspace(35.0, 45.0, ROWS), toe=np.linspace(-0.02, 0.02, ROWS))
    return values(shot), values(clubface.fly(shot))


def derivatives() -> Any:
    """Return derivatives of a launch."""
    return clubface.sensitivity("driver", **SHOT, model="rings").si


def history() -> Any:
    """Return the forces of a contact over time, and the path of a flight."""
    track = clubface.trajectory(clubface.impact("driver", **SHOT))
    contact = clubface.history("driver", **SHOT, model="volumetric")
    return contact.time, contact.normal_force, track.position


def own_law() -> Any:
    """Return a launch by a law of contact that each thread registers under a name of its own."""
    name = f"law_{threading.get_ident()}"

    def law(touch: Any, given: Any) -> Any:
        return max(given["stiffness"] * touch.depth**1.5, 0.0), -50.0 * touch.sliding_y, -50.0 * touch.sliding_z

    clubface.register_law(name, law, parameters={"stiffness": 2e7})
    return values(clubface.impact("driver", **SHOT, model=name))


@cache
def shared_contact() -> Any:
    """Return a contact, and a head and a ball that touch."""
    from clubface.simulation.multibody import BallMotion

    motion = BallMotion(np.zeros(3))
    head = clubface.Delivery(**SHOT).pose("driver", ball_position=np.zeros(3))
    inner = head._replace(position=np.asarray(head.position) + np.array([1e-4, 0.0, 0.0]))
    return clubface.SteppedContact(head, motion, club="driver"), inner, motion


def stepped() -> Any:
    """Return the forces of one contact that all threads share, again and again."""
    with ONE_AT_A_TIME:
        contact, head, motion = shared_contact()
    results = []
    for _ in range(200):
        wrench, rates = contact.evaluate(head, motion, contact.initial)
        results.append([np.asarray(each) for each in (wrench.force, wrench.head_torque, rates)])
    return results, contact.names


def elements() -> Any:
    """Return an impact by finite elements on a coarse ball, on two threads of its own."""
    from clubface import fem
    from clubface.fem.case import case

    ball = fem.ball("paper")
    ball = replace(ball, cube=2, pieces=tuple(replace(piece, layers=1) for piece in ball.pieces))
    done = case("paper-rigid").replace(ball=ball, settings={"threads": 2}).run()
    return done.peak_force, done.contact_time, values(done.launch)


def spread() -> Any:
    """Return the statistics of a golfer's shots."""
    shots = clubface.dispersion("bogey-driver", count=256, seed=1)
    return shots.mean("carry"), shots.spread("carry")


def read() -> Any:
    """Return the shots of files of several forms."""
    names = ("flightscope", "foresight-2020", "garmin-de", "garmin-en")
    files = [HERE.parent / "data" / "launch_monitors" / f"{name}.csv" for name in names]
    return [sorted(clubface.read_shots(each).launches.items()) for each in files]


def workbooks(folder: Path) -> Callable[[], Any]:
    """Return what reads a workbook."""
    from openpyxl import Workbook

    book = Workbook()
    sheet: Any = book.active
    for row in (
        ["Club Speed (mph)", "Ball Speed (mph)", "Launch Angle (deg)"],
        *([90 + i, 130 + i, 12] for i in range(9)),
    ):
        sheet.append(row)
    book.save(folder / "shots.xlsx")
    return lambda: sorted(clubface.read_shots(folder / "shots.xlsx").launches.items())


def club() -> Any:
    """Return a club that is read from its file, and changed."""
    made = clubface.Club.from_toml(Path(clubface.__file__).parent / "data" / "clubs" / "driver.toml")
    return sorted(made.replace(mass="205 g").inputs().items())


def digest(result: Any) -> str:
    """Return a fingerprint of every bit of a result."""
    if isinstance(result, np.ndarray):
        return hashlib.sha256(f"{result.dtype}{result.shape}".encode() + result.tobytes()).hexdigest()
    if isinstance(result, (list, tuple)):
        return hashlib.sha256("".join(map(digest, result)).encode()).hexdigest()
    return hashlib.sha256(repr(result).encode()).hexdigest()


def main(threads: int, rounds: int) -> dict[str, Any]:
    """Return what differs, what was raised, and how often each warning was given."""
    sys.setswitchinterval(1e-5)  # an interpreter with its lock changes threads often too
    given: list[str] = []
    warnings.simplefilter("always")
    warnings.showwarning = lambda message, *_, **__: given.append(str(message))
    named: dict[str, Callable[[], Any]] = {
        each.__name__: each
        for each in (shots, batch, derivatives, history, own_law, elements, spread, read, club, stepped)
    }
    folder = tempfile.TemporaryDirectory()
    if find_spec("openpyxl"):
        named["workbooks"] = workbooks(Path(folder.name))
    names = list(named)
    start, lock = threading.Barrier(threads), threading.Lock()
    digests: dict[str, list[str]] = {name: [] for name in names}
    raised: list[str] = []

    def work(first: int) -> None:
        start.wait()
        for turn in range(rounds * len(names)):
            name = names[(first + turn) % len(names)]
            try:
                result = digest(named[name]())
            except Exception as error:
                result, _ = "", raised.append(f"{name}: {error!r}")
            with lock:
                digests[name].append(result)

    # Two and two begin with the same computation, so that they meet in the same caches.
    workers = [threading.Thread(target=work, args=(index // 2 * 3,)) for index in range(threads)]
    for each in workers:
        each.start()
    for each in workers:
        each.join()
    alone = {name: digest(compute()) for name, compute in named.items()}
    folder.cleanup()
    return {
        "different": [name for name in names if set(digests[name]) != {alone[name]}],
        "computed": {name: len(digests[name]) for name in names},
        "raised": raised,
        "warned": {message: given.count(message) for message in given},
        "locked": getattr(sys, "_is_gil_enabled", lambda: True)(),
    }


if __name__ == "__main__":
    print(json.dumps(main(*map(int, sys.argv[1:])), indent=1))
