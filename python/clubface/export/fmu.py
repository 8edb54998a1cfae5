"""Exports a struck ball as a co-simulation unit (FMI 2.0 and 3.0): native library, model description and parameters.

Standards: FMI 2.0.4 and 3.0, Modelica Association, https://fmi-standard.org. The unit takes pose and motion of a head,
returns force and torque on it, and moves the ball; see :class:`clubface.StruckBall`. It contains no Python.
"""

from __future__ import annotations

import hashlib
import importlib.resources
import json
import math
import os
import platform
import re
import sys
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple
from xml.etree import ElementTree

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import reduced_model
from clubface.errors import InputError, RunError
from clubface.simulation.impact import Parameters
from clubface.simulation.inputs import HandLike, prepare
from clubface.simulation.multibody import DEFAULT_MODEL, SPEED
from clubface.simulation.results import inputs, outputs
from clubface.support.checks import check_choice
from clubface.support.version import __version__

VERSIONS = ("2.0", "3.0")
STEP = 1e-5
"""Default step size [s]; averaging the force over it changes the ball speed by less than 1e-4, relative."""
STOP = 0.01
"""Default stop time of a simulation [s]."""
EXCHANGED = ("club", "ball", "parameters")
"""Input groups that become parameters of the unit; the delivery is computed by the master."""
BASE_UNITS = {
    "m": {"m": 1}, "m/s": {"m": 1, "s": -1}, "rad": {"rad": 1}, "rad/s": {"rad": 1, "s": -1}, "s": {"s": 1},
    "kg": {"kg": 1}, "kg m2": {"kg": 1, "m": 2}, "N": {"kg": 1, "m": 1, "s": -2}, "N m": {"kg": 1, "m": 2, "s": -2},
    "Pa": {"kg": 1, "m": -1, "s": -2}, "s/m": {"s": 1, "m": -1}, "N/m3": {"kg": 1, "m": -2, "s": -2},
    "N m/rad": {"kg": 1, "m": 2, "s": -2, "rad": -1}, "N m s/rad": {"kg": 1, "m": 2, "s": -1, "rad": -1},
}  # fmt: skip
"""Exponents of the base units; a unit that is not listed has only its name."""


class Variable(NamedTuple):
    """A variable of the co-simulation unit."""

    name: str
    unit: str
    meaning: str
    causality: str  # "input", "parameter" or "output"
    start: float = 0.0
    kind: str = "Real"  # or "Integer" or "Boolean"
    bounds: tuple[float, float] | None = None  # minimum and maximum


def write_fmu(
    path: str | os.PathLike[str],
    club: str | os.PathLike[str] | Club,
    *,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    hand: HandLike | None = None,
    version: str = "2.0",
) -> Path:
    """Write a co-simulation unit and return its path.

    Inputs are rotation (a quaternion, real part first), position, velocity and angular velocity of the head; outputs
    are mean force and torque on the head over the last step, position and motion of the ball, and once the ball has
    left the face, ``launched_ball_speed`` and the other outputs of an impact. Club, ball and model are parameters.

    Parameters
    ----------
    path
        Path that ends in ``.fmu``; the name before that is the model identifier, of letters, digits and underscores.
    club, model, parameters, ball, hand
        As for :class:`clubface.StruckBall`.
    version
        Version of the standard, "2.0" or "3.0".

    Raises
    ------
    InputError
        The path or version is not allowed, or the model has no contact law.
    RunError
        This installation has no native library for units.
    """
    target = Path(path)
    check_choice("standard", version, VERSIONS)
    if target.suffix != ".fmu" or not re.fullmatch(r"[A-Za-z_]\w*", target.stem):
        allowed = "a file name that ends in .fmu, of letters, digits and underscores, as in impact.fmu"
        raise InputError("output", str(path), allowed)
    described = reduced_model(model, "one that follows the contact in time")
    if described.kind != "contact":
        raise InputError("model", model, "one that follows the contact in time: volumetric, rings or area")
    shot = prepare(model, club, {"speed": SPEED}, ball, parameters, hand, single="a unit for co-simulation")
    values = dict(zip(inputs(), shot.shots.columns, strict=True))
    chosen = dict(zip((each.name for each in described.parameters), shot.parameters, strict=True))
    library, folder, suffix = native_library(version)
    variables = (*_head(), *_start(), *_club_variables(values, chosen, described), *_outputs())
    names = ["time", *(each.name for each in variables)]
    setup = {
        "model": model,
        "inputs": {name: value if math.isfinite(value) else None for name, value in values.items()},
        "parameters": chosen,
        "variables": names,
    }
    text = json.dumps(setup, indent=1)
    token = hashlib.sha256(f"{__version__} {text}".encode()).hexdigest()[:32]
    title = f"{shot.shots.club.name} and {shot.shots.ball.name} by {model}"
    description = (_description_2 if version == "2.0" else _description_3)(target.stem, token, title, variables)
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("modelDescription.xml", description)
        archive.writestr("resources/impact.json", text)
        archive.writestr(f"binaries/{folder}/{target.stem}{suffix}", library)
    return target


def native_library(version: str) -> tuple[bytes, str, str]:
    """Return this machine's native library, the platform name in a unit, and the file extension."""
    system, suffix = {"linux": ("linux", ".so"), "darwin": ("darwin", ".dylib")}.get(sys.platform, ("windows", ".dll"))
    machine = {"AMD64": "x86_64", "arm64": "aarch64"}.get(platform.machine(), platform.machine())
    file = importlib.resources.files("clubface.export").joinpath("native", f"clubface_fmi{suffix}")
    if not file.is_file():
        raise RunError(
            "this installation has no library for units of FMI: install a wheel, or run `make build` in a checkout"
        )
    if version == "3.0":
        return file.read_bytes(), f"{machine}-{system}", suffix
    bits = {"linux": "linux64", "windows": "win64", "darwin": "darwin64"}[system]
    return file.read_bytes(), bits, suffix


def _vector(stem: str, unit: str, meaning: str, causality: str) -> Iterator[Variable]:
    for axis, direction in (("x", "to the target"), ("y", "up"), ("z", "to the right")):
        yield Variable(f"{stem}{axis}", unit, f"{meaning}, {direction}", causality)


def _head() -> Iterator[Variable]:
    turn = (
        "rotation from the axes of the head, which stands at its static loft with a square face, to those of the world"
    )
    for part, start in (("w", 1.0), ("x", 0.0), ("y", 0.0), ("z", 0.0)):
        yield Variable(f"head_q{part}", "1", f"{turn}: {part} of the quaternion", "input", start)
    yield from _vector("head_", "m", "centre of mass of the head", "input")
    yield from _vector("head_v", "m/s", "velocity of the centre of mass of the head", "input")
    yield from _vector("head_w", "rad/s", "angular velocity of the head about its centre of mass", "input")


def _start() -> Iterator[Variable]:
    yield from _vector("ball_start_", "m", "centre of the ball before impact", "parameter")
    yield from _vector("ball_start_v", "m/s", "velocity of the ball before impact", "parameter")
    yield from _vector("ball_start_w", "rad/s", "angular velocity of the ball before impact", "parameter")
    meaning = "whether the head gives way to the ball within a step, by its own inertia, or moves as prescribed"
    yield Variable("head_gives_way", "1", meaning, "parameter", 1.0, "Boolean")


def _club_variables(values: dict[str, float], chosen: dict[str, float], described: Any) -> Iterator[Variable]:
    for name, each in inputs().items():
        attached = each.group == "attachment" and any(values[n] for n, i in inputs().items() if i.group == "attachment")
        if (each.group in EXCHANGED or attached) and math.isfinite(values[name]):
            yield Variable(name, each.unit, each.meaning, "parameter", values[name])
    for each in described.parameters:
        yield Variable(
            each.name, each.unit, each.meaning, "parameter", chosen[each.name], bounds=(each.lower, each.upper)
        )


def _outputs() -> Iterator[Variable]:
    yield from _vector("force_", "N", "mean force on the head over the last step", "output")
    yield from _vector(
        "torque_", "N m", "mean torque on the head about its centre of mass over the last step", "output"
    )
    yield Variable("normal_force", "N", "normal force at the end of the step", "output")
    yield Variable("penetration", "m", "penetration at the end of the step, negative when apart", "output")
    yield from _vector("ball_", "m", "centre of the ball", "output")
    yield from _vector("ball_v", "m/s", "velocity of the ball", "output")
    yield from _vector("ball_w", "rad/s", "angular velocity of the ball", "output")
    yield Variable("phase", "1", "0 before the contact, 1 in it, 2 after it", "output", kind="Integer")
    for name, each in outputs().items():
        yield Variable(f"launched_{name}", each.unit, f"{each.meaning}; 0 before the launch", "output")


def _description(name: str, title: str, variables: tuple[Variable, ...], **attributes: str) -> ElementTree.Element:
    """Return the part of the description that both versions share, with an empty list of variables at its end."""
    common = {"modelName": name, "description": title, "generationTool": f"clubface {__version__}"}
    root = ElementTree.Element("fmiModelDescription", attributes | common | {"variableNamingConvention": "flat"})
    ElementTree.SubElement(root, "CoSimulation", modelIdentifier=name, canHandleVariableCommunicationStepSize="true")
    definitions = ElementTree.SubElement(root, "UnitDefinitions")
    for symbol in dict.fromkeys(each.unit for each in variables if each.unit != "1"):
        unit = ElementTree.SubElement(definitions, "Unit", name=symbol)
        if symbol in BASE_UNITS:
            ElementTree.SubElement(unit, "BaseUnit", {base: str(power) for base, power in BASE_UNITS[symbol].items()})
    ElementTree.SubElement(root, "DefaultExperiment", startTime="0", stopTime=repr(STOP), stepSize=repr(STEP))
    ElementTree.SubElement(root, "ModelVariables")
    return root


def _text(root: ElementTree.Element) -> bytes:
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="utf-8", xml_declaration=True)


def _value(each: Variable) -> str:
    return {"Real": repr(each.start), "Integer": str(int(each.start)), "Boolean": str(bool(each.start)).lower()}[
        each.kind
    ]


def _attributes(each: Variable, reference: int) -> dict[str, str]:
    variability = {"parameter": "fixed", "input": "continuous", "output": "continuous"}[each.causality]
    return {
        "name": each.name,
        "valueReference": str(reference),
        "description": each.meaning,
        "causality": each.causality,
        "variability": variability if each.kind == "Real" or each.causality == "parameter" else "discrete",
    }


def _type_attributes(each: Variable) -> dict[str, str]:
    """Return unit, bounds and start value in the form of both FMI versions; outputs have no start value."""
    typed = {"unit": each.unit} if each.kind == "Real" and each.unit != "1" else {}
    if each.bounds is not None:
        typed |= {"min": repr(each.bounds[0]), "max": repr(each.bounds[1])}
    return typed | ({} if each.causality == "output" else {"start": _value(each)})


def _description_2(name: str, token: str, title: str, variables: tuple[Variable, ...]) -> bytes:
    head = {"fmiVersion": "2.0", "guid": f"{{{token}}}", "numberOfEventIndicators": "0"}
    root = _description(name, title, variables, **head)
    listed = root[-1]
    for reference, each in enumerate(variables, 1):
        initial = {"parameter": {"initial": "exact"}, "output": {"initial": "calculated"}}.get(each.causality, {})
        scalar = ElementTree.SubElement(listed, "ScalarVariable", _attributes(each, reference) | initial)
        ElementTree.SubElement(scalar, each.kind, _type_attributes(each))
    structure = ElementTree.SubElement(root, "ModelStructure")
    for part in ("Outputs", "InitialUnknowns"):
        unknowns = ElementTree.SubElement(structure, part)
        for index, each in enumerate(variables, 1):
            if each.causality == "output":
                ElementTree.SubElement(unknowns, "Unknown", index=str(index))
    return _text(root)


def _description_3(name: str, token: str, title: str, variables: tuple[Variable, ...]) -> bytes:
    root = _description(name, title, variables, fmiVersion="3.0", instantiationToken=f"{{{token}}}")
    listed = root[-1]
    time = {"name": "time", "valueReference": "0", "causality": "independent", "variability": "continuous"}
    ElementTree.SubElement(listed, "Float64", time | {"description": "time of the master"})
    kinds = {"Real": "Float64", "Integer": "Int32", "Boolean": "Boolean"}
    for reference, each in enumerate(variables, 1):
        initial = {"parameter": {"initial": "exact"}, "output": {"initial": "calculated"}}.get(each.causality, {})
        ElementTree.SubElement(
            listed, kinds[each.kind], _attributes(each, reference) | initial | _type_attributes(each)
        )
    structure = ElementTree.SubElement(root, "ModelStructure")
    for part in ("Output", "InitialUnknown"):
        for reference, each in enumerate(variables, 1):
            if each.causality == "output":
                ElementTree.SubElement(structure, part, valueReference=str(reference))
    return _text(root)
