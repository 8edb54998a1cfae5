"""The numbers the benchmark shots are made with, read from their file."""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.models import model
from clubface.simulation.quantities import input_dimensions, outputs
from clubface.support.arrays import Floats
from clubface.support.shipped import DATA
from clubface.support.strict_toml import Document

FOLDER = DATA / "benchmark"
HEADS = {"driver": "driver-as-printed", "7-iron": "7-iron"}
"""The built-in heads that hit the shots of the two clubs, those of the publication."""
CLUBS = tuple(HEADS)


class Spread(NamedTuple):
    """How one quantity of a delivery varies, SI.

    Attributes
    ----------
    mean
        Over all players.
    between
        Standard deviation of the players' means.
    within
        Standard deviation of the shots of one player.
    """

    mean: float
    between: float
    within: float


class Part(NamedTuple):
    """One model of the mixture.

    Attributes
    ----------
    restitution
        At the face centre and the speed the recipe names.
    changed
        Parameters other than the published ones, SI.
    """

    restitution: float
    changed: dict[str, float]


class Recipe(NamedTuple):
    """Everything that decides the shots of one club; SI."""

    club: str
    head: str
    seed: tuple[int, int]
    shots: int
    players: int
    slowest: float
    fastest: float
    swing_plane: float
    delivery: dict[str, Spread]
    follows: dict[str, tuple[str, float]]
    mixture: dict[str, Part]
    restitution_at: float
    restitution_slope: float
    ball_scatter: float
    flex_drop: float
    flex_radius: float
    shaft_mass: float
    hosel: Floats
    frame: float
    arc_radius: float
    position_noise: float
    attitude_noise: float
    time_noise: float
    growth: dict[str, tuple[float, float]]
    monitor: dict[str, float]


@cache
def recipe(club: str) -> Recipe:
    """Return the recipe of ``club``, "driver" or "7-iron"."""
    data = Document.read(FOLDER / "recipe.toml").data
    own, effects, capture = data[club], data["effects"], data["capture"]
    return Recipe(
        club=club,
        head=HEADS[club],
        seed=(data["seed"], CLUBS.index(club)),
        shots=own["shots"],
        players=own["players"],
        slowest=units.parse(own["slowest"], "speed"),
        fastest=units.parse(own["fastest"], "speed"),
        swing_plane=units.parse(own["swing_plane"], "angle"),
        delivery={name: _spread(name, texts) for name, texts in own["delivery"].items()},
        follows={
            "face": ("path", data["correlations"]["face_with_path"]),
            "loft": ("attack", data["correlations"]["loft_with_attack"]),
        },
        mixture={name: _part(name, texts) for name, texts in data["mixture"][club].items()},
        restitution_at=units.parse(data["restitution"][club]["at"], "speed"),
        restitution_slope=units.parse(data["restitution"]["slope"], "inverse speed"),
        ball_scatter=float(effects["ball_scatter"]),
        flex_drop=float(effects["flex_drop"]),
        flex_radius=units.parse(effects["flex_radius"], "length"),
        shaft_mass=units.parse(effects["shaft_mass"], "mass"),
        hosel=np.array([units.parse(text, "length") for text in effects[f"{club.split('-')[-1]}_hosel"]]),
        frame=1.0 / float(capture["frame_rate"]),
        arc_radius=units.parse(capture["arc_radius"], "length"),
        position_noise=units.parse(capture["position_noise"], "length"),
        attitude_noise=units.parse(capture["attitude_noise"], "angle"),
        time_noise=units.parse(capture["time_noise"], "time"),
        growth={
            rate: (float(capture[name][0]), float(capture[name][1]))
            for rate, name in (
                ("closure", "closure_growth"),
                ("pitch_rate", "pitch_growth"),
                ("lie_rate", "lie_growth"),
            )
        },
        monitor={name: units.parse(text, outputs()[name].dimension) for name, text in data["monitor"].items()},
    )


def _spread(name: str, texts: list[str]) -> Spread:
    return Spread(*(units.parse(text, input_dimensions()[name], name=name) for text in texts))


def _part(name: str, texts: dict[str, Any]) -> Part:
    declared = model(name)
    changed = {
        key: units.parse(text, units.unit(declared.parameter(key).unit).dimension, name=key)
        for key, text in texts.items()
        if key != "restitution"
    }
    return Part(float(texts["restitution"]), changed)
