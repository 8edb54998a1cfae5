"""Finding columns whose sign disagrees with the others, such as attack angles counted positive downwards.

From shot to shot, launch depends on delivery in ways no model disputes: more loft launches the ball higher, a face to
the right starts it to the right, a path to the right makes it curve to the left. A column with a clearly opposite
trend, in contradiction to the other columns, most likely has the wrong sign. A note says so; values are not changed.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.equipment.described import HANDS
from clubface.results.notes import Note, note
from clubface.shots.club_names import club_kind
from clubface.shots.recorded import RecordedShots
from clubface.units import to_si

CLEARLY = 4.0
"""Number of standard errors by which a slope must have the wrong sign; by chance one column in 30,000 does."""
FEWEST = 8
"""Minimum number of shots beyond the number of slopes, for reliable standard errors."""
UPWARDS = to_si(2.5, "deg")
"""Upper limit of a plausible median attack angle with irons; tour players hit down by 2 to 5 deg on average."""
FEWEST_IRONS = 5
_ACROSS = ("azimuth", "sidespin", "spin_axis", "face", "path")
"""Quantities mirrored for left-handers."""


class SignRule(NamedTuple):
    """How a launch quantity depends on delivery quantities."""

    launch: str
    signs: Mapping[str, int]  # of its slopes; 0 where they differ from club to club
    needed: tuple[str, ...]  # must have been measured


RULES = (
    SignRule("launch", {"loft": 1, "attack": 1, "high": 0}, ("attack",)),
    SignRule("backspin", {"loft": 1, "attack": -1, "speed": 1, "high": 0}, ("loft", "attack")),
    SignRule("azimuth", {"face": 1, "path": 1, "toe": 0}, ("face",)),
    SignRule("spin_axis", {"face": 1, "path": -1, "toe": -1}, ("face", "path")),
)
"""Launch angle lies between attack angle and loft, azimuth between path and face. Spin comes from the angle between
path and face, and an impact towards the toe makes the ball curve towards the heel side (gear effect)."""


def suspected_signs(shots: RecordedShots) -> tuple[Note, ...]:
    """Return a note for each column whose sign disagrees with the others."""
    clubs = np.array([club_kind(str(each)) or str(each) for each in shots.clubs]) if shots.clubs is not None else None
    suspects: dict[str, list[str]] = {}
    for rule in RULES:
        for name, other in _disagreeing(shots, clubs, rule).items():
            suspects.setdefault(name, []).extend(other)
    notes = [
        note("sign-turned" if len(others) > 1 else "sign-one-turned", quantity=name, others=others)
        for name, others in suspects.items()
    ]
    if "attack" not in suspects:
        notes += _upward_irons(shots, clubs)
    return tuple(notes)


def _disagreeing(shots: RecordedShots, clubs: NDArray[np.str_] | None, rule: SignRule) -> dict[str, list[str]]:
    """Return the columns that contradict a rule, each with the columns that reveal it."""
    values = {
        name: each
        for name in (rule.launch, *rule.signs)
        if (each := _for_a_right_hander(shots, name)) is not None and np.isfinite(each).sum() >= FEWEST
    }
    names = [name for name in rule.signs if name in values]
    if not {rule.launch, *rule.needed} <= set(values):
        return {}
    table = np.column_stack([values[name] for name in (rule.launch, *names)])
    known = np.isfinite(table).all(axis=1)
    table, groups = table[known], clubs[known] if clubs is not None else None
    slopes = _slopes(table, groups)
    if slopes is None:
        return {}
    signs = {name: rule.signs[name] for name in names if rule.signs[name]}
    wrong = [name for name in signs if signs[name] * slopes[names.index(name)] < -CLEARLY]
    if len(wrong) == len(signs) > 1:
        return {rule.launch: wrong}
    return {name: [rule.launch] for name in wrong}


def _slopes(table: NDArray[np.float64], groups: NDArray[np.str_] | None) -> NDArray[np.float64] | None:
    """Return the slopes of the first column over the others within clubs, in standard errors; None for few shots."""
    labels = np.unique(groups, return_inverse=True)[1] if groups is not None else np.zeros(len(table), dtype=int)
    count = int(labels.max(initial=-1)) + 1
    free = len(table) - count - (table.shape[1] - 1)
    if free < FEWEST:
        return None
    sums = np.zeros((count, table.shape[1]))
    np.add.at(sums, labels, table)
    within = table - (sums / np.bincount(labels)[:, None])[labels]
    launch, delivery = within[:, 0], within[:, 1:]
    scale = np.linalg.norm(delivery, axis=0)
    if not scale.all():
        return None
    slopes, _, rank, _ = np.linalg.lstsq(delivery / scale, launch, rcond=1e-6)
    if rank < delivery.shape[1]:
        return None
    spread = np.sum((launch - delivery / scale @ slopes) ** 2) / free
    errors = np.sqrt(spread * np.diag(np.linalg.inv((delivery / scale).T @ (delivery / scale))))
    return slopes / np.maximum(errors, 1e-300)


def _for_a_right_hander(shots: RecordedShots, name: str) -> NDArray[np.float64] | None:
    values = (shots.deliveries | shots.launches).get(name)
    if values is None or name not in _ACROSS or shots.hand is None:
        return values
    return values * np.array([float(HANDS[each]) for each in shots.hand])


def _upward_irons(shots: RecordedShots, clubs: NDArray[np.str_] | None) -> list[Note]:
    """Return a note if the file has irons and wedges hit upwards."""
    if clubs is None or "attack" not in shots.deliveries:
        return []
    attack = shots.deliveries["attack"][[each.endswith(("-iron", "-wedge")) for each in clubs]]
    attack = attack[np.isfinite(attack)]
    if attack.size < FEWEST_IRONS or np.median(attack) <= UPWARDS:
        return []
    return [note("irons-hit-upwards", attack=float(np.median(attack)))]
