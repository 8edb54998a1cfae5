"""Write tests/golden/shots.json: shots that Rust, Python, the command line and the studio must compute alike.

Each shot has the text of the studio's link, whose keys and values are those of the options of ``clubface shot``, and
what comes of it in SI: the inputs and parameters as the core takes them, and every number of launch and flight. The
inputs that do not belong to the delivery, and the parameters, are the same for many shots; they stand once. The shots
are drawn at random with a fixed seed. ``make golden-shots`` writes the file again after a change of physics, clubs,
balls or parameters that is meant.
"""

from __future__ import annotations

import json
import math
import random
import warnings
from pathlib import Path
from typing import Any

import clubface
from clubface import _core
from clubface.equipment.clubs import club
from clubface.errors import RangeWarning, RuleWarning
from clubface.simulation.results import inputs
from clubface.support.files import builtin_names
from clubface.units import from_si
from clubface.validation.tour import averages

TARGET = Path(__file__).parents[1] / "tests/golden/shots.json"
COUNT = 200
CHOICES = ("model", "ball", "hand")
"""What a link says besides the club and the delivery."""
SPREADS = {
    "path": (4.0, 1, "deg"), "face": (3.0, 1, "deg"), "lie": (2.0, 1, "deg"), "toe": (8.0, 1, "mm"),
    "high": (5.0, 1, "mm"), "closure": (1500.0, 0, "deg/s"), "pitch_rate": (300.0, 0, "deg/s"),
}  # fmt: skip
"""Standard deviation, digits and unit of what about half of the shots say of the delivery."""


def drawn(rng: random.Random) -> dict[str, str]:
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


def computed(link: dict[str, str]) -> dict[str, Any] | None:
    """Return inputs, parameters and every number [SI] of the shot of a link; None where it has no flight."""
    values = {key: text for key, text in link.items() if key not in ("club", *CHOICES)}
    chosen = {key: link[key] for key in CHOICES if key in link}
    head = club(link["club"])
    try:
        launch = clubface.impact(head, **chosen, **values)
        flight = clubface.fly(launch)
    except clubface.ClubfaceError:
        return None
    taken = {name: float(launch.input(name)) for name in inputs()}
    numbers = {entry["name"]: float(launch.get(entry["name"])) for entry in _core.outputs()}
    numbers |= {entry["name"]: float(flight.get(entry["name"])) for entry in _core.flight_outputs()}
    delivery = {name: taken.pop(name) for name, entry in inputs().items() if entry.group == "delivery"}
    return {
        "delivery": delivery,
        "equipment": {name: None if math.isinf(value) else value for name, value in taken.items()},
        "parameters": launch.parameters.columns(),
        "numbers": {name: value for name, value in numbers.items() if math.isfinite(value)},
    }


def golden_shots() -> dict[str, Any]:
    """Return the content of the file."""
    rng = random.Random(1)
    equipment: list[dict[str, Any]] = []
    parameters: list[list[float]] = []
    shots = []

    def place(list_: list[Any], value: Any) -> int:
        if value not in list_:
            list_.append(value)
        return list_.index(value)

    while len(shots) < COUNT:
        link = drawn(rng)
        if (made := computed(link)) is None:
            continue
        shots.append({
            "link": link, "delivery": made["delivery"], "equipment": place(equipment, made["equipment"]),
            "parameters": place(parameters, made["parameters"]), "numbers": made["numbers"],
        })  # fmt: skip
    return {"equipment": equipment, "parameters": parameters, "shots": shots}


def main() -> None:
    """Write the file."""
    warnings.simplefilter("ignore", RangeWarning)
    warnings.simplefilter("ignore", RuleWarning)
    made = golden_shots()
    lists = (f'"{name}": [\n' + ",\n".join(map(json.dumps, each)) + "\n]" for name, each in made.items())
    TARGET.parent.mkdir(exist_ok=True)
    TARGET.write_text("{\n" + ",\n".join(lists) + "\n}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
