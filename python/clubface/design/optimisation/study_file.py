"""The TOML file of a study or a fitting, read strictly: every error names the file, the line and the key.

A study::

    title = "A driver for bogey golf"
    club = "driver"
    golfer = "bogey-driver"
    objective = "strokes"                # or two of them, for the front between both

    [hole]
    length = "400 yd"

    [variables]
    loft = ["8 deg", "14 deg"]
    bulge = ["200 mm", "500 mm"]
    mass_distribution = "free"           # or bounds of single mass properties

    [head]                               # where its mass may be, seen from the face centre
    size = ["115 mm", "62 mm", "124 mm"] # face to back, sole to crown, heel to toe
    centre = ["-55 mm", "2 mm", "3 mm"]
    volume = "460 cm3"
    discretionary_mass = "30 g"

    [limits]
    side_spread = ["none", "25 yd"]
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from clubface import units
from clubface.design.feasibility import MASS_PROPERTIES, SHAPES, Volume
from clubface.design.optimisation.combination import SETTINGS
from clubface.design.optimisation.fitting import Fitting
from clubface.design.optimisation.landings import FREE, SPEED_EXPONENT, Setting
from clubface.design.optimisation.objectives import OBJECTIVES
from clubface.design.optimisation.study import DIMENSIONS, DISTRIBUTION, MOST_SHOTS, DesignStudy, Head, golfers_of
from clubface.design.strokes import Hole
from clubface.equipment.balls import ball as ball_of
from clubface.equipment.clubs import club as club_of
from clubface.equipment.models import DEFAULT_MODEL, reduced_model
from clubface.errors import InputError
from clubface.simulation.flight_inputs import check_conditions
from clubface.support.checks import check_choice, check_count, check_names
from clubface.support.shipped import beside
from clubface.support.strict_toml import Document

OPEN = "none"
"""The word for a limit that is not there."""
COUNTS = {"shots": (1, MOST_SHOTS), "seed": (0, 2**31), "starts": (1, 1000), "points": (3, 200)}
"""Least and greatest value of what is counted."""
JUDGED = {**{name: each.dimension for name, each in OBJECTIVES.items()}, "strokes": units.DIMENSIONLESS}
_COMMON = ("title", "golfer", "objective", "model", "shots", "seed", "hole", "air", "wind", "ground")
_STUDY = (*_COMMON, "club", "ball", "starts", "points", "variables", "head", "limits", "rules", "mass")
_FIT = (*_COMMON, "fit")


OTHERS = {
    "cg_x": ("a club", 'a study of its own names it, as in club = "my-driver.toml"'),
    "study": ("a study of many runs", "clubface study run reads it"),
    "metals": ("a study of a head of shells", "clubface fem design reads it"),
}
"""What other files are, by a key that only they have, and what to do with them."""


def read(path: str | os.PathLike[str]) -> DesignStudy | Fitting:
    """Read a study, or a fitting if the file has a table ``[fit]``; files that it names are looked for beside it."""
    return from_document(Document.read(path), Path(path).parent)


def design_study(given: DesignStudy | str | os.PathLike[str]) -> DesignStudy:
    """Return a study, or that of a file; the file of a fitting is an :class:`InputError`."""
    if isinstance(given, DesignStudy):
        return given
    found = read(given)
    if isinstance(found, Fitting):
        raise InputError("study", given, "a study with variables; fit takes a fitting, which has a table [fit]")
    return found


def fitting(given: Fitting | str | os.PathLike[str]) -> Fitting:
    """Return a fitting, or that of a file; the file of a study is an :class:`InputError`."""
    if isinstance(given, Fitting):
        return given
    found = read(given)
    if isinstance(found, DesignStudy):
        raise InputError("fitting", given, "one with a table [fit]; optimise takes a study, which has variables")
    return found


def from_text(text: str) -> DesignStudy | Fitting:
    """Read the same from text; files that it names are looked for in the current folder."""
    return from_document(Document(text), Path())


def from_document(document: Document, folder: Path) -> DesignStudy | Fitting:
    """Read the same from a document, whose files are looked for in a folder."""
    data = document.data
    for key, (what, advice) in OTHERS.items():
        if key in data:
            raise document.error(f"this is {what}; {advice}", key)
    fits = "fit" in data
    required = ("title", "golfer", "objective", *(() if fits else ("club", "variables")))
    document.check_keys(data, _FIT if fits else _STUDY, required)
    document.check_text(data, ("title", "club", "ball", "model"))
    for name in ("hole", "air", "variables", "head", "limits", "rules", "mass", "fit"):
        if name in data and not isinstance(data[name], dict):
            raise document.error(f"{name} must be a table", name)
    try:
        common = _common(document, folder)
        return _fitting(document, common, folder) if fits else _study(document, common, folder)
    except InputError as error:
        raise document.wrap(error) from error


def _common(document: Document, folder: Path) -> dict[str, Any]:
    data = document.data
    found: dict[str, Any] = {"title": data["title"], "golfers": golfers_of(_golfers(document, folder))}
    if "hole" in data:
        document.check_keys(data["hole"], tuple(Hole.__dataclass_fields__), ("length",), "hole")
        found["hole"] = Hole(**data["hole"])
    for name, limits in COUNTS.items():
        if name in data:
            found[name] = check_count(name, data[name], *limits)
    model = data.get("model", DEFAULT_MODEL)
    reduced_model(model, "one with derivatives")
    flown: dict[str, Any] = {name: data.get(name) for name in ("air", "wind", "ground")}
    check_conditions(**flown)
    mass = data.get("mass", {})
    document.check_keys(mass, ("speed_exponent",), (), "mass")
    exponent = mass.get("speed_exponent", SPEED_EXPONENT)
    if isinstance(exponent, bool) or not isinstance(exponent, int | float) or not 0.0 <= exponent <= 1.0:
        raise InputError("mass.speed_exponent", exponent, "a number from 0 to 1")
    ball = ball_of(beside(data["ball"], folder)) if "ball" in data else None
    found["setting"] = Setting(model=model, ball=ball, speed_exponent=float(exponent), **flown)
    return found


def _golfers(document: Document, folder: Path) -> Any:
    given = document.data["golfer"]
    if isinstance(given, str):
        return beside(given, folder)
    if not (isinstance(given, list) and given and all(isinstance(each, dict) for each in given)):
        raise document.error("golfer must be a name, a file, or tables [[golfer]] with name and weight", "golfer")
    for place, each in enumerate(given):
        document.check_keys(each, ("name", "weight"), ("name",), "golfer", place)
        document.check_text(each, ("name",), "golfer", place)
        weight = each.get("weight", 1.0)
        if isinstance(weight, bool) or not isinstance(weight, int | float) or not 0.0 < weight < math.inf:
            raise document.error(f"weight must be a positive number, not {weight!r:.40}", "weight", "golfer", place)
    return [{**each, "name": beside(each["name"], folder)} for each in given]


def _study(document: Document, common: dict[str, Any], folder: Path) -> DesignStudy:
    data = document.data
    given = data["objective"]
    objectives = tuple(given) if isinstance(given, list) else (given,)
    if not 1 <= len(objectives) <= 2 or len(set(map(str, objectives))) < len(objectives):
        raise InputError("objective", given, "one objective, or a list of two different ones")
    for name in objectives:
        check_choice("objective", name, JUDGED)
    if len(objectives) == 1 and "points" in data:
        raise InputError("points", data["points"], "leave it out; it is for the front between two objectives")
    variables = dict(data["variables"])
    distributed = _is_distributed(variables)
    bounds = {
        name: _bounds(f"variables.{name}", each, DIMENSIONS, name, open_=False) for name, each in variables.items()
    }
    if distributed:
        own = [name for name in bounds if name in MASS_PROPERTIES and name != "mass"]
        if own:
            raise InputError(f"variables.{own[0]}", variables[own[0]], f"under [limits], since {DISTRIBUTION} is free")
    known = {**DIMENSIONS, **JUDGED}
    limits = {}
    for name, each in data.get("limits", {}).items():
        check_choice("limit", name, (*FREE, *JUDGED))
        limits[name] = _bounds(f"limits.{name}", each, known, name, open_=True)
    rules = data.get("rules", {})
    document.check_keys(rules, ("conform", "tolerance"), (), "rules")
    for name, each in rules.items():
        if not isinstance(each, bool):
            raise InputError(f"rules.{name}", each, "true or false")
    return DesignStudy(
        **common, club=club_of(beside(data["club"], folder)), objectives=objectives, bounds=bounds,
        distributed=distributed, head=_head(document) if "head" in data else None, limits=limits, **rules,
    )  # fmt: skip


def _is_distributed(variables: dict[str, Any]) -> bool:
    """Take the word that frees the whole distribution of mass from the variables."""
    known = (*FREE, DISTRIBUTION)
    check_names("variable", variables, known)
    if DISTRIBUTION not in variables:
        return False
    word = variables.pop(DISTRIBUTION)
    check_choice(f"variables.{DISTRIBUTION}", word, ("free",))
    return True


def _bounds(place: str, given: Any, dimensions: Mapping[str, str], name: str, *, open_: bool) -> tuple[float, float]:
    """Return the least and the greatest of two values with units; with ``open_`` either may be missing."""
    example = 'two values, least and greatest, as in ["8 deg", "14 deg"]' + (f'; "{OPEN}" is no limit' if open_ else "")
    if not (isinstance(given, list) and len(given) == 2):
        raise InputError(place, given, example)
    found = [
        side if open_ and each == OPEN else units.parse(each, dimensions[name], name=place)
        for each, side in zip(given, (-math.inf, math.inf), strict=True)
    ]
    if not found[0] < found[1] or found == [-math.inf, math.inf]:
        raise InputError(place, given, example)
    if not open_ and name in ("mass", "bulge", "roll", "ixx", "iyy", "izz") and found[0] <= 0.0:
        raise InputError(place, given, "above 0 at both ends")
    return found[0], found[1]


def _vector(place: str, given: Any) -> tuple[float, float, float]:
    if not (isinstance(given, list) and len(given) == 3):
        raise InputError(place, given, 'three lengths, as in ["115 mm", "62 mm", "124 mm"]')
    one, two, three = (units.parse(each, "length", name=place) for each in given)
    return one, two, three


def _head(document: Document) -> Head:
    given = document.data["head"]
    known = ("shape", "size", "centre", "volume", "discretionary_mass", "shell")
    document.check_keys(given, known, ("size", "centre", "discretionary_mass"), "head")
    shape = given.get("shape", "box")
    check_choice("head.shape", shape, SHAPES)
    volume = Volume(
        shape=shape, centre=_vector("head.centre", given["centre"]), size=_vector("head.size", given["size"])
    )
    displaced = units.parse(given["volume"], "volume", name="head.volume") if "volume" in given else None
    if displaced is not None and displaced <= 0.0:
        raise InputError("head.volume", given["volume"], "above 0")
    budget = units.parse(given["discretionary_mass"], "mass", name="head.discretionary_mass")
    if not 0.0 < budget < 1.0:
        raise InputError("head.discretionary_mass", given["discretionary_mass"], "between 0 and 1 kg")
    shell = None
    if "shell" in given:
        document.check_keys(given["shell"], MASS_PROPERTIES, MASS_PROPERTIES, "head.shell")
        shell = tuple(
            units.parse(given["shell"][name], DIMENSIONS[name], name=f"head.shell.{name}") for name in MASS_PROPERTIES
        )
    return Head(volume=volume, discretionary=budget, displaced=displaced, shell=shell)


def _fitting(document: Document, common: dict[str, Any], folder: Path) -> Fitting:
    data, given = document.data, document.data["fit"]
    if not isinstance(data["objective"], str):
        raise InputError("objective", data["objective"], "one objective")
    check_choice("objective", data["objective"], JUDGED)
    document.check_keys(given, ("clubs", "balls", "setting", "loft", "lie"), ("clubs",), "fit")
    bounds = {
        name: _bounds(f"fit.{name}", given[name], DIMENSIONS, name, open_=False)
        for name in ("loft", "lie")
        if name in given
    }
    settings, described = {}, given.get("setting", [])
    for each in described if isinstance(described, list) else [described]:
        if not isinstance(each, dict) or not isinstance(each.get("name"), str):
            raise InputError("fit.setting", str(each)[:60], 'tables [[fit.setting]], each with its name: name = "back"')
        check_names("change of a setting", [name for name in each if name != "name"], SETTINGS)
        if each["name"] in settings:
            raise InputError("fit.setting", each["name"], "a name that no other setting has")
        settings[each["name"]] = {
            name: units.parse(value, DIMENSIONS[name], name=f"setting.{name}")
            for name, value in each.items()
            if name != "name"
        }
    clubs = tuple(club_of(beside(each, folder)) for each in _texts("fit.clubs", given["clubs"]))
    balls: tuple[Any, ...] = (None,)
    if "balls" in given:
        balls = tuple(ball_of(beside(each, folder)) for each in _texts("fit.balls", given["balls"]))
    kept = {name: each for name, each in common.items() if name not in ("starts", "points")}
    return Fitting(**kept, objective=data["objective"], clubs=clubs, balls=balls, settings=settings, bounds=bounds)


def _texts(place: str, given: Any) -> list[str]:
    if not (isinstance(given, list) and given and all(isinstance(each, str) for each in given)):
        raise InputError(place, given, "a list of names or files")
    return given
