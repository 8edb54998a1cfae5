"""Statistics of one club for a report: medians and spreads, mishits, and inferences of the models."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.clubs import TOUR_CLUBS, Club, club as club_named
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import RangeWarning
from clubface.inference.prior import UnreachableLaunchError
from clubface.inference.run import Inference
from clubface.shots.club_names import club_kind
from clubface.shots.measured import QUANTITIES
from clubface.shots.mishits import Mishit, Statistic, find_mishits, is_mishit, statistic
from clubface.shots.recorded import RecordedShots
from clubface.shots.reference_points import refer
from clubface.simulation.flight import fly
from clubface.simulation.inputs import OF_CLUB, hand_value
from clubface.simulation.launch import Launch
from clubface.simulation.sensitivity import sensitivity
from clubface.simulation.shot_shape import curve, shot_shape
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings

MOST_INFERRED, SAMPLES = 60, 200
"""Maximum number of shots of a club with inferred deliveries, spread evenly over all, and draws for each."""
IN_ALL, FEWEST_INFERRED = 1200, 4
"""Maximum number of inferred shots in a report, and minimum per club if there are many clubs."""
CHANGES = {
    "speed": "1 mph", "attack": "1 deg", "loft": "1 deg", "face": "1 deg", "path": "1 deg", "toe": "5 mm",
    "high": "5 mm",
}  # fmt: skip
"""Changes of the what-if and their sizes."""
LAUNCHED = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")


@dataclass(frozen=True, kw_only=True)
class Inferred:
    """Deliveries of a club inferred from its launches, without mishits, SI.

    The ``doubt`` of a quantity is its standard deviation for a single shot; more shots do not reduce the part that
    comes from the prior.
    """

    mean: dict[str, float]  # of each delivery quantity over the shots
    doubt: dict[str, float]
    shots: int
    refused: int  # number of shots that no delivery can produce
    remarked: tuple[int, ...]  # rows of shots with inconsistent values


@dataclass(frozen=True, kw_only=True)
class DeliveryEffect:
    """Effect of a change of the delivery on launch, carry and side of the mean shot, SI."""

    name: str
    step: float
    launch: dict[str, float]
    carry: float
    side: float


@dataclass(frozen=True, kw_only=True)
class ClubStatistics:
    """All statistics of one club; those by a model are None or empty without a built-in club or launch.

    ``measured`` holds those of launch, flight and delivery by quantity, and the curve if start direction, carry and
    side are known. ``closing`` is the first-order contribution of the closure rate to start line and sidespin.
    """

    name: str  # as in the file
    club: Club | None  # the built-in club that represents it
    shots: RecordedShots
    measured: dict[str, Statistic]
    mishits: list[Mishit]
    computed: bool  # whether carry and side were computed from the launch in still air instead of measured
    inferred: Inferred | None = None
    changes: tuple[DeliveryEffect, ...] = ()
    start: dict[str, float] = field(default_factory=dict)  # change of the start line by face and path [rad/rad]
    closing: dict[str, float] = field(default_factory=dict)  # [rad, rad/s]
    player: str = ""  # if the shots are of several players
    launch: Launch | None = None  # of the mean shot by the model, to which changes are added

    @property
    def title(self) -> str:
        """The name of the club, preceded by its player if there are several."""
        return f"{self.player}: {self.name}" if self.player else self.name

    @property
    def mishit(self) -> NDArray[np.bool_]:
        """Whether each shot is a mishit."""
        return is_mishit(self.mishits, len(self.shots))

    @property
    def shot_shape(self) -> str:
        """The name of the typical shot, such as "pull hook", or "" if start direction, carry or side is missing."""
        if "curve" not in self.measured:
            return ""
        typical = (self.measured[name].median for name in ("azimuth", "curve", "carry"))
        return shot_shape(*typical, hand=hand_value(_hand(self.shots)))


def club_statistics(shots: RecordedShots, name: str, clubs: int = 1) -> ClubStatistics:
    """Return the statistics of the club called ``name`` in the file, for a report on ``clubs`` clubs."""
    kind = club_kind(name)
    hand = _hand(shots)
    head = _head(kind, hand) if kind in TOUR_CLUBS else None
    if head is not None:
        shots = refer(shots, head)
    flown = with_computed_carry(shots)
    columns = {**flown.deliveries, **flown.launches}
    if {"azimuth", "carry", "side"} <= columns.keys():
        columns["curve"] = curve(columns["azimuth"], columns["carry"], columns["side"])
    mishits = find_mishits(columns)
    mask = is_mishit(mishits, len(shots))
    measured = {each: result for each, values in columns.items() if (result := statistic(values, mask)) is not None}
    plain = ClubStatistics(
        name=name, club=head, shots=shots, measured=measured, mishits=mishits, computed=flown is not shots
    )
    if head is None or "ball_speed" not in measured or "launch" not in measured:
        return plain
    most = min(MOST_INFERRED, max(FEWEST_INFERRED, IN_ALL // clubs))
    prepared = _inference(kind, hand, shots.speed_at, shots.face_at)
    result = _infer_deliveries(shots, np.flatnonzero(~mask), prepared, most)
    if result is None:
        return plain
    launch, changes, start, closing = _changes(head, result.mean)
    return replace(plain, inferred=result, changes=changes, start=start, closing=closing, launch=launch)


def with_computed_carry(shots: RecordedShots) -> RecordedShots:
    """Return the shots with carry and side computed from the launch in still air, or unchanged if carry is known."""
    if "carry" in shots.launches or not all(each in shots.launches for each in LAUNCHED):
        return shots
    return replace(shots, launches=shots.launches | _carry_and_side({each: shots.launches[each] for each in LAUNCHED}))


def _hand(shots: RecordedShots) -> str:
    """Return the hand of the player, right if unknown."""
    return "left" if shots.hand is not None and set(shots.hand) == {"left"} else "right"


@cache
def _head(kind: str, hand: str) -> Club:
    """Return a built-in club, cached for reports on many players."""
    head = club_named(kind)
    return head.replace(hand="left") if hand == "left" else head


@cache
def _inference(kind: str, hand: str, speed_at: str, face_at: str) -> Inference:
    """Return the inference shared by all players with this kind of club."""
    head = _head(kind, hand)
    return Inference(club=head, prior="wide", samples=SAMPLES, threads=1, speed_at=speed_at, face_at=face_at)


def _infer_deliveries(
    shots: RecordedShots, chosen: NDArray[np.intp], prepared: Inference, most: int
) -> Inferred | None:
    """Return the inferred deliveries of at most ``most`` of the ``chosen`` shots."""
    places = chosen[np.unique(np.linspace(0, len(chosen) - 1, most).round().astype(int))]
    means, doubts, refused, remarked = [], [], 0, []
    for place in places:
        launch = _values_at(shots.launches, QUANTITIES, place)
        if not {"ball_speed", "launch"} <= set(launch):
            continue
        try:
            result = prepared.of(launch, _values_at(shots.deliveries, OF_CLUB, place))
        except UnreachableLaunchError:
            refused += 1
            continue
        means.append({**result.mean, **result.known})
        doubts.append(result.deviation)
        if result.warnings:
            remarked.append(int(shots.rows[place]))
    if not means:
        return None
    return Inferred(
        mean={name: float(np.mean([each[name] for each in means])) for name in means[0]},
        doubt={name: float(np.mean([each[name] for each in doubts])) for name in doubts[0]},
        shots=len(means),
        refused=refused,
        remarked=tuple(remarked),
    )


def _values_at(columns: dict[str, Floats], names: Any, place: int) -> dict[str, float]:
    return {name: each for name in names if name in columns and math.isfinite(each := float(columns[name][place]))}


def _changes(
    head: Club, delivery: dict[str, float]
) -> tuple[Launch, tuple[DeliveryEffect, ...], dict[str, float], dict[str, float]]:
    """Return the mean shot, effects of changes by exact derivatives, start line slopes, and effect of closure."""
    with without_warnings(RangeWarning):
        table = sensitivity(
            head, delivery, model=DEFAULT_MODEL, outputs=list(LAUNCHED), variables=[*CHANGES, "closure"]
        )
    base = {name: float(getattr(table.launch, name)) for name in LAUNCHED}
    before = _carry_and_side({name: np.array([value]) for name, value in base.items()})
    result = []
    for name, text in CHANGES.items():
        step = units.parse(text, OF_CLUB[name])
        moved = {each: table.value(each, name) * step for each in LAUNCHED}
        after = _carry_and_side({each: np.array([base[each] + moved[each]]) for each in LAUNCHED})
        carry, side = (float(after[each][0] - before[each][0]) for each in ("carry", "side"))
        result.append(DeliveryEffect(name=name, step=step, launch=moved, carry=carry, side=side))
    start = {name: table.value("azimuth", name) for name in ("face", "path")}
    closing = {name: table.value(name, "closure") * delivery["closure"] for name in ("azimuth", "sidespin")}
    return table.launch, tuple(result), start, closing


def _carry_and_side(launch: dict[str, Floats]) -> dict[str, Floats]:
    """Return carry and side of launches in still air at sea level; NaN where a value is missing."""
    known = np.all([np.isfinite(values) for values in launch.values()], axis=0)
    result = {name: np.full(known.shape, np.nan) for name in ("carry", "side")}
    if known.any():
        flight = fly({name: values[known] for name, values in launch.items()}, on_error="nan")
        for name in result:
            result[name][known] = getattr(flight, name)
    return result
