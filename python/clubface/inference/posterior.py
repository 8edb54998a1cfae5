"""Posteriors: a sample of the deliveries that could have produced a launch, with statistics and pictures."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from clubface import units
from clubface.equipment.clubs import Club
from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError
from clubface.inference.evaluation.result import error_quantity
from clubface.inference.importance import Sample
from clubface.inference.prior import FAR, Prior, shown, unit_of
from clubface.quantities import bare_value, quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, table, text
from clubface.shots.recorded import RecordedShots
from clubface.simulation.impact import Tally
from clubface.simulation.inputs import OF_CLUB
from clubface.simulation.launch import Launch
from clubface.simulation.provenance import provenance_of
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice

if TYPE_CHECKING:
    import pandas

FEWEST_EFFECTIVE = 400
"""Number of effective draws below which a sample should not be trusted."""
SURPRISING = 0.001
"""Probability below which a shot contradicts the prior."""
MOST_WEIGHT = 0.05
"""Share of the weight on one draw above which a warning is given."""
CLOSE = 0.5
"""Magnitude of the correlation above which two quantities are called tied."""
NOT_LEARNED = 0.05
"""Narrowing below which a launch contains no information on a quantity."""
MOST_QUANTITIES, MOST_POINTS, BINS = 7, 2000, 30
"""Maximum number of quantities and draws in a picture, and number of bars of a histogram."""


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Posterior(Described):
    """Equally probable deliveries that could have produced a launch, in SI units.

    Attributes
    ----------
    deliveries
        Values of each uncertain quantity, one per draw.
    launch
        The measured launch.
    delivery
        Measured club data among the quantities of the prior.
    known
        Measured club data not among the quantities of the prior, taken as exact.
    noise
        Standard deviations of the measured launch and delivery quantities.
    prior
        The prior distribution of deliveries.
    club, model, parameters
        Club, model and parameters that the launches were computed with.
    sample
        The sample with its size and diagnostics.
    surprise
        Probability under the prior of a shot that deviates more from the expected ones.
    expected
        Expected value in words of each measured quantity that is far from the prior.
    reproduced
        Mean of each measured quantity over the draws, close to the measured value if the model can reproduce it.
    seed
        Seed of the random numbers.
    struck
        Launch of the mean delivery.
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
    expected: list[str]
    reproduced: dict[str, float]
    seed: int
    struck: Launch

    @property
    def outside(self) -> str:
        """The warning in one line if the mean delivery is outside the range of model or parameters, else ""."""
        return Tally().add_all((self.struck,)).remark()

    @property
    def effective(self) -> float:
        """Effective number of independent draws behind the sample."""
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
        """Return the central interval that contains the fraction ``confidence`` of the draws of a quantity."""
        check_choice("quantity of the delivery", name, self.deliveries)
        if not 0.0 < confidence < 1.0:
            raise InputError("confidence", confidence, "between 0 and 1")
        low, high = np.quantile(self.deliveries[name], [0.5 - confidence / 2, 0.5 + confidence / 2])
        return float(low), float(high)

    @property
    def learned(self) -> dict[str, float]:
        """Narrowing of each quantity from its prior: one minus the ratio of standard deviations, 0 to 1."""
        return {name: max(0.0, 1.0 - each / self.prior.deviation[name]) for name, each in self.deviation.items()}

    @property
    def correlation(self) -> Floats:
        """Correlation of the quantities, in the order of ``names``."""
        return np.atleast_2d(np.corrcoef(np.stack(list(self.deliveries.values()))))

    @property
    def not_learned(self) -> list[str]:
        """The quantities that are as uncertain as under the prior."""
        return [name for name, part in self.learned.items() if part < NOT_LEARNED]

    @property
    def warnings(self) -> list[Note]:
        """Reasons not to trust the sample."""
        notes = []
        if self.surprise < SURPRISING:
            code = "contradicts-prior" if self.expected else "contradicts-prior-together"
            notes.append(note(code, prior=self.prior.name, model=self.model, expected=self.expected))
        before, spread = self.prior.mean, self.prior.deviation
        if far := [
            f"{name} {shown(name, value, 3)} is {abs(value - before[name]) / spread[name]:.1f} standard deviations from"
            f" {shown(name, before[name], 3)}"
            for name, value in self.mean.items()
            if abs(value - before[name]) > FAR * spread[name]
        ]:
            notes.append(note("far-from-prior", quantities=far))
        if missed := [
            f"{name} {shown(name, value, 4)} ({shown(name, self.reproduced[name], 4)})"
            for name, value in {**self.launch, **self.delivery}.items()
            if not abs(self.reproduced[name] - value) <= FAR * self.noise[name]
        ]:
            notes.append(note("not-reproduced", quantities=missed))
        if self.effective < min(FEWEST_EFFECTIVE, len(self)):
            notes.append(note("sample-too-small", effective=round(self.effective), draws=self.sample.draws))
        if self.sample.largest_weight > MOST_WEIGHT:
            notes.append(note("one-draw-dominates", weight=self.sample.largest_weight))
        return notes

    @property
    def ties(self) -> list[Note]:
        """Notes on pairs of strongly correlated quantities, strongest first."""
        correlation, names, deviation = self.correlation, self.names, self.deviation
        pairs = [
            (abs(correlation[i, j]), i, j)
            for i in range(len(names))
            for j in range(i)
            if abs(correlation[i, j]) >= CLOSE and not {names[i], names[j]} <= set(self.not_learned)
        ]
        notes = []
        for _, i, j in sorted(pairs, reverse=True):
            first, second = sorted((names[i], names[j]), key=lambda name: -deviation[name] / self.prior.deviation[name])
            slope = float(correlation[i, j]) * deviation[second] / deviation[first]
            change = slope * units.parse(f"1 {unit_of(first)}", OF_CLUB[first])
            notes.append(
                note("tied", first=first, second=second, correlation=float(correlation[i, j]),
                     step=f"1 {unit_of(first)}", change=units.show(abs(change), unit_of(second), 2),
                     direction="more" if change > 0 else "less")
            )  # fmt: skip
        return notes

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

    def to_pandas(self, name: str | None = None) -> pandas.DataFrame:
        """Return a frame with one row per draw, or the table called ``name``, SI."""
        if name is not None:
            return self.to_result().to_pandas(name)
        import pandas

        return pandas.DataFrame(self.deliveries)

    def __repr__(self) -> str:
        mean, deviation = self.mean, self.deviation
        heads = {name: f"{name} ({unit_of(name)})" for name in self.names}
        width = max(map(len, heads.values()))
        lines = [f"{len(self)} deliveries of {self.club.name} for one launch by {self.model}, prior {self.prior.name}"]
        for name, head in heads.items():
            numbers = [bare_value(each[name], quantity(name)) for each in (mean, deviation)]
            lines.append(f"  {head:<{width}}  {numbers[0]:>9} +- {numbers[1]}")
        return "\n".join(lines)

    def to_result(self) -> Result:
        """Return mean, spread and interval of each quantity, the measured values, and what the launch leaves open."""
        sample = self.sample
        notes = [*self.warnings]
        if self.known:
            exact = [f"{name} {shown(name, value, 4)}" for name, value in self.known.items()]
            notes.append(note("taken-as-exact", quantities=exact))
        notes += self.ties
        if unknown := self.not_learned:
            notes.append(note("launch-says-nothing" if not self.delivery else "shot-says-nothing", names=unknown))
        notes.append(note("model-taken-as-exact", model=self.model, parameters=self.parameters.name))
        measured = {
            name: f"{shown(name, value, 5)} +- {shown(name, self.noise[name], 2)}"
            for name, value in {**self.launch, **self.delivery}.items()
        }
        inputs = {**measured, "before": self.prior.name, "seed": str(self.seed)}
        return Result(
            "inference", f"Deliveries that make this launch: {self.club.name}, {self.model}",
            tables=tuple(
                each for each in (self._deliveries(), self._measured(), self._correlations(), self._prior(),
                                  self._parameters()) if len(each)
            ),
            values=(
                text("before", [self.prior.name]), text("samples", [len(self)]), text("draws", [sample.draws]),
                text("effective", [round(self.effective)], label="effective draws", in_files=False),
                text("effective", [self.effective], printed=False), text("impacts", [sample.evaluations]),
                text("stages", [sample.stages], printed=False),
                text("largest_weight", [sample.largest_weight], printed=False),
                text("log_evidence", [sample.log_evidence], printed=False),
                text("surprise", [self.surprise], printed=False), text("seed", [self.seed]),
            ),
            notes=tuple(notes),
            provenance=replace(provenance_of([self.struck]), inputs=inputs), draw=lambda: [pairs_picture(self)],
        )  # fmt: skip

    def _deliveries(self) -> Table:
        names = self.names
        read_as = [quantity(name) for name in names]
        ends = [self.interval(name) for name in names]
        numbers = {
            "mean": ("mean", self.mean.values()), "std": ("STD", self.deviation.values()),
            "low": ("95% from", [low for low, _ in ends]), "high": ("to", [high for _, high in ends]),
            "prior_mean": ("before", self.prior.mean.values()), "prior_std": ("+-", self.prior.deviation.values()),
        }  # fmt: skip
        return table(
            "deliveries", text("delivery_of", [each.label for each in read_as], label="quantity", in_files=False),
            *(Column(name, list(values), read_as, label=label) for name, (label, values) in numbers.items()),
            column("narrower", list(self.learned.values()), "1", label="narrower by", unit="%", digits=0),
            title="Deliveries",
        )  # fmt: skip

    def _measured(self) -> Table:
        given = {**self.launch, **self.delivery, **self.known}
        read_as = [quantity(name) for name in given]
        return table(
            "measured", text("measured", [each.label for each in read_as], in_files=False),
            Column("value", list(given.values()), read_as),
            Column("noise", list(map(self.noise.get, given)), [error_quantity(name) for name in given]),
            Column("reproduced", list(map(self.reproduced.get, given)), read_as),
            text("part", ["launch" if name in self.launch else "club" for name in given], printed=False),
            title="Measured, and what these deliveries make",
        )  # fmt: skip

    def _correlations(self) -> Table:
        rows = self.correlation
        return table(
            "correlations", text("quantity", self.names),
            *(text(name, rows[:, place].tolist(), digits=2) for place, name in enumerate(self.names)),
            title="Correlations", printed=False,
        )  # fmt: skip

    def _prior(self) -> Table:
        pairs = self.prior.correlations
        return table(
            "prior_correlations", text("first", [first for first, _ in pairs]),
            text("second", [second for _, second in pairs]), text("correlation", list(pairs.values()), digits=2),
            title="Correlations before", printed=False,
        )  # fmt: skip

    def _parameters(self) -> Table:
        values, own = self.parameters.values, self.parameters.units
        return table(
            "parameters", text("parameter", list(values)),
            Column("value", list(values.values()), [quantity(name, own[name]) for name in values], digits=-5),
            title=f"Parameters: {self.parameters.name}", printed=False,
        )  # fmt: skip


def pairs_picture(posterior: Posterior, *, truth: Mapping[str, float] | None = None) -> Picture:
    """Return the picture of all pairs of quantities with priors and correlations; ``truth`` [SI] is marked if given."""
    names = _quantities_to_draw(posterior)
    known = truth or {}
    rows: list[list[Panel | None]] = []
    for row, below in enumerate(names):
        panels: list[Panel | None] = []
        for place, name in enumerate(names):
            across = axis(name, name.replace("_", " "))
            upwards = axis(below, below.replace("_", " "))
            if place:  # the first panel of the row has tick numbers and labels
                upwards = Axis(quantity(below)._replace(label=""), ticks=False)
            if place == row:
                panels.append(_distribution(posterior, name, known))
            elif place < row:
                x, y = (posterior.deliveries[each][:MOST_POINTS] for each in (name, below))
                marks = [Mark("points", x, y, symbol="", size=1.6, label="deliveries that make this launch")]
                if name in known and below in known:
                    marks.append(
                        Mark("points", [known[name]], [known[below]], symbol="+", size=8.0, style=1, label="truth")
                    )
                panels.append(Panel(marks, across, upwards, grid=False))
            else:
                both = posterior.correlation[posterior.names.index(below), posterior.names.index(name)]
                size = 6.0 + 5.0 * abs(float(both))
                panels.append(Panel([Mark("text", texts=[f"{both:+.2f}"], size=size)], across, grid=False))
        rows.append(panels)
    caption = "Pairs of quantities of the deliveries that make this launch, what was believed before, and correlations"
    return Picture("pairs", caption, rows, share_x=True, legend=True, height=6.9)


def _quantities_to_draw(posterior: Posterior) -> list[str]:
    """Return the quantities that the launch narrows or ties to others; of too many, those narrowed most."""
    tied = np.abs(posterior.correlation - np.eye(len(posterior.names))).max(axis=0) >= CLOSE
    learned = posterior.learned
    names = [name for name, each in zip(posterior.names, tied, strict=True) if each or learned[name] >= NOT_LEARNED]
    kept = sorted(names, key=lambda name: -learned[name])[:MOST_QUANTITIES]
    return [name for name in posterior.names if name in kept] or list(posterior.names[:MOST_QUANTITIES])


def _distribution(posterior: Posterior, name: str, truth: Mapping[str, float]) -> Panel:
    """Return the panel of one quantity: posterior and prior distribution."""
    density, edges = np.histogram(posterior.deliveries[name], bins=BINS, density=True)
    mean, deviation = posterior.prior.mean[name], posterior.prior.deviation[name]
    margin = 0.05 * float(edges[-1] - edges[0])
    low, high = float(edges[0]) - margin, float(edges[-1]) + margin
    x = np.linspace(low, high, 200)
    prior = np.exp(-0.5 * ((x - mean) / deviation) ** 2) / (deviation * np.sqrt(2.0 * np.pi))
    marks = [Mark("steps", edges, density), Mark("line", x, prior, style=-1, label="before", dash=0)]
    if name in truth:
        marks.append(Mark("line", [truth[name]] * 2, [0.0, float(density.max())], style=1, dash=0))
    across = axis(name, name.replace("_", " "), limits=(low, high))
    return Panel(marks, across, axis(limits=(0.0, None), ticks=False), grid=False)
