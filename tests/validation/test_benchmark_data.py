"""The benchmark shots: made again from their recipe, true to it, and with the means of the shots they stand for."""

import math
from dataclasses import replace

import numpy as np
import pytest

import clubface
from clubface import units
from clubface.errors import UnknownNameError

pytest.importorskip("pyarrow")

from clubface.validation import benchmark_data, benchmark_recipe
from clubface.validation.benchmark_data import CLUBS, FOLDER, HEADS, recipe

MPH, RPM, DEG = units.parse("1 mph", "speed"), math.pi / 30, math.pi / 180
SHOTS = {"driver": 550, "7-iron": 120}
PUBLISHED = {  # Tables 2 and 4 of the paper on three-dimensional impact models: mean of each measured quantity
    "driver": {"ball_speed": 158.9, "launch": 14.5, "azimuth": 2.19, "backspin": 2980, "sidespin": 490},
    "7-iron": {"ball_speed": 117.0, "launch": 18.9, "azimuth": 2.19, "backspin": 6487, "sidespin": 681},
}
UNIT = {"ball_speed": MPH, "launch": DEG, "azimuth": DEG, "backspin": RPM, "sidespin": RPM}


@pytest.fixture(scope="module", params=CLUBS)
def club(request):
    return request.param


@pytest.fixture(scope="module")
def shots(club):
    return benchmark_data.load(club)


def test_the_recipe_gives_the_shipped_files_bit_for_bit(club):
    import pyarrow.parquet

    for name, columns in benchmark_recipe.tables(recipe(club)).items():
        shipped = pyarrow.parquet.read_table(FOLDER / name)
        assert shipped.column_names == list(columns)
        for heading, values in columns.items():
            assert shipped[heading].to_pylist() == np.asarray(values).tolist(), (name, heading)


def test_there_are_as_many_shots_as_were_published_and_nothing_is_missing(club, shots):
    assert len(shots) == len(shots.truth) == SHOTS[club]
    assert str(shots).startswith(f"{SHOTS[club]} benchmark shots of the {club}")
    assert set(shots.measured.clubs) == {HEADS[club]}
    for table in (shots.measured, shots.truth):
        assert set(table.deliveries) == set(recipe(club).delivery)
        assert all(np.isfinite(each).all() for each in (table.deliveries | table.launches).values())
    assert len(set(shots.player)) == recipe(club).players


def test_mean_launches_are_those_published(club, shots):
    for name, published in PUBLISHED[club].items():
        mean = np.abs(shots.measured.launches[name]).mean() / UNIT[name]
        # The recipe was solved for the first, to 0.5 %; of azimuth and sidespin, whose sign is not published, it takes
        # the mean magnitude and comes within 8 % of both at once.
        allowed = 0.08 if name in ("azimuth", "sidespin") else 0.005
        assert mean == pytest.approx(published, rel=allowed), name


def test_drives_are_as_fast_as_those_published():
    speed = benchmark_data.load("driver").truth.deliveries["speed"] / MPH
    assert 101 <= speed.min() < 105
    assert 115 < speed.max() <= 118


def test_a_true_launch_is_that_of_its_model_with_the_true_delivery(club, shots):
    made_by = recipe(club)
    for name in made_by.mixture:
        own = shots.model == name
        delivery = {key: each[own] for key, each in shots.truth.deliveries.items()}
        result = benchmark_recipe.launches(made_by, name, delivery, shots.restitution_offset[own])
        for key, values in result.items():
            # Half of the last of five decimals, in the unit of the file.
            assert np.abs(values - shots.truth.launches[key][own]).max() <= 0.51e-5 * UNIT[key]


def test_every_model_of_the_mixture_has_its_share_of_the_shots(club, shots):
    made_by = recipe(club)
    share = 1 / len(made_by.mixture)
    for name in made_by.mixture:
        # Four standard deviations of a binomial share.
        allowed = 4 * math.sqrt(share * (1 - share) / made_by.shots)
        assert np.mean(shots.model == name) == pytest.approx(share, abs=allowed)


def test_the_models_of_the_mixture_agree_at_the_mean_delivery(club):
    made_by = recipe(club)
    mean = {name: np.array([spread.mean]) for name, spread in made_by.delivery.items()}
    launches = {name: benchmark_recipe.launches(made_by, name, mean, 0.0) for name in made_by.mixture}
    for name, launch in launches.items():
        # The parameters were solved to this and written with three or four digits.
        assert abs(launch["ball_speed"] - launches["slip"]["ball_speed"])[0] < 0.1 * MPH, name
        assert abs(launch["backspin"] - launches["slip"]["backspin"])[0] < 10 * RPM, name


@pytest.mark.parametrize("name", ["volumetric", "rings", "area"])
def test_damping_gives_the_restitution_it_was_made_for(name):
    speed, wanted = np.array([30.0, 50.0]), np.array([0.75, 0.85])
    damping = benchmark_recipe.damping_of(wanted, speed)
    # A central impact: the law is that of the normal force, so that nothing else may move.
    launch = clubface.impact(
        "7-iron", speed=speed, loft=0.0, static_loft=0.0, cg_y=0.0, cg_z=0.0, ixy=0.0, ixz=0.0, iyz=0.0,
        model=name, parameters={"damping": damping}, accuracy=1e-9,
    )  # fmt: skip
    result = (launch.velocity_x - launch.club_velocity_x) / speed
    assert result == pytest.approx(wanted, abs=1e-6)


def test_the_shaft_moves_mass_centre_and_inertia_as_two_bodies_have_them(club):
    made_by, head = recipe(club), clubface.club(HEADS[club])
    both = benchmark_recipe.with_shaft(made_by)
    assert both.mass == pytest.approx(head.mass + made_by.shaft_mass, rel=1e-15)
    shift = np.array([getattr(head, f"cg_{x}") - getattr(both, f"cg_{x}") for x in "xyz"])
    # First moments about the head's CG, then Steiner for each body about the common one.
    assert both.mass * shift == pytest.approx(made_by.shaft_mass * made_by.hosel, rel=1e-9)

    def tensor(of_club):
        names = ["xx xy xz", "xy yy yz", "xz yz zz"]
        return np.array([[getattr(of_club, f"i{each}") for each in row.split()] for row in names])

    def steiner(mass, arm):
        return mass * (arm @ arm * np.eye(3) - np.outer(arm, arm))

    expected = tensor(head) + steiner(head.mass, -shift) + steiner(made_by.shaft_mass, made_by.hosel - shift)
    assert tensor(both) == pytest.approx(expected, rel=1e-9)


def test_capture_without_noise_of_a_straight_steady_head_is_the_truth(club):
    made_by = recipe(club)._replace(
        arc_radius=1e7, position_noise=0.0, attitude_noise=0.0, time_noise=0.0,
        growth=dict.fromkeys(("closure", "pitch_rate", "lie_rate"), (0.0, 0.0)),
    )  # fmt: skip
    random = np.random.default_rng(1)
    truth = benchmark_recipe.deliveries(made_by, random)
    seen = benchmark_recipe.captured(made_by, truth, random)
    for name, values in truth.items():
        # 1e-7: what an arc of ten thousand kilometres still bends within 4 ms, and rounding.
        assert seen[name] == pytest.approx(values, abs=1e-7), name


def test_straight_lines_through_an_arc_miss_as_much_as_its_curvature_says(club):
    made_by = recipe(club)._replace(
        position_noise=0.0, attitude_noise=0.0, time_noise=0.0,
        growth=dict.fromkeys(("closure", "pitch_rate", "lie_rate"), (1000.0, 0.0)),
    )  # fmt: skip
    random = np.random.default_rng(1)
    truth = benchmark_recipe.deliveries(made_by, random)
    seen = benchmark_recipe.captured(made_by, truth, random)
    # Through values at -t and -t - h, a line misses a parabola at 0 by half its second derivative times t (t + h),
    # which is evenly spread in t; the mean of t (t + h) over a frame is 5/6 h^2.
    mean = 0.5 * 5 / 6 * made_by.frame**2
    closing = truth["face"] - seen["face"]
    assert closing.mean() == pytest.approx(-1000.0 * mean, rel=0.1)
    inward = np.mean(truth["speed"]) ** 2 / made_by.arc_radius
    rise = inward * math.sin(made_by.swing_plane) * mean
    # The head is really higher than the line says, so that the ball is believed too high on the face: 10 % for the
    # few shots of a sample, 10 % for the loft by which the face leans back.
    assert (seen["high"] - truth["high"]).mean() == pytest.approx(rise, rel=0.2)
    assert (seen["toe"] - truth["toe"]).mean() < 0.0
    # Velocity turns by 1.2 degrees in half a frame; its straight line leaves the second order of that, 0.02 degrees.
    for name in ("attack", "path"):
        assert np.abs(seen[name] - truth[name]).max() < 0.1 * DEG


def test_a_few_tenths_of_a_degree_are_lost_in_capture(club, shots):
    for name in ("face", "loft"):
        error = shots.measured.deliveries[name] - shots.truth.deliveries[name]
        assert 0.1 < error.std() / DEG < 0.4


def test_the_monitor_errs_by_fifty_rpm_and_a_fifth_of_a_degree(club, shots):
    for name, mean in {"launch": 0.2, "azimuth": 0.2, "backspin": 50, "sidespin": 50}.items():
        error = (shots.measured.launches[name] - shots.truth.launches[name]) / UNIT[name]
        # Five standard errors of a mean absolute error of 120 or 550 normal deviates.
        assert np.abs(error).mean() == pytest.approx(mean, rel=5 * 0.76 / math.sqrt(len(shots)))


def test_an_unknown_club_is_reported_with_the_known_ones():
    with pytest.raises(UnknownNameError, match="driver, 7-iron"):
        benchmark_data.load("putter")


def test_sets_of_shots_are_compared_as_themselves_and_not_by_their_arrays():
    one = benchmark_data.load("driver")
    same = one
    assert one == same
    assert (one == replace(one)) is False
    assert len({one, replace(one)}) == 2
