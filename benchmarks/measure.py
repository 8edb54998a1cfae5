"""What everything costs: the figures of docs/benchmarks.md, measured on this machine.

``python benchmarks/measure.py`` takes some four minutes of two cores; names of sections, such as ``elements models``,
measure theirs alone. A time is the shortest of several on the clock, next to the result that it computed. Each section
of docs/benchmarks.json says on which machine, when and with which sources it was measured, and how many other processes
ran then: on a machine that does other work, times are too long. ``benchmarks/lulesh.py`` adds a section of its own.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import subprocess
import sys
import tempfile
import time
import warnings
from collections.abc import Callable
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np

import clubface
from clubface import _core, fem, studies
from clubface.errors import RangeWarning
from clubface.fem.paper import meshes
from clubface.fem.run import case
from clubface.validation import benchmark_data

sys.path.append(str(Path(__file__).parent.parent / "docs"))
from run import commit

ROOT = Path(__file__).parent.parent
STORED = ROOT / "docs" / "benchmarks.json"
DRIVE = {"speed": 48.0, "attack": 0.03, "path": 0.02, "loft": 0.22, "face": -0.01, "toe": 0.008, "high": 0.004}
THREADS = (1, 2)
LEAST_RUNS, LONGEST = 3, 1.0
"""Runs of each entry at least, and time [s] after which there are no more."""
BATCHES = {"impulse": 200_000, "contact": 4_000}
"""Shots in a batch by the kind of the model, which take some tenths of a second."""
FLIGHTS = 50_000
DRIVES = 1_000_000
FEM_DRIVES = """
[study]
[impact]
club = "driver"
model = "fem"
[sweep]
speed = { from = "95 mph", to = "115 mph", count = 8 }
loft = { from = "9 deg", to = "16 deg", count = 8 }
"""
"""The study that was also measured on sixteen cores."""


def shortest(run: Callable[[], Any]) -> tuple[float, Any]:
    """Return the shortest time of several runs [s], and the result of the first, which is not timed."""
    result = run()
    times: list[float] = []
    while len(times) < LEAST_RUNS or sum(times) < LONGEST:
        begun = time.perf_counter()
        run()
        times.append(time.perf_counter() - begun)
    return min(times), result


def batch(count: int) -> dict[str, Any]:
    """Return deliveries about the drive."""
    spread = np.linspace(0.95, 1.05, count)
    return {**DRIVE, "speed": DRIVE["speed"] * spread, "loft": DRIVE["loft"] * spread[::-1]}


def measure_models() -> dict[str, Any]:
    """Return the cost of a shot by each model: one call, in a batch on one thread, and with its derivatives [s]."""
    rows: dict[str, Any] = {}
    for each in _core.models():
        name, deliveries = each["name"], batch(BATCHES[each["kind"]])
        one, launch = shortest(lambda name=name: clubface.impact("driver", DRIVE, model=name))
        many, _ = shortest(
            lambda name=name, deliveries=deliveries: clubface.impact("driver", deliveries, model=name, threads=1)
        )
        exact, _ = shortest(lambda name=name: clubface.sensitivity("driver", DRIVE, model=name))
        rows[name] = {
            "call": one, "shot": many / len(deliveries["speed"]), "derivatives": exact,
            "ball_speed": float(launch.ball_speed), "backspin": float(launch.backspin),
        }  # fmt: skip
    one, launch = shortest(lambda: clubface.impact("driver", DRIVE, model="fem", threads=1))
    rows["fem"] = {"call": one, "ball_speed": float(launch.ball_speed), "backspin": float(launch.backspin)}
    return rows


def measure_flights() -> dict[str, Any]:
    """Return the cost of a flight on one thread, and of a million drives with their flights on some [s]."""
    launches = clubface.impact("driver", batch(FLIGHTS))
    many, flight = shortest(lambda: clubface.fly(launches, threads=1))
    drives = batch(DRIVES)

    def fly(threads: int) -> Any:
        return clubface.fly(clubface.impact("driver", drives, threads=threads), threads=threads)

    return {
        "flight": many / FLIGHTS,
        "carry": float(flight.carry.mean()),
        "drives": {str(threads): shortest(lambda threads=threads: fly(threads))[0] for threads in THREADS},
    }


def measure_elements() -> dict[str, Any]:
    """Return the cost of runs by finite elements: the reference case on two meshes, heads, derivatives."""
    reference = fem.ball("reference")
    rows = []
    for ball in meshes(reference, (3, 6)):
        for threads in THREADS:
            settings = fem.Settings(threads=threads)
            runs = [
                fem.throw(ball, speed="35 m/s", angle="11.5 deg", friction=0.35, settings=settings)
                for _ in range(LEAST_RUNS)
            ]
            run = min(runs, key=lambda each: each.wall)
            rows.append({
                "elements": run.elements, "threads": threads, "steps": run.steps, "wall": run.wall,
                "backspin": run.backspin, "peak_force": run.peak_force,
            })  # fmt: skip
    strike = {"speed": "105 mph", "ball": "modern", "friction": 0.35}
    heads = {}
    for name, head in (("rigid", "driver"), ("shells", fem.head("paper"))):
        wall, run = shortest(lambda head=head: fem.strike(head, **strike))
        heads[name] = {"wall": wall, "ball_speed": float(run.launch.ball_speed)}
    wall, _ = shortest(lambda: fem.sensitivity("driver", by=("speed", "loft", "toe", "high"), **strike))
    return {"reference": rows, "heads": heads, "derivatives": wall}


def measure_identification() -> dict[str, Any]:
    """Return the cost of the published search, 200 by 100 sets of parameters on 550 drives and five refinements."""
    shots = benchmark_data.load("driver").measured
    rows = {}
    for model in ("standard", "slip"):
        begun, processor = time.perf_counter(), time.process_time()
        fit = clubface.identify(shots, club="driver-as-printed", model=model, folds=0, bootstrap=0, profiles=())
        rows[model] = {
            "wall": time.perf_counter() - begun, "processor": time.process_time() - processor,
            "impacts": fit.impacts, "cost": fit.cost,
        }  # fmt: skip
    return rows


def measure_studies() -> dict[str, Any]:
    """Return the time of a study of 64 drives by finite elements, by its workers [s]."""
    times = {}
    with tempfile.TemporaryDirectory() as folder:
        for workers in THREADS:
            path = Path(folder) / f"drives-{workers}.toml"
            path.write_text(FEM_DRIVES)
            begun = time.perf_counter()
            studies.run(path, workers=workers)
            times[str(workers)] = time.perf_counter() - begun
    return times


def measure_processes() -> dict[str, Any]:
    """Return the time of fresh processes [s]."""
    every = {
        "import clubface": [sys.executable, "-c", "import clubface"],
        "clubface shot driver": [sys.executable, "-m", "clubface", "shot", "driver", "--speed", "113 mph"],
    }
    run = {name: lambda words=words: subprocess.run(words, check=True, capture_output=True) for name, words in
           every.items()}  # fmt: skip
    return {name: shortest(each)[0] for name, each in run.items()}


def measure_browser() -> dict[str, Any] | None:
    """Return the cost of the core in WebAssembly, run by Node on Chromium's engine; None where it is not built."""
    modules = [ROOT / "studio" / "generated" / name for name in ("clubface.wasm", "clubface-fem.wasm")]
    if not all(each.is_file() for each in modules):
        return None
    count = 10_000
    launch = clubface.impact("driver", batch(count))
    thrown = fem.reference()
    asked = {
        "modules": [str(each) for each in modules],
        "inputs": [np.broadcast_to(launch.input(each["name"]), count).tolist() for each in _core.inputs()],
        "models": {each["name"]: [p["default"] for p in each["parameters"]] for each in _core.models()},
        "shots": {each["name"]: BATCHES[each["kind"]] // 20 for each in _core.models()},
        "case": case(thrown.ball, {"plane": thrown.given}, thrown.friction, thrown.settings),
    }
    script = Path(__file__).with_name("browser.mjs")
    done = subprocess.run(["node", script], input=json.dumps(asked), capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


SECTIONS: dict[str, Callable[[], dict[str, Any] | None]] = {
    "models": measure_models,
    "flights": measure_flights,
    "elements": measure_elements,
    "studies": measure_studies,
    "processes": measure_processes,
    "browser": measure_browser,
    "identification": measure_identification,
}


def machine() -> dict[str, Any]:
    """Return what a time depends on: the machine, its load by others, the day and the sources."""
    processor = platform.processor() or platform.machine()
    description = Path("/proc/cpuinfo")
    if description.is_file():
        names = [
            line.partition(":")[2].strip() for line in description.read_text().splitlines() if "model name" in line
        ]
        processor = names[0] if names else processor
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
    load = round(os.getloadavg()[0], 1) if hasattr(os, "getloadavg") else None
    return {
        "processor": processor, "cores": cores, "system": platform.system(), "date": date.today().isoformat(),
        "commit": commit(), "load": load,
    }  # fmt: skip


def rounded(value: Any) -> Any:
    """Return measured values with four digits."""
    if isinstance(value, dict):
        return {key: rounded(each) for key, each in value.items()}
    if isinstance(value, list):
        return [rounded(each) for each in value]
    return float(f"{value:.4g}") if isinstance(value, float) else value


def store(section: str, measured: dict[str, Any], on: dict[str, Any]) -> None:
    """Put a section into the file, and leave the others."""
    document = json.loads(STORED.read_text(encoding="utf-8")) if STORED.is_file() else {}
    document[section] = {"measured": on, **rounded(measured)}
    STORED.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")
    print(section, json.dumps(document[section], indent=1), flush=True)


def main() -> None:
    """Measure some sections, or all."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("sections", nargs="*", metavar="SECTION", help=", ".join(SECTIONS))
    chosen = parser.parse_args().sections or list(SECTIONS)
    unknown = [each for each in chosen if each not in SECTIONS]
    if unknown:
        parser.error(f"{unknown[0]} is no section; there are {', '.join(SECTIONS)}")
    warnings.simplefilter("ignore", RangeWarning)  # of models that are only timed
    for each in chosen:
        on = machine()
        measured = SECTIONS[each]()
        if measured is None:
            print(f"{each}: left out, for want of studio/generated, which make studio-build makes", file=sys.stderr)
        else:
            store(each, measured, on)


if __name__ == "__main__":
    main()
