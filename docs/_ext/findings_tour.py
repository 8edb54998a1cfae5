"""Tables of one parameter set for all clubs of the tour averages, made from the results of the study."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from benchmark_findings import FREE
from core_tables import CoreTable, markdown_table
from findings_results import plain_number, results, shown
from sphinx.application import Sphinx

from clubface import units
from clubface.equipment.models import model as model_named
from clubface.quantities import display_unit


def tour_means(result: dict[str, Any], kind: str) -> dict[str, float]:
    """Return mean absolute errors over the clubs; the launch angle over those with a published loft."""
    values = {name: np.array(each, dtype=float) for name, each in result[kind].items()}
    return {name: float(np.nanmean(np.abs(each))) for name, each in values.items()}


class TourSets(CoreTable):
    """``{findings-tour}``: one parameter set a model for all twelve clubs, with its errors."""

    def table(self) -> list[str]:
        """One row a model."""
        rows = []
        for model in FREE:
            result = results()["tour"][model]
            fit, left = tour_means(result, "errors"), tour_means(result, "left_out")
            values = []
            for name in result["free"]:
                unit = display_unit(name, model_named(model).parameter(name).unit)
                number = plain_number(float(units.from_si(result["parameters"][name], unit)))
                values.append(f"`{name}` {number}" + ("" if unit == "1" else f" {unit}"))
            carry = float(np.mean(np.abs(result["carry"])))
            rows.append(
                [f"`{model}`", ", ".join(values)]
                + [f"{shown(fit[name], name)} ({shown(left[name], name)})" for name in ("ball_speed", "launch", "spin")]
                + [shown(carry, "carry")]
            )
        columns = ["ball speed, mph", "launch of driver and 6-iron, deg", "spin, rpm", "carry, yd"]
        return markdown_table(["", "one set for all clubs", *columns], rows)


class TourClubs(CoreTable):
    """``{findings-tour-clubs} rings``: model less published, club by club, with one parameter set."""

    required_arguments = 1

    def table(self) -> list[str]:
        """One row a club."""
        result = results()["tour"][self.arguments[0]]
        rows = []
        for place, club in enumerate(result["clubs"]):
            errors = [(name, result["errors"][name][place]) for name in ("ball_speed", "launch", "spin")]
            left = result["left_out"]["spin"][place]
            rows.append(
                [club, f"{math.degrees(result['lofts'][place]):.1f}"]
                + [shown(value, name, "+") for name, value in errors]
                + [shown(left, "spin", "+"), shown(result["carry"][place], "carry", "+")]
            )
        columns = [
            "dynamic loft, deg",
            "ball speed, mph",
            "launch, deg",
            "spin, rpm",
            "spin, club left out",
            "carry, yd",
        ]
        return markdown_table(["", *columns], rows)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("findings-tour", TourSets)
    app.add_directive("findings-tour-clubs", TourClubs)
    return {"parallel_read_safe": True}
