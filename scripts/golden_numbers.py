"""Write tests/golden: numbers that Rust, Python, the command line and the studio must compute alike.

Each case has the text of the studio's link, whose keys and values are those of the options of the command line; what
comes of it in SI, as the core takes it; and every number that the package computes, by name. The tests of Rust take the
inputs of the core through the C interface, those of Python the options of the command line, those of the studio the
inputs in WebAssembly and the links in a browser. ``make golden`` writes the files again after a change of physics,
clubs, balls, golfers or parameters that is meant.

``shots.json`` has shots drawn at random with a fixed seed; the other links are those of ``golden_links.toml``.
``flights.json`` has shots in wind, other air and on other grounds, ``maps.json`` maps of faces, ``dispersions.json``
shots of golfers, ``elements.json`` impacts by finite elements, and ``tolerance.json`` when two numbers are the same.

A name of a number begins with the quantity that it is of: ``carry``, ``carry mean``, ``toe ball_speed`` (how far
towards the toe the ball speed is greatest).
"""

from __future__ import annotations

import json
import math
import random
import tomllib
import warnings
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import clubface
from clubface import _core, fem, units
from clubface.design.face_map import SHARE, FaceMap
from clubface.design.golfer import MIRRORED, golfer
from clubface.design.strokes import AT_REST, as_lists
from clubface.equipment.clubs import club
from clubface.errors import RangeWarning, RuleWarning
from clubface.fem.backend import HOW
from clubface.fem.impact_result import CONTACT
from clubface.fem.run import case, face_of, inputs_of, one_shot
from clubface.simulation.flight import conditions as flight_conditions
from clubface.simulation.launch import Launch
from clubface.simulation.results import flight_inputs, inputs
from clubface.support.files import builtin_names
from clubface.units import from_si
from clubface.validation.tour import averages

TARGET = Path(__file__).parents[1] / "tests/golden"
LINKS = Path(__file__).with_name("golden_links.toml")
TOLERANCE = {
    "relative": 1e-12,
    "scales": {
        **dict.fromkeys(("carry", "side", "total", "total_side", "curve", "backspin", "sidespin"), 100.0),
        **dict.fromkeys(("launch", "azimuth", "landing_angle", "spin_axis", "energy_error", "missed"), 1.0),
        **dict.fromkeys(("velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z"), 100.0),
        **{f"club_{each}_{axis}": 100.0 for each in ("velocity", "spin") for axis in "xyz"},
        **dict.fromkeys(("ball_speed", "normal_velocity", "tangential_velocity"), 50.0),
        **dict.fromkeys(("tangential_max", "tangential_min"), 1e4),
        **dict.fromkeys(("toe", "high"), 0.05),
    },
}
"""Two numbers are the same if they differ by no more than a share of the greater of their size and a scale [SI].

The share is what is left of the last bits of numbers: of logarithms and powers, which come from the library of the
machine, of products and sums that a machine fuses, and of units to and fro. A number with a scale is a component, or a
difference of larger numbers: those lose their last bits, not it.
"""

SHOTS = 200
CHOICES = ("model", "ball", "hand")
"""What a link gives in addition to the club and the delivery."""
CONDITIONS = ("wind", "wind_from", "altitude", "temperature", "humidity", "pressure", "ground")
SPREADS = {
    "path": (4.0, 1, "deg"), "face": (3.0, 1, "deg"), "lie": (2.0, 1, "deg"), "toe": (8.0, 1, "mm"),
    "high": (5.0, 1, "mm"), "closure": (1500.0, 0, "deg/s"), "pitch_rate": (300.0, 0, "deg/s"),
}  # fmt: skip
"""Standard deviation, digits and unit of what about half of the shots say of the delivery."""
GRID = 41
"""Points of a map along each side."""
STEP = 5
"""Of these the first and every fifth after it are kept."""
BEST = ("ball_speed", "carry")
"""What is greatest somewhere on a face."""
SCATTERED = ("ball_speed", "launch", "backspin", "sidespin", "azimuth", "carry", "side", "total")
"""Quantities of which a map says what scattered impacts cost."""
COUNT = 4096
PERCENTILES, ELLIPSES = (0.05, 0.25, 0.5, 0.75, 0.95), (0.5, 0.9)

Link = dict[str, str]


def parsed(text: str) -> Link:
    """Return keys and values of a link."""
    return dict(part.split("=", 1) for part in text.split("&"))


def split(link: Link, *settings: str) -> tuple[Link, Link, Link]:
    """Return what a link says of model, ball and hand, of the delivery, and of air, wind and ground."""
    chosen, given = ({key: link[key] for key in keys if key in link} for keys in (CHOICES, CONDITIONS))
    delivery = {key: text for key, text in link.items() if key not in ("club", *CHOICES, *CONDITIONS, *settings)}
    return chosen, delivery, given


def conditions(given: Link) -> dict[str, Any]:
    """Return air, wind and ground as the package takes them; a link says where the wind comes from."""
    air = {key: given[key] for key in ("altitude", "temperature", "humidity", "pressure") if key in given}
    wind = None
    if "wind" in given:
        speed, from_ = units.parse(given["wind"], "speed"), units.parse(given["wind_from"], "angle")
        wind = (-speed * math.cos(from_), 0.0, -speed * math.sin(from_))
    return {"air": air, "wind": wind, "ground": given.get("ground")}


def finite(values: Mapping[str, float]) -> dict[str, float]:
    """Return the values that are numbers."""
    return {name: float(value) for name, value in values.items() if math.isfinite(value)}


def as_listed(values: Iterable[float]) -> list[float | None]:
    """Return values as JSON has them."""
    return [float(value) if math.isfinite(value) else None for value in values]


# --- Shots and flights ------------------------------------------------------------------------------------------------


def drawn(rng: random.Random) -> Link:
    """Return a link at random, by key: an ordinary strike by any club, ball, model and hand."""
    name = rng.choice(builtin_names("clubs"))
    each = club(name)
    near = min(averages(), key=lambda row: (club(row.club).kind == "iron") != (each.kind == "iron"))
    speed = float(from_si(near.club_speed, "mph")) * rng.uniform(0.7, 1.15)
    metric = rng.random() < 0.3
    link = {
        "club": name,
        "model": rng.choice([entry["name"] for entry in _core.models()]),
        "ball": rng.choice(builtin_names("balls")),
        "speed": f"{speed * 0.44704:.1f}m/s" if metric else f"{speed:.1f}mph",
        "attack": f"{rng.gauss(0.0, 3.0):.1f}deg",
    }
    if rng.random() < 0.3:
        link["hand"] = "left"
    if rng.random() < 0.7:
        link["loft"] = f"{from_si(each.loft, 'deg') + rng.gauss(0.0, 2.5):.1f}deg"
    for key, (spread, digits, unit) in SPREADS.items():
        if rng.random() < 0.5:
            link[key] = f"{rng.gauss(0.0, spread):.{digits}f}{unit}"
    return link


def shot(link: Link) -> dict[str, Any] | None:
    """Return inputs, parameters and every number [SI] of the shot of a link; None where it has no flight."""
    chosen, values, given = split(link)
    about = conditions(given)
    try:
        launch = clubface.impact(club(link["club"]), **chosen, **values)
        flight = clubface.fly(launch, **about)
    except clubface.ClubfaceError:
        return None
    taken = {name: float(launch.input(name)) for name in inputs()}
    numbers = {entry["name"]: float(launch.get(entry["name"])) for entry in _core.outputs()}
    numbers |= {entry["name"]: float(flight.get(entry["name"])) for entry in _core.flight_outputs()}
    delivery = {name: taken.pop(name) for name, entry in inputs().items() if entry.group == "delivery"}
    return {
        "link": link,
        "model": launch.model,
        "delivery": delivery,
        "equipment": {name: None if math.isinf(value) else value for name, value in taken.items()},
        "parameters": launch.parameters.columns(),
        **({"conditions": flight_conditions(**about)} if given else {}),
        "numbers": finite(numbers),
    }


def shots_at_random() -> Iterable[dict[str, Any]]:
    """Yield shots that fly."""
    rng, count = random.Random(1), 0
    while count < SHOTS:
        if (made := shot(drawn(rng))) is not None:
            count += 1
            yield made


def shots(made: Iterable[Any]) -> dict[str, Any]:
    """Return shots; inputs that do not belong to the delivery, and parameters, are those of many: written once."""
    lists: dict[str, list[Any]] = {"equipment": [], "parameters": []}
    cases = []
    for each in made:
        for name, list_ in lists.items():
            if each[name] not in list_:
                list_.append(each[name])
            each[name] = list_.index(each[name])
        cases.append(each)
    return {**lists, "cases": cases}


# --- Maps and dispersions ---------------------------------------------------------------------------------------------


def described(launch: Launch, about: Mapping[str, Any]) -> dict[str, Any]:
    """Return a strike and its flights as the core takes them; null is infinite, or is what each shot replaces."""
    flight = {name: each.default for name, each in flight_inputs().items()} | flight_conditions(**about)
    ball = {name: launch.input(name) for name, each in flight_inputs().items() if each.group == "ball"}
    return {
        "model": launch.model,
        "inputs": as_listed(launch.input(name) for name in inputs()),
        "parameters": launch.parameters.columns(),
        "flight": as_listed((flight | ball).values()),
    }


def face_map(link: Link) -> dict[str, Any]:
    """Return the map of a link: of each club what the core takes and its numbers, and the values at some points."""
    chosen, delivery, given = split(link, "map", "map_minus", "strikes_toe", "strikes_high")
    about, spread = conditions(given), (link["strikes_toe"], link["strikes_high"])
    hand = chosen.pop("hand", "right")
    maps: list[FaceMap] = []
    for name in (link[key] for key in ("club", "map_minus") if key in link):
        places: dict[str, Any] = {"points": (maps[0].toe, maps[0].high)} if maps else {"grid": (GRID, GRID)}
        maps.append(clubface.map_face(club(name).replace(hand=hand), delivery, **chosen, **about, **places))
    mapped = maps[0] if len(maps) == 1 else clubface.FaceMapDifference(*maps)
    values = mapped.get(link["map"])[::STEP, ::STEP]
    places = {"points": [maps[0].toe.tolist(), maps[0].high.tolist()]}
    return {
        "link": link,
        "step": STEP,
        "toe": maps[0].toe[::STEP].tolist(),
        "high": maps[0].high[::STEP].tolist(),
        "values": [as_listed(row) for row in values],
        "faces": [
            {
                "setup": {
                    **described(each.centre, about),
                    "outline": each.outline.corners.tolist(),
                    **(places if place else {"grid": [GRID, GRID]}),
                    "best": BEST,
                    "share": SHARE,
                    "scatter": {"deviations": [units.parse(text, "length") for text in spread]},
                },
                "numbers": face_numbers(each, spread),
            }
            for place, each in enumerate(maps)
        ],
    }


def face_numbers(mapped: FaceMap, spread: tuple[str, str]) -> dict[str, float]:
    """Return what is known of a face as a whole."""
    costs = mapped.forgiveness(spread)
    numbers = {"face_area": mapped.outline.area(), "effective_area": mapped.area(), "missed": costs.missed}
    for name in BEST:
        best = mapped.best(name)
        numbers |= {f"{name} greatest": best.value, f"toe {name}": best.toe, f"high {name}": best.high}
    for name in SCATTERED:
        for kind in ("mean", "deviation", "loss"):
            numbers[f"{name} {kind}"] = getattr(costs, kind)[name]
    return finite(numbers)


def dispersion(link: Link) -> dict[str, Any]:
    """Return what the core takes of a golfer on a hole, and where the shots go."""
    about = conditions(split(link)[2])
    player = golfer(link["golfer"])
    hole = clubface.Hole(length=link["hole"])
    done = clubface.dispersion(
        player, club(player.club).replace(hand=link["hand"]), count=COUNT, hole=hole, seed=0, **about
    )
    player = done.golfer
    numbers = {"shots": done.count, "lost": done.lost, "strokes": done.strokes}
    numbers |= {f"share {lie}": share for lie, share in done.lies.items()}
    for name in done.quantities:
        numbers |= {f"{name} mean": done.mean(name), f"{name} spread": done.spread(name)}
        numbers |= {f"{name} {share}": done.quantile(name, share) for share in PERCENTILES}
    for share in ELLIPSES:
        ellipse = done.ellipse(share)
        numbers |= dict(zip((f"carry centre {share}", f"side centre {share}"), ellipse.centre, strict=True))
        numbers |= dict(zip((f"carry long {share}", f"carry short {share}"), ellipse.half_axes, strict=True))
        numbers[f"azimuth ellipse {share}"] = ellipse.angle
    return {
        "link": link,
        "count": COUNT,
        "setup": {
            **described(done.mean_launch, about),
            "golfer": {
                "variables": player.variables,
                "mean": player.mean.tolist(),
                "covariance": player.covariance.tolist(),
                "mirrored": [name for name in MIRRORED if player.hand < 0 and name in player.variables],
                "mishit_share": player.mishit_share,
                "mishit_scale": player.mishit_scale,
            },
            "hole": {
                **{name: getattr(hole, name) for name in ("length", "fairway", "rough", "green")},
                "tables": [dict(zip(("distance", "strokes"), as_lists(lie), strict=True)) for lie in AT_REST],
            },
            "seed": 0,
            "percentiles": PERCENTILES,
            "ellipses": ELLIPSES,
        },
        "numbers": finite(numbers),
    }


# --- Finite elements --------------------------------------------------------------------------------------------------


def impact_by_elements(link: Link) -> dict[str, Any]:
    """Return an impact by finite elements: what the core takes, and its numbers."""
    ball = fem.ball(link["ball"])
    if link["against"] == "plane":
        impact = fem.throw(ball, speed=link["speed"], angle=link["loft"], friction=float(link["friction"]))
        face, how = {"plane": impact.given}, fem.Settings()
    else:
        delivery = split(link, "against", "follow")[1]
        struck = one_shot(link["club"], delivery, ball)
        impact = fem.strike(link["club"], delivery, ball=ball, settings=HOW)
        face, how = face_of(None, struck.club, inputs_of(struck)), HOW
    values = {name: float(getattr(impact, name)) for name in (*CONTACT, "energy_error", "steps")}
    return {
        "link": link,
        "setup": case(ball, face, impact.friction, how),
        "numbers": finite(impact.outcome() | values),
    }


def main() -> None:
    """Write the files."""
    warnings.simplefilter("ignore", RangeWarning)
    warnings.simplefilter("ignore", RuleWarning)
    links = {name: list(map(parsed, texts)) for name, texts in tomllib.loads(LINKS.read_text("utf-8")).items()}
    files = {
        "shots": shots(shots_at_random()),
        "flights": shots(map(shot, links["flights"])),
        "maps": {"cases": list(map(face_map, links["maps"]))},
        "dispersions": {"cases": list(map(dispersion, links["dispersions"]))},
        "elements": {"cases": list(map(impact_by_elements, links["elements"]))},
    }
    TARGET.mkdir(exist_ok=True)
    for name, made in files.items():
        lists = (f'"{key}": [\n' + ",\n".join(map(json.dumps, each)) + "\n]" for key, each in made.items())
        (TARGET / f"{name}.json").write_text("{\n" + ",\n".join(lists) + "\n}\n", encoding="utf-8")
    (TARGET / "tolerance.json").write_text(json.dumps(TOLERANCE, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
