"""Whether dynamic loft was measured, or computed by the monitor from ball data.

Radar monitors see the ball better than the face. Some compute dynamic loft and face angle from ball speed, launch and
spin; the ratio I w / (m R v_t) of the spin w to the ball's speed v_t along the face is then the same in every shot
(1.12 to 1.15 in TrackMan's sets). Fitting or testing a spin model with such lofts only recovers the monitor's own
impact model.

The shots decide, not the brand. With one ratio for all shots of a club, the ball data imply an angle between face
normal and launch direction of arcsin(I w / (m R v ratio)). Computed angles scatter about it only by the rounding in the
file, such as 7773 public TrackMan drives by less than 0.001 degrees (0.07 to 0.13 if face angle and start direction are
ignored). Measured angles scatter far more, by monitor errors and by real differences between shots: those of the
benchmark shots by 1.1 degrees with the driver and 0.8 with the 7-iron.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.balls import published_ball
from clubface.results.notes import Note, note
from clubface.shots.recorded import RecordedShots
from clubface.simulation.spin import rolling_speed
from clubface.support.arrays import Floats

FEWEST = 5
"""Minimum number of shots with a club for a decision."""
MEASURED = units.to_si(0.3, "deg")
"""Smallest standard deviation [rad] expected of a measured angle between face and launch, without rounding."""
LIKELY = 0.99
"""Confidence with which the scatter must be below or above that of a measured angle."""
EXPLAINED = 0.5
"""Share of the angle's variance that spin must explain, since similar shots share one ratio in any case."""
RATIOS = (0.7, 1.5)
"""Plausible range of the ratio; impact models give 0.85 to 1.3 with the face at first touch or maximum compression."""
OUTLIER, KEPT = 4.0, 2.0 / 3.0
"""Number of robust standard deviations that makes an outlier, and the share of shots that must not be outliers."""
SHARPEST = MEASURED / 10.0
"""Standard deviation [rad] below which no shots count as outliers."""
STEPS = (1.0, 0.5, 0.1, 0.05, 0.01)
"""Rounding steps of angles in files, in degrees."""
SPIN_STEPS = (100.0, 50.0, 10.0, 1.0)
"""Rounding steps of spins in files, in rpm."""

COMPUTED, FROM_MEASUREMENT, UNDECIDED = ORIGINS = ("computed from the ball", "measured", "undecided")
"""Possible origins of a club's lofts."""

_ball = cache(published_ball)
"""Ball for the ratio, I = 0.400 m R^2, as used for published ratios."""


class LoftOrigin(NamedTuple):
    """The origin of the dynamic lofts of one club in one file.

    Attributes
    ----------
    club, file
        Names as in the file, or "".
    shots, origin
        Number of shots with all the data needed, and one of ``ORIGINS``.
    with_face
        Whether the face angle was used too; it then has the same origin as the loft.
    ratio, ratio_scatter
        I w / (m R v_t), the median over the shots, weighted by spin over speed, and its robust standard deviation from
        shot to shot, from the median deviation.
    scatter
        Standard deviation of the angle between face normal and launch about the implied angle [rad], without outliers.
    rounding
        The part of it explained by rounding in the file [rad].
    """

    club: str
    file: str
    shots: int
    origin: str
    with_face: bool
    ratio: float
    ratio_scatter: float
    scatter: float
    rounding: float


def loft_origins(shots: RecordedShots) -> tuple[LoftOrigin, ...]:
    """Return the origin of dynamic lofts by club and file, where there are enough shots to tell."""
    if "loft" not in shots.deliveries or not {"ball_speed", "launch"} <= shots.launches.keys():
        return ()
    clubs = np.full(len(shots), "", dtype=object) if shots.clubs is None else shots.clubs
    files = np.full(len(shots), "", dtype=object) if shots.files is None else shots.files
    origins = []
    for club, file in dict.fromkeys(zip(clubs, files, strict=True)):
        chosen = (clubs == club) & (files == file)
        both = [_angles(shots, chosen, with_face=each) for each in (True, False)]
        if known := [each for each in both if each is not None]:
            # The analysis with the face angle is preferred unless the other is more decisive.
            best = min(known, key=lambda each: (ORIGINS.index(each.origin), not each.with_face))
            origins.append(best._replace(club=str(club), file=str(file)))
    return tuple(origins)


def computed(origins: Iterable[LoftOrigin]) -> list[LoftOrigin]:
    """Return the origins whose loft was computed from the ball."""
    return [each for each in origins if each.origin == COMPUTED]


def origin_notes(origins: Iterable[LoftOrigin]) -> list[Note]:
    """Return a note on each club with lofts computed from the ball, and a final note with advice."""
    notes = [
        note("loft-and-face-computed" if each.with_face else "loft-computed", ratio=each.ratio,
             ratio_scatter=each.ratio_scatter, shots=each.shots, club=each.club or "one club")
        .of(**{"in_files": [each.file]} if each.file else {})
        for each in computed(origins)
    ]  # fmt: skip
    return [*notes, note("loft-computed-advice")] if notes else []


def _angles(shots: RecordedShots, chosen: NDArray[np.bool_], *, with_face: bool) -> LoftOrigin | None:
    """Return the origin shown by angles between face normal and launch, in space or in the vertical plane."""
    names = ("face", "azimuth") if with_face else ()
    every = {**shots.deliveries, **shots.launches}
    spins = _spin(every, in_space=with_face)
    if spins is None or not set(names) <= every.keys():
        return None
    used = ("loft", "launch", "ball_speed", *names)
    known = np.all([np.isfinite(every[name]) for name in used], axis=0)
    there = chosen & known & np.isfinite(spins) & (np.abs(spins) > 0.0)
    if there.sum() < FEWEST:
        return None
    loft, launch, speed, *sides = (every[name][there] for name in used)
    face, azimuth = sides or (np.zeros_like(loft), np.zeros_like(loft))
    rolling = rolling_speed(_ball(), spins[there]) / speed
    across, turn = _separation(loft, launch, face - azimuth)
    steps = [_step(every[name][there], STEPS, "deg") for name in ("loft", "launch", *names)]
    upwards, sideways = np.mean(np.cos(turn) ** 2), np.mean(np.sin(turn) ** 2)
    variance = upwards * (steps[0] ** 2 + steps[1] ** 2) + sideways * sum(each**2 for each in steps[2:])
    spin_step = _step(spins[there], SPIN_STEPS, "rpm") * np.median(np.abs(across / spins[there]))
    rounding = math.sqrt((variance + spin_step**2) / 12.0)
    return _decide_origin(across, rolling, rounding, with_face)


def _separation(loft: Floats, launch: Floats, turned: Floats) -> tuple[Floats, Floats]:
    """Return the angle between face normal and launch [rad], and its direction, 0 in the vertical plane [rad].

    ``turned`` is face angle minus start direction [rad]. Without face angles, the angle is loft minus launch, which is
    negative if the ball starts above the normal.
    """
    if not turned.any():
        return loft - launch, np.zeros_like(loft)
    up = np.sin(loft) * np.cos(launch) - np.cos(loft) * np.sin(launch) * np.cos(turned)
    side = np.cos(loft) * np.sin(turned)
    along = np.sin(loft) * np.sin(launch) + np.cos(loft) * np.cos(launch) * np.cos(turned)
    return np.arctan2(np.hypot(up, side), along), np.arctan2(side, up)


def _decide_origin(across: Floats, rolling: Floats, rounding: float, with_face: bool) -> LoftOrigin:
    """Decide from angles [rad] and from rolling speed over ball speed."""
    from scipy.stats import chi2

    # The ratio of rolling speed to sines with the smallest absolute deviations of the sines is a weighted median.
    middle = float(np.quantile(np.sin(across) / rolling, 0.5, weights=np.abs(rolling), method="inverted_cdf"))
    ratio = 1.0 / middle if middle != 0.0 else 0.0
    asked = np.arcsin(np.clip(rolling / ratio, -1.0, 1.0)) if ratio else np.zeros_like(rolling)
    off = across - asked
    robust = 1.4826 * float(np.median(np.abs(off - np.median(off))))
    kept = np.abs(off - np.median(off)) <= OUTLIER * max(robust, rounding, SHARPEST)
    count = int(kept.sum())
    free = max(count - 1, 1)
    scatter = math.sqrt(float(np.sum(off[kept] ** 2)) / free)
    spread = float(np.std(across[kept], ddof=1)) if count > 1 else 0.0
    measured = math.hypot(rounding, MEASURED)
    low, high = (scatter * math.sqrt(free / end) for end in chi2.ppf([LIKELY, 1.0 - LIKELY], free))
    explained = 1.0 - (scatter / spread) ** 2 if spread > 0.0 else 0.0
    plausible = RATIOS[0] <= ratio <= RATIOS[1] and count >= KEPT * len(off)
    if plausible and high < measured and explained >= EXPLAINED:
        origin = COMPUTED
    elif low > measured:
        origin = FROM_MEASUREMENT
    else:
        origin = UNDECIDED
    middle = float(np.median(np.abs(asked[kept])))
    relative = robust / math.tan(middle) if middle > 0.0 else math.nan
    return LoftOrigin("", "", len(off), origin, with_face, ratio, abs(ratio) * relative, scatter, rounding)


def _step(values: Floats, steps: Iterable[float], unit: str) -> float:
    """Return the rounding step of values [SI], 0 if it is none of ``steps``."""
    shown = np.asarray(units.from_si(values, unit))
    for step in steps:
        if np.max(np.abs(shown / step - np.round(shown / step))) < 1e-6:
            return float(step * units.size(unit))
    return 0.0


def _spin(every: dict[str, Floats], *, in_space: bool) -> Floats | None:
    """Return the spin for the angle in space (total spin first) or in the vertical plane (backspin first), or None."""
    total, back = every.get("total_spin"), every.get("backspin")
    first, second = (total, back) if in_space else (back, total)
    if first is None or second is None:
        return first if second is None else second
    return np.where(np.isfinite(first), first, second)
