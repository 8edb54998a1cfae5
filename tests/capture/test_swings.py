"""Deliveries read from synthetic swings, whose truth is known, against what the page on motion capture promises."""

import math
import warnings

import numpy as np
import pytest

import clubface
from captures import SHOWN, captured, deviations, errors, swings, world_cameras
from clubface.capture.reduction import QUANTITIES
from clubface.capture.swing import read_swing, read_swings
from clubface.capture.synthetic.laboratory import Cameras, calibration_map, synthesize
from clubface.capture.synthetic.synthetic_swing import random_swing
from clubface.errors import CaptureWarning, InputError

ALLOWED = {"attack": 0.05, "path": 0.05, "loft": 0.05, "face": 0.05, "lie": 0.05, "toe": 0.3, "high": 0.3}
"""Degrees and mm; the speed may be off by 0.05%."""


@pytest.mark.parametrize(("club", "hand"), [("driver", "right"), ("driver", "left"), ("7-iron", "right")])
def test_without_noise_the_delivery_is_read_to_a_twentieth_of_a_degree(club, hand):
    for swing in swings(12, club=club, hand=hand):
        result = captured(swing, Cameras())
        off = dict(zip(QUANTITIES, np.abs(errors(result, swing)), strict=True))
        assert off["speed"] < 5e-4 * swing.truth["speed"]
        for name, allowed in ALLOWED.items():
            assert off[name] < allowed, name
        # Rates of 40 rad/s to 0.25%: the markers' path gives them as well as it gives velocities.
        assert max(off["closure"], off["pitch_rate"], off["lie_rate"]) < 0.1
        assert abs(result.time - 0.25) < 2 / 720
        assert result.notes == ()


def test_linear_extrapolation_errs_by_the_bend_of_the_path_in_a_frame():
    result = [captured(swing, Cameras(), estimator="linear") for swing in swings(12)]
    off = np.array([errors(each, swing) for each, swing in zip(result, swings(12), strict=True)])
    high = off[:, QUANTITIES.index("high")]
    # A path that bends with a = v^2/r = 1500 m/s2 leaves its tangent by a/2 (1/720 s)^2 = 1.4 mm within a frame, and
    # the slope from the frame before is half a frame old: up to twice that again.
    assert 0.5 < np.abs(high).max() < 5.0
    assert np.abs(off[:, 0]).mean() > 10 * 5e-4


def test_the_stated_uncertainties_hold_the_truth_as_often_as_they_say():
    made = [random_swing(1000 + seed) for seed in range(60)]
    scaled, flown = [], []
    for seed, swing in enumerate(made):
        result = captured(swing, Cameras(noise=3e-4), seed=seed)
        scaled.append(errors(result, swing) / deviations(result))
        off = {name: value - swing.launch[name] for name, value in result.launch.items()}
        flown.append([off[name] / deviation for name, deviation in result.launch_uncertainty.items()])
    inside = np.mean(np.abs(scaled) < 1.959964)
    # 660 intervals, of which a swing's eleven hang together: as if of 60 x 4, whose rate scatters by 1.4%.
    assert 0.91 < inside < 0.985
    # No quantity by itself is off by a factor: 60 values give a root mean square to 9%, four times that is allowed.
    assert np.sqrt(np.mean(np.square(scaled), axis=0)) == pytest.approx(np.full(11, 0.95), abs=0.36)
    # Nor is one of the ball's flight: speed, launch and azimuth.
    assert np.sqrt(np.mean(np.square(flown), axis=0)) == pytest.approx(np.ones(3), abs=0.36)


def test_laboratory_axes_do_not_change_the_delivery():
    swing = random_swing(3)
    plain = captured(swing, world_cameras())
    for target, up in (("+y", "+z"), ("-x", "+y"), ("+z", "-x"), ("-y", "-z")):
        turned = captured(swing, Cameras(target=target, up=up))
        for name in QUANTITIES:
            # The file of positions is the same but for its rounding, 1e-16, which the fit of 1 um markers magnifies.
            assert getattr(turned.delivery, name) == pytest.approx(getattr(plain.delivery, name), abs=1e-6)


def test_a_left_hander_is_read_as_the_mirror_image():
    right, left = (captured(random_swing(6, hand=hand), world_cameras()) for hand in ("right", "left"))
    for row, name in enumerate(QUANTITIES):
        sign = -1 if name in ("path", "face") else 1
        assert getattr(left.delivery, name) == pytest.approx(sign * getattr(right.delivery, name), abs=1e-9)
        assert left.uncertainty[name] == pytest.approx(right.uncertainty[name], rel=1e-6)
        cross = right.covariance[row, 0] * sign
        assert left.covariance[row, 0] == pytest.approx(cross, rel=1e-5, abs=1e-15)
    assert left.launch["azimuth"] == pytest.approx(-right.launch["azimuth"], abs=1e-9)


def test_a_target_line_of_two_markers_gives_the_axes_as_well():
    from dataclasses import replace

    from clubface.capture.setup import prepare
    from clubface.capture.swing import capture
    from clubface.capture.synthetic.laboratory import positions_map

    swing, cameras = random_swing(3), Cameras()
    recording = cameras.record(swing, 1)
    line = np.array([[0.35, -0.2, 0.0], [0.35 + 3 * math.sin(0.02), -0.2 + 3 * math.cos(0.02), 0.1]])
    shown = np.broadcast_to(line, (len(recording.positions), 2, 3))
    recording = replace(
        recording,
        labels=(*recording.labels, "NEAR", "FAR"),
        positions=np.concatenate([recording.positions, shown], axis=1),
    )
    mapping = positions_map(swing.club, cameras)
    plain = capture(recording, prepare(mapping, swing.club))
    result = capture(recording, prepare(replace(mapping, target=("NEAR", "FAR")), swing.club))
    # The line points 0.02 rad to the right of +y (right of +y with z up is +x), so all lies 0.02 rad further left.
    assert result.delivery.path == pytest.approx(plain.delivery.path - 0.02, abs=1e-9)
    assert result.delivery.face == pytest.approx(plain.delivery.face - 0.02, abs=1e-9)
    assert result.delivery.attack == pytest.approx(plain.delivery.attack, abs=1e-9)


def test_a_calibration_places_the_cluster_as_well_as_given_positions(tmp_path):
    files = synthesize(tmp_path, 4, cameras=Cameras(noise=1e-4))
    with warnings.catch_warnings():
        warnings.simplefilter("error", CaptureWarning)
        result = read_swings(files[:4], tmp_path / "markers.toml", "driver")
    truth = clubface.read_shots(tmp_path / "truth.csv") if hasattr(clubface, "read_shots") else None
    if truth is None:
        from clubface.shots.reading import read_shots

        truth = read_shots(tmp_path / "truth.csv")
    for name in QUANTITIES:
        off = (result.shots.deliveries[name] - truth.deliveries[name]) / result.uncertainty.deliveries[name]
        assert np.abs(off).max() < 4.0, name
    for name in ("ball_speed", "launch", "azimuth"):
        assert result.shots.launches[name] == pytest.approx(truth.launches[name], rel=2e-3, abs=2e-3)


def test_a_short_calibration_is_less_certain_and_says_so():
    """With one frame of calibration its noise is in every swing alike; the stated uncertainty holds it."""
    from clubface.capture.calibration import calibrated
    from clubface.capture.setup import Setup, prepare
    from clubface.capture.swing import capture
    from clubface.capture.synthetic.laboratory import positions_map

    swing = random_swing(8)
    cameras = Cameras(noise=1e-6, calibration_frames=1)
    rough = Cameras(noise=5e-4, calibration_frames=1)
    recording = cameras.record(swing, 1)
    ready = prepare(positions_map(swing.club, cameras), swing.club)
    from dataclasses import replace

    mapping = replace(calibration_map(swing.club, cameras), noise=5e-4)
    scaled = []
    for seed in range(60):
        placed = calibrated(mapping, swing.club, rough.calibrate(swing.club, seed), ready.turn(recording))
        result = capture(recording, replace(ready, registration=placed))
        scaled.append(errors(result, swing) / deviations(result))
    assert isinstance(ready, Setup)
    angles = [QUANTITIES.index(name) for name in ("loft", "face", "lie", "toe", "high")]
    # 60 values give a root mean square to 9%; three times that is allowed.
    assert np.sqrt(np.mean(np.square(scaled), axis=0))[angles] == pytest.approx(np.ones(5), abs=0.27)


def test_gaps_cost_certainty_and_nothing_else():
    swing = random_swing(5)
    whole = captured(swing, Cameras(noise=3e-4))
    gappy = captured(swing, Cameras(noise=3e-4, gaps=0.25))
    assert gappy.uncertainty["loft"] > whole.uncertainty["loft"]
    assert np.abs(errors(gappy, swing) / deviations(gappy)).max() < 4.0


def test_the_flight_of_the_ball_is_read_with_the_delivery():
    swing = random_swing(5)
    result = captured(swing, Cameras())
    for name in ("ball_speed", "launch", "azimuth"):
        assert result.launch[name] == pytest.approx(swing.launch[name], rel=1e-6, abs=1e-7)
    noisy = captured(swing, Cameras(noise=3e-4))
    for name, deviation in noisy.launch_uncertainty.items():
        assert abs(noisy.launch[name] - swing.launch[name]) < 4 * deviation


def test_a_captured_delivery_goes_straight_into_an_impact(tmp_path):
    files = synthesize(tmp_path, 1)
    result = read_swing(files[0], tmp_path / "markers.toml", "driver")
    launch = clubface.impact("driver", result.delivery)
    truth = random_swing(np.random.default_rng([1, 1, 0])).launch
    assert float(launch.ball_speed) == pytest.approx(truth["ball_speed"], rel=1e-3)
    many = clubface.impact("driver", result.sample(500))
    # Without noise 0.05% of speed is 0.04 m/s of the ball's.
    assert np.std(many.ball_speed) < 0.05
    assert result.get("speed", "mph")[0] == pytest.approx(result.delivery.speed / 0.44704)
    assert result.get("speed", "mph")[1] == pytest.approx(result.uncertainty["speed"] / 0.44704)
    assert SHOWN["speed"] == 1.0


def test_the_error_bars_of_a_delivery_are_the_quantiles_of_its_normal_distribution():
    result = captured(random_swing(3), Cameras(noise=3e-4))
    variances = np.diag(result.covariance)
    for place, name in enumerate(QUANTITIES):
        value, deviation = getattr(result.delivery, name), result.uncertainty[name]
        assert deviation**2 == pytest.approx(variances[place], rel=1e-12)
        # 0.975 and 0.995 of a standard normal lie below 1.959964 and 2.575829 (tabulated to seven digits).
        assert result.interval(name) == pytest.approx(
            (value - 1.959964 * deviation, value + 1.959964 * deviation), abs=1e-6 * deviation
        )
        assert result.interval(name, 0.99)[1] - value == pytest.approx(2.575829 * deviation, rel=1e-6)
    drawn = result.sample(4000, seed=2)
    for name in QUANTITIES:
        # 4000 draws tell a deviation to 1.1% and a mean to 1.6% of it; four times that is allowed.
        assert np.std(drawn[name]) == pytest.approx(result.uncertainty[name], rel=0.045)
        off = np.mean(drawn[name]) - getattr(result.delivery, name)
        assert abs(off) < 0.065 * result.uncertainty[name]
    for wrong in ({"count": 0}, {"count": -1}, {"count": 2.5}, {"count": True}, {"count": "5"}, {"count": 10**14}):
        with pytest.raises(InputError, match="count"):
            result.sample(**wrong)
    for seed in (-1, 1.5, "a", None):
        with pytest.raises(InputError, match="seed"):
            result.sample(3, seed=seed)
    with pytest.raises(InputError, match="free memory"):
        result.sample(2**32)
