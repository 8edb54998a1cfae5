"""Synthetic swings are what they say they are: only then can they judge an estimator."""

import math

import numpy as np
import pytest

from captures import swings, world_cameras
from clubface.capture.reduction import QUANTITIES, gap
from clubface.capture.rotations import logarithm
from clubface.capture.synthetic.laboratory import Cameras, synthesize
from clubface.capture.synthetic.synthetic_swing import random_swing
from clubface.shots.reading import read_shots


@pytest.mark.parametrize("club", ["driver", "7-iron"])
def test_the_true_delivery_is_that_of_the_path(club):
    """Velocity and rates from one-sided differences of the path itself, which has no closed-form derivative in it."""
    for swing in swings(5, club=club):
        h = 1e-5
        position, rotation = swing.head(np.array([-2 * h, -h, 0.0]))
        velocity = (3 * position[2] - 4 * position[1] + position[0]) / (2 * h)
        turned = [logarithm(rotation[place] @ rotation[2].T) for place in (0, 1)]
        spin = (turned[0] - 4 * turned[1]) / (2 * h)
        # Second order: h^2/3 of the third derivative, 1e-10/3 of 5e4 m/s3 or rad/s3; rounding 1e-16/h.
        speed, truth = np.linalg.norm(velocity), swing.truth
        assert speed == pytest.approx(truth["speed"], abs=1e-5)
        assert math.asin(velocity[1] / speed) == pytest.approx(truth["attack"], abs=1e-6)
        assert math.atan2(velocity[2], velocity[0]) == pytest.approx(truth["path"], abs=1e-6)
        rates = [-truth["lie_rate"], truth["closure"], truth["pitch_rate"]]
        assert spin == pytest.approx(rates, abs=2e-5)


def test_the_face_first_touches_the_ball_at_time_zero():
    for swing in swings(5):
        times = np.linspace(-0.02, 0.0, 400)
        position, rotation = swing.head(times)
        ahead, local = gap(position, rotation, swing.rest, swing.club, swing.ball.radius)
        assert ahead[-1] == pytest.approx(0.0, abs=1e-15)
        assert (np.diff(ahead) < 0).all()
        assert local[-1, 2] == pytest.approx(swing.truth["toe"], rel=0.1, abs=1e-3)


def test_a_swing_has_the_magnitudes_of_a_golfers():
    closing = [math.degrees(each.truth["closure"]) / 720 for each in swings(60)]
    # Caldwell and McPhee: the face turns 3-4 degrees between frames of 720 Hz.
    assert 3.0 < np.mean(closing) < 4.0
    assert 2.6 < min(closing) < max(closing) < 4.4
    for swing in swings(10):
        h = 1e-3
        position, _ = swing.head(np.array([-2 * h, -h, 0.0]))
        bending = np.linalg.norm(position[2] - 2 * position[1] + position[0]) / h**2
        # The path of a head bends with a radius of 1.3 to 2 m: the club's length and part of the arm's.
        assert 1.2 < swing.truth["speed"] ** 2 / bending < 2.2


def test_impact_slows_the_head_and_keeps_momentum():
    swing = random_swing(4)
    h = 1e-6
    before, after = (swing.head(np.array([t, t + h]))[0] for t in (-h, 0.6e-3))
    bare = swing.chain.pose(np.array([0.6e-3, 0.6e-3 + h]))[0] @ swing.turned.T
    change = (np.diff(after, axis=0) - np.diff(bare, axis=0))[0] / h
    ball = np.diff(swing.ball_centre(np.array([0.6e-3, 0.6e-3 + h])), axis=0)[0] / h
    fallen = np.array([0.0, 9.80665 * 0.6e-3, 0.0])
    # Differences over 1e-6 s of positions of 1 m: rounding 2e-10/1e-6 = 2e-4 m/s at worst.
    assert swing.club.mass * change + swing.ball.mass * (ball + fallen) == pytest.approx(np.zeros(3), abs=1e-4)
    assert np.linalg.norm(np.diff(before, axis=0)) / h == pytest.approx(swing.truth["speed"], abs=0.01)


def test_a_left_hander_is_the_mirror_image():
    right, left = (random_swing(9, hand=hand) for hand in ("right", "left"))
    for name in QUANTITIES:
        assert left.truth[name] == (-1 if name in ("path", "face") else 1) * right.truth[name]
    times = np.linspace(-0.02, 0.02, 7)
    mirrored = right.points([[0.01, 0.02, 0.03]], times) * [1, 1, -1]
    assert left.points([[0.01, 0.02, 0.03]], times) == pytest.approx(mirrored, abs=1e-15)
    assert left.ball_centre(times) == pytest.approx(right.ball_centre(times) * [1, 1, -1], abs=1e-15)
    assert left.launch["azimuth"] == -right.launch["azimuth"]


def test_cameras_measure_in_their_own_axes_with_noise_and_gaps():
    swing = random_swing(2)
    plain = world_cameras().record(swing, 5)
    turned = Cameras(target="-y", up="+z", origin=(1.0, 2.0, 3.0)).record(swing, 5)
    x, y, z = plain.positions[10, 0]
    # Target along -y and up along +z leave the right of the target line along x cross y = (-y) cross z = -x.
    assert turned.positions[10, 0] == pytest.approx([1.0 - z, 2.0 - x, 3.0 + y], abs=1e-15)
    noisy = world_cameras(noise=3e-4, gaps=0.1).record(swing, 5)
    scatter = (noisy.positions - plain.positions)[np.isfinite(noisy.positions)]
    # 203 frames of six markers: 3000 values, whose standard deviation is known to 1.3%.
    assert np.std(scatter) == pytest.approx(3e-4, rel=0.05)
    hidden = np.isnan(noisy.positions[:, :5, 0]).mean()
    assert 0.04 < hidden < 0.2
    assert not np.isnan(noisy.positions[:, 5]).any()


def test_a_folder_of_swings_holds_all_that_is_needed(tmp_path):
    files = synthesize(tmp_path / "swings", 3, club="7-iron", hand="left", cameras=Cameras(noise=1e-4))
    again = synthesize(tmp_path / "again", 3, club="7-iron", hand="left", cameras=Cameras(noise=1e-4))
    assert [each.name for each in files] == [
        "swing-001.c3d", "swing-002.c3d", "swing-003.c3d", "calibration.c3d", "markers.toml", "truth.csv",
    ]  # fmt: skip
    assert all(a.read_bytes() == b.read_bytes() for a, b in zip(files, again, strict=True))
    table = read_shots(files[-1])
    assert len(table) == 3
    assert set(table.hand) == {"left"}
