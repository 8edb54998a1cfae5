"""Estimating a golfer from launch monitor shots, and the sensitivity of dispersion to assumed figures.

A session drifts, as the golfer tires or works on something, and contains mishits. Spreads and correlations therefore
come from differences of successive shots, which nearly cancel drift (von Neumann, 1941), and shots are modelled as a
mixture with mishits. Rows that are not in the order of play are shuffled first, since sorted rows would give spreads
that are far too small.

Both parts of the mixture are normal, with the mishits c times as wide. The difference of two shots then has covariance
2 C with probability (1 - s)^2, (1 + c^2) C with 2 s (1 - s), and 2 c^2 C with s^2; share s, scale c and covariance C
are maximum-likelihood estimates. As in other robust estimates, a mishit has little weight in C. The stated error of C
includes the uncertainty about the mishits.

Correlations are shrunk towards zero by the amount that minimises their expected squared error (Ledoit and Wolf, 2004),
because few shots and many quantities give strong correlations by chance; spreads are not shrunk.

To show how much depends on assumed figures, each is changed in turn and the same quasi-random shots are hit.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from clubface.design.dispersion import dispersion
from clubface.design.golfer import Golfer, golfer as golfer_named, golfers, is_assumed
from clubface.equipment.clubs import Club
from clubface.equipment.described import HANDS
from clubface.errors import InputError, Wording
from clubface.results.notes import Note, note
from clubface.shots.formats import CG, FACE
from clubface.shots.measured import ReadyShots, ready_shots
from clubface.shots.mishits import find_mishits, is_mishit
from clubface.shots.recorded import RecordedShots
from clubface.simulation.inputs import OF_CLUB
from clubface.support.arrays import Floats, ValueLike

ENOUGH = 40
"""Number of shots needed to estimate mishits; with fewer, they are taken from the golfer that fills the gaps."""
SCALES = np.arange(1.5, 6.01, 0.25)
"""Scales of mishits tried."""
GAIN = 4.0
"""Gain in log likelihood required to accept that there are mishits."""
ROUNDS = 60
SETTLED = 1e-7
"""Relative change of a covariance below which its iteration has converged."""
VANISHES = 1e-12
"""Relative variance below which a quantity hardly ever changes, because every change counts as a mishit."""
STANDARD_ERROR = 0.75
"""Relative variance of a spread times the number of shots: 3/4 from successive differences, 1/2 about the mean."""
MIXTURES = [(0.0, 1.0), *product((0.03, 0.08, 0.15, 0.25), (1.5, 2.0, 3.0, 4.5))]
"""Shares and scales of mishits over which the uncertainty is averaged."""
NO_MISHITS = 0.15
"""Prior probability of the first mixture; the others share the rest equally."""
EFFECTIVE_SHARE = 2 / 3
"""Number of independent shots one successive difference is worth: 1/2 over 3/4 (``STANDARD_ERROR``)."""
BLOCKS = 20
"""Number of blocks of a long session for the jackknife error of the spreads."""
OF_FEW = 1.07
"""Widening of intervals from so few blocks: Student's t with 19 degrees of freedom, 2.09 instead of 1.96."""


class Mixture(NamedTuple):
    """Covariance of the shots that are not mishits, and share and scale of the mishits."""

    covariance: Floats
    share: float
    scale: float


def mixture(steps: Floats) -> Mixture:
    """Return the maximum-likelihood mixture; its share is 0 if mishits gain too little likelihood."""
    result = Mixture(covariance_of(steps, 0.0, 1.0), 0.0, 1.0)
    best, covariance = _fit_mixture(steps, result).likelihood + GAIN, result.covariance
    for scale in map(float, SCALES):
        share = 0.1
        for _ in range(ROUNDS):
            covariance = covariance_of(steps, share, scale, start=covariance)
            before, share = share, _fit_mixture(steps, Mixture(covariance, share, scale)).mishits
            if abs(share - before) < 1e-5:
                break
        if (likelihood := _fit_mixture(steps, Mixture(covariance, share, scale)).likelihood) > best:
            best, result = likelihood, Mixture(covariance, share, scale)
    return result


def covariance_of(steps: Floats, share: float, scale: float, *, start: Floats | None = None) -> Floats:
    """Return the maximum-likelihood covariance without mishits, for their share and scale, iterated from ``start``."""
    first, _ = shrunk(steps, np.full(len(steps), 0.5))
    covariance = first if start is None else start
    for _ in range(ROUNDS):
        weights = _fit_mixture(steps, Mixture(covariance, share, scale)).weights
        before, (covariance, _) = covariance, shrunk(steps, weights)
        size = np.sqrt(np.outer(np.diag(first), np.diag(first)))
        if (np.diag(covariance) < VANISHES * np.diag(first)).any():
            raise np.linalg.LinAlgError
        if (np.abs(covariance - before) <= SETTLED * size).all():
            break
    return covariance


def shrunk(steps: Floats, weights: Floats) -> tuple[Floats, float]:
    """Return the covariance of weighted differences of shots, and the shrinkage of its correlations.

    The shrinkage of Ledoit and Wolf (2004) is the sum of the variances of the correlations over the sum of their
    squares. Their target is a multiple of the identity; here quantities are first scaled by their spreads, which
    therefore do not change. ``weights`` of the squared ``steps``, shape (n,), are 1/2 for normally distributed shots.
    """
    count = len(steps)
    weighted = steps * np.sqrt(weights)[:, None]
    spread = np.sqrt((weighted**2).mean(axis=0))
    if not (spread > 0.0).all():
        raise np.linalg.LinAlgError
    scaled = weighted / spread
    correlation = scaled.T @ scaled / count
    apart = ~np.eye(len(spread), dtype=bool)
    independent = max(EFFECTIVE_SHARE * count - 1.0, 1.0)
    sampled = ((scaled**2).T @ scaled**2 / count - correlation**2)[apart].sum() / independent
    squares = (correlation[apart] ** 2).sum()
    share = float(min(sampled / squares, 1.0)) if squares > 0.0 else 0.0
    correlation[apart] *= 1.0 - share
    return correlation * np.outer(spread, spread), share


class _MixtureFit(NamedTuple):
    """Fit of differences of shots to a mixture: expected 1 / width, log likelihood, estimated share of mishits."""

    weights: Floats
    likelihood: float
    mishits: float


def _fit_mixture(steps: Floats, mixed: Mixture) -> _MixtureFit:
    covariance, share, scale = mixed
    widths = np.array([2.0, 1.0 + scale**2, 2.0 * scale**2])
    chances = np.array([(1.0 - share) ** 2, 2.0 * share * (1.0 - share), share**2])
    root = np.linalg.cholesky(covariance)
    squares = (np.linalg.solve(root, steps.T) ** 2).sum(axis=0)[:, None]
    with np.errstate(divide="ignore"):
        logs = np.log(chances) - 0.5 * steps.shape[1] * np.log(widths) - 0.5 * squares / widths
    most = logs.max(axis=1, keepdims=True)
    each = np.exp(logs - most)
    total = each.sum(axis=1, keepdims=True)
    each /= total
    likelihood = float((most + np.log(total)).sum()) - len(steps) * float(np.log(np.diag(root)).sum())
    return _MixtureFit((each / widths).sum(axis=1), likelihood, float((each[:, 1] + 2.0 * each[:, 2]).mean() / 2.0))


def error_of(steps: Floats, mixed: Mixture) -> Floats:
    """Return the standard errors of the spreads, from sampling and from the uncertainty about mishits."""
    covariance, share, scale = mixed
    spread = np.sqrt(np.diag(covariance))
    of_sample = spread * np.sqrt(STANDARD_ERROR / (len(steps) + 1))
    if len(steps) + 1 >= ENOUGH:
        parts = np.array_split(np.arange(len(steps)), BLOCKS)
        without = [np.delete(steps, part, axis=0) for part in parts]
        spreads = np.sqrt([np.diag(covariance_of(each, share, scale, start=covariance)) for each in without])
        of_sample = np.maximum(of_sample, OF_FEW * np.sqrt((BLOCKS - 1) * spreads.var(axis=0)))
    return np.hypot(of_sample, spread * _mishit_error(steps, spread))


def _mishit_error(steps: Floats, spread: Floats) -> Floats:
    """Return the relative error of the spreads: the root mean square over mixtures weighted by likelihood."""
    mixtures = [Mixture(covariance_of(steps, *each), *each) for each in MIXTURES]
    logs = np.array([_fit_mixture(steps, each).likelihood for each in mixtures])
    before = [NO_MISHITS, *[(1.0 - NO_MISHITS) / (len(MIXTURES) - 1)] * (len(MIXTURES) - 1)]
    chances = before * np.exp(EFFECTIVE_SHARE * (logs - logs.max()))
    away = np.log(np.sqrt([np.diag(each.covariance) for each in mixtures]) / spread)
    return np.sqrt(chances @ away**2 / chances.sum())


def mean_of(values: Floats, mixed: Mixture) -> Floats:
    """Return the mean, in which a shot has less weight the more likely it is a mishit."""
    covariance, share, scale = mixed
    mean, size = np.median(values, axis=0), values.shape[1]
    if share == 0.0:
        return values.mean(axis=0)
    widths, chances = np.array([1.0, scale**2]), np.array([1.0 - share, share])
    for _ in range(ROUNDS):
        away = values - mean
        squares = np.einsum("ni,ij,nj->n", away, np.linalg.inv(covariance), away)[:, None]
        logs = np.log(chances) - 0.5 * size * np.log(widths) - 0.5 * squares / widths
        weights = np.exp(logs - logs.max(axis=1, keepdims=True))
        weights = (weights / widths).sum(axis=1) / weights.sum(axis=1)
        mean = (values * weights[:, None]).sum(axis=0) / weights.sum()
    return mean


FEWEST = 6
"""Minimum number of shots: in 19 of 20 sessions a spread is then within a factor exp(1.96 sqrt(3/4 / 6)) = 2.0."""
CONDITION = 1e6
"""Condition number of the scaled differences above which one quantity follows from the others."""
ZIGZAG = 3.5
"""Number of standard deviations above 1 of von Neumann's ratio (1 within 1/sqrt(n) for n independent shots) that shows
rows are not in the order of play."""
SORTED = 8
"""Number of different values for which a column that only rises or falls shows sorted rows; by chance 1 in 20,000."""


class Estimate(NamedTuple):
    """A golfer estimated from shots.

    Attributes
    ----------
    golfer, shots
        The golfer, and number of shots used.
    measured
        Variables whose spread was measured; all others spread as for ``like``.
    error
        Standard error of the spread of each measured variable [SI], shape (measured,). It is proportional: the true
        spread is within a factor of exp(1.96 error / spread) either way in about 19 of 20 sessions. It includes the
        uncertainty about mishits.
    drift
        Standard deviation about the session's mean over the one from successive differences, shape (measured,): well
        above 1 if the session drifted, well below 1 if the rows are not in the order of play.
    shrinkage
        Share by which correlations were shrunk towards zero, 0 to 1 (Ledoit and Wolf, 2004); larger with fewer shots.
    like
        The shipped golfer that supplies what was not measured.
    notes
        Caveats of the estimate.
    """

    golfer: Golfer
    shots: int
    measured: tuple[str, ...]
    error: Floats
    drift: Floats
    shrinkage: float
    like: str
    notes: tuple[Note, ...]

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
    assume: Mapping[str, ValueLike] | None = None,
) -> Estimate:
    """Estimate a golfer from shots in the order of play, leaving out mishits recognised by their flight.

    Parameters
    ----------
    shots
        Shots of one club and one player, or a launch monitor's file. Face angles measured at the impact point are
        converted to the face centre.
    like
        The golfer that supplies what was not measured; default the shipped golfer with this kind of club and the
        nearest mean speed.
    club, hand, only, where, mismatch, assume
        As for :func:`clubface.shots.measured.ready_shots`.

    Raises
    ------
    InputError
        There are fewer than ``FEWEST`` shots, several players or clubs, or one quantity follows from the others.
    """
    shots = ready_shots(shots, club=club, hand=hand, only=only, where=where, mismatch=mismatch, assume=assume)
    if shots.groups() is not None:
        raise InputError("players", Wording("several"), "one: choose a player, as with where=\"player == 'A'\"")
    if shots.hand is not None and len(set(shots.hand)) > 1:
        raise InputError("hand", Wording("right and left"), "one hand: take the shots of one player")
    mishits = find_mishits({**shots.deliveries, **shots.launches})
    mishit = is_mishit(mishits, len(shots))
    if mishits:
        shots = shots.select(~mishit)
    names, values, same = _complete_shots(shots)
    base = golfer_named(like if like is not None else _nearest_golfer(shots, names, values))
    base = base.for_hand(shots.club.hand if shots.hand is None else HANDS[str(shots.hand[0])])
    before, order = values, _order_problem(values, names)
    if order is not None:
        values = np.random.default_rng(0).permutation(values)
    steps = np.diff(values, axis=0)
    try:
        if _has_dependent_column(steps):
            raise np.linalg.LinAlgError
        if len(values) < ENOUGH:
            mishits_of_base = base.mishit_share, base.mishit_scale
            mixed = Mixture(covariance_of(steps, *mishits_of_base), *mishits_of_base)
        else:
            mixed = mixture(steps)
        mean, error = mean_of(values, mixed), error_of(steps, mixed)
        _, shrinks = shrunk(steps, _fit_mixture(steps, mixed).weights)
    except np.linalg.LinAlgError:
        problem = Wording("such that one quantity follows from others or hardly ever changes")
        raise InputError("shots", problem, f"leave out the column of one of {', '.join(names)}") from None
    together = _merge_figures(base, names, mean, mixed.covariance, same, shots)
    looked_for = len(values) >= ENOUGH
    together["sources"]["mishits"] = f"measured: {shots.source}" if looked_for else f"assumed: as of {base.name}"
    fitted = Golfer(
        name=name, title=f"{name}, {shots.club.name}", club=shots.club.name, hand=base.hand, mishit_share=mixed.share,
        mishit_scale=mixed.scale if mixed.share > 0.0 else 1.0, **together,
    )  # fmt: skip
    total = np.sqrt(np.diag(fitted.total_covariance))
    if order is None:
        drift = values.std(axis=0, ddof=1) / total[[fitted.variables.index(each) for each in names]]
    else:
        drift = 1.0 / np.sqrt(_von_neumann_ratio(before))
    left_out = [note("golfer-mishits-left-out", mishits=int(mishit.sum()), shots=len(mishit))] if mishits else []
    notes = (*left_out, *_notes(shots, len(values), names, base, drift, same, order, shrinks))
    return Estimate(fitted, len(values), names, error, drift, shrinks, base.name, notes)


def _has_dependent_column(steps: Floats) -> bool:
    """Return whether one quantity follows from the others; with few shots, only pairs are tested."""
    scaled = steps / np.sqrt((steps**2).mean(axis=0))
    if len(steps) > steps.shape[1]:
        return bool(np.linalg.cond(scaled) > CONDITION)
    alike = np.abs(scaled.T @ scaled / len(steps))
    return bool((alike[~np.eye(len(alike), dtype=bool)] > 1.0 - 1.0 / CONDITION).any())


def _von_neumann_ratio(values: Floats) -> Floats:
    """Return half the mean squared successive difference over the variance, by column (von Neumann, 1941)."""
    return 0.5 * (np.diff(values, axis=0) ** 2).mean(axis=0) / values.var(axis=0, ddof=1)


def _order_problem(values: Floats, names: tuple[str, ...]) -> str | None:
    """Return why rows cannot be in the order of play, in words; None if they may be."""
    steps = np.diff(values, axis=0)
    # Equal values, as from rounding, count once.
    rises = ((steps >= 0.0).all(axis=0) | (steps <= 0.0).all(axis=0)) & ((steps != 0.0).sum(axis=0) >= SORTED - 1)
    if rises.any():
        return f"the rows are sorted by {names[int(np.argmax(rises))].replace('_', ' ')}"
    zigzag = _von_neumann_ratio(values)
    most = int(np.argmax(zigzag))
    if zigzag[most] > 1.0 + ZIGZAG / np.sqrt(len(values)):
        return f"rows that follow each other differ more than others in {names[most].replace('_', ' ')}"
    return None


def _complete_shots(shots: ReadyShots) -> tuple[tuple[str, ...], Floats, dict[str, float]]:
    """Return the measured variables, their values in complete shots, shape (n, k), and the constant ones."""
    given = {name: values for name, values in shots.deliveries.items() if name in OF_CLUB}
    # Variables measured in fewer than half of the shots would leave too few complete ones.
    names = tuple(name for name in OF_CLUB if name in given and np.isfinite(given[name]).mean() > 0.5)
    names = _drop_sparse_names(names, given)
    if "speed" not in names:
        why = "".join(f"; {each}" for each in shots.notes if _explains_missing_speed(each))
        raise InputError(
            "session",
            Wording("without club speed"),
            "one with measured club speed, since a golfer describes how the club is delivered (clubface golfer list"
            f" shows ready-made golfers){why}",
        )
    values = np.stack([given[name] for name in names], axis=1)
    values = values[np.isfinite(values).all(axis=1)]
    # A value that never changes was set, not measured: it gives a mean but no spread.
    varies = np.ptp(values, axis=0) > 0.0 if len(values) > 1 else np.ones(len(names), dtype=bool)
    same = {name: float(row[0]) for name, row, does in zip(names, values.T, varies, strict=True) if not does}
    if len(values) < FEWEST:
        raise InputError(
            "shots",
            Wording(f"{len(values)} with all of {', '.join(names)}"),
            f"at least {FEWEST} such shots: with fewer, a spread is not known even to a factor of two",
        )
    if "speed" in same:
        raise InputError("shots", Wording("all with the same club speed"), "shots whose club speed was measured")
    return tuple(name for name in names if name not in same), values[:, varies], same


def _explains_missing_speed(remark: Note) -> bool:
    impossible = remark.code == "impossible-values" and "speed" in remark.data["example"]
    return impossible or remark.code in (
        "column-misspelled", "columns-not-read", "faster-than-club", "speed-of-club-or-ball", "without-club-data",
    )  # fmt: skip


def _drop_sparse_names(names: tuple[str, ...], given: Mapping[str, Floats]) -> tuple[str, ...]:
    """Return the names without those missing most often, so that enough shots have all of the rest."""
    seen = {name: np.isfinite(given[name]) for name in names}
    while len(seen) > 1 and np.logical_and.reduce(list(seen.values())).sum() < FEWEST:
        worst = min((name for name in seen if name != "speed"), key=lambda name: int(seen[name].sum()))
        if seen[worst].all():
            break
        del seen[worst]
    return tuple(seen)


def _nearest_golfer(shots: ReadyShots, names: tuple[str, ...], values: Floats) -> str:
    kind = "driver" if shots.club.parameters == "driver" else "7-iron"
    speed = float(np.median(values[:, names.index("speed")]))
    some = [each for each in map(golfer_named, golfers()) if each.club == kind]
    return min(some, key=lambda each: abs(each.mean[each.variables.index("speed")] - speed)).name


def _merge_figures(
    base: Golfer, names: tuple[str, ...], mean: Floats, covariance: Floats, same: Mapping[str, float], shots: ReadyShots
) -> dict[str, Any]:
    """Return variables, moments and sources of the golfer: measured ones, completed from ``base``."""
    variables = tuple(name for name in OF_CLUB if name in names or name in same or name in base.variables)
    centre, matrix = np.zeros(len(variables)), np.zeros((len(variables),) * 2)
    sources = {}
    for place, name in enumerate(variables):
        if name in names:
            centre[place] = mean[names.index(name)]
        elif name in base.variables:
            at = base.variables.index(name)
            centre[place], matrix[place, place] = base.mean[at], base.covariance[at, at]
        source = f"measured: {shots.source}" if name in names else f"assumed: as of {base.name}"
        sources |= {f"mean of {name}": source, f"spread of {name}": source}
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
) -> Iterator[Note]:  # fmt: skip
    yield from shots.notes
    if left := len(shots) - count:
        yield note("golfer-shots-left-out", left=left, shots=len(shots))
    if same:
        yield note("golfer-same-in-every-shot", like=base.name, names=list(same))
    if missing := [name for name in base.variables if name not in names and name not in same]:
        yield note("golfer-not-measured", like=base.name, names=missing)
    if count < ENOUGH:
        yield note("golfer-few-for-mishits", shots=count, like=base.name)
    if {"loft", "face"} & set(names) and shots.face_at != FACE:
        yield note("golfer-place-of-face-unknown")
    if shots.speed_at != CG:
        yield note("golfer-place-of-speed-unknown")
    if len(names) > 1 and shrinks >= 0.005:
        yield note("golfer-shrunk", shots=count, shrinkage=shrinks)
    drifted = [name for name, ratio in zip(names, drift, strict=True) if ratio > 1.0 + 3.0 / np.sqrt(count)]
    if order is not None:
        yield note("golfer-disorder", reason=order)
    elif drifted:
        yield note("golfer-drifted", names=drifted)
    yield note("golfer-monitor-errors")


OFF = 0.3
"""Default relative change of a figure."""
COUNT = 2**15
"""Shots per change, enough to know a change of a standard deviation to about 1 % (for amateurs' drives, where the few
worst mishits count most; better for others)."""
QUANTITIES = ("carry", "side")
LEAST = 0.01
"""Smallest eigenvalue allowed when correlations are made stronger and may contradict each other."""


class FigureEffect(NamedTuple):
    """Effect of a smaller and a larger figure on the spread of the landings."""

    figure: str  # as in :meth:`Golfer.source`
    assumed: bool  # without published or measured source
    spread: dict[str, tuple[float, float]]  # standard deviation of ``QUANTITIES`` [m]: smaller and larger figure


class SpreadSensitivity(NamedTuple):
    """Sensitivity of the spread of the landings to each figure, most important first.

    Every figure is changed by the share ``off``; ``spread`` is the standard deviation [m] of each of ``QUANTITIES``
    without a change, and ``shots`` the number of shots per change.
    """

    off: float
    spread: dict[str, float]
    figures: tuple[FigureEffect, ...]
    shots: int = COUNT

    def changes(self, doubt: FigureEffect, name: str) -> tuple[float, float]:
        """Return the relative change of a quantity's spread with the figure smaller and larger; 0 without spread."""
        now, (less, more) = self.spread[name], doubt.spread[name]
        return (less / now - 1.0, more / now - 1.0) if now > 0.0 else (0.0, 0.0)


def doubts(golfer: Golfer, club: Club, *, off: float = OFF, count: int = COUNT) -> SpreadSensitivity:
    """Hit a golfer's shots with each spread, the correlations and the mishit share changed by ``off`` either way.

    Uses the default model in still air and ``count`` shots per change; ``off`` is a relative change.
    """
    if not 0.0 < off < 1.0:
        raise InputError("off", off, "a share between 0 and 1")
    player = golfer.for_hand(club.hand)

    def spreads(varied: Golfer) -> dict[str, float]:
        shots = dispersion(varied, club, count=count)
        return {name: shots.spread(name) for name in QUANTITIES}

    figures = []
    still = {f"mean of {name}" for name in player.variables}
    still |= {f"spread of {name}" for name, each in zip(player.variables, player.spread, strict=True) if each == 0.0}
    for figure in (each for each in player.figures() if each not in still):
        less, more = (spreads(changed(player, figure, factor)) for factor in (1.0 - off, 1.0 + off))
        both = {name: (less[name], more[name]) for name in QUANTITIES}
        figures.append(FigureEffect(figure, is_assumed(golfer, figure), both))
    result = SpreadSensitivity(off, spreads(player), tuple(figures), count)
    order = sorted(figures, key=lambda each: -max(abs(result.changes(each, name)[1]) for name in QUANTITIES))
    return result._replace(figures=tuple(order))


def changed(golfer: Golfer, figure: str, factor: float) -> Golfer:
    """Return a golfer with one figure multiplied by ``factor``."""
    if figure == "mishits":
        return golfer.replace(mishit_share=min(golfer.mishit_share * factor, 0.99))
    spread = golfer.spread
    if figure == "correlation":
        correlation = golfer.correlation * factor
        np.fill_diagonal(correlation, 1.0)
        return golfer.replace(covariance=possible(correlation) * np.outer(spread, spread))
    scale = np.where([f"spread of {name}" == figure for name in golfer.variables], factor, 1.0)
    return golfer.replace(covariance=golfer.covariance * np.outer(scale, scale))


def possible(correlation: Floats) -> Floats:
    """Return a valid correlation matrix near the given one, by raising eigenvalues to at least ``LEAST``."""
    values, vectors = np.linalg.eigh(correlation)
    if values[0] >= LEAST:
        return correlation
    raised = (vectors * np.maximum(values, LEAST)) @ vectors.T
    scale = np.sqrt(np.diag(raised))
    scaled = raised / np.outer(scale, scale)
    np.fill_diagonal(scaled, 1.0)
    return 0.5 * (scaled + scaled.T)
