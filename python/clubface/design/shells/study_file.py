"""The TOML file of a study of a head of shells, read strictly: every error names the file, the line and the key.

A study::

    title = "A face within the rules"
    head = "driver.toml"                 # a driver of walls, beside this file
    objective = "ball_speed"             # or carry, characteristic_time, wall_mass (the least)
    safety = 1.1                         # by what the yield stress is divided

    [variables.thickness]
    face_centre = ["2.4 mm", "4.2 mm"]

    [delivery]                           # or golfer = "average-driver" and points alone
    speed = "100 mph"
    loft = "12 deg"
    points = [["0 mm", "0 mm"], ["12 mm", "4 mm"]]   # to the toe, above the face centre

    [hardest]                            # what the delivery has, unless it is given
    speed = "120 mph"

    [limits]
    wall_mass = ["none", "195 g"]

    [[metals]]                           # left out: that of the head
    name = "Ti-6Al-4V"
    youngs = "114 GPa"
    poisson = 0.34
    density = "4430 kg/m3"
    yield = "880 MPa"
    source = "where the figures are from"
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from clubface import units
from clubface.design.golfer.golfers import golfer as golfer_of
from clubface.design.shells.study import QUANTITIES, Blow, NamedMetal, ShellStudy
from clubface.errors import ClubfaceError, FileError, InputError, UnknownNameError
from clubface.fem.balls import ball as ball_of
from clubface.fem.heads.driver import SHAPE, WALLS, DriverHead
from clubface.fem.heads.metal import Metal
from clubface.fem.heads.read import FOLDER, from_toml
from clubface.simulation.delivery import DIMENSIONS, Delivery
from clubface.support.shipped import beside, path_of
from clubface.support.strict_toml import Document

OPEN = "none"
"""The word for a limit that is not there."""
KEYS = ("title", "head", "objective", "golfer", "ball", "safety", "rules", "designs", "radius", "neighbours",
        "variables", "delivery", "hardest", "limits", "metals")  # fmt: skip
TABLES = ("variables", "delivery", "hardest", "limits")
METAL = ("name", "source", "youngs", "poisson", "density", "yield")
MOST_POINTS = 100


def read(path: str | os.PathLike[str]) -> ShellStudy:
    """Read a study; files that it names are looked for beside it."""
    return from_document(Document.read(path), Path(os.fspath(path)).parent)


def from_document(document: Document, folder: Path) -> ShellStudy:
    """Read a study from a document."""
    data = document.data
    document.check_keys(data, KEYS, ("title", "head", "objective", "variables"))
    document.check_text(data, ("title", "head", "objective", "golfer", "ball"))
    for name in TABLES:
        if not isinstance(data.get(name, {}), dict):
            raise document.error(f"{name} must be a table", name)
    for name in ("rules", "neighbours"):
        if not isinstance(data.get(name, True), bool):
            raise document.error(f"{name} must be true or false, not {data[name]!r:.40}", name)
    try:
        delivery = _delivery(document, folder)
        found: dict[str, Any] = {name: data[name] for name in ("rules", "neighbours", "designs") if name in data}
        for name in ("safety", "radius"):
            if name in data:
                found[name] = units.parse(data[name], units.DIMENSIONLESS, name=name)
        if "ball" in data:
            found["ball"] = ball_of(beside(data["ball"], folder))
        return ShellStudy(
            title=data["title"], head=_head(document, folder), objective=data["objective"], bounds=_variables(document),
            delivery=delivery, hardest=_hardest(document, delivery) if "hardest" in data else None,
            limits=_limits(document),
            metals=_metals(document), **found,
        )  # fmt: skip
    except FileError:
        raise
    except ClubfaceError as error:
        raise document.wrap(error) from error


def _head(document: Document, folder: Path) -> DriverHead:
    try:
        head = from_toml(path_of("head of finite elements", beside(document.data["head"], folder), FOLDER))
    except ClubfaceError as error:
        raise document.error(f"head: {error}", "head") from error
    if not isinstance(head, DriverHead):
        raise document.error(f'head must be of the kind "driver", whose walls can vary; {head.name} is another', "head")
    return head


def _variables(document: Document) -> dict[str, tuple[float, float]]:
    given = document.data["variables"]
    for name in given:
        if name not in ("thickness", "shape"):
            told = UnknownNameError("table of variables", name, ("thickness", "shape"))
            raise document.error(str(told), "", f"variables.{name}")
    found = {}
    for table, known in (("thickness", WALLS), ("shape", SHAPE)):
        values = given.get(table, {})
        if not isinstance(values, dict):
            raise document.error(f"variables.{table} must be a table: [variables.{table}]", table, "variables")
        document.check_keys(values, known, (), f"variables.{table}")
        for name, each in values.items():
            place, dimension = f"variables.{table}.{name}", "angle" if name == "loft" else "length"
            if not (isinstance(each, list) and len(each) == 2):
                raise InputError(place, each, 'two values, least and greatest, as in ["2.4 mm", "4.2 mm"]')
            low, high = (units.parse(side, dimension, name=place) for side in each)
            found[f"{table}.{name}"] = (low, high)
    return found


def _limits(document: Document) -> dict[str, tuple[float, float]]:
    given = document.data.get("limits", {})
    document.check_keys(given, [each for each in QUANTITIES if each != "stress"], (), "limits")
    return {name: _limit(name, each) for name, each in given.items()}


def _limit(name: str, given: Any) -> tuple[float, float]:
    place, dimension = f"limits.{name}", QUANTITIES[name][1]
    if not (isinstance(given, list) and len(given) == 2):
        raise InputError(place, given, f'two values, least and greatest, as in ["{OPEN}", "..."]; "{OPEN}" is no limit')
    low, high = (
        side if each == OPEN else units.parse(each, dimension, name=place)
        for each, side in zip(given, (0.0, math.inf), strict=True)
    )
    if not 0.0 <= low < high or (low, high) == (0.0, math.inf):
        raise InputError(place, given, f'the least value, then a greater one; "{OPEN}" is no limit')
    return low, high


def _delivery(document: Document, folder: Path) -> Blow:
    data = document.data
    given = dict(data.get("delivery", {}))
    points = _points("delivery", given.pop("points", None)) or ((0.0, 0.0),)
    if "golfer" not in data:
        return Blow(delivery=_values(document, given, "delivery", ("speed",)), points=points)
    if given:
        raise InputError(f"delivery.{next(iter(given))}", next(iter(given.values())),
                         "left out: the golfer delivers; give points alone")  # fmt: skip
    mean = golfer_of(beside(data["golfer"], folder)).for_hand(1.0).delivery()
    values = {name: getattr(mean, name) for name in DIMENSIONS if name not in ("toe", "high")}
    return Blow(delivery={name: float(value) for name, value in values.items() if value is not None}, points=points)


def _hardest(document: Document, usual: Blow) -> Blow:
    given = dict(document.data["hardest"])
    points = _points("hardest", given.pop("points", None)) or usual.points
    return Blow(delivery={**usual.delivery, **_values(document, given, "hardest", ())}, points=points)


def _values(document: Document, given: Mapping[str, Any], table: str, required: tuple[str, ...]) -> dict[str, float]:
    """Return the values of a delivery [SI]; where it strikes is told by points."""
    known = [name for name in DIMENSIONS if name not in ("toe", "high")]
    document.check_keys(dict(given), known, required, table)
    values = {name: units.parse(each, DIMENSIONS[name], name=f"{table}.{name}") for name, each in given.items()}
    if values:
        try:
            Delivery(**{"speed": "40 m/s", **values})
        except InputError as error:
            raise document.wrap(error, table) from error
    return values


def _points(table: str, given: Any) -> tuple[tuple[float, float], ...] | None:
    if given is None:
        return None
    wanted = f'1 to {MOST_POINTS} points, each to the toe and above the face centre, as in [["0 mm", "0 mm"]]'
    if not (isinstance(given, list) and 1 <= len(given) <= MOST_POINTS):
        raise InputError(f"{table}.points", given, wanted)
    found = []
    for each in given:
        if not (isinstance(each, list) and len(each) == 2):
            raise InputError(f"{table}.points", given, wanted)
        toe, high = (units.parse(value, "length", name=f"{table}.points") for value in each)
        if max(abs(toe), abs(high)) > 0.06:
            raise InputError(f"{table}.points", each, "within 60 mm of the face centre")
        found.append((toe, high))
    return tuple(found)


def _metals(document: Document) -> tuple[NamedMetal, ...]:
    given = document.data.get("metals", [])
    if not (isinstance(given, list) and all(isinstance(each, dict) for each in given)):
        raise document.error("metals must be tables, each under [[metals]]", "metals")
    found: list[NamedMetal] = []
    for place, each in enumerate(given):
        document.check_keys(each, METAL, ("name", "youngs", "poisson", "density"), "metals", place)
        document.check_text(each, ("name", "source"), "metals", place)
        if each["name"] in [other.name for other in found]:
            raise document.error(f"name: {each['name']!r} is taken; every metal needs its own", "name", "metals", place)
        values = {name: each[name] for name in ("youngs", "poisson", "density") if name in each}
        try:
            metal = Metal(**values, yield_stress=each.get("yield"))
        except InputError as error:
            raise document.wrap(error, "metals", place) from error
        found.append(NamedMetal(name=each["name"], metal=metal, source=each.get("source", "")))
    return tuple(found)
