"""Clubs and balls: the built-in ones, what is refused, and reading back what was written."""

import math
import warnings

import numpy as np
import pytest

from clubface import published_data
from clubface.equipment.balls import Ball, ball, ball_names, published_ball
from clubface.equipment.clubs import CLUB_NAMES, CLUB_PROPERTIES, TOUR_CLUBS, club
from clubface.errors import RuleWarning
from clubface.simulation.impact import impact
from clubface.support import files

pytestmark = pytest.mark.usefixtures("new_process")


def test_the_driver_and_the_7_iron_are_those_of_table_1():
    driver, iron = club("driver-as-printed"), club("7-iron")
    # 1e-15: one rounding of the conversion.
    assert driver.cg == pytest.approx((0.0408, 0.0114, 0.001), rel=1e-15)
    assert iron.cg == pytest.approx((0.00361, 0.00485, 0.00112), rel=1e-15)
    assert (driver.mass, iron.mass) == (0.204, 0.264)
    expected = [[2843, -733, 530.2], [-733, 5679, 0.5], [530.2, 0.5, 4085]]
    assert np.array(driver.inertia) * 1e7 == pytest.approx(np.array(expected), rel=1e-15)
    expected = [[2752, -51, -53], [-51, 2889, -429], [-53, -429, 576.6]]
    assert np.array(iron.inertia) * 1e7 == pytest.approx(np.array(expected), rel=1e-15)
    assert math.degrees(driver.loft) == pytest.approx(9.8, rel=1e-15)
    assert math.degrees(iron.loft) == pytest.approx(30.5, rel=1e-15)
    assert (driver.bulge, driver.roll, iron.bulge, iron.roll) == (0.305, 0.305, math.inf, math.inf)


def test_the_mass_centre_of_the_driver_is_that_of_danaei_and_co_workers_turned_once_by_the_loft():
    """(-42.3, 2.9) mm from the face centre, y up, in the frame of the face; the file has hundredths of a mm."""
    driver, printed = club("driver"), club("driver-as-printed")
    cosine, sine = math.cos(driver.loft), math.sin(driver.loft)
    expected = (0.0423 * cosine + 0.0029 * sine, 0.0423 * sine - 0.0029 * cosine, printed.cg_z)
    assert driver.cg == pytest.approx(expected, abs=0.5001e-5)
    assert driver.replace(name=printed.name, cg_x=printed.cg_x, cg_y=printed.cg_y).inputs() == printed.inputs()


def test_the_default_ball_conforms_and_the_published_ball_is_that_of_table_1_with_a_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert impact("driver", speed=50.0).ball == ball() == ball("modern")
        published = published_ball()
    with pytest.warns(RuleWarning, match=r"42\.60 mm"):
        assert ball("published") == published
    assert published.inputs() == pytest.approx(
        {"ball_mass": 0.0459, "ball_radius": 0.0213, "ball_inertia": 83.36e-7}, rel=1e-15
    )


def test_the_conforming_ball_breaks_no_rule_and_is_a_uniform_sphere():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        conforming = ball("conforming")
    # The file gives six digits.
    assert conforming.inertia == pytest.approx(0.4 * conforming.mass * conforming.radius**2, rel=1e-6)


def test_there_is_a_club_for_every_row_of_the_tour_averages():
    assert tuple(published_data.table("pga-2023")["club"]) == TOUR_CLUBS


def test_a_built_in_club_is_named_as_its_file():
    assert [club(name).name for name in CLUB_NAMES] == list(CLUB_NAMES)
    assert sorted(CLUB_NAMES) == list(files.builtin_names("clubs"))


@pytest.mark.parametrize("name", CLUB_NAMES)
def test_every_value_of_a_built_in_club_has_a_source(name):
    assert set(club(name).sources) == set(CLUB_PROPERTIES) - {"cor"}


@pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")
@pytest.mark.parametrize("name", ball_names())
def test_every_value_of_a_built_in_ball_has_a_source(name):
    made = Ball.builtin(name)
    friction = set() if made.friction is None else {"friction"}
    wanted = {"mass", "diameter", "pieces"} if made.construction else {"mass", "radius", "inertia"}
    assert set(made.sources) == wanted | friction


# Values in the files have six digits: 1e-5 leaves room for two such roundings.
SIX_DIGITS = 1e-5


@pytest.mark.parametrize(("name", "loft", "volume"), [("3-wood", 15, 165), ("5-wood", 18, 150), ("hybrid", 18, 100)])
def test_woods_follow_the_scaling_rules_their_files_state(name, loft, volume):
    driver, iron, wood = club("driver"), club("7-iron"), club(name)
    length = (volume / 460.0) ** (1.0 / 3.0)
    share = (wood.loft - driver.loft) / (iron.loft - driver.loft)
    assert math.degrees(wood.loft) == pytest.approx(loft)
    assert wood.mass == pytest.approx(driver.mass + share * (iron.mass - driver.mass), abs=0.5001e-3)
    angle = wood.loft - driver.loft
    turn = np.array([[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]])
    assert np.array(wood.cg) == pytest.approx(length * turn @ np.array(driver.cg), rel=SIX_DIGITS)
    scaled = np.array(driver.inertia) * (wood.mass / driver.mass) * length**2
    assert np.array(wood.inertia) == pytest.approx(scaled, rel=SIX_DIGITS)


@pytest.mark.parametrize("name", [name for name in TOUR_CLUBS if "iron" in name or "wedge" in name])
def test_irons_follow_the_scaling_rules_their_files_state(name):
    seven, iron = club("7-iron"), club(name)
    steps = (10 if "wedge" in name else int(name[0])) - 7
    angle = iron.loft - seven.loft
    turn = np.array([[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]])
    normal = np.array([math.cos(seven.loft), math.sin(seven.loft), 0.0])
    assert iron.mass == pytest.approx(seven.mass + 0.007 * steps, rel=1e-12)
    assert np.array(iron.cg) == pytest.approx(turn @ (seven.cg - 0.207e-3 * steps * normal), rel=SIX_DIGITS)
    scaled = turn @ np.array(seven.inertia) @ turn.T * iron.mass / seven.mass
    assert np.array(iron.inertia) == pytest.approx(scaled, rel=SIX_DIGITS)


def test_the_set_grows_in_loft_and_mass_from_driver_to_wedge():
    lofts = [club(name).loft for name in TOUR_CLUBS if name != "hybrid"]
    masses = [club(name).mass for name in TOUR_CLUBS]
    assert lofts == sorted(lofts)
    assert masses == sorted(masses)
