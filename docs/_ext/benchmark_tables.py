"""Tables of what everything costs, as `make benchmarks` measured it, next to how near the models come."""

from __future__ import annotations

import json
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

from core_tables import NBSP, CoreTable, compared, markdown_table
from findings_results import duration
from sphinx.application import Sphinx
from validation_tables import validation

from clubface import units
from clubface.equipment.models import models
from clubface.validation import tour

DOCS = Path(__file__).parent.parent
BUSY = 0.5
"""Other processes, on the average, from which on a machine is called busy."""
LIBRARIES = {
    "NumPy": ("array-libraries.json", "NumPy", "/plug-into-jax.md"),
    "JAX, compiled": ("array-libraries.json", "JAX, compiled", "/plug-into-jax.md"),
    "PyTorch": ("array-libraries.json", "PyTorch", "/plug-into-torch.md"),
    "C": ("c-interface-costs.json", "C", "/c-interface.md"),
    "CasADi": ("c-interface-costs.json", "CasADi", "/plug-into-casadi.md"),
    "Octave": ("c-interface-costs.json", "Octave", "/plug-into-matlab.md"),
}
"""Ways to call the core: the file and the name under which their costs stand, and their page."""


@cache
def stored(name: str = "benchmarks.json") -> dict[str, Any]:
    """Return a file of measured costs."""
    return json.loads((DOCS / name).read_text(encoding="utf-8"))


def spaced(seconds: float) -> str:
    """Write a time that is not broken over lines."""
    return duration(seconds).replace(" ", NBSP)


def element_step(wall: float, steps: int, elements: int) -> str:
    """Write nanoseconds an element and step."""
    return f"{1e9 * wall / (steps * elements):.1f}"


class Machine(CoreTable):
    """``{benchmark-machine} models flights``: where, when and with which sources sections were measured."""

    required_arguments = 1
    final_argument_whitespace = True

    def table(self) -> list[str]:
        """One sentence for each machine and day."""
        groups = dict.fromkeys(
            tuple(stored()[name]["measured"][key] for key in ("date", "processor", "cores", "system", "commit"))
            for name in self.arguments[0].split()
        )
        loads = [stored()[name]["measured"]["load"] or 0.0 for name in self.arguments[0].split()]
        sentences = [
            f"Measured on {day} on {cores} cores of {processor} ({system}), with the sources of commit {commit}."
            for day, processor, cores, system, commit in groups
        ]
        if max(loads) > BUSY:
            sentences.append(f"The machine did other work at the time (load {max(loads)}): these times are too long.")
        return [f"*{' '.join(sentences)}*"]


class Models(CoreTable):
    """``{benchmark-models}``: how near each model comes to what is published, and what a shot by it costs."""

    def table(self) -> list[str]:
        """One row a model."""
        checked = validation()
        averages = [compared(name) for name in tour.TABLES]
        costs = stored()["models"]
        rows = []
        for name in (*models(), "fem"):
            verdict, cost = checked.verdict(name), costs[name]
            row = [f"[`{name}`]({'/finite-elements' if name == 'fem' else f'/models/{name}'}.md)"]
            row.append(f"{verdict.met} of {verdict.of}")
            if name == "fem":
                row += ["–", "–", "–", spaced(cost["call"]), "–", "–"]
            else:
                errors = tour.mean_absolute_error(averages, name)
                row += [
                    f"{units.from_si(errors[quantity], unit):.{digits}f}"
                    for quantity, unit, digits in (("ball_speed", "mph", 1), ("spin", "rpm", 0), ("carry", "yd", 1))
                ]
                row += [spaced(cost[key]) for key in ("call", "shot", "derivatives")]
            rows.append(row)
        heads = ["model", "within tolerance", "ball speed, mph", "spin, rpm", "carry, yd"]
        return markdown_table([*heads, "one call", "a shot in a batch", "derivatives"], rows)


class Flights(CoreTable):
    """``{benchmark-flights}``: the cost of flights and of a million drives."""

    def table(self) -> list[str]:
        """One row a computation."""
        flights = stored()["flights"]
        rows = [["a flight in a batch, 1 thread", spaced(flights["flight"])]]
        rows += [
            [f"a million drives with their flights, {threads} thread{'s' * (threads != '1')}", spaced(wall)]
            for threads, wall in flights["drives"].items()
        ]
        return markdown_table(["", "time"], rows)


class Elements(CoreTable):
    """``{benchmark-elements}``: the reference case on two meshes, by threads."""

    def table(self) -> list[str]:
        """One row a mesh and number of threads."""
        rows = []
        for run in stored()["elements"]["reference"]:
            cost = element_step(run["wall"], run["steps"], run["elements"])
            result = f"{units.from_si(run['backspin'], 'rpm'):.0f} rpm, {run['peak_force'] / 1e3:.2f} kN"
            rows.append(
                [f"{run['elements']:,}", f"{run['steps']:,}", run["threads"], cost, spaced(run["wall"]), result]
            )
        heads = ["elements", "steps", "threads", "ns an element and step", "whole run", "result"]
        return markdown_table(heads, rows)


class Heads(CoreTable):
    """``{benchmark-heads}``: drives by finite elements, and derivatives of one."""

    def table(self) -> list[str]:
        """One row a computation."""
        elements = stored()["elements"]
        heads = elements["heads"]
        return markdown_table(["a drive on all cores", "time"], [
            ["rigid head", spaced(heads["rigid"]["wall"])],
            ["rigid head, with derivatives by four inputs", spaced(elements["derivatives"])],
            ["head of shells", spaced(heads["shells"]["wall"])],
        ])  # fmt: skip


class Lulesh(CoreTable):
    """``{benchmark-lulesh}``: LULESH on the machine of the finite elements."""

    def table(self) -> list[str]:
        """One row a number of threads."""
        section = stored()["lulesh"]
        rows = [[run["threads"], f"{1e9 * run['element_step']:.0f}"] for run in section["runs"]]
        heads = ["threads", f"LULESH, {section['elements']:,} elements: ns an element and step"]
        return markdown_table(heads, rows)


class Identification(CoreTable):
    """``{benchmark-identification}``: the published search on all cores."""

    def table(self) -> list[str]:
        """One row a model."""
        rows = [
            [f"`{name}`", f"{each['impacts'] / 1e6:.1f}", spaced(each["wall"]), spaced(each["processor"]),
             f"{each['cost']:.4f}"]
            for name, each in stored()["identification"].items() if name != "measured"
        ]  # fmt: skip
        return markdown_table(["model", "million impacts", "time", "of processors", "cost reached"], rows)


class Studies(CoreTable):
    """``{benchmark-studies}``: a study of 64 drives by finite elements."""

    def table(self) -> list[str]:
        """One row a number of workers."""
        times = {name: wall for name, wall in stored()["studies"].items() if name != "measured"}
        rows = [[workers, spaced(wall), f"{times['1'] / wall:.2f}"] for workers, wall in times.items()]
        return markdown_table(["workers", "time", "speed-up"], rows)


class Interfaces(CoreTable):
    """``{benchmark-interfaces}``: a shot by the default model, called from elsewhere."""

    def table(self) -> list[str]:
        """One row a library or language."""
        rows = []
        for name, (file, key, page) in LIBRARIES.items():
            works = [
                f"response, {key}, {work}, {shots}" for work in ("ball speed", "spin by loft") for shots in (1, 1000)
            ]
            rows.append([f"[{name}]({page})", *(spaced(1e-3 * stored(file)[work]["ms"]) for work in works)])
        return markdown_table(["", "launch", "a thousand", "its derivatives", "a thousand"], rows)


class Browser(CoreTable):
    """``{benchmark-browser}``: the core in WebAssembly, next to the native one."""

    def table(self) -> list[str]:
        """One row a model, the finite elements last."""
        browser, native = stored()["browser"], stored()["models"]
        rows = [
            [f"`{name}`, a shot in a batch", spaced(each["shot"]), spaced(native[name]["shot"])]
            for name, each in browser["models"].items()
        ]
        here = stored()["elements"]["reference"][0]
        rows.append(["reference case of the finite elements", *_walls(browser["reference"]["wall"], here["wall"])])
        return markdown_table(["one thread", "WebAssembly", "native"], rows)


def _walls(*walls: float) -> Iterable[str]:
    return map(spaced, walls)


class Processes(CoreTable):
    """``{benchmark-processes}``: what starting costs."""

    def table(self) -> list[str]:
        """One row a process."""
        times = stored()["processes"]
        return markdown_table(["a fresh process", "time"], [
            [f"`{name}`", spaced(wall)] for name, wall in times.items() if name != "measured"
        ])  # fmt: skip


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    for directive in (
        Machine, Models, Flights, Elements, Heads, Lulesh, Identification, Studies, Interfaces, Browser, Processes,
    ):  # fmt: skip
        app.add_directive(f"benchmark-{directive.__name__.lower()}", directive)
    return {"parallel_read_safe": True}
