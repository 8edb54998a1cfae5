"""Write what the studio needs of the package: equipment and golfers in SI, and the description of the core.

``python studio/data.py FOLDER`` writes ``equipment.json``, which the pages load, and ``description.json``, which their
unit tests read; in the browser the description comes from the core itself. An infinite radius is null.
"""

from __future__ import annotations

import json
import math
import sys
import warnings
from collections.abc import Mapping
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

from certainty import Numbered, certainty_data, kind_of
from equations import equations_data
from lesson_figures import lesson_figures
from titles import ball_title, club_title, set_title

from clubface import _core, fem, units
from clubface.design.contributions import QUANTITIES
from clubface.design.face_map import SHARE
from clubface.design.face_surface import outline_of
from clubface.design.feasibility import QUANTITIES as SIZES, usual_space
from clubface.design.golfer import MIRRORED, Golfer, golfer
from clubface.design.optimisation.landings import SPEED_EXPONENT
from clubface.design.optimisation.study import RULED
from clubface.design.strokes import AT_REST, FAIRWAY_WIDTH, GREEN_RADIUS, ROUGH_WIDTH, as_lists
from clubface.equipment.balls import DEFAULT_BALL, FRICTION_LIMITS, Ball, ball
from clubface.equipment.clubs import CLUB_PROPERTIES, KINDS, Club, club
from clubface.equipment.models import DEFAULT_MODEL
from clubface.equipment.parameters import ParameterSet, builtin_sets
from clubface.equipment.rules import STEEPEST_PENDULUM_LOFT, rules, rules_of
from clubface.errors import RuleWarning
from clubface.fem.backend import HOW
from clubface.fem.balls import ball_names
from clubface.fem.case import case
from clubface.fem.heads.parametric import DriverHead
from clubface.fem.heads.read import design_of, head_names
from clubface.fem.paper import ANGLE, FRICTION as REFERENCE_FRICTION, REFERENCE_SPEED
from clubface.fem.run import THROW_ANGLE, THROW_SPEED
from clubface.fem.settings import SAFETIES
from clubface.schema import PhysicalValue
from clubface.simulation.flight import GROUNDS
from clubface.simulation.inputs import equipment, parameter_set
from clubface.simulation.launch_conditioned import impact_at_launch
from clubface.simulation.results import inputs
from clubface.support.files import builtin_names
from clubface.support.version import __version__
from clubface.units import from_si
from clubface.validation.tour import Average, averages

DESCRIBED = (
    "quantities", "units", "dimensions", "models", "inputs", "outputs", "flight_inputs", "flight_outputs",
    "shot_shapes",
)  # fmt: skip

SHOWN, FRAMES = 600e-6, 61
"""Time that most contacts do not exceed [s], and the shapes that are kept in it, one in 10 us."""
MILLISECOND_FRAMES = 101
"""The same for a millisecond."""


def tour_delivery(each: Club) -> dict[str, list[Any]]:
    """Return speed, attack angle and dynamic loft of the tour average of a club, or of the nearest loft of its kind.

    The dynamic loft is the one with which the ball starts at the published launch angle; a club of another loft than
    the tour's delivers as many degrees more or less.
    """

    def distance(row: Average) -> tuple[bool, bool, float]:
        other = club(row.club)
        return row.club != each.name, (other.kind == "iron") != (each.kind == "iron"), abs(other.loft - each.loft)

    row = min(averages(), key=distance)
    launched = impact_at_launch(row.club, speed=row.club_speed, attack=row.attack, launch=row.launch)
    loft = float(launched.loft) + each.loft - club(row.club).loft
    speed, attack, loft = from_si(row.club_speed, "mph"), from_si(row.attack, "deg"), from_si(loft, "deg")
    given = {"speed": (speed, "mph"), "attack": (attack, "deg"), "loft": (loft, "deg")}
    return {name: [round(float(value), 1), unit] for name, (value, unit) in given.items()}


def finite(values: Mapping[str, float]) -> dict[str, float | None]:
    """Return values as JSON has them."""
    return {name: None if math.isinf(value) else value for name, value in values.items()}


def described_club(each: Club, columns: Mapping[str, float]) -> dict[str, Any]:
    """Return what the pages show and compute of a club."""
    outline = outline_of(each)
    return {
        "label": club_title(each.name),
        "kind": each.kind,
        "published_kind": kind_of(each),
        "parameters": each.parameters,
        "description": each.description,
        "typical": tour_delivery(each),
        "outline": outline.corners.tolist(),
        "outline_source": outline.origin,
        "columns": finite({name: columns[name] for name, entry in inputs().items() if entry.group == "club"}),
        "space": described_space(each),
        "rules": rule_names(each),
    }


def described_space(each: Club) -> dict[str, Any]:
    """Return the space that a head is assumed to fill."""
    space = usual_space(each)
    return {
        "shape": space.volume.shape,
        "centre": space.volume.centre,
        "size": space.volume.size,
        "volume": space.displaced,
        "free_mass": space.free,
        "origin": space.origin,
    }


def described_rules() -> dict[str, dict[str, Any]]:
    """Return the limits of a head by name.

    ``of`` is the number that is limited, ``steepest`` the greatest loft for which the limit holds; a head must not be
    longer from face to back than from heel to toe, which has ``most_of`` in the place of ``most``.
    """
    limited = {rule: field for field, rule in RULED.items()}
    result: dict[str, dict[str, Any]] = {
        name: {
            "title": rule.title,
            "of": limited.get(name, name),
            "most": rule.most,
            "tolerance": rule.tolerance,
            "source": rule.source,
            "steepest": STEEPEST_PENDULUM_LOFT if name == "characteristic_time" else None,
        }
        for name, rule in rules().items()
    }
    longest = {"title": "face to back, no longer than heel to toe", "of": "face_to_back", "most_of": "heel_to_toe"}
    return {**result, "face_to_back": {**result["heel_to_toe"], **longest}}


def rule_names(each: Club) -> list[str]:
    """Return the limits that hold for a kind of head, whatever its loft."""
    names = [rule.name for rule in rules_of(each.replace(loft=0.0))]
    return names + ["face_to_back"] * ("heel_to_toe" in names)


def club_fields() -> list[dict[str, Any]]:
    """Return the numbers of a club's file: key, input of the core, unit, bounds in it, and the word for infinity."""
    columns = {"mass": "club_mass", "loft": "static_loft"}
    result = []
    for key, entry in CLUB_PROPERTIES.items():
        kind = entry.value
        if key == "cor" or not isinstance(kind, PhysicalValue):
            continue  # a file with a restitution goes through the package, which knows what spring it means
        infinite = next(iter(kind.special), None)
        bounds = {"unit": kind.unit, "least": kind.lower, "most": kind.upper, "infinite": infinite}
        result.append({"key": key, "column": columns.get(key, key), "needed": entry.is_required, **bounds})
    return result


def described_ball(each: Ball) -> dict[str, Any]:
    """Return what the pages show and compute of a ball."""
    return {"label": ball_title(each.name), "description": each.description, "columns": each.inputs()}


def set_names(model: str, family: str) -> list[str | None]:
    """Return None, for the usual parameters, and the names of the published sets for a family of clubs."""
    fitting = [each.name for each in builtin_sets(model) if each.club in (family, "any")]
    return [None, *dict.fromkeys(fitting)]


def described_set(each: ParameterSet) -> dict[str, Any]:
    """Return values and origin of a parameter set."""
    return {
        "model": each.model,
        "name": each.name,
        "label": set_title(each.name),
        "source": each.source,
        "reference": each.reference,
        "caveats": [*each.caveats, *(f"{name}: {text}" for name, text in each.value_caveats.items())],
        "values": each.columns(),
        "includes_face": each.includes_face,
        "characteristic_time": each.characteristic_time,
    }


def described_golfer(each: Golfer) -> dict[str, Any]:
    """Return a golfer's shots as the core takes them, with a club of either hand."""

    def distribution(hand: int) -> dict[str, Any]:
        own = each.for_hand(hand)
        return {
            "variables": own.variables,
            "mean": own.mean.tolist(),
            "covariance": own.covariance.tolist(),
            "mirrored": [name for name in MIRRORED if hand < 0 and name in own.variables],
            "mishit_share": own.mishit_share,
            "mishit_scale": own.mishit_scale,
        }

    return {
        "title": each.title,
        "club": each.club,
        "right": distribution(1),
        "left": distribution(-1),
        "sources": [[", ".join(figures), source] for source, figures in each.figures_by_source().items()],
    }


def described_hole() -> dict[str, Any]:
    """Return what stands for the measures of a hole that are not given, and the strokes to hole out from each lie."""
    tables = [dict(zip(("distance", "strokes"), as_lists(lie), strict=True)) for lie in AT_REST]
    return {"fairway": FAIRWAY_WIDTH, "rough": ROUGH_WIDTH, "green": GREEN_RADIUS, "tables": tables}


def equipment_data() -> dict[str, Any]:
    """Return what can be chosen, which set and face belong to a model, club and ball, and what is known of numbers."""
    clubs = {name: club(name) for name in builtin_names("clubs")}
    balls = {name: ball(name) for name in builtin_names("balls")}
    order = sorted(clubs, key=lambda name: (clubs[name].description.count("measured") > 0, clubs[name].loft))
    sets: dict[str, dict[str, Any]] = {}
    set_places, faces = Numbered(), Numbered()
    choices: dict[str, Any] = {}
    for model in (entry["name"] for entry in _core.models()):
        for club_name, each in clubs.items():
            for ball_name, struck in balls.items():
                plain = dict(zip(inputs(), equipment(each, struck).columns, strict=True))
                places: dict[str, list[int]] = {}
                for name in set_names(model, each.parameters):
                    chosen = parameter_set(model, each, name, struck)
                    columns = chosen.with_included_face(plain)
                    data = described_set(chosen)
                    key = json.dumps(data)
                    sets[key] = data
                    face = (columns["characteristic_time"], columns.get("included_time", 0.0))
                    places[name or ""] = [set_places.place(key), faces.place(face)]
                choices.setdefault(model, {}).setdefault(club_name, {})[ball_name] = places
    return {
        "version": __version__,
        "defaults": {"model": DEFAULT_MODEL, "ball": DEFAULT_BALL, "club": "driver"},
        "inputs": list(inputs()),
        "clubs": {
            name: described_club(clubs[name], dict(zip(inputs(), equipment(clubs[name], None).columns, strict=True)))
            for name in order
        },
        "balls": {name: described_ball(each) for name, each in balls.items()},
        "face_map": {"quantities": list(QUANTITIES), "share": SHARE},
        "quantities": [each._asdict() for each in SIZES],
        "rules": described_rules(),
        "club_file": {"fields": club_fields(), "keys": [each.name for each in fields(Club)], "kinds": KINDS},
        "speed_exponent": SPEED_EXPONENT,
        "golfers": {name: described_golfer(golfer(name)) for name in builtin_names("golfers")},
        "hole": described_hole(),
        "grounds": {name: dict(values) for name, values in GROUNDS.items()},
        "sets": [sets[key] for key in set_places],
        "faces": [list(face) for face in faces],
        "numbers": {
            "explained": [entry["name"] for entry in (*_core.outputs(), *_core.flight_outputs())],
            **equations_data(),
            "certainty": certainty_data(),
        },
        "choices": choices,
        "elements": elements_data(),
        "lessons": lesson_figures(),
    }


def meshed_ball(made: fem.Ball) -> dict[str, Any]:
    """Return a ball of pieces as the finite elements take it, and its columns as the input of a shot."""
    return {"values": made.values(), "columns": made.rigid.inputs(), "elements": made.elements}


def coarser(made: fem.Ball) -> fem.Ball:
    """Return a ball with half as many elements along every edge."""
    pieces = tuple(replace(piece, layers=-(-piece.layers // 2)) for piece in made.pieces)
    return replace(made, cube=2 * (made.cube // 4), pieces=pieces)


def elements_data() -> dict[str, Any]:
    """Return what the finite elements take: meshed balls, heads of shells, how to run, and published cases."""
    balls = {name: fem.ball(name) for name in ball_names()}
    designs = {name: design_of(name) for name in head_names()}
    heads = {name: each for name, each in designs.items() if isinstance(each, DriverHead)}
    paper = case("paper")
    return {
        "balls": {
            name: {
                "friction": each.friction,
                "pieces": [piece.name for piece in each.pieces],
                "meshes": {"coarse": meshed_ball(coarser(each)), "fine": meshed_ball(each)},
            }
            for name, each in balls.items()
        },
        "heads": {
            name: {
                "label": each.name,
                "values": {"driver": each.values()},
                "columns": finite({key: value for key, value in each.mesh().club.inputs().items() if key != "hand"}),
                "elements": each.mesh().elements,
            }
            for name, each in heads.items()
        },
        "runs": {
            "contact": replace(HOW, duration=SHOWN, frames=FRAMES, threads=1).values(),
            "millisecond": fem.Settings(frames=MILLISECOND_FRAMES, threads=1).values(),
        },
        "safeties": list(SAFETIES),
        "limits": {
            "friction": FRICTION_LIMITS,
            **{
                name: [units.to_si(each, kind.unit) for each in (kind.lower or 0.0, kind.upper or 0.0)]
                for name, kind in (("thrown_speed", THROW_SPEED), ("thrown_angle", THROW_ANGLE))
            },
        },
        "cases": {
            "paper": {
                "label": "Roh and Lee",
                "ball": "paper",
                "against": "paper",
                "friction": paper.friction,
                "delivery": dict(paper.delivery),
            },
            "reference": {
                "label": "Reference case",
                "ball": "reference",
                "against": "plane",
                "friction": REFERENCE_FRICTION,
                "delivery": {"speed": REFERENCE_SPEED, "loft": ANGLE},
            },
        },
    }


def description() -> dict[str, Any]:
    """Return the description of the core."""

    def plain(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: plain(item) for key, item in value.items()}
        if isinstance(value, list | tuple):
            return [plain(item) for item in value]
        return None if isinstance(value, float) and not math.isfinite(value) else value

    return {name: plain(getattr(_core, name)()) for name in DESCRIBED}


def main(folder: str) -> None:
    """Write both files into a folder."""
    warnings.simplefilter("ignore", RuleWarning)
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    for name, data in (("equipment", equipment_data()), ("description", description())):
        text = json.dumps(data, ensure_ascii=False, allow_nan=False, separators=(",", ":"))
        (target / f"{name}.json").write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
