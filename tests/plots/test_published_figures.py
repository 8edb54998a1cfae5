"""Published figures in pictures stand where they were printed: read from the axes, and typed again from the source."""

import runpy
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from clubface import published_data
from fem_runs import coarse_drive

pytest.importorskip("matplotlib")

from clubface.design.best_loft import ChartComparison, chart_picture
from clubface.fem.pictures import paper_picture, sweep_picture
from clubface.inference.evaluation import published
from clubface.inference.evaluation.result import error_picture
from clubface.present.drawing import draw
from clubface.shots.measured import QUANTITIES
from clubface.validation import tour, validate
from clubface.validation.run import validation_picture
from clubface.validation.tour import TABLES, launch_picture, published_lofts

DOCS = Path(__file__).parents[2] / "docs"


def within_axes(axes, x, y):
    """Whether a point is seen: inside the limits of its panel."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    return left <= x <= right and low <= y <= high


@cache
def panels_of_paper():
    result = coarse_drive()
    picture = paper_picture({"penalty": result})
    axes = draw(picture).axes
    return result, {panel.y.heading: drawn for panel, drawn in zip(picture.panels(), axes, strict=True)}


# Roh and Lee, typed from their text: end or value in time [us] and height. None stands for what the run gives.
MARKS = {
    "speed (m/s)": [(None, 50.4), (None, 24.0)],
    "launch angle (deg)": [(None, 9.8)],
    "normal force (kN)": [(280.0, 6.6)],
    # Their ball of 42.8 mm, 23% contracted.
    "mass centre to face (mm)": [(300.0, 0.77 * 21.4)],
    "force along the face (N)": [(320.0, 0.0)],
    "velocity along the face (m/s)": [(0.0, 7.0), (None, 5.15)],
    "backspin (rpm)": [(None, 2047.0)],
}


@pytest.mark.parametrize("panel", MARKS)
def test_the_figures_of_roh_and_lee_are_marked_where_they_printed_them(panel):
    _, panels = panels_of_paper()
    (mark,) = [line for line in panels[panel].lines if line.get_marker() == "x"]
    for (x, y), (time, value) in zip(mark.get_xydata(), MARKS[panel], strict=True):
        assert y == pytest.approx(value)
        assert time is None or x == pytest.approx(time)


def test_the_least_sliding_of_roh_and_lee_stands_at_320_us():
    _, panels = panels_of_paper()
    sliding = panels["velocity along the face (m/s)"].lines
    # A line across the panel.
    assert [line.get_xdata() for line in sliding if line.get_xdata()[0] == line.get_xdata()[-1] != 0.0] == [[320.0] * 2]


def test_the_sweep_is_marked_with_the_case_and_the_least_factor_of_roh_and_lee():
    # Fig. 8 and its text: 35 m/s with 11.5 deg of loft, and a least factor of 0.92 over all speeds and lofts.
    case = {"ball_speed_mps": 50.4, "launch_deg": 9.8, "spin_rpm": 2047.0, "f": 0.9476}
    rows = [
        {"speed_mps": speed, "loft_deg": 11.5, "ball_speed_mps": 50.0, "launch_deg": 9.0, "spin_rpm": 2000.0, "f": 0.95}
        for speed in (30.0, 60.0)
    ]
    panels = draw(sweep_picture(rows, published=True)).axes
    for axes, value in zip(panels, case.values(), strict=True):
        (mark,) = [line for line in axes.lines if line.get_marker() == "x"]
        assert mark.get_xydata().tolist() == [[35.0, pytest.approx(value)]]
        assert within_axes(axes, 35.0, value)
    assert [0.92, 0.92] in [list(line.get_ydata()) for line in panels[3].lines]
    # The panel shows factors, and none that only a slip of the pen could need.
    assert panels[3].get_ylim()[0] > 0.8
    assert panels[3].get_ylim()[1] < 1.05


@pytest.mark.parametrize("table", TABLES)
def test_tour_averages_are_drawn_as_they_were_published(table):
    result = tour.tour(["standard"], table=table)
    rows = published_data.table(table)
    chosen = [list(rows["club"]).index(club) for club in result.clubs]
    figure = draw(launch_picture(result))
    for axes, (name, unit) in zip(figure.axes, (("ball_speed", "mph"), ("spin", "rpm"), ("carry", "yd")), strict=False):
        assert unit in axes.get_ylabel()
        line = axes.lines[0]  # the line of what is published
        assert line.get_ydata() == pytest.approx(rows.get(name, unit)[chosen])
    lofts = published_lofts(table)
    known = [club for club in result.clubs if club in lofts]
    marks = [mark for mark in launch_picture(result).rows[1][1].marks if mark.label == "published loft"]
    launch = dict(zip(rows["club"], rows["launch"], strict=True))
    drawn = [value for mark in marks for value in mark.y]
    assert drawn == pytest.approx([lofts[club] - launch[club] for club in known])


def test_the_pga_averages_of_2023_are_those_of_the_chart():
    # Typed again from TrackMan's table: driver, 6-iron and pitching wedge, in mph, rpm and yards.
    figure = draw(launch_picture(tour.tour(["standard"], table="pga-2023")))
    clubs = [label.get_text() for label in figure.axes[2].get_xticklabels()]
    for index, expected in enumerate(([171, 130, 104], [2545, 6204, 9316], [282, 188, 142])):
        line = figure.axes[index].lines[0]
        drawn = dict(zip(clubs, line.get_ydata(), strict=True))
        assert [drawn[club] for club in ("driver", "6-iron", "pitching-wedge")] == pytest.approx(expected)


@pytest.mark.parametrize(
    ("chart", "table", "column"),
    [("trackman", "optimum-trackman-2010", "dynamic_loft"), ("ping", "optimum-ping-2019", "launch")],
)
def test_a_chart_of_best_lofts_is_drawn_as_it_was_published(chart, table, column):
    rows = published_data.table(table)
    best = SimpleNamespace(**{name: np.zeros(len(rows[column])) for name in ("loft", "launch", "spin", "carry")})
    picture = chart_picture(ChartComparison(chart, best, dict(rows.columns)))
    assert picture.panels()[0].marks[1].x == pytest.approx(rows[column])


def test_published_errors_are_drawn_at_their_values():
    # Caldwell and McPhee (2023), Table 2, driver: typed again, in mph, deg, deg, rpm and rpm.
    expected = {
        "adjusted": [1.51, 0.68, 0.78, 211, 153],
        "slip": [1.85, 0.71, 0.81, 219, 149],
        "volumetric": [2.12, 0.54, 1.07, 228, 227],
    }
    size = SimpleNamespace(mae=0.0, mae_interval=(0.0, 0.0))
    names = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")
    result = SimpleNamespace(
        models=list(expected), quantities=list(names), floor={},
        sizes={name: dict.fromkeys(expected, size) for name in names},
        published={model: published()[model, "driver"] for model in expected},
    )  # fmt: skip
    panels = draw(error_picture(result)).axes
    for column, (name, axes) in enumerate(zip(names, panels, strict=False)):
        drawn = [point for line in axes.lines if line.get_marker() == "D" for point in line.get_xydata().tolist()]
        assert [x for x, _ in drawn] == pytest.approx([row[column] for row in expected.values()]), QUANTITIES[name]
        assert [y for _, y in drawn] == [0, 1, 2]


def test_errors_against_published_figures_are_drawn_over_their_tolerance():
    result = validate("standard", checks=["plates"])
    axes = draw(validation_picture(result)).axes[0]
    drawn = [x for line in axes.lines if line.get_marker() not in ("None", "") for x in line.get_xdata()]
    expected = []
    for quantity in result.summary("standard", "plates"):
        for each in result.figures["standard"]["plates"]:
            if each.quantity == quantity.quantity and each.within is not None:
                least, most = each.published
                nearest = min(max(each.computed, least), most)
                away = (each.computed - nearest) / (abs(nearest) if each.relative else 1.0)
                expected.append(np.clip(away / each.tolerance, -4.0, 4.0))
    assert drawn == pytest.approx(expected)


def test_the_displacements_of_the_published_sets_are_drawn_at_their_values():
    script = runpy.run_path(str(DOCS / "figures" / "contact_laws.py"), run_name="drawn")
    normal, up, _ = script["displacement_figure"]({}).axes
    # Caldwell and McPhee (2023), Table 3: driver and 7-iron, mm.
    assert [line.get_ydata()[0] for line in normal.lines[:2]] == pytest.approx([0.0, -0.395])
    assert [line.get_ydata()[0] for line in up.lines[:2]] == pytest.approx([-0.482, -0.182])
