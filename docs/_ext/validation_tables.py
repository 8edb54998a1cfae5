"""Models compared with published figures, computed when the pages are built; finite elements come from a file."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from functools import cache
from pathlib import Path

from core_tables import NBSP, CoreTable, markdown_table
from sphinx.application import Sphinx

from clubface.equipment.models import DEFAULT_MODEL, models
from clubface.present.terminal import headings_and_rows
from clubface.validation import Validation, chart, off_centre, own_monitor, validate
from clubface.validation.check import CERTAINTIES
from clubface.validation.run import figure_table, mean_text, tolerance_text

STORED = Path(__file__).parent.parent / "validation-fem.json"
SHOWN = tuple(dict.fromkeys((DEFAULT_MODEL, "fem", "standard", "slip", "rings")))
"""The models of the tables of single checks."""


@cache
def validation() -> Validation:
    """Return all checks of all models; ``docs/figures/validation.py`` wrote what finite elements compute."""
    result = validate(models())
    stored = json.loads(STORED.read_text(encoding="utf-8"))
    default_figures = result.figures[DEFAULT_MODEL]
    result.figures["fem"] = {
        check: [each._replace(computed=_number(stored[check][f"{each.case}: {each.quantity}"])) for each in figures]
        for check, figures in default_figures.items()
    }
    return result


def _number(value: float | None) -> float:
    return math.nan if value is None else value


class Checks(CoreTable):
    """``{validation} tour-irons robot-irons``: mean errors in every quantity of some checks, or of all."""

    optional_arguments = 1
    final_argument_whitespace = True

    def table(self) -> list[str]:
        """One row a check and quantity; a mean within the tolerance is bold, behind it how many are inside."""
        result = validation()
        wanted = self.arguments[0].split() if self.arguments else [each.name for each in result.checks]
        names = SHOWN if self.arguments else result.models
        rows = []
        for check in result.checks:
            if check.name not in wanted:
                continue
            for place, first in enumerate(result.summary(names[0], check.name)):
                name = check.title if self.arguments else f"`{check.name}`"
                tolerance = tolerance_text(first).replace(" ", NBSP)
                row = [f"{name}: {first.quantity}", f"{tolerance}, {check.certainty}"]
                for name in names:
                    each = result.summary(name, check.name)[place]
                    mean = mean_text(each).replace(" ", NBSP)
                    inside = f" · {each.inside}/{each.intervals}" if each.intervals else ""
                    row.append(f"**{mean}**{inside}" if each.met else f"{mean}{inside}" if mean else "—")
                rows.append(row)
        return markdown_table(["", "tolerance, certainty", *(f"`{name}`" for name in names)], rows)


class Figures(CoreTable):
    """``{validation-figures} tour-driver``: every figure of some checks with its interval, by the default model."""

    required_arguments = 1
    final_argument_whitespace = True

    def table(self) -> list[str]:
        """One row a figure."""
        every = validation()
        chosen = tuple(each for each in every.checks if each.name in self.arguments[0].split())
        of_default = replace(every, checks=chosen, figures={DEFAULT_MODEL: every.figures[DEFAULT_MODEL]})
        heads, cells = headings_and_rows(figure_table(of_default))
        rows = []
        for row in cells:
            each = dict(zip((words for words, _ in heads), row, strict=True))  # the second unit is that of the error
            unit = row[[words for words, _ in heads].index("unit")]
            error = f"{each['error']} {each['unit']}".replace(" %", "%") if each["inside"] == "no" else "inside"
            published = f"{_range(each['published'], each['to'])} {unit}"
            computed = error if each["within"] == "yes" else f"**{error}**"
            rows.append([f"{each['shot']}: {each['quantity']}", published, each["computed"], computed])
        return markdown_table(["", "published", "computed", "outside by"], rows)


def _range(least: str, most: str) -> str:
    """Return two ends as people write a range."""
    return least if least == most else f"{least} to {most}"


class Certainties(CoreTable):
    """``{validation-certainties}``: what the words for how sure a published figure is mean."""

    def table(self) -> list[str]:
        """One row a word."""
        return markdown_table(["certainty", "the figure is"], CERTAINTIES.items())


class Causes(CoreTable):
    """``{off-centre-causes}``: strikes off the centre with one thing changed, by the default model."""

    def table(self) -> list[str]:
        """One row a figure."""
        heads, cells = headings_and_rows(off_centre.causes())
        rows = [
            [figure, f"{' '.join(filter(None, (_range(least, most), unit)))}, {certainty}", *computed]
            for figure, unit, least, most, certainty, *computed in cells
        ]
        return markdown_table(["", "published, certainty", *(words for words, _ in heads[5:])], rows)


class BehindTheChart(CoreTable):
    """``{model-behind-chart}``: how near models come to TrackMan's chart of 2010, and what that means."""

    def table(self) -> list[str]:
        """One row a model and place of the strike; what the numbers say below."""
        result = chart.chart().to_result()
        rows: dict[tuple[str, str], list[str]] = {}
        heads: dict[str, None] = {}
        for name, struck, quantity, unit, mean, _, deviation in headings_and_rows(result.table())[1]:
            heads[f"{quantity}, {unit}"] = None
            rows.setdefault((name, struck), []).append(f"{mean} ± {deviation}")
        table = markdown_table(["model", "struck", *heads], ([*place, *cells] for place, cells in rows.items()))
        return [*table, "", *(f"* {each.sentence}" for each in result.notes[:-1])]


class Reasons(CoreTable):
    """``{validation-reasons}``: what is compared in each check, why its tolerances are as they are, and its sources."""

    def table(self) -> list[str]:
        """One item a check."""
        lines = []
        for check in validation().checks:
            sources = ", ".join(f"`{name}`" for name in check.sources)
            lines += [f"`{check.name}`", f": {check.title} ({sources}). {check.reason}", ""]
        return lines


class Verdicts(CoreTable):
    """``{validation-verdicts}``: in how many quantities each model is within the tolerance."""

    def table(self) -> list[str]:
        """One row a model."""
        result = validation()
        rows = [
            [f"`{name}`", f"{each.met} of {each.of}", each.every]
            for name in result.models
            for each in [result.verdict(name)]
        ]
        return markdown_table(["", "mean error within the tolerance", "every error"], rows)


class Camps(CoreTable):
    """``{published-camps}``: spin of published irons by an index and over the default model, tours and others."""

    def table(self) -> list[str]:
        """One row a club of the tours."""
        _, cells = headings_and_rows(own_monitor.camp_table())
        ends = [(club, *zip(values[::2], values[1::2], strict=True)) for club, *values in cells]
        heads = [f"{what}: {who}" for what in ("index", "spin") for who in ("tours", "robots, single golfers")]
        return markdown_table(["club", *heads], ([club, *(_range(*each) for each in pairs)] for club, *pairs in ends))


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("published-camps", Camps)
    app.add_directive("validation", Checks)
    app.add_directive("validation-figures", Figures)
    app.add_directive("validation-certainties", Certainties)
    app.add_directive("off-centre-causes", Causes)
    app.add_directive("model-behind-chart", BehindTheChart)
    app.add_directive("validation-reasons", Reasons)
    app.add_directive("validation-verdicts", Verdicts)
    return {"parallel_read_safe": True}
