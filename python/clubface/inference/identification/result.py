"""The result of an identification as tables, notes and a picture."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.models import model as model_named
from clubface.equipment.parameters import ParameterSet
from clubface.inference.evaluation.result import arrange_in_rows, error_quantity, shot_tables
from clubface.inference.identification.intervals import CHI_SQUARE_95, Identifiability, Profile, outside
from clubface.quantities import display_unit, quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Described, Provenance, Result
from clubface.results.table import Column, Table, column, table, text
from clubface.shots.loft_origin import LoftOrigin
from clubface.shots.recorded import RejectedRow
from clubface.support.arrays import Floats

COLUMNS = 4
"""Number of panels in a row of the picture."""
HIGHEST = 3.0 * CHI_SQUARE_95
"""The rise at the top of a panel."""
BINS = 24
FINE = 16
"""Number of curve points between two points of a profile."""
COSTS = {"published": "published cost", "least-squares": "mean square", "robust": "robust cost"}


@dataclass(frozen=True, kw_only=True, eq=False)
class Deviation:
    """Deviation of a fit's launches from the measured ones, in one quantity [SI].

    Attributes
    ----------
    mean
        Mean magnitude of the measured values.
    mae
        Mean absolute error.
    bias, std
        Mean and standard deviation of simulated minus measured values.
    mae_holdout
        Mean absolute error with each shot simulated by a fit without it; NaN without hold-out.
    mae_before
        Mean absolute error with the initial parameter set, such as the published one.
    """

    mean: float
    mae: float
    bias: float
    std: float
    mae_holdout: float
    mae_before: float


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Identification(Described):
    """Identified parameters and their uncertainty.

    Attributes
    ----------
    model, club
        Names of the model and of the club.
    parameters
        All parameters of the model, usable wherever a parameter set is; ``to_toml()`` returns them as the text of a
        file.
    free
        Names of the identified parameters.
    intervals, confidence
        Ends of the confidence interval of each free parameter [SI], and its confidence level.
    method
        Method of the intervals: "bootstrap", or "information", from derivatives and normally distributed deviations.
    cost, cost_holdout
        Cost at the identified parameters, and with each shot simulated by a fit without it; NaN without hold-out.
    cost_kind
        "published" (equation 22 of Caldwell and McPhee 2023), "least-squares" or "robust".
    deviations
        One :class:`Deviation` per launch quantity.
    evaluations, impacts
        Number of simulations of all shots, and of impacts.
    wall_s
        Time taken [s], including interrupted runs.
    shots
        Number of shots used.
    dropped
        Rows not used, with reasons.
    refined
        Final costs of the refinements.
    samples
        Parameters of the bootstrap samples [SI], shape (samples, free).
    held_out
        Launches of each shot by a fit without it [SI], shape (quantities, shots); None without hold-out.
    identifiability
        Fisher's information of the shots.
    profiles
        Profile likelihoods by parameter.
    at_bound
        Names of the free parameters at a bound of the search.
    warnings, notes
        Warnings to read before using the parameters, and notes on assumptions about the shots.
    settings
        The options of the identification.
    loft_origins
        Origin of the dynamic lofts, as far as the shots reveal it.
    provenance
        Source of the shots, and initial parameters.
    """

    model: str
    club: str
    parameters: ParameterSet
    free: tuple[str, ...]
    intervals: Mapping[str, tuple[float, float]]
    confidence: float
    method: str
    cost: float
    cost_holdout: float
    cost_kind: str
    deviations: Mapping[str, Deviation]
    evaluations: int
    impacts: int
    wall_s: float
    shots: int
    dropped: tuple[RejectedRow, ...]
    refined: tuple[float, ...]
    samples: NDArray[Any]
    held_out: NDArray[Any] | None
    identifiability: Identifiability
    profiles: Mapping[str, Profile]
    at_bound: tuple[str, ...]
    warnings: tuple[Note, ...]
    notes: tuple[Note, ...]
    settings: Mapping[str, Any]
    loft_origins: tuple[LoftOrigin, ...] = ()
    provenance: Provenance = field(default_factory=Provenance)

    def to_toml(self) -> str:
        """Return the parameters as the text of a file for ``parameters=`` and ``--parameters``."""
        return self.parameters.to_toml()

    def identified(self, name: str) -> str:
        """Return whether the shots determine a parameter.

        "yes", "no", "from below only" or "from above only"; "not alone" if a combination with other parameters changes
        no launch; "at its bound" if the best value may lie beyond it; or "contradicted" if an interval does not contain
        the value.
        """
        information = self.identifiability
        if not math.isfinite(information.errors[information.names.index(name)]):
            return "not alone"
        judged = "no" if name in information.unknown else "yes"
        verdict = self.profiles[name].verdict if name in self.profiles else judged
        if verdict == "no":
            return verdict
        if outside(float(self.parameters.values[name]), self.intervals[name], self.profiles.get(name)):
            return "contradicted"
        return "at its bound" if verdict == "yes" and name in self.at_bound else verdict

    def shown(self, name: str, value: float, digits: int = 4) -> str:
        """Return a parameter value as text in its display unit."""
        return units.show(value, display_unit(name, model_named(self.model).parameter(name).unit), digits)

    def __repr__(self) -> str:
        return str(self.to_result())

    def to_result(self) -> Result:
        """Return the parameters, deviations, directions and profiles with warnings, notes and a picture."""
        weak = [note("fit-weak", direction=each.words) for each in self.identifiability.directions
                if each.strength == "weak"]  # fmt: skip
        left_out = []
        if self.dropped:
            first = f"{self.dropped[0].line}: {self.dropped[0].reason}"
            left_out.append(note("rows-not-used", rows=len(self.dropped), first=first))
        tables = (
            self._parameters(), self._deviations(), self._directions(), self._profiles(), self._refinements(),
            *shot_tables(self.dropped, self.loft_origins),
        )  # fmt: skip
        settings = {
            name: _setting_text(value) for name, value in self.settings.items() if name not in ("noise", "bounds")
        }
        return Result(
            "identification", f"Parameters of {self.model} from {self.shots} shots with {self.club}",
            tables=tuple(each for each in tables if len(each)),
            values=(
                text("model", [self.model], printed=False), text("club", [self.club], printed=False),
                text("shots", [self.shots], printed=False), text("cost_kind", [self.cost_kind], printed=False),
                column("cost", [self.cost], "1", label=COSTS[self.cost_kind], digits=-5),
                column("cost_holdout", [self.cost_holdout], "1", label=f"{COSTS[self.cost_kind]}, held out", digits=-5),
                text("confidence", [self.confidence], printed=False),
                text("intervals_from", [self.method], label="intervals from"),
                text("evaluations", [self.evaluations]), text("impacts", [self.impacts]),
                column("wall_time", [self.wall_s], "s", label="time", unit="s", digits=1),
            ),
            notes=(*self.warnings, *weak, *left_out, *self.notes),
            provenance=self.provenance + Provenance(inputs=settings), draw=lambda: [self._picture()],
        )  # fmt: skip

    def _parameters(self) -> Table:
        """Return every parameter, and for free ones the interval and whether it is identified."""
        names = list(self.parameters.values)
        read_as = [quantity(name, self.parameters.units[name]) for name in names]
        profiles = [self.profiles.get(name) for name in names]
        bounds, tied = self.settings.get("bounds", {}), self.settings.get("tied", {})
        errors = dict(zip(self.identifiability.names, self.identifiability.errors.tolist(), strict=True))

        def numbers(name: str, values: list[Any], **options: Any) -> Column:
            return Column(name, values, read_as, **options)

        def end(pairs: Mapping[str, Any], place: int) -> list[Any]:
            return [pairs[name][place] if name in pairs else None for name in names]

        intervals = {name: each.interval for name, each in self.profiles.items()}
        closed = {name: each.closed for name, each in self.profiles.items()}
        share = f"{100 * self.confidence:g}% interval"
        return table(
            "parameters", text("parameter", names),
            numbers("value", [float(self.parameters.values[name]) for name in names], digits=-5),
            numbers("low", end(self.intervals, 0), label=f"{share} from", digits=-4),
            numbers("high", end(self.intervals, 1), label="to", digits=-4),
            text("profile", [self._profile_words(each) for each in profiles], label="profile likelihood",
                 in_files=False),
            text("identified", [self.identified(name) if name in self.free else None for name in names]),
            numbers("profile_low", end(intervals, 0), printed=False),
            numbers("profile_high", end(intervals, 1), printed=False),
            text("closed_below", end(closed, 0), printed=False), text("closed_above", end(closed, 1), printed=False),
            numbers("bound_low", end(bounds, 0), printed=False), numbers("bound_high", end(bounds, 1), printed=False),
            text("at_bound", [name in self.at_bound if name in self.free else None for name in names], printed=False),
            text("standard_error", [errors.get(name) for name in names], printed=False),
            text("tied_to", [tied.get(name) for name in names], printed=False),
            title="Parameters", shown_rows=[place for place, name in enumerate(names) if name in self.free],
        )  # fmt: skip

    def _profile_words(self, profile: Profile | None) -> str:
        """Format the interval of a profile; an end without a crossing is given as a bound."""
        if profile is None:
            return ""
        ends = [self.shown(profile.name, value) for value in profile.interval]
        return " .. ".join(end if closed else "bound" for end, closed in zip(ends, profile.closed, strict=True))

    def _deviations(self) -> Table:
        rows = list(self.deviations.values())
        read_as = [error_quantity(name) for name in self.deviations]
        noise = self.settings.get("noise") or [None] * len(rows)
        labels = {"mean": "mean size", "mae": "MAE", "mae_holdout": "held out", "mae_before": "before", "bias": "bias",
                  "std": "STD"}  # fmt: skip
        return table(
            "deviations", text("deviation_of", [each.label for each in read_as], label="quantity", in_files=False),
            *(
                Column(name, [getattr(each, name) for each in rows], read_as, label=label, digits=-4)
                for name, label in labels.items()
            ),
            Column("noise", noise, read_as, printed=False),
            Column("scatter", self.identifiability.noise.tolist(), read_as, printed=False),
            title="Launches of the fit less measured ones",
        )  # fmt: skip

    def _directions(self) -> Table:
        rows = self.identifiability.directions
        return table(
            "directions", text("strength", [each.strength for each in rows]),
            text("words", [each.words for each in rows], label="direction"),
            text("error", [each.error for each in rows], printed=False),
            *(
                text(f"{name}_share", [each.vector[place] for each in rows], printed=False)
                for place, name in enumerate(self.identifiability.names)
            ),
            title="Directions of the parameters, the weakest first", printed=False,
        )  # fmt: skip

    def _profiles(self) -> Table:
        rows = [(each, place) for each in self.profiles.values() for place in range(len(each.values))]
        return table(
            "profiles", text("parameter", [each.name for each, _ in rows]),
            Column("value", [each.values[place] for each, place in rows],
                   [quantity(each.name, self.parameters.units[each.name]) for each, _ in rows], digits=-5),
            text("rise", [float(each.rise[place]) for each, place in rows], digits=-4),
            title="Profile likelihoods: rise of minus twice the logarithm", printed=False,
        )  # fmt: skip

    def _refinements(self) -> Table:
        return table("refinements", text("cost", self.refined, digits=-6), title="Refinements", printed=False)

    def _picture(self) -> Picture:
        """Return a panel for each free parameter: its profile likelihood with the 95% level, samples and interval."""
        rows = arrange_in_rows([self._panel(place, name) for place, name in enumerate(self.free)], COLUMNS)
        return Picture(
            "identification", "Profile likelihoods with the level of 95%, fits to parts of the shots, and intervals",
            rows, title=f"{self.model}, {self.club}, {self.shots} shots", share_y=True, legend=True,
            height=0.5 + 1.75 * len(rows),
        )  # fmt: skip

    def _panel(self, place: int, name: str) -> Panel:
        low, high = self.intervals[name]
        value = float(self.parameters.values[name])
        shown = [low, high, value]
        unit = self.parameters.units[name]
        marks = []
        profile = self.profiles.get(name)
        if profile is not None:
            marks = [
                Mark("line", *_profile_curve(profile.values, profile.rise), label="profile"),
                Mark("points", profile.values, profile.rise, size=2.2),
            ]
            near = profile.values[profile.rise <= HIGHEST]
            shown += [float(near.min()), float(near.max())]
        span = max(shown) - min(shown) or abs(value) or 1.0
        left, right = min(shown) - 0.08 * span, max(shown) + 0.08 * span
        below: list[Mark] = []
        if len(self.samples):
            counts, edges = np.histogram(self.samples[:, place], bins=BINS, range=(left, right))
            below = [Mark("steps", edges, counts / max(counts.max(), 1) * 0.45 * HIGHEST, style=-1, label="bootstrap")]
        ends = np.array([low, high])
        return Panel(
            [
                *below,
                Mark("band", ends, y0=np.zeros(2), y1=np.full(2, HIGHEST), style=1,
                     label=f"{100 * self.confidence:g}% interval"),
                Mark("line", np.full(2, value), np.array([0.0, HIGHEST]), style=1, dash=0, label="fit"),
                *marks,
                Mark("rule", y=CHI_SQUARE_95, dash=2, style=-1, label="3.84: 95% of the likelihood"),
            ],
            axis(name, like=unit, unit=display_unit(name, unit), limits=(left, right)),
            axis(label="-2 log likelihood,\nrise", limits=(0.0, HIGHEST)),
        )  # fmt: skip


def _setting_text(value: Any) -> str:
    """Format a setting."""
    if isinstance(value, Mapping):
        return ", ".join(f"{name} follows {leader}" for name, leader in value.items()) or "none"
    return (", ".join(map(str, value)) or "none") if isinstance(value, (list, tuple)) else str(value)


def _profile_curve(where: Floats, rise: Floats) -> tuple[Floats, Floats]:
    """Return a curve through the points of a profile, linear in its square root like the interval."""
    place = np.linspace(0.0, len(where) - 1.0, FINE * (len(where) - 1) + 1)
    roots = np.sqrt(rise) * np.sign(np.arange(len(rise)) - float(np.argmin(rise)))
    counted = np.arange(len(where))
    return np.interp(place, counted, where), np.interp(place, counted, roots) ** 2
