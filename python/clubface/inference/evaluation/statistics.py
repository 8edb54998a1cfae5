"""Statistics of model errors: sizes with intervals, significance of differences, trends, and the noise floor.

The noise floor is the error of a perfect model when launch and delivery are measured with noise.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from statistics import NormalDist
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError, Wording
from clubface.inference.evaluation.published_accuracy import monitor_errors
from clubface.shots.measured import QUANTITIES
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice

CONFIDENCE = 0.95
SIGNIFICANCE = 0.05
_CHUNK, _KEPT = 1_000_000, 8_000_000
"""Number of resamples times shots drawn at a time, and the largest number kept instead of drawn again."""


TO_MEAN_ABSOLUTE = math.sqrt(2.0 / math.pi)
"""Mean absolute value of a standard normal deviate."""
MONITOR = {name: error / TO_MEAN_ABSOLUTE for name, error in monitor_errors().items()}
"""Default standard deviations of a monitor [SI], from the mean errors that Caldwell and McPhee (2023) quote for theirs,
0.2 deg and 50 rpm."""
DRAWS = 8
"""Number of perturbed copies per shot for estimating the effect of noise in the delivery."""
_LAUNCH_DIMENSIONS = {name: units.unit(unit).dimension for name, unit in QUANTITIES.items()}


class Interval(NamedTuple):
    """A 95% confidence interval; NaN if there are fewer than two different shots."""

    low: float
    high: float


class ErrorSize(NamedTuple):
    """The size of one model's errors in one quantity, in SI units.

    Attributes
    ----------
    shots
        Number of shots compared.
    bias
        Mean of model minus measured values; its interval is ``bias_interval``.
    mae
        Mean absolute error; its interval is ``mae_interval``.
    std
        Standard deviation of the error (n - 1); NaN for a single shot.
    rms, worst
        Root mean square and largest magnitude of the error.
    """

    shots: int
    bias: float
    bias_interval: Interval
    mae: float
    mae_interval: Interval
    std: float
    rms: float
    worst: float


class Rival(NamedTuple):
    """A model compared with the one with the smallest mean absolute error.

    Attributes
    ----------
    model
        Name of the model.
    difference
        Its mean absolute error minus that of the best model, with its interval.
    p
        Two-sided p-value that resampled shots favour the other model as clearly, with Holm's correction for the number
        of rivals. Before the correction it is bounded below by the smallest p-value of a sign-flip test with as many
        shots.
    """

    model: str
    difference: float
    interval: Interval
    p: float

    @property
    def is_worse(self) -> bool:
        """Whether the difference is significant at 5%."""
        return self.p < SIGNIFICANCE


class Best(NamedTuple):
    """The best model in one quantity, and how certain that is.

    Attributes
    ----------
    model
        The model with the smallest mean absolute error.
    rivals
        The other models, closest first.
    """

    model: str
    rivals: tuple[Rival, ...]

    @property
    def equals(self) -> tuple[str, ...]:
        """The models that are not significantly worse."""
        return tuple(each.model for each in self.rivals if not each.is_worse)


class Resamples:
    """Bootstrap resamples of shots, or of groups of shots, such as the shots of one player.

    Means over a resample are weighted means over the shots, so that all models and quantities share the same resamples;
    the same seed gives the same ones. ``groups`` has one label per shot; without it, every shot is a group.
    """

    def __init__(
        self, count: int, shots: int, seed: int, groups: Sequence[object] | NDArray[np.generic] | None
    ) -> None:
        self.count = count
        self._shots = shots
        self._seed = seed
        self._weights: Floats | None = None
        names, self._group = np.unique(np.arange(shots) if groups is None else np.asarray(groups), return_inverse=True)
        self.groups = len(names)
        """Number of groups drawn."""

    def means(self, values: Floats) -> Floats:
        """Return the means of ``values``, shape [columns, shots], in each resample: [resamples, columns]."""
        if self.count * self._shots <= _KEPT:
            if self._weights is None:
                self._weights = np.concatenate(list(self._draw_weights()))
            return self._weights @ values.T
        return np.concatenate([weights @ values.T for weights in self._draw_weights()])

    def _draw_weights(self) -> Iterator[Floats]:
        """Yield the weights of the shots, which sum to 1, in blocks of resamples: [resamples, shots]."""
        random = np.random.default_rng(self._seed)
        step = max(1, _CHUNK // self._shots)
        for first in range(0, self.count, step):
            size = min(step, self.count - first)
            drawn = (random.random((size, self.groups)) * self.groups).astype(np.int64)
            offsets = self.groups * np.arange(size)[:, None]
            counts = np.bincount((drawn + offsets).ravel(), minlength=size * self.groups)
            weights = counts.reshape(size, self.groups)[:, self._group].astype(np.float64)
            yield weights / weights.sum(axis=1, keepdims=True)


def group_labels(groups: Any, shots: int) -> NDArray[Any]:
    """Return the group labels, one per shot."""
    labels = np.asarray(groups)
    if labels.shape != (shots,):
        raise InputError("groups", Wording(f"of shape {labels.shape}"), f"one for each shot: ({shots},)")
    return labels


def interval(resampled: Floats, groups: int) -> Interval:
    """Return the percentile interval of means resampled from ``groups`` groups; NaN for fewer than two.

    The interval is widened by the ratio of Student's t to the normal distribution, because plain percentiles are too
    narrow for few groups: T. C. Hesterberg, What teachers should know about the bootstrap, The American Statistician 69
    (2015) 371-386.
    """
    if groups < 2:
        return Interval(math.nan, math.nan)
    normal, degrees = NormalDist(), groups - 1
    part = normal.cdf(math.sqrt(groups / degrees) * _students_t(normal.inv_cdf(0.5 + CONFIDENCE / 2), degrees))
    low, high = np.quantile(resampled, [1.0 - part, part])
    return Interval(float(low), float(high))


def _students_t(z: float, degrees: int) -> float:
    """Return the quantile of Student's t from the normal quantile, by Abramowitz and Stegun 26.7.5.

    For two degrees of freedom it is 3% low, but such a quantile is beyond all resamples anyway.
    """
    terms = (
        z,
        (z**3 + z) / 4.0,
        (5.0 * z**5 + 16.0 * z**3 + 3.0 * z) / 96.0,
        (3.0 * z**7 + 19.0 * z**5 + 17.0 * z**3 - 15.0 * z) / 384.0,
    )
    return sum(term / degrees**power for power, term in enumerate(terms))


def error_sizes(errors: Mapping[str, Floats], resamples: Resamples) -> tuple[dict[str, ErrorSize], Best]:
    """Return the error sizes of each model in one quantity, and the best model by paired bootstrap.

    ``errors`` are model minus measured values by model name, for the same shots in the order of the ``resamples``.
    """
    names, table = list(errors), np.stack(list(errors.values()))
    # Exact copies of a shot carry no further information.
    different = min(resamples.groups, len(np.unique(table, axis=1).T))
    means = resamples.means(np.concatenate([table, np.abs(table)]))
    signed, absolute = means[:, : len(names)], means[:, len(names) :]
    sizes = {}
    for place, name in enumerate(names):
        error = table[place]
        sizes[name] = ErrorSize(
            shots=error.size,
            bias=float(error.mean()),
            bias_interval=interval(signed[:, place], different),
            mae=float(np.abs(error).mean()),
            mae_interval=interval(absolute[:, place], different),
            std=float(error.std(ddof=1)) if error.size > 1 else float("nan"),
            rms=float(np.sqrt(np.mean(error**2))),
            worst=float(np.abs(error).max()),
        )
    mae = {name: sizes[name].mae for name in names}
    return sizes, best_of(mae, dict(zip(names, absolute.T, strict=True)), different)


def best_of(mae: Mapping[str, float], resampled: Mapping[str, Floats], groups: int) -> Best:
    """Return the model with the smallest mean absolute error, and the significance of its lead over each other model.

    ``mae`` is the mean absolute error by model name, ``resampled`` the same over each resample, paired. ``groups`` is
    the number of groups drawn; with fewer than ``fewest_groups`` no difference is significant.
    """
    # All groups favour the same model in two of 2^groups sign patterns.
    least = 2.0 ** (1 - groups)
    first = min(mae, key=lambda name: mae[name])
    rivals = []
    for name in sorted((each for each in mae if each != first), key=lambda name: mae[name]):
        lead = resampled[name] - resampled[first]
        # One more resample on either side, so that no finite number of them gives a probability of zero.
        tails = [(1.0 + float(np.sum(side))) / (1.0 + lead.size) for side in (lead <= 0.0, lead >= 0.0)]
        p = min(1.0, max(least, 2.0 * min(tails)))
        rivals.append(Rival(name, mae[name] - mae[first], interval(lead, groups), p))
    corrected = holm([each.p for each in rivals])
    return Best(first, tuple(each._replace(p=p) for each, p in zip(rivals, corrected, strict=True)))


def fewest_resamples(models: int) -> int:
    """Return the minimum number of resamples to find one of several models significantly worse.

    The smallest two-sided p-value of B resamples is 2 / (B + 1); times the number of rivals (Holm's correction) it must
    stay below ``SIGNIFICANCE``.
    """
    return math.ceil(2.0 * (models - 1) / SIGNIFICANCE - 1e-9)


def fewest_groups(models: int) -> int:
    """Return the minimum number of shots, or groups of shots, to find one of several models significantly worse.

    The smallest p-value of G groups is 2^(1 - G), multiplied by the number of rivals (Holm's correction).
    """
    return 2 + math.floor(math.log2(max(1, models - 1) / SIGNIFICANCE) + 1e-9)


def holm(probabilities: Sequence[float]) -> list[float]:
    """Return probabilities corrected for multiple comparisons by Holm (1979), in the given order."""
    given = np.array(probabilities)
    order = np.argsort(given, kind="stable")
    corrected = np.empty(len(given))
    corrected[order] = np.maximum.accumulate(np.minimum(1.0, np.arange(len(given), 0, -1) * given[order]))
    return corrected.tolist()


COVARIATES = {"speed": "mph", "path": "deg", "toe": "mm", "high": "mm", "attack": "deg", "loft": "deg", "face": "deg"}
"""The delivery quantities used as covariates of errors, each with its unit."""
FEWEST_SHOTS = 3
LEAST_SPREAD = 1e-9
"""A covariate with a smaller relative spread than this counts as constant."""


class Trend(NamedTuple):
    """A straight-line fit to one model's errors in one quantity over one delivery value, in SI units.

    Attributes
    ----------
    covariate
        The delivery value on the horizontal axis.
    slope
        Change of the error per unit of the covariate, with its interval.
    explained
        Fraction of the error's variance explained by the line, 0 to 1.
    """

    covariate: str
    slope: float
    interval: Interval
    explained: float

    @property
    def is_clear(self) -> bool:
        """Whether the interval excludes zero."""
        return self.interval.low > 0.0 or self.interval.high < 0.0


def trends(
    errors: Mapping[str, Floats], delivery: Mapping[str, Floats], resamples: Resamples
) -> dict[str, list[Trend]]:
    """Return the trend lines of each model over the covariates that were measured and vary.

    ``errors`` are model minus measured values of one quantity by model name, for the same shots as ``delivery``.
    """
    covariates = {
        name: values
        for name in COVARIATES
        if (values := delivery.get(name)) is not None and np.ptp(values) > LEAST_SPREAD * np.abs(values).max()
    }
    lines: dict[str, list[Trend]] = {name: [] for name in errors}
    centred = np.stack([each - each.mean() for each in errors.values()])
    if centred.shape[1] < FEWEST_SHOTS:
        return lines
    mean_errors = resamples.means(centred)
    for name, values in covariates.items():
        deviation = float(values.std())
        x = (values - values.mean()) / deviation
        means = resamples.means(np.concatenate([[x, x * x], x * centred]))
        spread = means[:, 1] - means[:, 0] ** 2
        usable = spread > LEAST_SPREAD
        resampled = (means[:, 2:] - means[:, :1] * mean_errors)[usable] / spread[usable, None]
        for place, model in enumerate(errors):
            slope, variance = float(np.mean(x * centred[place])), float(np.mean(centred[place] ** 2))
            ends = interval(resampled[:, place] / deviation, resamples.groups)
            explained = slope**2 / variance if variance > 0.0 else 0.0
            lines[model].append(Trend(name, slope / deviation, ends, explained))
    return lines


def standard_deviations(given: Mapping[str, Any] | None, dimensions: Mapping[str, str], what: str) -> dict[str, float]:
    """Return standard deviations in SI from text with units or SI numbers; ``what`` names them in errors."""
    deviations = {}
    for name, value in (given or {}).items():
        check_choice(f"quantity of {what}", name, dimensions)
        deviations[name] = units.parse(value, dimensions[name], name=f"{what} {name}")
        if deviations[name] < 0.0:
            raise InputError(f"{what} {name}", value, "a standard deviation, not negative")
    return deviations


def monitor_noise(given: Mapping[str, Any] | None) -> dict[str, float]:
    """Return the standard deviations of the monitor: ``MONITOR``, updated with the ``given`` values."""
    return {**MONITOR, **standard_deviations(given, _LAUNCH_DIMENSIONS, "noise")}


def error_floor(
    predict: Callable[[Mapping[str, Floats]], Mapping[str, Floats]] | None,
    delivery: Mapping[str, Floats],
    monitor: Mapping[str, float],
    disturbance: Mapping[str, float],
    seed: int,
) -> dict[str, float]:
    """Return the mean absolute error of a perfect model [SI] in each quantity whose noise is known.

    ``predict`` computes launches from deliveries with the model taken as the truth; it is not needed without
    ``disturbance``. ``monitor`` and ``disturbance`` are the standard deviations of the measured launch and delivery
    quantities, whose errors are independent and normally distributed.
    """
    if not disturbance or predict is None:
        return {name: TO_MEAN_ABSOLUTE * monitor[name] for name in QUANTITIES if name in monitor}
    random = np.random.default_rng(seed)
    undisturbed = predict(delivery)
    squares = dict.fromkeys(QUANTITIES, 0.0)
    for _ in range(DRAWS):
        moved = dict(delivery)
        for name, deviation in disturbance.items():
            centre = moved.get(name, 0.0)
            moved[name] = centre + deviation * random.standard_normal(len(delivery["speed"]))
        launch = predict(moved)
        for name in QUANTITIES:
            squares[name] += float(np.nanmean((launch[name] - undisturbed[name]) ** 2)) / DRAWS
    return {
        name: TO_MEAN_ABSOLUTE * math.hypot(math.sqrt(squares[name]), monitor.get(name, 0.0)) for name in QUANTITIES
    }
