"""Compare the core in WebAssembly, run by Node, with the installed package: shots, flights, finite elements."""

from __future__ import annotations

import json
import math
import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np

import clubface
from clubface import _core
from clubface.design.feasibility import Envelope, Margin, of_club, pseudo_inertia, usual_space
from clubface.design.strokes import AT_REST, as_lists
from clubface.fem.run import case
from clubface.simulation.shot_shape import shot_shape

SHOTS = 300
LARGEST = 400e3
"""Bytes that the module without finite elements may have, compressed as browsers ask for it: a first visitor waits for
them."""
COUNT = 4096
CHOSEN = {"outputs": [0, 4], "variables": [1, 6]}
"""Places of outputs and variables that are differentiated for all shots."""
TOLERANCES = {"rings": 1e-12, "response": 1e-12, "flight": 1e-12}
"""Largest relative difference of an output of a model, or of a derivative; 0 means the same bits.

Every operation and elementary function is one algorithm on both sides, but for logarithms and powers, which come from
the C library of the machine and may differ in the last bit: those of the rings, of the response and of the ground.
"""
ADDED_UP = 1e-9
"""The same of the last moments of paths and histories, and of statistics of shots.

They add up what a thousand steps or shots differ by, each as much as one output may.
"""
SIMULATION = 1e-6
"""The same of the finite elements.

A CPU may fuse products and sums, WebAssembly does not, and an impact multiplies rounding.
"""


def _deliveries() -> list[list[float]]:
    """Return columns of shots with the driver and the default ball, some of which cannot be computed."""
    random = np.random.default_rng(1)
    driver = clubface.impact("driver", speed=45.0)
    ranges = {
        "speed": (35.0, 55.0), "attack": (-0.1, 0.12), "path": (-0.14, 0.14), "loft": (0.1, 0.35),
        "face": (-0.14, 0.14), "lie": (-0.14, 0.14), "toe": (-0.025, 0.025), "high": (-0.012, 0.012),
        "closure": (-10.0, 60.0), "pitch_rate": (-20.0, 20.0), "lie_rate": (-20.0, 20.0),
        "ball_backspin": (-100.0, 100.0), "ball_sidespin": (-100.0, 100.0), "ball_riflespin": (-100.0, 100.0),
    }  # fmt: skip
    columns: list[list[float]] = []
    for entry in _core.inputs():
        name = entry["name"]
        if name in ranges:
            values = random.uniform(*ranges[name], SHOTS)
        elif name == "hand":
            values = np.where(random.uniform(size=SHOTS) < 0.5, 1.0, -1.0)
        else:
            values = np.full(SHOTS, driver.input(name))
        if name == "toe":
            values[17] = 0.2
        columns.append(values.tolist())
    return columns


def _launches_in_air(outputs: np.ndarray) -> list[list[float]]:
    """Return columns of flights from the launches of a model."""
    names = [entry["name"] for entry in _core.outputs()]
    good = ~np.isnan(outputs[0])
    columns = []
    for entry in _core.flight_inputs():
        if entry["name"] in names:
            columns.append(outputs[names.index(entry["name"])][good].tolist())
        else:
            columns.append(np.full(int(good.sum()), entry["default"]).tolist())
    return columns


def _shapes(launches: np.ndarray, flights: np.ndarray) -> list[str]:
    """Return the names of the shapes of shots from launches of a model and the flights of those that have a result."""
    outputs, flown = ([each["name"] for each in variables] for variables in (_core.outputs(), _core.flight_outputs()))
    good = ~np.isnan(launches[0])
    azimuth = launches[outputs.index("azimuth")][good]
    return list(shot_shape(azimuth, *(np.asarray(flights)[flown.index(name)] for name in ("curve", "carry"))))


def _dispersion(models: dict[str, list[float]]) -> tuple[dict[str, Any], clubface.Dispersion]:
    """Return the description of shots of a golfer on a hole, and where they go by the package."""
    hole = clubface.Hole(length="430 yd")
    done = clubface.dispersion("handicap-10-driver", count=COUNT, hole=hole, seed=3)
    player, launch = done.golfer, done.mean_launch
    described = {
        "model": done.model,
        "parameters": models[done.model],
        "inputs": [float(launch.input(entry["name"])) for entry in _core.inputs()],
        "flight": [
            float(launch.input(entry["name"])) if entry["group"] == "ball" else float(np.nan_to_num(entry["default"]))
            for entry in _core.flight_inputs()
        ],
        "golfer": {
            "variables": player.variables, "mean": player.mean.tolist(), "covariance": player.covariance.tolist(),
            "mishit_share": player.mishit_share, "mishit_scale": player.mishit_scale,
        },
        "hole": {
            "length": hole.length, "fairway": hole.fairway, "rough": hole.rough, "green": hole.green,
            "tables": [dict(zip(("distance", "strokes"), as_lists(lie), strict=True)) for lie in AT_REST],
        },
        "seed": 3, "percentiles": [0.1, 0.5], "ellipses": [0.9],
    }  # fmt: skip
    return described, done


def _heads() -> tuple[dict[str, Any], np.ndarray, list[list[Margin]]]:
    """Return the space of a driver, mass properties of heads as columns, and all their margins by the package."""
    driver = clubface.club("driver")
    space, own = usual_space(driver), of_club(driver)
    values = np.repeat(own[:, None], 1 + own.size, axis=1)
    values[range(own.size), range(1, 1 + own.size)] *= 1.2
    shell = pseudo_inertia(own) * (1.0 - space.free / driver.mass)
    margins = []
    for column in values.T:
        envelope = Envelope(volume=space.volume, shell=shell, budget=max(column[0] - driver.mass + space.free, 1e-6))
        margins.append(envelope.margins(pseudo_inertia(column))[:-1])  # the budget is all that the shell leaves
    shape, centre, size = space.volume.space
    described = {"shape": shape, "centre": centre, "size": size, "head": own.tolist(), "free": space.free}
    return described, values, margins


def _difference(here: np.ndarray, there: np.ndarray) -> float:
    """Return the largest relative difference of outputs, infinite where one is missing."""
    if (np.isnan(here) != np.isnan(there)).any():
        return math.inf
    here, there = np.nan_to_num(here), np.nan_to_num(there)
    scale = np.abs(here).max(axis=1, keepdims=True)
    return float((np.abs(here - there) / np.where(scale > 0.0, scale, 1.0)).max())


def _largest(pairs: Iterable[tuple[float, float]]) -> float:
    """Return the largest relative difference of pairs of numbers."""
    return max(abs(here - there) / (abs(here) or 1.0) for here, there in pairs)


def _as_json(value: Any) -> Any:
    """Return a description as JSON has it: no tuples, and null for what is not finite."""
    if isinstance(value, dict):
        return {key: _as_json(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_as_json(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def _array(columns: list[list[float | None]]) -> np.ndarray:
    return np.array([[math.nan if value is None else value for value in column] for column in columns])


class Report:
    """Lines printed, and whether all was well."""

    def __init__(self) -> None:
        self.failed = False

    def line(self, what: str, good: bool, text: str) -> None:
        """Print one line."""
        self.failed |= not good
        print(f"{'ok  ' if good else 'FAIL'} {what:<22} {text}")


def main(module: str, fem: str) -> int:
    """Compare the module, and the one that has the finite elements, too; return the exit status."""
    names = (
        "quantities", "units", "dimensions", "models", "inputs", "outputs", "flight_inputs", "flight_outputs",
        "shot_shapes",
    )  # fmt: skip
    description = _as_json({name: getattr(_core, name)() for name in names})
    models = {entry["name"]: [p["default"] for p in entry["parameters"]] for entry in _core.models()}
    inputs = _deliveries()
    native = {
        name: _core.impact(name, [np.array(c) for c in inputs], parameters, SHOTS)
        for name, parameters in models.items()
    }
    flights = _launches_in_air(native["standard"][0])
    flown = _core.fly([np.array(column) for column in flights], len(flights[0]))
    thrown = clubface.fem.reference()
    described = case(thrown.ball, {"plane": thrown.given}, thrown.friction, thrown.settings)

    golfer_shots, dispersed = _dispersion(models)
    space, heads, margins = _heads()
    asked = {
        "module": module, "fem": fem, "inputs": inputs, "models": models, "chosen": CHOSEN, "flights": flights,
        "case": described, "dispersion": golfer_shots, "count": COUNT,
        "space": space, "heads": heads.tolist(),
    }  # fmt: skip
    script = Path(__file__).with_name("wasm_check.mjs")
    ran = subprocess.run(["node", script], input=json.dumps(asked), capture_output=True, text=True, check=False)
    if ran.returncode != 0:
        print(ran.stderr, file=sys.stderr)
        return 1
    answer = json.loads(ran.stdout)

    report = Report()
    report.line("description", answer["description"] == description, f"{len(models)} models")
    for name, (outputs, rejects) in native.items():
        there = answer["launches"][name]
        difference = _difference(np.asarray(outputs), _array(there["outputs"]))
        same = [[r["row"], r["input"], r["message"]] for r in there["rejects"]] == [list(r) for r in rejects]
        values, jacobian = _core.sensitivity(name, [column[0] for column in inputs], models[name])
        by = answer["derivatives"][name]
        some, _ = _core.sensitivities(
            name, [np.array(c) for c in inputs], models[name], SHOTS, CHOSEN["outputs"], CHOSEN["variables"]
        )
        exact = [
            _difference(values[:, None], _array([by[0]]).T),
            _difference(jacobian, _array(by[1])),
            _difference(np.asarray(some), _array(answer["chosen"][name])),
        ]
        difference = max(difference, *exact)
        text = f"largest difference {difference:.1e}, {there['seconds'] / SHOTS * 1e9:.0f} ns a shot"
        report.line(name, same and difference <= TOLERANCES.get(name, 0.0), text)
    difference = _difference(np.asarray(flown[0]), _array(answer["flights"]["outputs"]))
    values, jacobian = _core.fly_sensitivity([column[0] for column in flights])
    by = answer["flight_derivatives"]
    exact = [_difference(values[:, None], _array([by[0]]).T), _difference(jacobian, _array(by[1]))]
    difference = max(difference, *exact)
    seconds = answer["flights"]["seconds"] / len(flights[0])
    good = difference <= TOLERANCES["flight"]
    report.line("flight", good, f"largest difference {difference:.1e}, {seconds * 1e6:.1f} us a flight")
    shapes = _shapes(native["standard"][0], flown[0])
    good = answer["shapes"] == shapes and len(set(shapes)) > 5
    report.line("shapes", good, f"{len(shapes)} shots, {len(set(shapes))} names")
    first = [column[0] for column in inputs]
    paths = {
        "path": _core.trajectory([column[0] for column in flights]),
        "history": _core.history("rings", first, models["rings"]),
    }
    for name, arrays in paths.items():
        there = answer[name]
        shapes = {key: list(array.shape) for key, array in arrays.items()}
        ends = [(array.flat[-1], there[key]["values"][-1]) for key, array in arrays.items()]
        difference = _largest(ends)
        good = shapes == {key: array["shape"] for key, array in there.items()} and difference <= ADDED_UP
        report.line(name, good, f"{len(arrays)} arrays, largest difference {difference:.1e}")
    there = answer["dispersion"]
    quantities, (ellipse,) = there["quantities"], there["ellipses"]
    pairs = [
        (getattr(dispersed, kind)(name), quantities[name][kind])
        for name in ("ball_speed", "backspin", "carry", "side", "total") for kind in ("mean", "spread")
    ] + [
        (dispersed.quantile("carry", 0.1), quantities["carry"]["percentiles"][0]), (dispersed.lost, there["lost"]),
        (dispersed.strokes, there["strokes"]), (dispersed.lies["rough"], there["lies"]["rough"]),
        (dispersed.ellipse(0.9).half_axes[0], ellipse["half_axes"][0]), (dispersed.points[2, 1], there["landings"][5]),
    ]  # fmt: skip
    difference = _largest(pairs)
    report.line("dispersion", difference <= ADDED_UP, f"{COUNT} shots, largest difference {difference:.1e}")
    there = answer["buildable"]
    least = [min(each.value for each in head) for head in margins]
    pairs = [*zip(least, there["least"], strict=True)]
    pairs += [(each.value, other["value"]) for each, other in zip(margins[0], there["margins"], strict=True)]
    good = [each.name for each in margins[0]] == [each["name"] for each in there["margins"]]
    difference = _largest(pairs)
    report.line("heads", good and difference <= ADDED_UP, f"{len(least)} heads, largest difference {difference:.1e}")
    refusals = answer["refusals"]
    expected = ("no such model", "accuracy", "clubface-fem.wasm")
    good = all(word in refusal for word, refusal in zip(expected, refusals, strict=True))
    report.line("refusals", good, "; ".join(refusals))

    reference = answer["reference"]
    pairs = {
        "normal velocity": (thrown.normal_velocity, reference["ball_velocity"][0], "m/s"),
        "tangential velocity": (thrown.tangential_velocity, reference["ball_velocity"][1], "m/s"),
        "backspin": (thrown.backspin, reference["ball_spin"][2], "rad/s"),
        "peak force": (thrown.peak_force, reference["peak_force"], "N"),
        "contact time": (thrown.contact_time, reference["contact_time"], "s"),
    }
    for name, (here, there, unit) in pairs.items():
        difference = abs(there / here - 1.0)
        report.line(name, difference <= SIMULATION, f"{here:.10g} {unit}, difference {difference:.1e}")
    each = reference["wall"] * 1e9 / (thrown.ball.properties()["elements"] * reference["steps"])
    speed = f"{each:.1f} ns an element and step, {reference['steps']} steps in {reference['wall']:.2f} s"
    report.line("finite elements", reference["steps"] == thrown.steps, speed)
    interrupted = "by request" in (answer["stopped"] or "")
    report.line("progress", answer["seen"] > 100 and interrupted, f"{answer['seen']} calls; {answer['stopped']}")
    for name, (size, compressed) in zip(("size", "size with fem"), answer["sizes"], strict=True):
        good = name != "size" or compressed <= LARGEST
        report.line(name, good, f"{size / 1e3:.0f} kB, {compressed / 1e3:.0f} kB compressed by brotli")
    return int(report.failed)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
