"""What a validation found, as rows of tables, CSV, Markdown and JSON."""

from __future__ import annotations

import json
import math
from typing import Any

from clubface import units
from clubface.validation.check import Check, Figure
from clubface.validation.run import Summary, Validation
from clubface.validation.tour_tables import csv_text

DIGITS = {"mm": 1, "mph": 1, "deg": 1, "rpm": 0, "yd": 1, "us": 0, "1": 3, "%": 1}
WITHIN = {True: "yes", False: "no", None: ""}
SUMMARY_HEADS = [
    "check", "quantity", "certainty", "tolerance", "model", "inside", "within", "median |error|", "mean |error|",
    "mean error", "worst",
]  # fmt: skip
FIGURE_HEADS = ["", "quantity", "published", "certainty", "computed", "inside", "error", "tolerance", "within"]


def in_unit(value: float, unit: str, sign: str = "") -> str:
    """Write an SI value, or a share as percent, without its unit; NaN is empty."""
    if math.isnan(value):
        return ""
    shown = 100.0 * value if unit == "%" else float(units.from_si(value, unit))
    text = f"{shown:{sign}.{DIGITS[unit]}f}"
    return text if text.strip("+-0.") else text.lstrip("+-")


def with_unit(value: float, unit: str, sign: str = "") -> str:
    """Write an SI value, or a share as percent, with its unit; NaN is empty."""
    text = in_unit(value, unit, sign)
    return text if unit == "1" or not text else f"{text}%" if unit == "%" else f"{text} {unit}"


def published(each: Figure) -> str:
    """Write what was published, a range as two ends; a bound has one."""
    low, high = each.published
    if low == high:
        return with_unit(low, each.unit)
    if math.isinf(high):
        return f"over {with_unit(low, each.unit)}"
    return f"{in_unit(low, each.unit)} to {with_unit(high, each.unit)}"


def figure_rows(figures: list[Figure]) -> list[list[str]]:
    """Return one row a figure, under ``FIGURE_HEADS``."""
    found = []
    for each in figures:
        unit = "%" if each.relative else each.unit
        computed = with_unit(each.computed, each.unit)
        error = with_unit(each.error, unit, "+") if computed else ""
        tolerance = with_unit(each.tolerance, unit)
        found.append(
            [
                each.what, each.quantity, published(each), each.certainty, computed, WITHIN[each.inside], error,
                tolerance, WITHIN[each.within],
            ]
        )  # fmt: skip
    return found


def summary_cells(each: Summary) -> list[str]:
    """Return how many figures are inside an interval and within the tolerance, and what their errors are."""
    if not each.told:
        return ["", "says nothing", "", "", "", ""]
    inside = f"{each.inside} of {each.intervals}" if each.intervals else ""
    sizes = [with_unit(value, each.unit) for value in (each.median, each.mean)]
    signed = [with_unit(value, each.unit, "+") for value in (each.bias, each.worst)]
    return [inside, f"{each.within} of {each.figures}", *sizes, *signed]


def tolerances(of: Summary) -> str:
    """Write the tolerance, or the range of tolerances, of a quantity."""
    least, most = (with_unit(each, of.unit) for each in of.tolerances)
    return most if least == most else f"{in_unit(of.tolerances[0], of.unit)} to {most}"


def summary_rows(result: Validation) -> list[list[str]]:
    """Return one row a check, quantity and model, under ``SUMMARY_HEADS``."""
    found = []
    for check in result.checks:
        for place, first in enumerate(result.summary(result.models[0], check.name)):
            for model in result.models:
                each = result.summary(model, check.name)[place]
                head = [check.name, each.quantity, check.certainty, tolerances(first), model]
                found.append([*head, *summary_cells(each)])
    return found


def verdicts(result: Validation) -> list[str]:
    """Say of each model in how many quantities its errors are on average within the tolerance."""
    return [
        f"{model}: in {each.met} of {each.of} measured quantities the mean error is within the tolerance, in"
        f" {each.every} every error is."
        for model in result.models
        for each in [result.verdict(model)]
    ]


def notes(check: Check) -> list[str]:
    """Return why the tolerances are as they are, and the sources."""
    return [check.reason, *(f"{each.title}: {each.source}." for each in check.tables)]


def records(result: Validation) -> list[dict[str, Any]]:
    """Return one record a model and figure, in the unit of the figure."""
    found = []
    for model, checks in result.figures.items():
        for check, figures in checks.items():
            for each in figures:
                low, high = (float(units.from_si(value, each.unit)) for value in each.published)
                error, allowed = (
                    value if each.relative else float(units.from_si(value, each.unit))
                    for value in (each.error, each.tolerance)
                )  # fmt: skip
                found.append(
                    {
                        "model": model, "check": check, "what": each.what, "quantity": each.quantity, "unit": each.unit,
                        "published_least": _rounded(low), "published_most": _rounded(high), "certainty": each.certainty,
                        "computed": _rounded(float(units.from_si(each.computed, each.unit))),
                        "error": _rounded(error), "tolerance": _rounded(allowed),
                        "relative": each.relative, "inside": each.inside, "within": each.within,
                    }
                )  # fmt: skip
    return found


def _rounded(value: float) -> float | None:
    """Return a number to six decimals; JSON has none for NaN and infinity."""
    return round(value, 6) if math.isfinite(value) else None


def document(result: Validation) -> dict[str, Any]:
    """Return everything as one document for JSON."""
    return {
        "ball": result.ball,
        "checks": {
            each.name: {
                "title": each.title,
                "reason": each.reason,
                "certainty": each.certainty,
                "sources": list(each.sources),
            }
            for each in result.checks
        },
        "figures": records(result),
    }


def as_json(result: Validation) -> str:
    """Return :func:`document` as text."""
    return json.dumps(document(result), indent=1, allow_nan=False) + "\n"


def as_csv(result: Validation) -> str:
    """Return :func:`records` as CSV."""
    return csv_text(records(result))


def as_markdown(result: Validation) -> str:
    """Return a page: the summary, then every figure with its sources."""
    lines = [f"# {', '.join(result.models)} beside published figures", "", f"Ball: {result.ball}.", ""]
    lines += markdown(SUMMARY_HEADS, summary_rows(result))
    for check in result.checks:
        lines += ["", f"## {check.title}", "", *(f"* {note}" for note in notes(check))]
        for model in result.models:
            lines += ["", f"### {model}", "", *markdown(FIGURE_HEADS, figure_rows(result.figures[model][check.name]))]
    return "\n".join([*lines, ""])


def markdown(heads: list[str], rows: list[list[str]]) -> list[str]:
    """Return the lines of a Markdown table."""
    cells = [heads, ["---"] * len(heads), *([cell.replace("|", "\\|") for cell in row] for row in rows)]
    return [f"| {' | '.join(row)} |" for row in cells]
