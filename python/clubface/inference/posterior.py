"""Posteriors: a sample of the deliveries that can have made a launch, and what it says in words.

A sample of the deliveries that can have made a launch.

A posterior in tables and words: what is known, which quantities are tied, and what the launch leaves open.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from clubface import units
from clubface.equipment.clubs import Club
from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError
from clubface.inference.importance import Sample
from clubface.inference.prior import FAR, Prior, shown as with_unit, unit_of as unit_of
from clubface.shots.recorded import RecordedShots
from clubface.simulation.inputs import OF_CLUB
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice

if TYPE_CHECKING:
    import pandas


FEWEST_EFFECTIVE = 400
"""Effective draws below which a sample should not be trusted."""
SURPRISING = 0.001
"""Probability under the prior below which a shot contradicts it."""
MOST_WEIGHT = 0.05
"""Part of the weight on one draw from which it is warned of."""
DIGITS = {"mph": 1, "deg": 1, "mm": 1, "deg/s": 0}


def shown(value: float, name: str) -> str:
    """Write a value [SI] of a quantity of a delivery in its unit."""
    unit = unit_of(name)
    return f"{float(units.from_si(value, unit)):.{DIGITS[unit]}f}"


@dataclass(frozen=True, kw_only=True, eq=False)
class Posterior:
    """Deliveries that can have made a launch, equally probable, in SI units.

    Attributes
    ----------
    deliveries
        Values of each uncertain quantity, one for each draw.
    launch
        The measured launch.
    delivery
        What was measured of the club and is part of the prior.
    known
        What was measured of the club and is no part of the prior: it is taken as exact.
    noise
        Standard deviations of the measurement, of launch and delivery.
    prior
        What was believed about the delivery before the launch was known.
    club, model, parameters
        With what the launches were computed.
    sample
        How the sample was drawn.
    surprise
        Probability, under the prior, of a shot that lies further from the expected ones than this.
    expected
        What the prior expects of the measured quantities that are far from it, in words; "" if none is.
    reproduced
        Mean of each measured quantity over the draws, which are close to the measured ones if the model can make them.
    seed
        Seed of the random numbers.
    outside
        What the mean delivery is outside of, in one line: the range of the model or of its parameters; or "".
    """

    deliveries: dict[str, Floats]
    launch: dict[str, float]
    delivery: dict[str, float]
    known: dict[str, float]
    noise: dict[str, float]
    prior: Prior
    club: Club
    model: str
    parameters: ParameterSet
    sample: Sample
    surprise: float
    expected: str
    reproduced: dict[str, float]
    seed: int
    outside: str = ""

    @property
    def effective(self) -> float:
        """Effective number of independent draws on which the sample rests."""
        return self.sample.effective

    @property
    def names(self) -> tuple[str, ...]:
        """The uncertain quantities."""
        return tuple(self.deliveries)

    def __len__(self) -> int:
        return len(self.deliveries["speed"])

    @property
    def mean(self) -> dict[str, float]:
        """Mean of each quantity."""
        return {name: float(values.mean()) for name, values in self.deliveries.items()}

    @property
    def deviation(self) -> dict[str, float]:
        """Standard deviation of each quantity."""
        return {name: float(values.std(ddof=1)) for name, values in self.deliveries.items()}

    def interval(self, name: str, confidence: float = 0.95) -> tuple[float, float]:
        """Return the central interval that holds ``confidence`` of the draws of a quantity."""
        check_choice("quantity of the delivery", name, self.deliveries)
        if not 0.0 < confidence < 1.0:
            raise InputError("confidence", confidence, "between 0 and 1")
        low, high = np.quantile(self.deliveries[name], [0.5 - confidence / 2, 0.5 + confidence / 2])
        return float(low), float(high)

    @property
    def learned(self) -> dict[str, float]:
        """How much narrower each quantity is than its prior: one minus the ratio of standard deviations, 0 to 1."""
        return {name: max(0.0, 1.0 - each / self.prior.deviation[name]) for name, each in self.deviation.items()}

    @property
    def correlation(self) -> Floats:
        """Correlation of the quantities, in the order of ``names``."""
        return np.atleast_2d(np.corrcoef(np.stack(list(self.deliveries.values()))))

    @property
    def warnings(self) -> list[str]:
        """Reasons not to trust the sample."""
        found = [*self._against_the_prior(), *self._not_reproduced()]
        wanted = min(FEWEST_EFFECTIVE, len(self))
        if self.effective < wanted:
            found.append(
                f"only {self.effective:.0f} draws are effective (of {self.sample.draws}): the sample is too small"
                " to be trusted"
            )
        if self.sample.largest_weight > MOST_WEIGHT:
            found.append(f"a single draw has {self.sample.largest_weight:.0%} of the weight")
        return found

    def _against_the_prior(self) -> list[str]:
        """Say where the measured values and the deliveries found are far from what was believed before."""
        found = []
        if self.surprise < SURPRISING:
            told = f"expects {self.expected}" if self.expected else "hardly ever makes these values together"
            found.append(
                f"what was measured contradicts the prior ({self.prior.name}), which by {self.model} {told}; check"
                " units and club, or give a prior that suits the golfer"
            )
        mean = self.mean
        far = []
        for name, value in mean.items():
            before, spread = self.prior.mean[name], self.prior.deviation[name]
            away = abs(value - before) / spread
            if away > FAR:
                far.append(
                    f"{name} {with_unit(name, value, 3)} is {away:.1f} standard deviations from"
                    f" {with_unit(name, before, 3)}"
                )
        if far:
            found.append(f"a delivery far from the prior: {', '.join(far)}")
        return found

    def _not_reproduced(self) -> list[str]:
        """Say which measured values the deliveries found do not make."""
        measured = {**self.launch, **self.delivery}
        far = [
            f"{name} {with_unit(name, value, 4)} ({with_unit(name, self.reproduced[name], 4)})"
            for name, value in measured.items()
            if not abs(self.reproduced[name] - value) <= FAR * self.noise[name]
        ]
        return [f"not reproduced by these deliveries: {', '.join(far)}"] if far else []

    def shots(self) -> RecordedShots:
        """Return the draws as recorded shots, which can be written and predicted."""
        count = len(self)
        return RecordedShots(
            deliveries=dict(self.deliveries),
            launches={},
            clubs=np.full(count, self.club.name, dtype=object),
            hand=np.full(count, "right" if self.club.hand > 0 else "left", dtype=object),
            rows=np.arange(1, count + 1),
            source="posterior",
            format="clubface",
        )

    def to_pandas(self) -> pandas.DataFrame:
        """Return one row a draw, SI."""
        import pandas

        return pandas.DataFrame(self.deliveries)

    def __repr__(self) -> str:
        mean, deviation = self.mean, self.deviation
        heads = {name: f"{name} ({unit_of(name)})" for name in self.names}
        width = max(map(len, heads.values()))
        lines = [f"{len(self)} deliveries of {self.club.name} for one launch by {self.model}, prior {self.prior.name}"]
        for name, head in heads.items():
            lines.append(f"  {head:<{width}}  {shown(mean[name], name):>9} +- {shown(deviation[name], name)}")
        return "\n".join(lines)


CLOSE = 0.5
"""Correlation from which two quantities are said to go together."""
NOT_LEARNED = 0.05
"""Narrowing below which a launch is said to tell nothing of a quantity."""


def summary(of: Posterior) -> tuple[list[str], list[list[str]]]:
    """Return headings and rows: mean, standard deviation and 95% interval of each quantity, and what was believed."""
    heads = ["", "mean", "STD", "95%", "before", "narrower by"]
    mean, deviation, learned = of.mean, of.deviation, of.learned
    rows = []
    for name in of.names:
        low, high = of.interval(name)
        rows.append(
            [
                f"{name} ({unit_of(name)})",
                shown(mean[name], name),
                shown(deviation[name], name),
                f"[{shown(low, name)}, {shown(high, name)}]",
                f"{shown(of.prior.mean[name], name)} +- {shown(of.prior.deviation[name], name)}",
                f"{100.0 * learned[name]:.0f}%",
            ]
        )
    return heads, rows


def ambiguities(of: Posterior) -> list[str]:
    """Return a sentence about each pair of quantities that are tied together, the closest first."""
    correlation, names, same = of.correlation, of.names, not_learned(of)
    pairs = [
        (abs(correlation[i, j]), i, j)
        for i in range(len(names))
        for j in range(i)
        if names[i] not in same or names[j] not in same
    ]
    found = []
    for size, i, j in sorted(pairs, reverse=True):
        if size < CLOSE:
            break
        one, other = sorted((names[i], names[j]), key=lambda name: -of.deviation[name] / of.prior.deviation[name])
        slope = float(correlation[i, j]) * of.deviation[other] / of.deviation[one]
        step = units.parse(f"1 {unit_of(one)}", OF_CLUB[one])
        change = float(units.from_si(slope * step, unit_of(other)))
        word = "more" if change > 0 else "less"
        found.append(
            f"{one} and {other} are tied (correlation {correlation[i, j]:+.2f}): 1 {unit_of(one)} more {one} with"
            f" {abs(change):.2g} {unit_of(other)} {word} {other} makes about the same launch"
        )
    return found


def not_learned(of: Posterior) -> list[str]:
    """Return the quantities that are as uncertain as before."""
    return [name for name, part in of.learned.items() if part < NOT_LEARNED]


def notes(of: Posterior) -> list[str]:
    """Return what a reader of the tables must know."""
    given = ", ".join(
        f"{name} {with_unit(name, value, 5)} +- {with_unit(name, of.noise[name], 2)}"
        for name, value in {**of.launch, **of.delivery}.items()
    )
    found = [*of.warnings]
    found.append(f"Measured: {given}. Before: {of.prior.name}.")
    if of.known:
        told = ", ".join(f"{name} {with_unit(name, value, 4)}" for name, value in of.known.items())
        found.append(f"Measured, and taken as exact since the prior leaves it out: {told}.")
    found += [f"{text}." for text in ambiguities(of)]
    unknown = not_learned(of)
    if unknown:
        what = "The launch tells" if not of.delivery else "What was measured tells"
        found.append(f"{what} nothing of {', '.join(unknown)}: there the prior is seen again.")
    found.append(
        f"{of.model} with {of.parameters.name} is taken as exact; its errors belong into the noise. {len(of)} draws"
        f" from {of.sample.draws} weighted ones, of which {of.effective:.0f} are effective;"
        f" {of.sample.evaluations} impacts, seed {of.seed}."
    )
    return found


def document(of: Posterior) -> dict[str, Any]:
    """Return everything but the draws as one document for JSON, SI."""
    return {
        "club": of.club.name,
        "model": of.model,
        "parameters": {"name": of.parameters.name, "values": dict(of.parameters.values)},
        "launch": of.launch,
        "delivery": {**of.delivery, **of.known},
        "noise": of.noise,
        "prior": {
            "name": of.prior.name,
            "mean": dict(of.prior.mean),
            "deviation": dict(of.prior.deviation),
            "correlations": [[*pair, value] for pair, value in of.prior.correlations.items()],
        },
        "units": {name: units.SI_UNITS[OF_CLUB[name]] for name in of.names},
        "mean": of.mean,
        "deviation": of.deviation,
        "interval_95": {name: list(of.interval(name)) for name in of.names},
        "learned": of.learned,
        "names": list(of.names),
        "correlation": np.round(of.correlation, 6),
        "ambiguities": ambiguities(of),
        "not_learned": not_learned(of),
        "diagnostics": {
            "samples": len(of),
            "effective": of.effective,
            "draws": of.sample.draws,
            "impacts": of.sample.evaluations,
            "stages": of.sample.stages,
            "largest_weight": of.sample.largest_weight,
            "log_evidence": of.sample.log_evidence,
            "surprise": of.surprise,
            "reproduced": of.reproduced,
            "seed": of.seed,
        },
        "warnings": of.warnings,
    }
