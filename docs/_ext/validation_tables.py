"""Models beside published figures, computed when the pages are built; the finite elements are read from a file."""

from __future__ import annotations

import json
import math
from functools import cache
from pathlib import Path

from core_tables import CoreTable, markdown_table
from sphinx.application import Sphinx

from clubface.equipment.models import DEFAULT_MODEL, models
from clubface.validation import Validation, validate
from clubface.validation.tables import notes, tolerances, with_unit

STORED = Path(__file__).parent.parent / "validation-fem.json"
SHOWN = tuple(dict.fromkeys((DEFAULT_MODEL, "fem", "standard", "slip", "rings")))
"""The models of the tables of single checks."""


@cache
def validation() -> Validation:
    """Return all checks of all models; ``docs/figures/validation.py`` wrote what finite elements compute."""
    found = validate(models())
    stored = json.loads(STORED.read_text(encoding="utf-8"))
    beside = found.figures[DEFAULT_MODEL]
    found.figures["fem"] = {
        check: [each._replace(computed=_number(stored[check][f"{each.what}: {each.quantity}"])) for each in figures]
        for check, figures in beside.items()
    }
    return found


def _number(value: float | None) -> float:
    return math.nan if value is None else value


class Checks(CoreTable):
    """``{validation} tour-irons robot-irons``: mean errors in every quantity of some checks, or of all."""

    optional_arguments = 1
    final_argument_whitespace = True

    def table(self) -> list[str]:
        """One row a check and quantity; a mean within the tolerance is bold."""
        found = validation()
        wanted = self.arguments[0].split() if self.arguments else [each.name for each in found.checks]
        names = SHOWN if self.arguments else found.models
        rows = []
        for check in found.checks:
            if check.name not in wanted:
                continue
            for place, first in enumerate(found.summary(names[0], check.name)):
                row = [check.title if self.arguments else f"`{check.name}`", first.quantity, tolerances(first)]
                for name in names:
                    each = found.summary(name, check.name)[place]
                    mean = with_unit(each.mean, each.unit)
                    row.append(f"**{mean}**" if each.met else mean or "—")
                rows.append(row)
        return markdown_table(["", "quantity", "tolerance", *(f"`{name}`" for name in names)], rows)


class Reasons(CoreTable):
    """``{validation-reasons}``: what is compared in each check, why its tolerances are as they are, and its sources."""

    def table(self) -> list[str]:
        """One item a check."""
        lines = []
        for check in validation().checks:
            reason, *_ = notes(check)
            sources = ", ".join(f"`{name}`" for name in check.sources)
            lines += [f"`{check.name}`", f": {check.title} ({sources}). {reason}", ""]
        return lines


class Verdicts(CoreTable):
    """``{validation-verdicts}``: in how many quantities each model is within the tolerance."""

    def table(self) -> list[str]:
        """One row a model."""
        found = validation()
        rows = [
            [f"`{name}`", f"{each.met} of {each.of}", each.every]
            for name in found.models
            for each in [found.verdict(name)]
        ]
        return markdown_table(["", "mean error within the tolerance", "every error"], rows)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("validation", Checks)
    app.add_directive("validation-reasons", Reasons)
    app.add_directive("validation-verdicts", Verdicts)
    return {"parallel_read_safe": True}
