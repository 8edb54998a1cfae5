"""The model behind TrackMan's chart of drives: what ``clubface chart`` and its page say holds, and could fail to."""

import math

import numpy as np
import pytest

import clubface
from clubface.validation import chart

DEG = math.pi / 180


@pytest.fixture(scope="module")
def behind():
    return chart.chart()


def test_a_rigid_ball_that_rolls_off_a_head_struck_through_its_cg_has_the_spins_of_the_chart(behind):
    """The head of 2010 is unknown: mass and inertia scale all spins alike, so that what counts is the spread."""
    through, centre, *_ = behind.errors
    assert (through.model, through.struck) == ("standard", "through the CG")
    assert abs(through.spin[0]) < 0.015
    assert through.spin[2] < 0.006
    assert abs(through.launch[0]) < 0.5 * DEG
    # Struck elsewhere, or with the ball of finite elements, the errors differ from drive to drive.
    assert min(each.spin[2] for each in behind.errors[1:]) > 3 * through.spin[2]
    assert centre.struck == "face centre"


def test_the_lofts_of_the_chart_follow_from_its_balls(behind):
    """Typed in by hand from the chart: 100 mph, attack 0, the longest carry."""
    assert behind.drives == 60
    assert behind.ratio == pytest.approx((1.123, 0.026), abs=0.0005)
    assert behind.loft < 0.1 * DEG
    inertia, mass, radius = 8.336e-6, 0.0459, 0.0213
    table = clubface.published_data.table(chart.TABLE)
    row = np.flatnonzero((table["optimum_of"] == "carry") & (table.get("attack", "deg") == 0.0))[5]
    assert table.get("club_speed", "mph")[row] == pytest.approx(100.0)
    spin, speed = table["spin"][row], table["ball_speed"][row]
    loft = table["launch"][row] + math.asin(inertia * spin / (1.123 * mass * radius * speed))
    assert loft == pytest.approx(table["dynamic_loft"][row], abs=0.1 * DEG)


def test_the_normal_of_the_place_struck_runs_through_the_mass_centre():
    head = clubface.club("driver").replace(bulge="flat", roll="flat")
    toe, up = chart.through_cg(head)
    normal = np.array([math.cos(head.loft), math.sin(head.loft), 0.0])
    along = np.array([-math.sin(head.loft), math.cos(head.loft), 0.0])
    struck = np.array([head.cg_x, head.cg_y, head.cg_z]) + up * along + np.array([0.0, 0.0, toe])
    assert np.cross(struck, normal) == pytest.approx(0.0, abs=1e-12)


def test_the_command_prints_the_ratio_and_the_errors_of_each_model(clubface_, behind):
    assert "1.123" in clubface_("chart").out
    document = clubface_("chart", "--json").json
    assert document["values"]["drives"] == 60
    first, launch, *_ = document["tables"]["errors"]["rows"]
    assert (first["unit"], first["mean_error"]) == ("%", pytest.approx(100.0 * behind.errors[0].ball_speed[0]))
    assert (launch["unit"], launch["mean_error"]) == ("deg", pytest.approx(behind.errors[0].launch[0] / DEG))
