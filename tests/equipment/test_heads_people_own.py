"""Heads made from published measurements agree with what was published, and are plausible as bodies and in play."""

import math

import numpy as np
import pytest

import clubface
from clubface import published_data
from clubface.equipment.clubs import CATEGORIES, CLUB_NAMES, TOUR_CLUBS, club
from clubface.errors import InputError
from clubface.inference.prior import prior_of
from clubface.shots.club_names import club_kind
from clubface.shots.measured import ready_shots

IRONS = {
    "mizuno-pro-241-6-iron": ("PRO 241 #6", 2024),
    "titleist-t100-6-iron": ("T100 Forged #6", 2025),
    "taylormade-p790-6-iron": ("P790 #6", 2024),
    "ping-g430-6-iron": ("G430 #6", 2023),
    "cleveland-zipcore-xl-7-iron": ("Zipcore XL #7", 2025),
}
HYBRID = "cobra-transition-s-5-hybrid"
WEDGES = ("gap-wedge", "sand-wedge", "lob-wedge")
# Lengths in the files have six digits of up to 60 mm.
SIX_DIGITS = 1e-7


def measured_by_maltby(name):
    """Return mass, balance point height, CG height, moment about the vertical and loft as Maltby printed them, SI."""
    if name == HYBRID:
        table, row = published_data.table("head-hybrid-2009"), 0
    else:
        table = published_data.table("heads-irons-2022-2026")
        model, year = IRONS[name]
        (row,) = np.flatnonzero((table["model"] == model) & (table["year"] == year))
    return {key: float(table[key][row]) for key in table.units if key != "year"}


@pytest.mark.parametrize("name", [*IRONS, HYBRID])
def test_a_measured_head_has_the_published_mass_loft_moment_and_cg_depth(name):
    printed, head = measured_by_maltby(name), club(name)
    assert head.mass == pytest.approx(printed["mass"], rel=1e-12)
    assert head.loft == pytest.approx(printed["loft"], rel=1e-12)
    assert head.iyy == pytest.approx(printed["inertia_vertical"], rel=1e-12)
    # From the point on which the face balances, the CG lies straight behind the face: lower by depth times sin(loft).
    drop = printed["balance_point_height"] - printed["cg_height"]
    assert head.cg_depth * math.sin(head.loft) == pytest.approx(drop, abs=SIX_DIGITS)


@pytest.mark.parametrize("name", IRONS)
def test_the_measured_irons_balance_at_the_published_height_below_one_common_face_centre(name):
    balances = measured_by_maltby(name)["balance_point_height"] / math.cos(club(name).loft)
    assert balances - club(name).cg_height == pytest.approx(0.0258, abs=SIX_DIGITS)


def test_that_face_centre_lies_above_the_mean_balance_point_as_that_of_the_published_7_iron():
    table = published_data.table("heads-irons-2022-2026")
    mean = np.mean(table["balance_point_height"] / np.cos(table["loft"]))
    assert mean - club("7-iron").cg_height == pytest.approx(0.0258, abs=0.5e-4)  # given to 0.1 mm


@pytest.mark.parametrize(
    ("name", "row", "half_face"), [("average-driver-2020", 0, 0.0275), ("average-3-wood-2008", 1, 0.0185)]
)
def test_average_woods_have_the_published_mean_place_of_the_cg(name, row, half_face):
    table, head = published_data.table("heads-means-cg"), club(name)
    height = half_face + head.cg_height
    assert height == pytest.approx(table["height"][row], abs=SIX_DIGITS)
    level = height * math.sin(head.loft) + head.cg_depth * math.cos(head.loft)
    assert level == pytest.approx(table["depth"][row], abs=SIX_DIGITS)


def test_average_drivers_have_the_published_mean_moments():
    table = published_data.table("heads-means-drivers")
    moments = dict(zip(table["year"], table["inertia_vertical"], strict=True))
    for year in (2000, 2020):
        assert club(f"average-driver-{year}").iyy == pytest.approx(moments[year], rel=1e-12)


@pytest.mark.parametrize("name", [name for name in CLUB_NAMES if name not in TOUR_CLUBS])
def test_unpublished_moments_are_those_of_the_published_head_turned_with_the_loft(name):
    head = club(name)
    like = club("7-iron" if head.kind == "iron" else "driver")
    angle = head.loft - like.loft if head.kind == "iron" else 0.0
    turn = np.array([[math.cos(angle), -math.sin(angle), 0], [math.sin(angle), math.cos(angle), 0], [0, 0, 1]])
    tensor = turn @ np.array(like.inertia) @ turn.T
    assert np.array(head.inertia) == pytest.approx(tensor * head.iyy / tensor[1, 1], rel=1e-5)


def test_the_10k_driver_has_two_moments_of_more_than_10000_together_and_keeps_the_rules():
    head = club("ping-g430-max-10k-driver")
    assert (head.iyy + head.izz) * 1e7 > 10_000
    assert head.iyy * 1e7 == pytest.approx(5900)


def test_wedges_go_on_in_steps_of_7_g_with_the_cg_of_measured_blades():
    masses = [club(name).mass for name in ("pitching-wedge", *WEDGES)]
    assert np.diff(masses) == pytest.approx(0.007, rel=1e-9)
    table = published_data.table("heads-irons-2022-2026")
    words = ("MB", "Pro 221", "PRO 241", "Blueprint T", "S1 Forged", "Blade", "Pro S3", "Iron 201")
    blades = np.array([any(word in model for word in words) for model in table["model"]])
    assert blades.sum() == 11
    depth = (table["balance_point_height"] - table["cg_height"]) / np.sin(table["loft"])
    along = table["balance_point_height"] / np.cos(table["loft"])
    for name in WEDGES:
        # Rounded to 0.01 and 0.05 mm.
        assert club(name).cg_depth == pytest.approx(depth[blades].mean(), abs=6e-6)
        assert club(name).cg_height == pytest.approx(along[blades].mean() - 0.0258, abs=26e-6)


RANGES = {  # mass [g], depth [mm], height [mm] and moment about the vertical [g cm2] of heads of each category
    "drivers": ((185, 215), (25, 45), (-5, 6), (2900, 6000)),
    "fairway woods": ((205, 235), (20, 35), (-2, 6), (2000, 3500)),
    "hybrids": ((215, 255), (10, 30), (-2, 5), (2000, 3300)),
    "irons": ((230, 290), (-3, 8), (-6, 3), (1900, 3500)),
    "wedges": ((280, 320), (-3, 8), (-6, 5), (2300, 3300)),
}


@pytest.mark.parametrize("name", CLUB_NAMES)
def test_every_head_is_as_heavy_deep_and_stiff_against_twisting_as_its_kind(name):
    head = club(name)
    values = (head.mass * 1e3, head.cg_depth * 1e3, head.cg_height * 1e3, head.iyy * 1e7)
    assert all(low <= value <= high for value, (low, high) in zip(values, RANGES[head.category], strict=True)), values


def test_built_in_clubs_are_listed_by_kind():
    listed = {category: [name for name in TOUR_CLUBS if club(name).category == category] for category in CATEGORIES}
    assert listed["drivers"] == ["driver"]
    assert listed["fairway woods"] == ["3-wood", "5-wood"]
    assert listed["hybrids"] == ["hybrid"]
    assert listed["wedges"] == ["pitching-wedge"]
    assert {club(name).category for name in WEDGES} == {"wedges"}


def test_depth_and_height_of_the_cg_are_those_of_a_head_turned_upright():
    """At no loft they are the components of the vector itself; turning the head with its loft keeps them."""
    upright = club("driver").replace(loft=0.0)
    assert (upright.cg_depth, upright.cg_height) == (upright.cg_x, -upright.cg_y)
    turn = math.radians(12.0)
    turned = upright.replace(
        loft=turn,
        cg_x=upright.cg_x * math.cos(turn) - upright.cg_y * math.sin(turn),
        cg_y=upright.cg_x * math.sin(turn) + upright.cg_y * math.cos(turn),
    )
    assert turned.cg_depth == pytest.approx(upright.cg_depth, rel=1e-12)
    assert turned.cg_height == pytest.approx(upright.cg_height, rel=1e-12)


def test_a_toe_strike_costs_the_less_ball_speed_the_larger_the_moment_of_inertia():
    lost = []
    for name in ("average-driver-2000", "average-driver-2020", "ping-g430-max-10k-driver"):
        centre, toe = (clubface.impact(name, speed="105 mph", toe=where) for where in ("0 mm", "20 mm"))
        lost.append(1.0 - toe.ball_speed / centre.ball_speed)
    assert lost[0] > lost[1] > lost[2] > 0.0


@pytest.mark.parametrize("name", [name for name in CLUB_NAMES if club(name).category == "drivers"])
def test_a_driver_has_its_best_ball_speed_near_the_height_of_its_cg(name):
    """At one launch angle. It is lower by some mm, where the force, which friction turns up, points through the CG."""
    heights = np.linspace(-0.01, 0.01, 5)
    result = clubface.impact_at_launch(name, launch="12 deg", speed="105 mph", attack="0 deg", high=heights)
    curve = np.polyfit(heights, result.launch.ball_speed, 2)
    assert curve[0] < 0.0
    assert -4e-3 < -curve[1] / (2.0 * curve[0]) - club(name).cg_height < 0.0


@pytest.mark.parametrize("name", CLUB_NAMES)
def test_the_default_model_covers_every_built_in_club(name, recwarn):
    head = club(name)
    struck = clubface.impact(name, speed="85 mph", attack="-3 deg", loft=0.8 * head.loft)
    assert not [str(each.message) for each in recwarn]
    assert 0.8 < struck.ball_speed / clubface.units.to_si(85.0, "mph") < 1.55
    assert 0.0 < struck.launch < head.loft


def test_a_head_is_hit_as_the_tours_hit_its_kind_with_the_loft_that_it_has_more():
    own, strong = club("6-iron"), club("ping-g430-6-iron")
    usual, result = prior_of("tour", own), prior_of("tour", strong)
    assert result.mean["speed"] == usual.mean["speed"]
    assert result.mean["loft"] - usual.mean["loft"] == pytest.approx(strong.loft - own.loft, rel=1e-12)
    assert prior_of("tour", club(HYBRID)).mean["speed"] == prior_of("tour", club("hybrid")).mean["speed"]


@pytest.mark.parametrize("name", CLUB_NAMES)
def test_the_name_of_a_head_says_what_it_is(name):
    family = {"drivers": "driver", "fairway woods": "wood", "hybrids": "hybrid", "irons": "iron", "wedges": "wedge"}
    assert (club_kind(name) or "").endswith(family[club(name).category])


@pytest.mark.parametrize("called", ["SW", "56", "56°"])
def test_shots_with_a_sand_wedge_find_its_head(tmp_path, called):
    file = tmp_path / "shots.csv"
    file.write_text(
        "Club,Club Speed [mph],Attack Angle [deg],Dynamic Loft [deg],Ball Speed [mph],Launch Angle [deg],"
        "Spin Rate [rpm]\n" + f"{called},78,-4,42,81,30,9800\n" * 4
    )
    assert ready_shots(file).club == club("sand-wedge")


def test_a_wedge_of_a_loft_that_no_built_in_one_has_is_asked_for(tmp_path):
    file = tmp_path / "shots.csv"
    file.write_text("Club,Club Speed [mph],Ball Speed [mph],Launch Angle [deg]\n" + "54,78,81,30\n" * 4)
    with pytest.raises(InputError, match="the shots name '54'"):
        ready_shots(file)


def test_wedges_without_published_averages_are_hit_as_pitching_wedges_by_golfers_of_any_skill():
    pitching, sand = club("pitching-wedge"), club("sand-wedge")
    result, usual = prior_of(None, sand), prior_of("wide", pitching)
    assert result.mean["speed"] == usual.mean["speed"]
    assert result.mean["loft"] - usual.mean["loft"] == pytest.approx(sand.loft - pitching.loft, rel=1e-12)
    with pytest.raises(InputError, match='"wide" or a file for sand-wedge'):
        prior_of("tour", sand)
    assert prior_of(None, pitching).name == "tour averages, pitching-wedge"
    with pytest.raises(InputError, match="a file for prototype"):
        prior_of(None, sand.replace(name="prototype"))
