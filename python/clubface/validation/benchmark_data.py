"""Benchmark shots: 550 synthetic drives and 120 7-iron shots with known truth, as measured ones are not public.

Deliveries and launches look as motion capture and a launch monitor would report them; true deliveries, true launches
and the model behind each shot are given as well. ``recipe.toml`` holds every number that went into them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.models import model
from clubface.schema import Document
from clubface.shots.reading import read_shots
from clubface.shots.recorded import RecordedShots
from clubface.shots.tables.parquet import pyarrow_for
from clubface.simulation.results import input_dimensions, outputs
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice
from clubface.support.files import DATA

__all__ = ["BenchmarkShots", "MixtureComponent", "Recipe", "Spread", "load", "recipe"]

FOLDER = DATA / "benchmark"
HEADS = {"driver": "driver-as-printed", "7-iron": "7-iron"}
"""Built-in heads used for the two clubs, those of the publication."""
CLUBS = tuple(HEADS)


class Spread(NamedTuple):
    """Variation of one delivery quantity, in SI units."""

    mean: float  # over all players
    between: float  # standard deviation of the players' means
    within: float  # standard deviation of the shots of one player


class MixtureComponent(NamedTuple):
    """One model of the mixture."""

    restitution: float  # at the face centre and the speed given in the recipe
    changed: dict[str, float]  # parameters that differ from the published ones [SI]


class Recipe(NamedTuple):
    """Everything that determines the shots of one club, in SI units."""

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
    mixture: dict[str, MixtureComponent]
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
    """Return the recipe for ``club``, "driver" or "7-iron"."""
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


def _part(name: str, texts: dict[str, Any]) -> MixtureComponent:
    declared = model(name)
    changed = {
        key: units.parse(text, units.unit(declared.parameter(key).unit).dimension, name=key)
        for key, text in texts.items()
        if key != "restitution"
    }
    return MixtureComponent(float(texts["restitution"]), changed)


@dataclass(frozen=True, kw_only=True, eq=False)
class BenchmarkShots:
    """The benchmark shots of one club.

    Attributes
    ----------
    club
        "driver" or "7-iron".
    head
        The built-in head: "driver-as-printed" or "7-iron".
    measured
        Deliveries from motion capture and launches from a monitor, with errors.
    truth
        The true values of the same shots.
    player
        Number of each shot's player, from 1.
    model
        Name of the model behind each launch.
    restitution_offset
        Added to the model's restitution, for scatter of the ball and impact location.
    """

    club: str
    head: str
    measured: RecordedShots
    truth: RecordedShots
    player: NDArray[np.int64]
    model: NDArray[Any]
    restitution_offset: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.measured)

    def __repr__(self) -> str:
        return f"{len(self)} benchmark shots of the {self.club} by {len(set(self.player.tolist()))} players"


def load(club: str) -> BenchmarkShots:
    """Return the benchmark shots of ``club``, "driver" (550) or "7-iron" (120). Needs pyarrow."""
    check_choice("benchmark club", club, CLUBS)

    true_file = FOLDER / f"{club}-truth.parquet"
    extra_columns = pyarrow_for(true_file).parquet.read_table(
        true_file, columns=["player", "model", "restitution_offset"]
    )
    return BenchmarkShots(
        club=club,
        head=HEADS[club],
        measured=read_shots(FOLDER / f"{club}.parquet"),
        truth=read_shots(true_file),
        player=extra_columns["player"].to_numpy(),
        model=extra_columns["model"].to_numpy(),
        restitution_offset=extra_columns["restitution_offset"].to_numpy(),
    )
