"""One's own golfer from the shots of a launch monitor.

What counts is how a golfer's shots differ from each other at the moment of impact. A session also drifts, as the golfer
tires or works on something, and now and then comes a mishit. Therefore spreads and correlations come from the
differences of successive shots, in which a drift is all but gone (von Neumann, 1941), and shots are taken as a
:mod:`mixture <clubface.design.golfer.mixture>` with mishits. Rows that do not stand in the order of play have no drift
to take out: sorted ones would make the spreads far too small. They are put into a random order first.
"""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from clubface.design.golfer.golfer import Golfer
from clubface.design.golfer.golfers import golfer as golfer_named, golfers
from clubface.design.golfer.mixture import ENOUGH, covariance_of, error_of, mean_of, mixture, shrinkage
from clubface.equipment.clubs import Club
from clubface.equipment.described import HANDS
from clubface.errors import InputError, Told
from clubface.launch_monitor.formats import CG, FACE
from clubface.measured.ready import ReadyShots, ready_shots
from clubface.recorded.shots import RecordedShots
from clubface.simulation.delivery import OF_CLUB
from clubface.support.arrays import Floats

FEWEST = 6
"""Shots without which nothing is estimated: with six a spread is known to a factor of two either way in 19 of 20
sessions, exp(1.96 sqrt(3/4 / 6)) = 2.0."""
CONDITION = 1e6
"""Greatest ratio of the singular values of differences, each quantity in its spread: beyond, one of them follows from
the others."""
ZIGZAG = 3.5
"""Standard deviations by which successive shots differ more than shots apart in rows that are in no order of play. Of
n independent shots, half the mean square of successive differences over the variance is 1 to 1/sqrt(n) (von Neumann,
1941)."""
SORTED = 8
"""Different values from which on a column that only rises, or only falls, shows that rows are sorted; by chance 1 of
20,000 do."""


class Estimate(NamedTuple):
    """A golfer estimated from shots.

    Attributes
    ----------
    golfer
        The golfer.
    shots
        The number of shots used.
    measured
        The variables whose spread was measured; all others spread as those of ``like``.
    error
        Standard error of the spread of each measured variable [SI], shape (measured,). It holds in proportion: the
        spread lies within a factor of exp(1.96 error / spread) either way in about 19 of 20 sessions. Not knowing how
        many mishits there are is part of it.
    drift
        Standard deviation about the session's mean over that from successive differences, by variable: well above 1
        where the session drifted, well below 1 where the rows do not stand in the order of play, shape (measured,).
    shrinkage
        Share by which correlations were drawn towards zero, 0 to 1 (Ledoit and Wolf, 2004): the more, the fewer shots.
    like
        The shipped golfer that has what was not measured.
    notes
        What a reader should know.
    """

    golfer: Golfer
    shots: int
    measured: tuple[str, ...]
    error: Floats
    drift: Floats
    shrinkage: float
    like: str
    notes: tuple[str, ...]

    def __repr__(self) -> str:
        return f"estimated from {self.shots} shots; measured: {', '.join(self.measured)}\n{self.golfer}"


def estimate_golfer(
    shots: RecordedShots | str | os.PathLike[str],
    *,
    name: str = "my golfer",
    like: str | None = None,
    club: str | os.PathLike[str] | Club | None = None,
    hand: str | None = None,
    only: str | None = None,
    where: str | None = None,
    mismatch: str = "refuse",
    assume: Mapping[str, Any] | None = None,
) -> Estimate:
    """Estimate a golfer from shots in the order in which they were hit.

    Parameters
    ----------
    shots
        Shots of one club and one player, or a launch monitor's file. Face angles that were measured at the point of
        contact are brought back to the face centre.
    name
        What to call the golfer.
    like
        The golfer that gives what was not measured; left out, the shipped one with this kind of club whose mean speed
        is nearest.
    club, hand, only, where, mismatch, assume
        Which shots of the file, of which club, and values for what was not measured; as of
        :func:`clubface.measured.ready.ready_shots`.

    Raises
    ------
    InputError
        There are fewer than ``FEWEST`` shots, shots of several players or clubs, or quantities of which one follows
        from the others.
    """
    shots = ready_shots(shots, club=club, hand=hand, only=only, where=where, mismatch=mismatch, assume=assume)
    if shots.groups() is not None:
        raise InputError(
            "players", Told("several"), "one: take the shots of one player, as with where=\"player == 'A'\""
        )
    if shots.hand is not None and len(set(shots.hand)) > 1:
        raise InputError("hand", Told("right and left"), "one hand: take the shots of one player")
    names, values, same = _complete(shots)
    base = golfer_named(like if like is not None else _nearest(shots, names, values))
    base = base.for_hand(shots.club.hand if shots.hand is None else HANDS[str(shots.hand[0])])
    before, order = values, _disorder(values, names)
    if order is not None:
        values = np.random.default_rng(0).permutation(values)
    steps = np.diff(values, axis=0)
    try:
        if _dependent(steps):
            raise np.linalg.LinAlgError
        if len(values) < ENOUGH:
            share, scale = base.mishit_share, base.mishit_scale
            covariance = covariance_of(steps, share, scale)
        else:
            covariance, share, scale = mixture(steps)
        mean = mean_of(values, covariance, share, scale)
        error = error_of(steps, covariance, share, scale)
        shrinks = shrinkage(steps, covariance, share, scale)
    except np.linalg.LinAlgError:
        told = Told("such that one quantity follows from others or hardly ever changes")
        raise InputError("shots", told, f"leave out the column of one of {', '.join(names)}") from None
    together = _together(base, names, mean, covariance, same, shots)
    looked_for = len(values) >= ENOUGH
    together["sources"]["mishits"] = f"measured: {shots.source}" if looked_for else f"assumed: as of {base.name}"
    fitted = Golfer(
        name=name, title=f"{name}, {shots.club.name}", club=shots.club.name, hand=base.hand, mishit_share=share,
        mishit_scale=scale if share > 0.0 else 1.0, **together,
    )  # fmt: skip
    total = np.sqrt(np.diag(fitted.total_covariance))
    if order is None:
        drift = values.std(axis=0, ddof=1) / total[[fitted.variables.index(each) for each in names]]
    else:
        drift = 1.0 / np.sqrt(_zigzag(before))
    notes = _notes(shots, len(values), names, base, drift, same, order, shrinks)
    return Estimate(fitted, len(values), names, error, drift, shrinks, base.name, notes)


def _dependent(steps: Floats) -> bool:
    """Return whether one quantity follows from others; with few shots, whether it follows from one other."""
    scaled = steps / np.sqrt((steps**2).mean(axis=0))
    if len(steps) > steps.shape[1]:
        return bool(np.linalg.cond(scaled) > CONDITION)
    alike = np.abs(scaled.T @ scaled / len(steps))
    return bool((alike[~np.eye(len(alike), dtype=bool)] > 1.0 - 1.0 / CONDITION).any())


def _zigzag(values: Floats) -> Floats:
    """Return half the mean square of successive differences over the variance, by column (von Neumann, 1941)."""
    return 0.5 * (np.diff(values, axis=0) ** 2).mean(axis=0) / values.var(axis=0, ddof=1)


def _disorder(values: Floats, names: tuple[str, ...]) -> str | None:
    """Return in words why rows do not stand in the order of play; None if they may."""
    steps = np.diff(values, axis=0)
    # Of equal values, as rounding makes them, only one counts.
    rises = ((steps >= 0.0).all(axis=0) | (steps <= 0.0).all(axis=0)) & ((steps != 0.0).sum(axis=0) >= SORTED - 1)
    if rises.any():
        return f"the rows are sorted by {names[int(np.argmax(rises))].replace('_', ' ')}"
    zigzag = _zigzag(values)
    most = int(np.argmax(zigzag))
    if zigzag[most] > 1.0 + ZIGZAG / np.sqrt(len(values)):
        return f"rows that follow each other differ more than others in {names[most].replace('_', ' ')}"
    return None


def _complete(shots: ReadyShots) -> tuple[tuple[str, ...], Floats, dict[str, float]]:
    """Return the measured variables, the shots that have all of them, shape (n, k), and what is the same in each."""
    given = {name: values for name, values in shots.deliveries.items() if name in OF_CLUB}
    # What was measured in fewer than half of the shots would leave too few of them.
    names = tuple(name for name in OF_CLUB if name in given and np.isfinite(given[name]).mean() > 0.5)
    names = _together_often(names, given)
    if "speed" not in names:
        why = "".join(f"; {note}" for note in shots.notes if "speed" in note)
        raise InputError(
            "session",
            Told("without club speed"),
            "one whose club speed was measured, since a golfer is how the club is delivered (clubface golfer list has"
            f" golfers to take instead){why}",
        )
    values = np.stack([given[name] for name in names], axis=1)
    values = values[np.isfinite(values).all(axis=1)]
    # What never changes was set, not measured: it tells a mean, but no spread.
    varies = np.ptp(values, axis=0) > 0.0 if len(values) > 1 else np.ones(len(names), dtype=bool)
    same = {name: float(row[0]) for name, row, does in zip(names, values.T, varies, strict=True) if not does}
    if len(values) < FEWEST:
        raise InputError(
            "shots",
            Told(f"{len(values)} with all of {', '.join(names)}"),
            f"at least {FEWEST} such shots: with fewer, a spread is not known even to a factor of two",
        )
    if "speed" in same:
        raise InputError("shots", Told("all of one club speed"), "shots whose club speed was measured")
    return tuple(name for name in names if name not in same), values[:, varies], same


def _together_often(names: tuple[str, ...], given: Mapping[str, Floats]) -> tuple[str, ...]:
    """Leave out the quantities that are missing most often until enough shots have all the others."""
    seen = {name: np.isfinite(given[name]) for name in names}
    while len(seen) > 1 and np.logical_and.reduce(list(seen.values())).sum() < FEWEST:
        worst = min((name for name in seen if name != "speed"), key=lambda name: int(seen[name].sum()))
        if seen[worst].all():
            break
        del seen[worst]
    return tuple(seen)


def _nearest(shots: ReadyShots, names: tuple[str, ...], values: Floats) -> str:
    kind = "driver" if shots.club.parameters == "driver" else "7-iron"
    speed = float(np.median(values[:, names.index("speed")]))
    some = [each for each in map(golfer_named, golfers()) if each.club == kind]
    return min(some, key=lambda each: abs(each.mean[each.variables.index("speed")] - speed)).name


def _together(
    base: Golfer, names: tuple[str, ...], mean: Floats, covariance: Floats, same: Mapping[str, float], shots: ReadyShots
) -> dict[str, Any]:
    """Return variables, moments and sources: those measured, and of the base what was not."""
    variables = tuple(name for name in OF_CLUB if name in names or name in same or name in base.variables)
    centre, matrix = np.zeros(len(variables)), np.zeros((len(variables),) * 2)
    sources = {}
    for place, name in enumerate(variables):
        if name in names:
            centre[place] = mean[names.index(name)]
        elif name in base.variables:
            at = base.variables.index(name)
            centre[place], matrix[place, place] = base.mean[at], base.covariance[at, at]
        told = f"measured: {shots.source}" if name in names else f"assumed: as of {base.name}"
        sources |= {f"mean of {name}": told, f"spread of {name}": told}
        if name in same:
            centre[place] = same[name]
            sources[f"mean of {name}"] = f"the same in every shot: {shots.source}"
    own = [variables.index(name) for name in names]
    matrix[np.ix_(own, own)] = covariance
    sources["correlation"] = f"measured: {shots.source}"
    return {"variables": variables, "mean": centre, "covariance": matrix, "sources": sources}


def _notes(
    shots: ReadyShots, count: int, names: tuple[str, ...], base: Golfer, drift: Floats, same: Mapping[str, float],
    order: str | None, shrinks: float,
) -> tuple[str, ...]:  # fmt: skip
    found = list(shots.notes)
    if left := len(shots) - count:
        found.append(f"{left} of {len(shots)} shots lack some of the club data and were left out")
    missing = [name for name in base.variables if name not in names and name not in same]
    if same:
        found.append(f"the same in every shot, and therefore spread as of {base.name}: {', '.join(same)}")
    if missing:
        found.append(f"not measured, and therefore as of {base.name}: {', '.join(missing)}")
    if count < ENOUGH:
        found.append(f"{count} shots tell nothing of mishits: they are taken as of {base.name}")
    if {"loft", "face"} & set(names) and shots.face_at != FACE:
        found.append(
            "where on the face loft and face angle were taken is not known, or not in all shots: what the curved face"
            " adds off its centre may count twice"
        )
    if shots.speed_at != CG:
        found.append("speed, attack angle and path are not all known to be those of the head's centre of gravity")
    if len(names) > 1 and shrinks >= 0.005:
        found.append(
            f"correlations from {count} shots are drawn towards 0 by {shrinks:.0%} (Ledoit and Wolf, 2004): the fewer"
            " the shots, the more of them is chance"
        )
    drifted = [name for name, ratio in zip(names, drift, strict=True) if ratio > 1.0 + 3.0 / np.sqrt(count)]
    if order is not None:
        found.append(
            f"{order}, so that they do not stand in the order of play: spreads are taken about the mean of the session,"
            " and a drift would be in them"
        )
    elif drifted:
        found.append(f"the session drifted in {', '.join(drifted)}; the drift is not in the spreads")
    found.append("the errors of the monitor are in the spreads")
    return tuple(found)
