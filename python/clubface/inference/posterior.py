"""A sample of the deliveries that can have made a launch."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from clubface import units
from clubface.equipment.clubs import Club
from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError
from clubface.inference.expectation import FAR, shown as with_unit, unit_of as unit_of
from clubface.inference.importance import Sample
from clubface.inference.prior import Prior
from clubface.recorded.shots import RecordedShots
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
