"""An evaluation as tables of text: the published form, every model in detail, the best models, noise and trends."""

from __future__ import annotations

import math
from typing import NamedTuple

from clubface import units
from clubface.inference.evaluation.model_errors import ModelErrors
from clubface.inference.evaluation.statistics import COVARIATES, Interval, fewest_groups
from clubface.shots.measured import QUANTITIES

TITLES = {
    "ball_speed": "Ball speed", "launch": "Launch angle", "azimuth": "Azimuth", "backspin": "Backspin",
    "sidespin": "Sidespin",
}  # fmt: skip
DIGITS = {"ball_speed": 2, "launch": 2, "azimuth": 2, "backspin": 0, "sidespin": 0}
WRONG = "*"
"""Stands behind a printed percentage that is not that of the printed numbers."""
CLEAR = "*"
"""Stands behind a slope whose interval excludes zero."""


class Table(NamedTuple):
    """A table of text.

    Attributes
    ----------
    title
        What it shows.
    heads
        One a column.
    rows
        Cells; those of the first column are names.
    words
        The columns that hold words; the first one always does.
    """

    title: str
    heads: list[str]
    rows: list[list[str]]
    words: tuple[int, ...] = (0,)


def shown(value: float, quantity: str, *, signed: bool = False, more: int = 0) -> str:
    """Write an SI value of a launch quantity in the unit it is read in, with ``more`` decimals; NaN stays empty."""
    number = float(units.from_si(value, QUANTITIES[quantity]))
    if math.isnan(number):
        return ""
    text = f"{number:{'+' if signed else ''}.{DIGITS[quantity] + more}f}"
    return text if text.strip("+-0.") else text.lstrip("+-")


def between(ends: Interval, quantity: str, *, signed: bool = False, more: int = 0) -> str:
    """Write an interval as "[low, high]"; one of NaN stays empty."""
    if math.isnan(ends.low):
        return ""
    return f"[{', '.join(shown(each, quantity, signed=signed, more=more) for each in ends)}]"


def name_of(quantity: str) -> str:
    """Return the heading of a quantity, with the unit."""
    return f"{TITLES[quantity]} ({QUANTITIES[quantity]})"


def counted(shots: int, what: str = "shot") -> str:
    """Write a number of shots."""
    return f"{shots} {what}" + ("" if shots == 1 else "s")


def percent(part: float, whole: float) -> str:
    """Write a percentage with three digits, as Caldwell and McPhee (2023) do."""
    if whole == 0.0 or math.isnan(part):
        return ""
    return f"{100.0 * part / whole:.3g}%"


def in_published_form(of: ModelErrors) -> list[Table]:
    """Return the tables in the published form: one row a quantity, MAE and STD of each model with percentages."""
    found = []
    for what, words in (("mae", "Mean absolute error"), ("std", "Standard deviation of the error")):
        rows = []
        for name in of.quantities:
            cells = [getattr(of.sizes[name][model], what) for model in of.models]
            rows.append(
                [name_of(name), shown(of.mean[name], name)]
                + [f"{shown(each, name)} ({percent(each, of.mean[name])})" if each == each else "" for each in cells]
            )
        if what == "mae":
            rows.append(["Cost (Eq. 22)", "", *(f"{of.cost(model):.3f}" for model in of.models)])
            rows.append(["Processor time a shot", "", *(duration(of.seconds[model]) for model in of.models)])
        found.append(Table(f"{words}, {counted(len(of.shots))}", ["", "mean |measured|", *of.models], rows))
    return found


def published_form(of: ModelErrors) -> list[Table]:
    """Return the published tables of the same models, if the club is of a family they were published for."""
    known = of.published
    if not known:
        return []
    first = next(iter(known.values()))
    found = []
    for what, words in (("mae", "mean absolute error"), ("std", "standard deviation of the error")):
        models = [name for name in known if getattr(known[name], what)]
        if not models:
            continue
        rows = []
        for name in QUANTITIES:
            cells = []
            for model in models:
                value, printed = getattr(known[model], what)[name], getattr(known[model], f"{what}_percent")
                wrong = any(f"{what.upper()} of {name.replace('_', ' ')}:" in each for each in known[model].caveats)
                note = f" ({printed[name]:.3g}%{WRONG if wrong else ''})" if printed else ""
                cells.append(shown(value, name) + note)
            rows.append([name_of(name), shown(first.mean[name], name), *cells])
        if what == "mae":
            costs = {model: known[model].cost for model in models}
            times = {model: known[model].cpu for model in models}
            if any(each is not None for each in costs.values()):
                rows.append(["Cost (Eq. 22)", "", *("" if each is None else f"{each:.2f}" for each in costs.values())])
            rows.append(
                ["Processor time, 10 shots", "", *("" if each is None else duration(each) for each in times.values())]
            )
        title = f"As published for the {first.club}: {words}, {first.shots} shots"
        found.append(Table(title, ["", "mean", *models], rows))
    return found


def detail(of: ModelErrors, quantity: str) -> Table:
    """Return one row a model: errors with 95% intervals, beside what was published."""
    known = of.published
    heads = ["model", "MAE", "95%", "of mean", "STD", "bias", "95%", "worst"]
    heads += ["published MAE", "published STD"] if known else []
    rows = []
    for model, size in of.sizes[quantity].items():
        row = [
            model,
            shown(size.mae, quantity),
            between(size.mae_interval, quantity),
            percent(size.mae, of.mean[quantity]),
            shown(size.std, quantity),
            shown(size.bias, quantity, signed=True),
            between(size.bias_interval, quantity, signed=True),
            shown(size.worst, quantity),
        ]
        if known:
            given = known.get(model)
            row += [
                shown(getattr(given, what).get(quantity, math.nan), quantity) if given else ""
                for what in ("mae", "std")
            ]
        rows.append(row)
    count = next(iter(of.sizes[quantity].values())).shots
    return Table(f"{name_of(quantity)}: model less measured, {counted(count)}", heads, rows)


def best_models(of: ModelErrors) -> Table:
    """Return one row a quantity: the best model, those that are no worse, and the lead over the next."""
    rows = []
    for name, best in of.best.items():
        worse = next((each for each in best.rivals if each.is_worse), None)
        lead = ["", "", ""]
        if worse is not None:
            by = f"{shown(worse.difference, name, more=1)} {between(worse.interval, name, more=1)}"
            lead = [worse.model, by, probability(worse.p, of.resamples)]
        mae = shown(of.sizes[name][best.model].mae, name)
        rows.append([name_of(name), best.model, mae, ", ".join(best.equals) or "none", *lead])
    heads = ["", "least MAE", "MAE", "not significantly worse", "next, significantly worse", "by", "p"]
    return Table("Best model in each quantity", heads, rows, (0, 1, 3, 4))


def noise_floor(of: ModelErrors) -> Table:
    """Return one row a quantity: the error a perfect model would have, beside that of the best."""
    rows = []
    for name, least in of.floor.items():
        model = of.best[name].model
        size = of.sizes[name][model]
        share = min(1.0, (least * math.sqrt(math.pi / 2.0) / size.rms) ** 2) if size.rms else 1.0
        monitor = of.monitor_noise.get(name)
        rows.append(
            [
                name_of(name),
                "" if monitor is None else shown(monitor, name),
                shown(least, name),
                f"{shown(size.mae, name)} ({model})",
                f"{100.0 * share:.0f}%",
            ]
        )
    heads = ["", "monitor, standard deviation", "MAE of a perfect model", "least MAE found", "of its mean square"]
    return Table("What measurement alone explains", heads, rows)


def trend_table(of: ModelErrors, quantity: str) -> Table:
    """Return one row a model: the slope of its error over each quantity of the delivery."""
    lines = of.trends[quantity]
    names = list(dict.fromkeys(each.covariate for each_model in lines.values() for each in each_model))
    rows = []
    for model, own in lines.items():
        by_name = {each.covariate: each for each in own}
        cells = []
        for name in names:
            size = _step(name)
            each = by_name[name]
            value = float(units.from_si(each.slope * size, QUANTITIES[quantity]))
            cells.append(f"{value:+.{DIGITS[quantity] or 1}f}{CLEAR if each.is_clear else ''}")
        rows.append([model, *cells])
    heads = ["model", *(f"per {COVARIATES[name]} of {name}" for name in names)]
    return Table(f"{name_of(quantity)}: change of the error", heads, rows)


def parameters_table(of: ModelErrors) -> Table:
    """Return the parameter set of each model."""
    rows = []
    for model, each in of.parameters.items():
        values = ", ".join(f"{key} {units.show(value, each.units[key], 5)}" for key, value in each.values.items())
        rows.append([model, each.name, values])
    return Table("Parameters", ["model", "set", "values"], rows, (0, 1, 2))


def duration(seconds: float) -> str:
    """Write a time with a unit that suits it."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def probability(p: float, resamples: int) -> str:
    """Write a probability; one as small as the resamples can tell is said to be below."""
    return f"< {max(0.001, 20.0 / resamples):.2g}" if p < max(0.001, 20.0 / resamples) else f"{p:.2g}"


def _step(covariate: str) -> float:
    """Return the size in SI of one unit of a covariate."""
    return units.size(COVARIATES[covariate])


def remarks(of: ModelErrors) -> list[str]:
    """Return what a reader must know of the shots before the tables: what was assumed, what was left out."""
    found = list(of.shots.notes)
    if of.shots.dropped:
        first = "; ".join(f"{each.line}: {each.reason}" for each in of.shots.dropped[:5])
        found.append(
            f"left out of {of.shots.source}: {counted(len(of.shots.dropped), 'row')} ({first}{_more(of.shots.dropped)})"
        )
    if of.failed:
        first = "; ".join(f"{each.line}: {each.reason}" for each in of.failed[:5])
        found.append(
            f"left out for all models, since one cannot compute them: {counted(len(of.failed))}"
            f" ({first}{_more(of.failed)})"
        )
    return found


def notes(of: ModelErrors) -> list[str]:
    """Return what a reader must know of the tables."""
    found = [
        "Errors are model less measured. Percentages refer to the mean magnitude of what was measured. STD is the"
        " standard deviation of the error about its mean (n - 1)."
    ]
    if any(math.isnan(each.mae_interval.low) for sizes in of.sizes.values() for each in sizes.values()):
        found.append(
            "One shot, or shots all alike, give no intervals and cannot tell which model is better: that takes shots"
            " with different deliveries."
        )
    what = "shots" if of.groups is None else f"{of.groups} groups of shots, such as players"
    least, units_of = fewest_groups(len(of.models)), "shots" if of.groups is None else "groups"
    found.append(
        f"Intervals hold 95% of {of.resamples} bootstrap resamples of the {what} (seed {of.seed}). Models are compared"
        " on the same resamples; p is two-sided, after Holm's correction for the number of rivals, and differences of"
        f" fewer than {least} {units_of} are never significant between {counted(len(of.models), 'model')}. Which"
        " model is best was chosen on the same shots, and parameters"
        " identified on them flatter the model with more of them: only shots held out tell."
    )
    if of.published:
        found.append(
            "Published figures are those of the paper's own shots and golfers, with parameters identified on the same"
            " shots: they stand beside these for scale. The column of standard is from the thesis the paper grew out"
            f" of. A percentage with {WRONG} is not that of the printed numbers. Printed times are totals of ten shots."
            " Whether a mean of azimuth and sidespin, or an STD, is of magnitudes is not said there."
        )
        for each in of.published.values():
            found += [f"published {each.model}, {each.club}: {text}" for text in each.caveats]
    for name, each in of.parameters.items():
        found += [f"{name}: {text}" for text in each.caveats]
    return found


def _more(dropped: tuple[object, ...]) -> str:
    return "; ..." if len(dropped) > 5 else ""
