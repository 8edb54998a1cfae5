"""From path and ball to the delivery: worked by hand, and its covariance against its scatter."""

import math

import numpy as np
import pytest

import clubface
from captures import CLEAN_CAMERAS, random_swing
from clubface.capture.ball_flight import flight, resting_places
from clubface.capture.estimators import TIME, Path
from clubface.capture.reduction import QUANTITIES, Inputs, deliver, with_covariance
from clubface.capture.rotations import about

IRON = clubface.club("7-iron").replace(loft=0.0, cg_x="10 mm", cg_y="0 mm", cg_z="0 mm")
"""An upright plane, 10 mm in front of the CG."""
RADIUS = 0.02


def inputs(velocity=(40.0, 0.0, 0.0), spin=(0.0, 0.0, 0.0), ball=(0.03, 0.0, 0.0), club=(0.0,) * 6):
    """A head at the origin at time zero that moves and turns steadily."""
    rate = np.array([*velocity, *spin]) * TIME
    return Inputs(np.array([np.zeros(6), rate]), rate[None], np.array(ball), np.array(club))


def delivered(**given):
    values, time = deliver(inputs(**given), np.eye(3), IRON, RADIUS)
    return dict(zip(QUANTITIES, values.tolist(), strict=True)), float(time)


def test_an_upright_face_meets_a_ball_ahead_when_it_has_gone_the_way_between():
    values, time = delivered(ball=(0.07, 0.004, -0.006))
    assert time == pytest.approx((0.07 - 0.01 - RADIUS) / 40.0)
    assert (values["toe"], values["high"]) == pytest.approx((-0.006, 0.004))
    assert values["speed"] == pytest.approx(40.0)
    assert values["attack"] == values["path"] == values["loft"] == values["face"] == values["lie"] == 0.0


def test_rates_and_angles_have_the_signs_of_the_conventions():
    values, _ = delivered(velocity=(40.0, 3.0, 4.0), spin=(-2.0, 30.0, 5.0))
    assert values["speed"] == pytest.approx(math.sqrt(1600 + 9 + 16))
    assert values["attack"] == pytest.approx(math.atan2(3.0, math.hypot(40.0, 4.0)))
    assert values["path"] == pytest.approx(math.atan2(4.0, 40.0))
    assert (values["lie_rate"], values["closure"], values["pitch_rate"]) == pytest.approx((2.0, 30.0, 5.0), abs=1e-9)
    # Closing turns the face to the left, and the ball is met later.
    later, _ = delivered(spin=(0.0, 30.0, 0.0), ball=(0.07, 0.0, 0.0))
    assert later["face"] == pytest.approx(-30.0 * 0.001, rel=0.01)


def test_a_club_shifted_on_its_markers_has_the_velocity_of_its_own_cg():
    values, _ = delivered(spin=(0.0, 30.0, 0.0), club=(0.0, 0.0, 0.002, 0.0, 0.0, 0.0))
    # A point 2 mm towards the toe of a head that closes with 30 rad/s is 0.06 m/s faster; the ball lies 2 mm heelwards.
    assert values["speed"] == pytest.approx(40.06, abs=1e-12)
    assert values["toe"] == pytest.approx(-0.002, abs=1e-12)
    # Turned about its own heel-toe axis, it has that much more loft whichever way it looks.
    open_face = about(1, -0.3)
    values, _ = deliver(inputs(club=(0.0, 0.0, 0.0, 0.0, 0.0, 0.01)), open_face, IRON, RADIUS)
    assert values[QUANTITIES.index("loft")] == pytest.approx(0.01, abs=1e-12)
    assert values[QUANTITIES.index("face")] == pytest.approx(0.3, abs=1e-12)


def test_the_stated_covariance_is_that_of_the_scatter():
    club = clubface.club("driver")
    attitude = np.array(
        [[0.97, -0.17, 0.1], [0.18, 0.98, -0.05], [-0.09, 0.07, 0.99]],
    )
    left, _, right = np.linalg.svd(attitude)
    attitude = left @ right
    rate = np.array([[45.0, 2.0, 3.0, 1.0, 40.0, 10.0], [10.0, 30.0, -5.0, 20.0, 10.0, -30.0]]) * [[TIME], [TIME**2]]
    centre = attitude @ np.array(club.cg)
    ball = centre + attitude @ np.array([math.cos(club.loft), math.sin(club.loft), 0.0]) * 0.0213
    random = np.random.default_rng(7)
    roots = [random.normal(size=(n, n)) * size for n, size in ((30, 1e-4), (3, 2e-4), (6, 2e-4))]
    blocks = [root @ root.T for root in roots]
    position = np.concatenate([np.zeros((1, 6)), rate])
    path = Path(position, rate, blocks[0], 1.0)
    stated = with_covariance(
        path, ball, attitude, club, 0.0213, ball_covariance=blocks[1], club_covariance=blocks[2]
    ).covariance
    drawn = [random.normal(size=(20000, len(root))) @ root.T for root in roots]
    many = Inputs(
        position + drawn[0][:, :18].reshape(-1, 3, 6),
        rate + drawn[0][:, 18:].reshape(-1, 2, 6),
        ball + drawn[1],
        drawn[2],
    )
    values, _ = deliver(many, attitude, club, 0.0213)
    # 20000 draws give a standard deviation to 0.5%, correlations to 0.7%; the rest is curvature, of 1e-3 of the values.
    scale = np.sqrt(np.diag(stated))
    assert np.std(values, axis=0) == pytest.approx(scale, rel=0.025)
    assert np.corrcoef(values.T) == pytest.approx(stated / np.outer(scale, scale), abs=0.03)


def test_where_the_ball_rests_is_known_better_the_longer_it_is_seen():
    random = np.random.default_rng(3)
    seen = np.array([0.1, 0.2, 0.3]) + 3e-4 * random.normal(size=(400, 3))
    seen[300:] += np.linspace(0.05, 6.0, 100)[:, None]
    result = resting_places(seen, 720.0)
    assert (len(result), result[0].departure, result[0].span) == (1, 300, (0, 299))
    assert result[0].frames == 180 + 1  # a quarter of a second
    # A quartile of 400 steps: to some 5%.
    assert result[0].noise == pytest.approx(3e-4, rel=0.2)
    assert result[0].centre == pytest.approx([0.1, 0.2, 0.3], abs=4 * 3e-4 / math.sqrt(180))
    assert resting_places(np.full((5, 3), np.nan), 720.0) == []


def test_the_flight_of_a_ball_under_gravity_is_fitted_exactly():
    times = np.arange(60) / 720.0
    rest = np.array([0.0, 0.02, 0.0])
    velocity = np.array([60.0, 12.0, -3.0])
    gone = np.maximum(times - 0.0302, 0.0)[:, None]
    seen = rest + velocity * gone - [0.0, 0.5 * 9.80665, 0.0] * gone**2
    [ball] = resting_places(seen, 720.0)
    result = flight(seen, times, ball, 0.0302)
    assert result.velocity == pytest.approx(velocity, abs=1e-9)
    assert result.start == pytest.approx(0.0302, abs=1e-9)
    assert flight(seen[:22], times[:22], ball, 0.0302) is None


def test_an_uncertain_place_of_the_ball_is_an_uncertain_impact_point():
    from dataclasses import replace

    from clubface.capture.setup import prepare
    from clubface.capture.swing import capture
    from clubface.capture.synthetic.laboratory import positions_map

    swing = random_swing(4)
    recording = CLEAN_CAMERAS.record(swing, 1)
    mapping = replace(
        positions_map(swing.club, CLEAN_CAMERAS), ball=None, ball_position=tuple(recording.positions[0, 5])
    )
    sure = capture(recording, prepare(mapping, swing.club))
    unsure = capture(recording, prepare(replace(mapping, accuracy=3e-3), swing.club))
    assert sure.uncertainty["toe"] < 1e-5
    # The ball by 3 mm; the cluster of five, each known to 3 mm, adds to it.
    assert 3e-3 < unsure.uncertainty["toe"] < 5e-3
    assert unsure.delivery.toe == sure.delivery.toe
