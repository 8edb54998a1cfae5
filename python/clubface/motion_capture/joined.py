"""Deliveries from motion capture and launches from a launch monitor, of the same shots, joined into one table.

Each instrument misses shots of its own, so rows cannot be paired by counting. Both keep the order in which the shots
were hit, and both see a part of each shot: ball speed and launch angle, and the speed of the clubhead. The pairs are
the alignment of the two series with the least deviation, found by dynamic programming (S. B. Needleman and C. D.
Wunsch, Journal of Molecular Biology 48 (1970) 443-453).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError
from clubface.recorded.shots import RecordedShots, RejectedRow
from clubface.support.arrays import Floats

SAME = {"ball_speed": 1.5, "launch": units.to_si(2.0, "deg"), "speed": 2.5}
"""Differences [SI] beyond which two measurements are not of the same shot.

Azimuth is not looked at: lines to the target may differ.
"""
ALONE = 0.25
"""What a row without a partner costs: two of them as much as a pair that differs by 0.7 of what it may."""


def join(captured: RecordedShots, measured: RecordedShots) -> RecordedShots:
    """Return shots with the deliveries of one table and the launches of another.

    Parameters
    ----------
    captured
        The table whose deliveries are taken.
    measured
        The table whose launches and names of clubs are taken. Both tables are in the order in which the shots were hit.

    Returns
    -------
    RecordedShots
        The shots that both tables hold, with the rows of ``captured``. Rows without a partner are in ``rejected``.

    Raises
    ------
    InputError
        No quantity tells which shots are the same and the tables differ in length, or no pair was found.
    """
    for what, shots, values in (("captured", captured, captured.deliveries), ("measured", measured, measured.launches)):
        if not len(shots) or not values:
            kind = "deliveries" if shots is captured else "launches"
            raise InputError(what, shots.source, f"shots with {kind}")
    differences = _differences(captured, measured)
    if differences:
        pairs = _aligned(_costs(differences))
        told = f"paired in their order by {', '.join(differences)}"
    elif len(captured) == len(measured):
        pairs = np.repeat(np.arange(len(captured))[:, None], 2, axis=1)
        told = "paired by their order alone: both tables have nothing in common to tell shots by"
    else:
        raise InputError(
            "measured", f"{len(measured)} shots", f"as many as captured, {len(captured)}, since the tables have none of"
            f" {', '.join(SAME)} in common to tell which are the same",
        )  # fmt: skip
    if not len(pairs):
        raise InputError("measured", measured.source, f"of the same shots as {captured.source}; not one pair is alike")
    one, other = captured.select(pairs[:, 0]), measured.select(pairs[:, 1])
    left = [*_rejected(captured, pairs[:, 0], measured), *_rejected(measured, pairs[:, 1], captured)]
    return RecordedShots(
        deliveries=one.deliveries, launches=other.launches, rows=one.rows,
        clubs=one.clubs if other.clubs is None else other.clubs, hand=other.hand if one.hand is None else one.hand,
        source=f"{captured.source} and {measured.source}", format="joined",
        rejected=tuple(left),
        notes=(*captured.notes, *measured.notes, told, *_turned(one, other)),
        speed_at=captured.speed_at, face_at=captured.face_at,
    )  # fmt: skip


def _differences(captured: RecordedShots, measured: RecordedShots) -> dict[str, Floats]:
    """Return how much each shot of one table differs from each of the other, in parts of what is allowed."""
    first, second = ({**each.deliveries, **each.launches} for each in (captured, measured))
    found = {}
    for name, allowed in SAME.items():
        if name in first and name in second:
            difference = (first[name][:, None] - second[name][None, :]) / allowed
            if np.isfinite(difference).any():
                found[name] = difference
    return found


def _costs(differences: dict[str, Floats]) -> Floats:
    """Return what each pair costs, 0 to 1: the mean square of its differences, infinite where one is too large."""
    every = np.array(list(differences.values()))
    there = np.isfinite(every)
    squares = np.where(there, every, 0.0) ** 2
    count = there.sum(axis=0)
    # A pair of which nothing can be compared is taken rather than left alone, and no other for it.
    costs = np.where(count > 0, squares.sum(axis=0) / np.maximum(count, 1), ALONE)
    return np.where((squares > 1.0).any(axis=0), np.inf, costs)


def _aligned(costs: Floats) -> NDArray[np.int64]:
    """Return the pairs, in order, whose costs and those of the rows left alone are least; shape (pairs, 2)."""
    rows, columns = costs.shape
    total = np.empty((rows + 1, columns + 1))
    total[0], total[:, 0] = ALONE * np.arange(columns + 1), ALONE * np.arange(rows + 1)
    for row in range(rows):
        # A column left alone adds one to the place before: a running minimum, less the places passed.
        best = np.minimum(total[row, 1:] + ALONE, total[row, :-1] + costs[row])
        passed = ALONE * np.arange(columns + 1)
        total[row + 1] = np.minimum.accumulate(np.concatenate([[total[row + 1, 0]], best]) - passed) + passed
    pairs = []
    row, column = rows, columns
    while row and column:
        if np.isclose(total[row, column], total[row - 1, column - 1] + costs[row - 1, column - 1], rtol=0, atol=1e-9):
            row, column = row - 1, column - 1
            pairs.append((row, column))
        elif np.isclose(total[row, column], total[row - 1, column] + ALONE, rtol=0, atol=1e-9):
            row -= 1
        else:
            column -= 1
    return np.array(pairs[::-1], dtype=np.int64).reshape(-1, 2)


def _rejected(shots: RecordedShots, paired: NDArray[np.int64], other: RecordedShots) -> list[RejectedRow]:
    """Return the rows of a table that gave no shot, or one that the other does not have."""
    alone = np.setdiff1d(np.arange(len(shots)), paired)
    found = [*shots.rejected, *(RejectedRow(int(shots.rows[each]), f"not in {other.source}") for each in alone)]
    found.sort(key=lambda each: each.line or 0)
    return [each._replace(reason=f"{shots.source}: {each.reason}") for each in found]


def _turned(one: RecordedShots, other: RecordedShots) -> list[str]:
    """Return by how much the two lines to the target differ, where both saw the ball's direction."""
    if not ("azimuth" in one.launches and "azimuth" in other.launches):
        return []
    difference = other.launches["azimuth"] - one.launches["azimuth"]
    if not np.isfinite(difference).any():
        return []
    median = float(np.nanmedian(difference))
    side = "right" if median > 0.0 else "left"
    return [
        f"the azimuth of {other.source} is further {side} by {units.show(abs(median), 'deg', 2)} (median) than that of"
        f" {one.source}: if that is more than noise, the lines to the target differ"
    ]
