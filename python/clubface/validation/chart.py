"""The model behind TrackMan's 2010 chart of drives: a rigid ball rolling off a rigid head struck through its CG.

The chart gives complete deliveries and launches of 60 drives and looks like a measurement of dynamic loft and spin, but
is computed. The model ``standard``, with the head struck at the projection of its CG, reproduces the spins up to a
constant, and the ratio of spin to momentum along the face is the same in every row. The chart's dynamic lofts therefore
carry no more information than its launches.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from clubface import published_data
from clubface.equipment.balls import ball
from clubface.equipment.clubs import Club, club
from clubface.equipment.models import DEFAULT_MODEL
from clubface.quantities import quantity
from clubface.results.notes import note
from clubface.results.result import Described, Result
from clubface.results.table import Column, Table, column, text
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings
from clubface.validation.check import SHARE, ModelUnderTest
from clubface.validation.tour import loft_of_ratio, spin_ratio

TABLE = "optimum-trackman-2010"
BALL = "published"
"""A ball as assumed at the time: 45.9 g, 42.6 mm, with the moment of inertia of a homogeneous sphere."""
STANDARD = "standard"


class Errors(NamedTuple):
    """Errors of a model against the chart: mean, mean magnitude and standard deviation."""

    model: str
    struck: str  # description of the impact location
    ball_speed: tuple[float, float, float]  # relative
    launch: tuple[float, float, float]  # [rad]
    spin: tuple[float, float, float]  # relative


@dataclass(frozen=True)
class Chart(Described):
    """The chart compared with models.

    The ratio I w/(m R v_t), where v_t is the ball's velocity along the face, is 1 for a rigid ball that rolls off a
    face at rest.
    """

    drives: int  # number of them
    ratio: tuple[float, float]  # mean and standard deviation
    loft: float  # RMS difference of the chart's lofts and those from launch, speed, spin and mean ratio [rad]
    errors: list[Errors]

    def to_result(self) -> Result:
        """Return the errors of the models as a result, with conclusions on the chart in the notes."""
        table = published_data.table(TABLE)
        ratio, spread = self.ratio
        best = self.errors[0]
        return Result(
            kind="chart", title=f"{table.title}, ball {BALL}", tables=(self._error_table(),),
            values=(
                text("drives", [self.drives]),
                column("ratio", [ratio], "1", label="I w/(m R v_t), mean", digits=3),
                column("ratio_deviation", [spread], "1", label="I w/(m R v_t), standard deviation", digits=3),
                column("loft_error", [self.loft], "loft", label="error of the computed loft (RMS)", digits=2),
            ),
            notes=(
                note("chart-spin", model=best.model, struck=best.struck, drives=self.drives, mean=best.spin[0],
                     deviation=best.spin[2]),
                note("chart-loft", ratio=ratio, deviation=spread, error_loft=self.loft),
                note("chart-is-model"),
                note("published-table", title=table.title, source=table.source),
            ),
        )  # fmt: skip

    def _error_table(self) -> Table:
        """Return the table of errors, with one row per model and quantity."""
        names = {"ball_speed": SHARE, "launch": quantity("launch"), "spin": SHARE}
        rows = [(each, name) for each in self.errors for name in names]
        kinds = [names[name] for _, name in rows]
        means, magnitudes, deviations = zip(*(getattr(each, name) for each, name in rows), strict=True)
        return Table(
            "errors",
            (
                text("model", [each.model for each, _ in rows]), text("struck", [each.struck for each, _ in rows]),
                text("quantity", [quantity(name).label for _, name in rows]),
                Column("mean_error", means, kinds, difference=True),
                Column("mean_magnitude", magnitudes, kinds, label="mean |error|"),
                Column("deviation", deviations, kinds, label="standard deviation"),
            ),
            "Model less chart",
        )  # fmt: skip


def chart() -> Chart:
    """Compare the chart with models."""
    table = published_data.table(TABLE)
    with without_warnings():  # the ball is slightly smaller than the rules allow
        used = ball(BALL)
    launched = (used, table["ball_speed"], table["launch"], table["spin"])
    ratios = spin_ratio(*launched, table["dynamic_loft"])
    lofts = loft_of_ratio(*launched, ratios.mean())
    head = club("driver").replace(bulge="flat", roll="flat")
    shots = (
        (STANDARD, "through the CG", through_cg(head)),
        (STANDARD, "face centre", (0.0, 0.0)),
        (DEFAULT_MODEL, "through the CG", through_cg(head)),
        (DEFAULT_MODEL, "face centre", (0.0, 0.0)),
    )
    return Chart(
        len(table),
        (float(ratios.mean()), float(ratios.std())),
        float(np.sqrt(np.mean((lofts - table["dynamic_loft"]) ** 2))),
        [_errors(model, struck, head, where) for model, struck, where in shots],
    )


def through_cg(head: Club) -> tuple[float, float]:
    """Return the point on a flat face [m], towards the toe and up, whose normal passes through the CG."""
    return -head.cg_z, head.cg_height


def _errors(model: str, struck: str, head: Club, where: tuple[float, float]) -> Errors:
    table = published_data.table(TABLE)
    with without_warnings():
        shots = ModelUnderTest(model, BALL).strike(
            head, speed=table["club_speed"], attack=table["attack"], loft=table["dynamic_loft"], toe=where[0],
            high=where[1],
        )  # fmt: skip
    return Errors(
        model,
        struck,
        _spread(shots.ball_speed / table["ball_speed"] - 1.0),
        _spread(shots.launch - table["launch"]),
        _spread(shots.total_spin / table["spin"] - 1.0),
    )


def _spread(errors: Floats) -> tuple[float, float, float]:
    return float(errors.mean()), float(np.abs(errors).mean()), float(errors.std())
