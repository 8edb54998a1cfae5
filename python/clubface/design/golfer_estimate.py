"""One's own golfer from the shots of a launch monitor, and what rests on assumed figures.

What counts is how a golfer's shots differ from each other at the moment of impact. A session also drifts, as the golfer
tires or works on something, and now and then comes a mishit. Therefore spreads and correlations come from the
differences of successive shots, in which a drift is all but gone (von Neumann, 1941), and shots are taken as a mixture
with mishits. Rows that do not stand in the order of play have no drift to take out: sorted ones would make the spreads
far too small. They are put into a random order first.

Of the two normal distributions that of the mishits is c times as wide. A difference of two shots then has the
covariance 2 C with the probability (1 - s)^2, (1 + c^2) C with 2 s (1 - s), and 2 c^2 C with s^2; share s, scale c and
covariance C are those of the greatest likelihood. A mishit counts for little in C, as in other robust estimates. How
far C could be another with other mishits that go nearly as well with the shots is part of its stated error.

Correlations are drawn towards zero by the share that makes their expected square error least (Ledoit and Wolf, 2004):
few shots and many quantities make strong correlations by chance alone. Spreads stay, and any number of shots gives
correlations that are possible together.

To see what rests on assumed figures, they are changed one at a time, and the same quasi-random shots are hit with each,
so that a difference is one of the figure and not of the sample.
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
"""Shots from which on mishits are looked for; with fewer they are those of the golfer that fills the gaps."""
SCALES = np.arange(1.5, 6.01, 0.25)
"""The scales of mishits that are tried."""
GAIN = 4.0
"""Least gain in logarithmic likelihood by which mishits are taken to exist."""
ROUNDS = 60
SETTLED = 1e-7
"""Part of the variances by which a covariance still changes when it is taken to be that of the greatest likelihood."""
VANISHES = 1e-12
"""Part of a variance below which a quantity is one that hardly ever changes: all its changes count as mishits."""
STANDARD_ERROR = 0.75
"""Variance of the estimated spread, in squared spreads over the number of shots: 3/4 from successive differences of
normally distributed shots, where it is 1/2 about the mean."""
MIXTURES = [(0.0, 1.0), *product((0.03, 0.08, 0.15, 0.25), (1.5, 2.0, 3.0, 4.5))]
"""Shares and scales of mishits between which shots may leave open what the golfer is."""
NO_MISHITS = 0.15
"""How likely the first of these is before any shot is seen; the others are all alike."""
EFFECTIVE_SHARE = 2 / 3
"""Number of independent shots that a difference of successive shots counts as, since each shot is in two of them: the
variance of a spread is 1/2 about the mean, and 3/4 from differences (``STANDARD_ERROR``)."""
BLOCKS = 20
"""Parts of a longer session, of which each is left out once to see how sure the spreads are (jackknife)."""
OF_FEW = 1.07
"""How much wider intervals from so few parts are: Student's distribution of 19 degrees of freedom, 2.09 for 1.96."""


class Mixture(NamedTuple):
    """The covariance of shots that are no mishits, and share and scale of those that are."""

    covariance: Floats
    share: float
    scale: float


def mixture(steps: Floats) -> Mixture:
    """Return the mixture of the greatest likelihood; share 0 where mishits gain too little."""
    result = Mixture(covariance_of(steps, 0.0, 1.0), 0.0, 1.0)
    best, covariance = _weighed(steps, result).likelihood + GAIN, result.covariance
    for scale in map(float, SCALES):
        share = 0.1
        for _ in range(ROUNDS):
            covariance = covariance_of(steps, share, scale, start=covariance)
            before, share = share, _weighed(steps, Mixture(covariance, share, scale)).mishits
            if abs(share - before) < 1e-5:
                break
        if (likelihood := _weighed(steps, Mixture(covariance, share, scale)).likelihood) > best:
            best, result = likelihood, Mixture(covariance, share, scale)
    return result


def covariance_of(steps: Floats, share: float, scale: float, *, start: Floats | None = None) -> Floats:
    """Return the covariance of shots that are no mishits, of the greatest likelihood for a share and scale of these.

    ``start`` is a covariance to begin with, such as that of another share.
    """
    first, _ = shrunk(steps, np.full(len(steps), 0.5))
    covariance = first if start is None else start
    for _ in range(ROUNDS):
        weights = _weighed(steps, Mixture(covariance, share, scale)).weights
        before, (covariance, _) = covariance, shrunk(steps, weights)
        size = np.sqrt(np.outer(np.diag(first), np.diag(first)))
        if (np.diag(covariance) < VANISHES * np.diag(first)).any():
            raise np.linalg.LinAlgError
        if (np.abs(covariance - before) <= SETTLED * size).all():
            break
    return covariance


def shrunk(steps: Floats, weights: Floats) -> tuple[Floats, float]:
    """Return the covariance of weighted differences of shots, and the share by which correlations are shrunk.

    The share is that of Ledoit and Wolf (2004): the sum of the variances of correlations over that of their squares.
    Their target is a multiple of the identity; here each quantity is in its own spread, so that spreads stay.
    ``weights``, by which the square of each of the ``steps`` counts, shape (n,), are 1/2 each for normally distributed
    shots.
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


class _Weighed(NamedTuple):
    """How differences of shots fit a covariance: expected 1 / width, log likelihood, estimated share of mishits."""

    weights: Floats
    likelihood: float
    mishits: float


def _weighed(steps: Floats, mixed: Mixture) -> _Weighed:
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
    return _Weighed((each / widths).sum(axis=1), likelihood, float((each[:, 1] + 2.0 * each[:, 2]).mean() / 2.0))


def error_of(steps: Floats, mixed: Mixture) -> Floats:
    """Return the standard errors of the spreads: of the sample, and of not knowing the mishits."""
    covariance, share, scale = mixed
    spread = np.sqrt(np.diag(covariance))
    of_sample = spread * np.sqrt(STANDARD_ERROR / (len(steps) + 1))
    if len(steps) + 1 >= ENOUGH:
        parts = np.array_split(np.arange(len(steps)), BLOCKS)
        without = [np.delete(steps, part, axis=0) for part in parts]
        spreads = np.sqrt([np.diag(covariance_of(each, share, scale, start=covariance)) for each in without])
        of_sample = np.maximum(of_sample, OF_FEW * np.sqrt((BLOCKS - 1) * spreads.var(axis=0)))
    return np.hypot(of_sample, spread * _doubt(steps, spread))


def _doubt(steps: Floats, spread: Floats) -> Floats:
    """Return how far off the spreads are in proportion: in the root mean square over mixtures by their likelihood."""
    mixtures = [Mixture(covariance_of(steps, *each), *each) for each in MIXTURES]
    logs = np.array([_weighed(steps, each).likelihood for each in mixtures])
    before = [NO_MISHITS, *[(1.0 - NO_MISHITS) / (len(MIXTURES) - 1)] * (len(MIXTURES) - 1)]
    chances = before * np.exp(EFFECTIVE_SHARE * (logs - logs.max()))
    away = np.log(np.sqrt([np.diag(each.covariance) for each in mixtures]) / spread)
    return np.sqrt(chances @ away**2 / chances.sum())


def mean_of(values: Floats, mixed: Mixture) -> Floats:
    """Return the mean in which a shot counts the less, the more likely it is a mishit."""
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
    """Estimate a golfer from shots in the order in which they were hit, without mishits that their flight shows.

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
        :func:`clubface.shots.measured.ready_shots`.

    Raises
    ------
    InputError
        There are fewer than ``FEWEST`` shots, shots of several players or clubs, or quantities of which one follows
        from the others.
    """
    shots = ready_shots(shots, club=club, hand=hand, only=only, where=where, mismatch=mismatch, assume=assume)
    if shots.groups() is not None:
        raise InputError(
            "players", Wording("several"), "one: take the shots of one player, as with where=\"player == 'A'\""
        )
    if shots.hand is not None and len(set(shots.hand)) > 1:
        raise InputError("hand", Wording("right and left"), "one hand: take the shots of one player")
    mishits = find_mishits({**shots.deliveries, **shots.launches})
    mishit = is_mishit(mishits, len(shots))
    if mishits:
        shots = shots.select(~mishit)
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
            mishits_of_base = base.mishit_share, base.mishit_scale
            mixed = Mixture(covariance_of(steps, *mishits_of_base), *mishits_of_base)
        else:
            mixed = mixture(steps)
        mean, error = mean_of(values, mixed), error_of(steps, mixed)
        _, shrinks = shrunk(steps, _weighed(steps, mixed).weights)
    except np.linalg.LinAlgError:
        problem = Wording("such that one quantity follows from others or hardly ever changes")
        raise InputError("shots", problem, f"leave out the column of one of {', '.join(names)}") from None
    together = _together(base, names, mean, mixed.covariance, same, shots)
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
        drift = 1.0 / np.sqrt(_zigzag(before))
    left_out = [note("golfer-mishits-left-out", mishits=int(mishit.sum()), shots=len(mishit))] if mishits else []
    notes = (*left_out, *_notes(shots, len(values), names, base, drift, same, order, shrinks))
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
        why = "".join(f"; {each}" for each in shots.notes if _explains_missing_speed(each))
        raise InputError(
            "session",
            Wording("without club speed"),
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
            Wording(f"{len(values)} with all of {', '.join(names)}"),
            f"at least {FEWEST} such shots: with fewer, a spread is not known even to a factor of two",
        )
    if "speed" in same:
        raise InputError("shots", Wording("all of one club speed"), "shots whose club speed was measured")
    return tuple(name for name in names if name not in same), values[:, varies], same


def _explains_missing_speed(remark: Note) -> bool:
    impossible = remark.code == "impossible-values" and "speed" in remark.data["example"]
    return impossible or remark.code in (
        "column-misspelled", "columns-not-read", "faster-than-club", "speed-of-club-or-ball", "without-club-data",
    )  # fmt: skip


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
"""Share by which a figure is taken to be off."""
COUNT = 2**15
"""Shots of each change; with them a change of a standard deviation is known to about a hundredth of it (of amateurs'
drives, whose few worst mishits count most; of others better)."""
QUANTITIES = ("carry", "side")
LEAST = 0.01
"""Least eigenvalue of correlations made stronger: what is left of a variable that all but follows from others."""


class Doubt(NamedTuple):
    """What the landings do if one figure is smaller or larger.

    The ``figure`` has its name of :meth:`Golfer.source`, and is ``assumed`` where it has no published or measured
    source; ``spread`` is the standard deviation [m] of each of ``QUANTITIES`` with it smaller and larger.
    """

    figure: str
    assumed: bool
    spread: dict[str, tuple[float, float]]


class Doubts(NamedTuple):
    """How far the spread of the landings rests on each figure, the one that changes the landings most first.

    Every figure is changed by the share ``off``; ``spread`` is the standard deviation [m] of each of ``QUANTITIES``
    with all as they are. Each change is of so many ``shots``.
    """

    off: float
    spread: dict[str, float]
    figures: tuple[Doubt, ...]
    shots: int = COUNT

    def changes(self, doubt: Doubt, name: str) -> tuple[float, float]:
        """Return by which share a quantity spreads more with the figure smaller and larger; 0 if it never differs."""
        now, (less, more) = self.spread[name], doubt.spread[name]
        return (less / now - 1.0, more / now - 1.0) if now > 0.0 else (0.0, 0.0)


def doubts(golfer: Golfer, club: Club, *, off: float = OFF, count: int = COUNT) -> Doubts:
    """Hit a golfer's shots with each spread, the correlations and the share of mishits off by ``off`` either way.

    It is by the default model in still air, with ``count`` shots of each change; ``off`` is a share.
    """
    if not 0.0 < off < 1.0:
        raise InputError("off", off, "a share between 0 and 1")
    player = golfer.for_hand(club.hand)

    def spreads(varied: Golfer) -> dict[str, float]:
        shots = dispersion(varied, club, count=count)
        return {name: shots.spread(name) for name in QUANTITIES}

    figures = []
    for figure in _varying(player):
        less, more = (spreads(changed(player, figure, factor)) for factor in (1.0 - off, 1.0 + off))
        both = {name: (less[name], more[name]) for name in QUANTITIES}
        figures.append(Doubt(figure, is_assumed(golfer, figure), both))
    result = Doubts(off, spreads(player), tuple(figures), count)
    order = sorted(figures, key=lambda each: -max(abs(result.changes(each, name)[1]) for name in QUANTITIES))
    return result._replace(figures=tuple(order))


def changed(golfer: Golfer, figure: str, factor: float) -> Golfer:
    """Return a golfer one of whose figures is ``factor`` times as large, all others as they are."""
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
    """Return correlations that are possible together, near those given: eigenvalues are raised to ``LEAST``.

    Strong correlations made stronger may contradict each other.
    """
    values, vectors = np.linalg.eigh(correlation)
    if values[0] >= LEAST:
        return correlation
    raised = (vectors * np.maximum(values, LEAST)) @ vectors.T
    scale = np.sqrt(np.diag(raised))
    scaled = raised / np.outer(scale, scale)
    np.fill_diagonal(scaled, 1.0)
    return 0.5 * (scaled + scaled.T)


def _varying(golfer: Golfer) -> list[str]:
    """Return the figures that spread the shots: spreads above 0, correlations and mishits."""
    still = {f"spread of {name}" for name, each in zip(golfer.variables, golfer.spread, strict=True) if each == 0.0}
    return [each for each in golfer.figures() if not each.startswith("mean") and each not in still]
