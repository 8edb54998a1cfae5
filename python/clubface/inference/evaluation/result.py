"""The result of an evaluation: errors of models on measured shots as tables, notes and pictures."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from clubface import units
from clubface.equipment.parameters import ParameterSet
from clubface.errors import FileError
from clubface.inference.evaluation.published_accuracy import PublishedAccuracy, published
from clubface.inference.evaluation.statistics import COVARIATES, Best, ErrorSize, Rival, Trend, fewest_groups
from clubface.quantities import Quantity, Reading, quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Mark, Panel, Picture, axis
from clubface.results.result import Described, Provenance, Result
from clubface.results.table import Column, Table, column, table, text
from clubface.shots.loft_origin import LoftOrigin
from clubface.shots.measured import DELIVERY, LAUNCH, QUANTITIES, MeasuredShots
from clubface.shots.recorded import RejectedRow
from clubface.support.arrays import Floats

SHOTS_FILE = "evaluation.csv"
"""File name of the table with every model's values for every shot."""
TREND_COVARIATES = ("speed", "path", "toe", "high")
"""The quantities drawn; the tables have all."""
MOST_BINS, FEWEST_IN_BIN = 8, 8
MOST_POINTS = 2000
"""Largest number of shots drawn; of more shots, every n-th is drawn."""
LISTED = 5
"""Largest number of excluded rows listed in a note; the table has all."""


@dataclass(frozen=True, kw_only=True, eq=False, repr=False)
class Evaluation(Described):
    """Models compared with measured shots, in SI units.

    Attributes
    ----------
    shots
        The shots that all models could compute.
    parameters
        The parameters of each model, in the order in which the models were asked for.
    predicted
        Launches computed by each model, by quantity.
    sizes
        The size of the errors, by quantity and then by model.
    best
        The best model of each quantity, and the others that are as good.
    trends
        How the errors depend on the delivery, by quantity and then by model.
    floor
        Mean absolute error of a perfect model under the assumed noise, where it is known.
    monitor_noise, delivery_noise
        Standard deviations of the noise assumed.
    seconds
        Processor time of each model [s] for one shot.
    failed
        Shots that a model could not compute, with the reason; they are excluded.
    resamples, seed
        Number of bootstrap resamples, and the seed of the random numbers.
    groups
        Number of groups of shots, such as players, that are resampled as a whole; None if there are no groups.
    provenance
        Provenance of the launches.
    """

    shots: MeasuredShots
    parameters: dict[str, ParameterSet]
    predicted: dict[str, dict[str, Floats]]
    sizes: dict[str, dict[str, ErrorSize]]
    best: dict[str, Best]
    trends: dict[str, dict[str, list[Trend]]]
    floor: dict[str, float]
    monitor_noise: dict[str, float]
    delivery_noise: dict[str, float]
    seconds: dict[str, float]
    failed: tuple[RejectedRow, ...]
    resamples: int
    seed: int
    groups: int | None
    provenance: Provenance

    @property
    def models(self) -> list[str]:
        """The models, in the requested order."""
        return list(self.parameters)

    @property
    def quantities(self) -> list[str]:
        """The launch quantities that were measured."""
        return list(self.sizes)

    @cached_property
    def mean(self) -> dict[str, float]:
        """Mean absolute value of each measured quantity, the reference of percentages."""
        return {name: float(np.nanmean(np.abs(values))) for name, values in self.shots.launch.items()}

    @property
    def published(self) -> dict[str, PublishedAccuracy]:
        """Published accuracy of these models for this club family."""
        family = self.shots.club.parameters
        return {name: published()[name, family] for name in self.models if (name, family) in published()}

    def errors(self, model: str, quantity: str) -> Floats:
        """Return model minus measured values, one element per shot; NaN for values not measured."""
        return self.predicted[model][quantity] - self.shots.launch[quantity]

    def cost(self, model: str) -> float:
        """Return the cost of Caldwell and McPhee (2023), equation 22, with mean absolute values."""
        return sum(self.sizes[name][model].mae / self.mean[name] for name in self.quantities)

    def __repr__(self) -> str:
        lines = [f"{len(self.models)} models on {len(self.shots)} shots of {self.shots.club.name}"]
        for name, best in self.best.items():
            others = f", no worse than {' and '.join(best.equals)}" if best.equals else ""
            lines.append(f"  {name}: best {best.model}{others}")
        return "\n".join(lines)

    def to_result(self) -> Result:
        """Return tables of the errors, the best models, noise and trends, with notes and pictures."""
        shots = f"{len(self.shots)} measured shot{'s' * (len(self.shots) != 1)}"
        tables = (
            self._errors(), self._best(), self._models(), self._noise(), self._trends(), self._published(),
            self._parameters(), *shot_tables((*self.shots.dropped, *self.failed), self.shots.loft_origins),
        )  # fmt: skip
        return Result(
            "evaluation", f"Models compared with {shots}: {self.shots.club.name}",
            tables=tuple(each for each in tables if len(each)),
            values=(
                text("source", [self.shots.source]), text("club", [self.shots.club.name], printed=False),
                text("shots", [len(self.shots)]),
                text("compared_at", [LAUNCH if self.shots.start else DELIVERY]),
                text("resamples", [self.resamples]), text("groups", [self.groups]), text("seed", [self.seed]),
            ),
            summary=tuple(self._summary()), notes=tuple(self._notes()), provenance=self.provenance,
            draw=self._pictures,
        )  # fmt: skip

    def shots_table(self) -> Table:
        """Return one row per shot: its row in the source, the measured values, and every model's values."""
        columns = [text("row", self.shots.rows.tolist())]
        for name in self.quantities:
            columns.append(column(name, self.shots.launch[name]))
            columns += [column(f"{model}_{name}", self.predicted[model][name], name) for model in self.models]
        return Table("shots", tuple(columns))

    def write(self, folder: str | os.PathLike[str]) -> list[Path]:
        """Write the report (HTML, Markdown, JSON), its pictures, its tables and the table of shots; return the files.

        Raises
        ------
        FileError
            One of the files would overwrite the file of the shots.
        """
        refuse_input(folder, self.shots.source)
        result = self.to_result()
        return result.write(folder, {"errors.csv": result.table(), SHOTS_FILE: self.shots_table()})

    def _errors(self) -> Table:
        """Return one row per quantity and model: the errors with 95% intervals, and the lead of the best model."""
        rows = [(name, model, size) for name, sizes in self.sizes.items() for model, size in sizes.items()]
        read_as = [error_quantity(name) for name, _, _ in rows]
        rivals = [self._rival(name, model) for name, model, _ in rows]
        known = [self.published.get(model) for _, model, _ in rows]

        def errors(name: str, values: Iterable[Any], **options: Any) -> Column:
            return Column(name, list(values), read_as, **options)

        def of_mean(what: str) -> Column:
            shares = [getattr(size, what) / (self.mean[name] or math.nan) for name, _, size in rows]
            return column(f"{what}_of_mean", shares, "1", label="of mean", unit="%", digits=-3)

        sizes = [size for _, _, size in rows]
        return table(
            "errors",
            text("error_of", [quantity(name).label for name, _, _ in rows], label="quantity", in_files=False),
            text("model", [model for _, model, _ in rows]),
            text("shots", [size.shots for size in sizes], printed=len({size.shots for size in sizes}) > 1),
            errors("mean_measured", (self.mean[name] for name, _, _ in rows), label="mean measured"),
            errors("mae", (size.mae for size in sizes), label="MAE"),
            errors("mae_low", (size.mae_interval.low for size in sizes), label="from"),
            errors("mae_high", (size.mae_interval.high for size in sizes), label="to"),
            of_mean("mae"),
            errors("std", (size.std for size in sizes), label="STD"),
            of_mean("std"),
            errors("bias", (size.bias for size in sizes), difference=True),
            errors("bias_low", (size.bias_interval.low for size in sizes), label="from", difference=True),
            errors("bias_high", (size.bias_interval.high for size in sizes), label="to", difference=True),
            errors("rms", (size.rms for size in sizes), printed=False),
            errors("worst", (size.worst for size in sizes)),
            errors("behind", (each and each.difference for each in rivals), printed=False),
            errors("behind_low", (each and each.interval.low for each in rivals), printed=False),
            errors("behind_high", (each and each.interval.high for each in rivals), printed=False),
            text("p", [each and each.p for each in rivals], printed=False),
            *(
                errors(f"published_{what}", (
                    getattr(each, what).get(name) if each else None
                    for each, (name, _, _) in zip(known, rows, strict=True)
                ), label=f"published {what.upper()}")
                for what in ("mae", "std") if self.published
            ),
            title="Errors, model less measured",
        )  # fmt: skip

    def _rival(self, name: str, model: str) -> Rival | None:
        return next((each for each in self.best[name].rivals if each.model == model), None)

    def _best(self) -> Table:
        """Return one row per quantity: the best model, those not significantly worse, and the lead over the next."""
        names = list(self.best)
        nexts = [next((each for each in self.best[name].rivals if each.is_worse), None) for name in names]
        read_as = [error_quantity(name, 1) for name in names]
        return table(
            "best", text("quantity_label", [quantity(name).label for name in names], label="quantity", in_files=False),
            text("best_model", [self.best[name].model for name in names], label="least MAE"),
            Column("mae", [self.sizes[name][self.best[name].model].mae for name in names],
                   [error_quantity(name) for name in names], label="MAE"),
            text("not_significantly_worse", [", ".join(self.best[name].equals) or "none" for name in names],
                 label="not significantly worse"),
            text("next_model", [each and each.model for each in nexts], label="next, significantly worse"),
            Column("by", [each and each.difference for each in nexts], read_as),
            Column("by_low", [each and each.interval.low for each in nexts], read_as, label="from"),
            Column("by_high", [each and each.interval.high for each in nexts], read_as, label="to"),
            text("p", [each and self._probability(each.p) for each in nexts], in_files=False),
            title="Best model in each quantity",
        )  # fmt: skip

    def _probability(self, p: float) -> str:
        """Format a probability; the resamples cannot resolve one smaller than twenty of them."""
        least = max(0.001, 20.0 / self.resamples)
        return f"< {least:.2g}" if p < least else f"{p:.2g}"

    def _models(self) -> Table:
        known = [self.published.get(model) for model in self.models]
        return table(
            "models", text("model", self.models),
            text("parameters", [each.name for each in self.parameters.values()]),
            column("cost", [self.cost(model) for model in self.models], "1", label="cost (Eq. 22)"),
            column("processor_time", [self.seconds[model] for model in self.models], "s", unit="us", digits=2,
                   label="processor time a shot"),
            *(
                (
                    column("published_cost", [each and each.cost for each in known], "1", label="published cost"),
                    column("published_time", [each and each.cpu for each in known], "s", unit="ms", digits=2,
                           label="published, ten shots"),
                ) if self.published else ()
            ),
            title="Cost and time",
        )  # fmt: skip

    def _noise(self) -> Table:
        """Return the assumed noise, and the errors of a perfect model and of the best model."""
        names = [*self.floor, *(each for each in (*self.monitor_noise, *self.delivery_noise) if each not in self.floor)]
        best = [self.best[name].model if name in self.floor else None for name in names]
        sizes = [None if model is None else self.sizes[name][model] for name, model in zip(names, best, strict=True)]
        least = [self.floor.get(name) for name in names]
        shares = [
            None if size is None or floor is None
            else min(1.0, (floor * math.sqrt(math.pi / 2.0) / size.rms) ** 2) if size.rms else 1.0
            for size, floor in zip(sizes, least, strict=True)
        ]  # fmt: skip
        read_as = [error_quantity(name) for name in names]
        return table(
            "noise", text("noise_of", [quantity(name).label for name in names], label="quantity", in_files=False),
            Column("deviation", [{**self.delivery_noise, **self.monitor_noise}.get(name) for name in names], read_as,
                   label="standard deviation"),
            Column("perfect_mae", least, read_as, label="MAE of a perfect model"),
            Column("least_mae", [size and size.mae for size in sizes], read_as, label="least MAE"),
            text("best_model", best, label="of model"),
            column("share", shares, "1", label="of its mean square", unit="%", digits=0),
            title="What measurement alone explains",
        )  # fmt: skip

    def _trends(self) -> Table:
        """Return the slopes of the errors over the delivery quantities; an asterisk marks significant ones."""
        rows = [
            (name, model, line, units.size(COVARIATES[line.covariate]) / units.size(QUANTITIES[name]))
            for name, models in self.trends.items() for model, lines in models.items() for line in lines
        ]  # fmt: skip
        covariates = [line.covariate for _, _, line, _ in rows]
        slopes = [line.slope * size for _, _, line, size in rows]
        return table(
            "trends",
            text("error_of", [f"{quantity(name).label} ({QUANTITIES[name]}), {model}" for name, model, *_ in rows],
                 in_files=False),
            text("over", [f"per {COVARIATES[each]} of {each}" for each in covariates], in_files=False),
            text("shown", [
                f"{each:+.{error_quantity(name).golf.digits or 1}f}{'*' * line.is_clear}"
                for each, (name, _, line, _) in zip(slopes, rows, strict=True)
            ], in_files=False),
            text("quantity", [name for name, *_ in rows], printed=False),
            text("model", [model for _, model, *_ in rows], printed=False),
            text("covariate", covariates, printed=False), text("slope", slopes, printed=False),
            text("slope_low", [line.interval.low * size for _, _, line, size in rows], printed=False),
            text("slope_high", [line.interval.high * size for _, _, line, size in rows], printed=False),
            text("unit", [f"{QUANTITIES[name]} per {COVARIATES[line.covariate]}" for name, _, line, _ in rows],
                 printed=False),
            text("explained", [line.explained for _, _, line, _ in rows], printed=False),
            title="What the errors depend on; * marks a slope whose 95% interval excludes zero", layout="pivot",
            printed=False,
        )  # fmt: skip

    def _published(self) -> Table:
        """Return the published figures of the same models, if they exist for the club's family."""
        rows = [(name, each) for name in QUANTITIES for each in self.published.values()]
        read_as = [error_quantity(name) for name, _ in rows]
        columns = []
        for what, label in (("mae", "MAE"), ("std", "STD")):
            figures = [getattr(each, what).get(name) for name, each in rows]
            printed = [getattr(each, f"{what}_percent").get(name) for name, each in rows]
            columns += [
                Column(what, figures, read_as, label=label),
                column(f"{what}_of_mean", [each and each / 100.0 for each in printed], "1", label="printed as",
                       unit="%", digits=-3),
            ]  # fmt: skip
        return table(
            "published", text("error_of", [quantity(name).label for name, _ in rows], label="quantity", in_files=False),
            text("model", [each.model for _, each in rows]), text("shots", [each.shots for _, each in rows]),
            Column("mean", [each.mean[name] for name, each in rows], read_as), *columns,
            text("least_of", [each.source if each.is_least(name) else "" for name, each in rows], label="least of"),
            title=f"As published for the {self.shots.club.parameters}", printed=False,
        )  # fmt: skip

    def _parameters(self) -> Table:
        rows = [(model, own, key) for model, own in self.parameters.items() for key in own.values]
        return table(
            "parameters", text("model", [model for model, _, _ in rows]),
            text("set", [own.name for _, own, _ in rows]), text("parameter", [key for _, _, key in rows]),
            Column("value", [own.values[key] for _, own, key in rows],
                   [quantity(key, own.units[key]) for _, own, key in rows], digits=-5),
            title="Parameters", printed=False,
        )  # fmt: skip

    def _summary(self) -> list[Note]:
        of_model: dict[str, list[str]] = {}
        for name, best in self.best.items():
            of_model.setdefault(best.model, []).append(quantity(name).label)
        return [note("evaluation-best", model=model, names=names) for model, names in of_model.items()]

    def _notes(self) -> list[Note]:
        notes = [*self.shots.notes]
        if self.shots.dropped:
            first, count = _first(self.shots.dropped), len(self.shots.dropped)
            notes.append(note("rows-left-out", rows=count, source=self.shots.source, first=first))
        if self.failed:
            notes.append(note("shots-not-computed", shots=len(self.failed), first=_first(self.failed)))
        notes.append(note("evaluation-errors"))
        if any(math.isnan(each.mae_interval.low) for sizes in self.sizes.values() for each in sizes.values()):
            notes.append(note("evaluation-no-intervals"))
        notes.append(
            note("evaluation-intervals", resamples=self.resamples, seed=self.seed, models=len(self.models),
                 drawn="shots" if self.groups is None else f"{self.groups} groups of shots, such as players",
                 least=fewest_groups(len(self.models)), unit="shots" if self.groups is None else "groups")
        )  # fmt: skip
        if self.published:
            notes.append(note("evaluation-published"))
        for each in self.published.values():
            notes += [note("published-caveat", model=each.model, club=each.club, caveat=one) for one in each.caveats]
        for name, each in self.parameters.items():
            notes += [note("caveat-of-model", model=name, caveat=one) for one in each.caveats]
        return notes

    def _pictures(self) -> list[Picture]:
        return [error_picture(self), _trend_picture(self), _agreement_picture(self)]


def refuse_input(folder: str | os.PathLike[str], source: str) -> None:
    """Raise FileError for a folder in which the table of shots would overwrite the input file."""
    target = Path(folder) / SHOTS_FILE
    if target.exists() and os.path.exists(source) and target.samefile(source):
        raise FileError(source, None, "the report would overwrite this file; give another folder")


def shot_tables(dropped: Iterable[RejectedRow], origins: Sequence[LoftOrigin]) -> tuple[Table, Table]:
    """Return the excluded rows with reasons, and the origin of the shots' dynamic lofts."""
    rows = list(dropped)
    left_out = table(
        "left_out", text("row", [each.line for each in rows]), text("reason", [each.reason for each in rows]),
        title="Rows left out", printed=False,
    )  # fmt: skip
    names = ("club", "file", "shots", "origin", "with_face")
    numbers = {"ratio": "1", "ratio_scatter": "1", "scatter": "rad", "rounding": "rad"}
    lofts = table(
        "loft_origins", *(text(name, [getattr(each, name) for each in origins]) for name in names),
        *(column(name, [getattr(each, name) for each in origins], unit) for name, unit in numbers.items()),
        title="Where the dynamic lofts come from", printed=False,
    )  # fmt: skip
    return left_out, lofts


def error_quantity(name: str, more: int = 0) -> Quantity:
    """Return a quantity with the digits of an error, with the changes in ``more``."""
    known = quantity(name)
    digits = known.golf.digits + (known.golf.unit != "rpm") + more
    return known._replace(golf=Reading(known.golf.unit, digits))


def _first(rows: Sequence[RejectedRow]) -> str:
    listed = "; ".join(f"{each.line}: {each.reason}" for each in rows[:LISTED])
    return listed + "; ..." * (len(rows) > LISTED)


def error_picture(evaluation: Evaluation) -> Picture:
    """Return a picture of the mean absolute errors with intervals, published errors, and the effect of noise."""
    places = np.arange(len(evaluation.models))
    panels = []
    for name in evaluation.quantities:
        sizes = [evaluation.sizes[name][model] for model in evaluation.models]
        low, high = (np.array([size.mae_interval[end] for size in sizes]) for end in (0, 1))
        mae = np.array([size.mae for size in sizes])
        read_as = error_quantity(name).golf
        numbers = [f"{units.from_si(each, read_as.unit):.{read_as.digits}f}" for each in mae]
        marks = [
            Mark("bars", mae[[place]], places[[place]], style=model, size=0.6, faint=True)
            for place, model in enumerate(evaluation.models)
        ]
        marks.append(Mark("intervals", mae, places, x0=low, x1=high, style=-2, symbol="", label="95% interval"))
        known = [(place, evaluation.published.get(model)) for place, model in enumerate(evaluation.models)]
        if shown := [(place, each.mae[name]) for place, each in known if each is not None]:
            x, y = np.array([each for _, each in shown]), np.array([place for place, _ in shown])
            marks.append(
                Mark("points", x, y, style=-2, symbol="D", size=4.5, hollow=True, label="as published, on other shots")
            )
        if name in evaluation.floor:
            shade = Mark("shade", x0=0.0, x1=evaluation.floor[name], style=-1, label="what measurement alone explains")
            marks.append(shade)
        end = 1.2 * float(np.nanmax([*mae, *high, *(each for _, each in shown)]))
        marks.append(Mark("text", np.full(len(places), 0.95 * end), places, texts=numbers, style=-2))
        panels.append(
            Panel(marks, axis(name, limits=(0.0, end or None)),
                  axis(names=evaluation.models, reversed=True))
        )  # fmt: skip
    count = len(panels)
    return Picture(
        "errors", "Mean absolute error of every model with its 95% interval, as published (hollow), and what"
        " measurement alone explains (shaded).", arrange_in_rows(panels, 2), legend=True,
        height=0.5 + (0.5 + 0.17 * len(places)) * ((count + 1) // 2),
    )  # fmt: skip


def _trend_picture(evaluation: Evaluation) -> Picture:
    """Return the error of each model over speed, path and place on the face, as means of equal numbers of shots."""
    delivery = evaluation.shots.delivery
    names = [name for name in TREND_COVARIATES if name in delivery and float(np.ptp(delivery[name])) > 0.0]
    rows: list[list[Panel | None]] = [
        [
            Panel(
                [Mark("rule", y=0.0, style=-1)]
                + [
                    Mark("line", *_bin(delivery[name], evaluation.errors(model, measured)), style=model, label=model)
                    for model in evaluation.models
                ],
                axis(name), axis(measured),
            )
            for name in names
        ]
        for measured in evaluation.quantities
    ]  # fmt: skip
    if not names:
        rows = [[Panel([Mark("text", texts=["nothing of the delivery varies"])])]]
    return Picture(
        "trends", "Error over the delivery: means of equal numbers of shots.", rows, share_x=True, share_y=True,
        legend=True, height=0.6 + 1.45 * len(rows),
    )  # fmt: skip


def _agreement_picture(evaluation: Evaluation) -> Picture:
    """Return a picture of computed over measured values, for the best model of each quantity."""
    step = max(1, -(-len(evaluation.shots) // MOST_POINTS))
    panels = []
    for name in evaluation.quantities:
        model = evaluation.best[name].model
        measured, computed = (
            values[::step] for values in (evaluation.shots.launch[name], evaluation.predicted[model][name])
        )
        middle = float(np.nanmean(measured))
        marks = [
            Mark("points", measured, computed, style=model, symbol=""),
            Mark("slope", middle, middle, values=1.0, style=-1),
        ]
        panels.append(
            Panel(
                marks, axis(name, "measured"), axis(name, "model"), title=f"{quantity(name).label}: {model}", equal=True
            )
        )
    return Picture("agreement", "Model over measured; on the line they agree.", arrange_in_rows(panels, 3))


def arrange_in_rows(panels: Sequence[Panel], columns: int) -> list[list[Panel | None]]:
    """Return panels in rows of at most ``columns``, the last row filled up with None."""
    columns = min(columns, len(panels))
    padded = [*panels, *[None] * (-len(panels) % columns)]
    return [list(padded[start : start + columns]) for start in range(0, len(padded), columns)]


def _bin(x: Floats, error: Floats) -> tuple[list[float], list[float]]:
    """Return the means of ``x`` and ``error`` in bins of equal numbers of shots, sorted by ``x``."""
    there = np.isfinite(error)
    order = np.argsort(x[there], kind="stable")
    bins = min(MOST_BINS, max(1, order.size // FEWEST_IN_BIN))
    parts = [each for each in np.array_split(order, bins) if each.size]
    return [float(x[there][part].mean()) for part in parts], [float(error[there][part].mean()) for part in parts]
