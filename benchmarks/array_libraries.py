"""What a launch, its derivatives and the gradient of a carry cost in NumPy, JAX and PyTorch.

``python benchmarks/array_libraries.py [FILE]`` prints, in two minutes, the shortest of several times on the clock
and the result of each computation, which must agree from row to row, and puts both into FILE; the page
docs/plug-into-jax.md reads docs/array-libraries.json. A library that is not installed is left out, and keeps its
entries in the file. On a machine that does other work, the times are too long.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable, Iterable
from importlib.util import find_spec
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import clubface

DRIVE = {"speed": 48.0, "attack": 0.03, "path": 0.02, "loft": 0.22, "face": -0.01, "lie": 0.03, "toe": 0.008,
         "high": 0.004, "closure": 40.0}  # fmt: skip
LOFT = list(DRIVE).index("loft")
ONE = np.array(list(DRIVE.values()))
THOUSAND = ONE * np.linspace(0.98, 1.02, 1000)[:, None]
MODELS = ("response", "volumetric")
LEAST_RUNS, LONGEST = 5, 0.5
"""Runs of each entry at least, and time [s] after which there are no more."""

Calls = dict[str, Callable[[np.ndarray], Any]]
WORK = ("ball speed", "spin by loft", "carry by loft")
"""What is computed [m/s, 1/s, m/rad]: a launch; all its outputs by nine variables; a carry, by the same."""


class Cost(NamedTuple):
    """The time of some work and what came of it.

    Attributes
    ----------
    interface, work
        Their names.
    shots
        How many.
    seconds
        [s].
    result
        Mean over the shots, SI.
    """

    interface: str
    work: str
    shots: int
    seconds: float
    result: float


def numpy_calls(model: str) -> Calls:
    """Return the work in NumPy, without the gradient of a carry, for which there is no one call."""

    def named(rows: np.ndarray) -> dict[str, Any]:
        return dict(zip(DRIVE, rows.T, strict=True))

    def slope(rows: np.ndarray) -> Any:
        return clubface.sensitivity("driver", named(rows), model=model, variables=list(DRIVE)).value("backspin", "loft")

    return {WORK[0]: lambda rows: clubface.impact("driver", named(rows), model=model).ball_speed, WORK[1]: slope}


def jax_calls(model: str, *, compiled: bool) -> Calls:
    """Return the work in JAX."""
    import jax

    import clubface.jax

    jax.config.update("jax_enable_x64", True)
    wrap: Any = jax.jit if compiled else lambda function: function

    def launch(row: Any) -> Any:
        return clubface.jax.impact("driver", dict(zip(DRIVE, row, strict=True)), model=model)

    def carry(row: Any) -> Any:
        return clubface.jax.fly(launch(row), outputs=["carry"])["carry"]

    def mapped(function: Any) -> Callable[[np.ndarray], Any]:
        one, many = wrap(function), wrap(jax.vmap(function))
        return lambda rows: jax.tree.map(np.asarray, (one if rows.ndim == 1 else many)(jax.numpy.asarray(rows)))

    speeds, jacobians, gradients = mapped(launch), mapped(jax.jacrev(launch)), mapped(jax.grad(carry))
    return {
        WORK[0]: lambda rows: speeds(rows)["ball_speed"],
        WORK[1]: lambda rows: jacobians(rows)["backspin"][..., LOFT],
        WORK[2]: lambda rows: gradients(rows)[..., LOFT],
    }


def torch_calls(model: str) -> Calls:
    """Return the work in PyTorch."""
    import torch  # pyright: ignore[reportMissingImports]
    from torch.func import grad, jacrev, vmap  # pyright: ignore[reportMissingImports]

    import clubface.torch

    def launch(row: Any) -> Any:
        return clubface.torch.impact("driver", dict(zip(DRIVE, row.unbind(-1), strict=True)), model=model)

    def carry(row: Any) -> Any:
        return clubface.torch.fly(launch(row), outputs=["carry"])["carry"]

    def mapped(function: Any) -> Callable[[np.ndarray], Any]:
        return lambda rows: (function if rows.ndim == 1 else vmap(function))(torch.as_tensor(rows))

    jacobians, gradients = mapped(jacrev(launch)), mapped(grad(carry))
    return {
        WORK[0]: lambda rows: launch(torch.as_tensor(rows))["ball_speed"].numpy(),
        WORK[1]: lambda rows: jacobians(rows)["backspin"][..., LOFT].numpy(),
        WORK[2]: lambda rows: gradients(rows)[..., LOFT].numpy(),
    }


def costs(model: str) -> list[Cost]:
    """Return the cost of all work in every library that is installed."""
    interfaces = {"NumPy": numpy_calls(model)}
    if find_spec("jax"):
        interfaces |= {"JAX": jax_calls(model, compiled=False), "JAX, compiled": jax_calls(model, compiled=True)}
    if find_spec("torch"):
        interfaces["PyTorch"] = torch_calls(model)
    return [
        cost(interface, work, call, rows)
        for interface, calls in interfaces.items()
        for work, call in calls.items()
        for rows in (ONE, THOUSAND)
    ]


def cost(interface: str, work: str, call: Callable[[np.ndarray], Any], rows: np.ndarray) -> Cost:
    """Return the shortest time of a call, after one that compiles."""
    result = call(rows)
    times: list[float] = []
    while len(times) < LEAST_RUNS or sum(times) < LONGEST:
        start = time.perf_counter()
        call(rows)
        times.append(time.perf_counter() - start)
    return Cost(interface, work, 1 if rows.ndim == 1 else len(rows), min(times), float(np.mean(result)))


def tabulate(costs_of: Callable[[str], Iterable[Cost]], file: str | None) -> None:
    """Print what everything costs with each model, and put it into a file."""
    path = Path(file) if file else None
    content = json.loads(path.read_text()) if path is not None and path.exists() else {}
    for model in MODELS:
        print(f"{model:14} {'':14} {'shots':>5} {'ms':>9} {'result':>12}")
        for each in costs_of(model):
            print(f"{each.interface:14} {each.work:14} {each.shots:5} {each.seconds * 1e3:9.4f} {each.result:12.6f}")
            entry = {"ms": float(f"{each.seconds * 1e3:.3g}"), "result": round(each.result, 6)}
            content[f"{model}, {each.interface}, {each.work}, {each.shots}"] = entry
    if path is not None:
        path.write_text(json.dumps(content, indent=1) + "\n")


if __name__ == "__main__":
    tabulate(costs, sys.argv[1] if len(sys.argv) > 1 else None)
