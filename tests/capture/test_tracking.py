"""Poses of a cluster of markers: exact, of the stated covariance, and through exchanged, stray and hidden markers."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st
from scipy.signal import butter, filtfilt, freqz

from clubface.capture.rotations import (
    degrees_of_freedom,
    exponential,
    fit_poses,
    left_jacobian,
    logarithm,
    pose_information,
)
from clubface.capture.tracking import look_alikes, track
from clubface.errors import FileError

SHAPE = np.array([[-25, 32, -20], [-30, 34, 25], [-75, 28, 0], [-35, 8, 52], [-12, 40, -48]]) * 1e-3
NAMES = ("A", "B", "C", "D", "E")


def moving(frames=80, noise=0.0, seed=1):
    """Markers of a head that turns and flies, and its true poses."""
    random = np.random.default_rng(seed)
    steps = np.linspace(0.0, 1.0, frames)[:, None]
    rotation = exponential(steps * [0.4, 2.0, 1.0])
    position = steps * [2.0, 0.3, -0.5] + [1.0, 2.0, 3.0]
    seen = position[:, None] + np.einsum("kij,mj->kmi", rotation, SHAPE)
    return seen + noise * random.normal(size=seen.shape), position, rotation


@settings(max_examples=40)
@given(
    st.tuples(*[st.floats(-1.7, 1.7)] * 3), st.tuples(*[st.floats(-5, 5)] * 3), st.integers(3, 5), st.integers(0, 99)
)
def test_the_pose_of_exact_markers_is_exact(vector, place, count, seed):
    random = np.random.default_rng(seed)
    chosen = np.sort(random.permutation(5)[:count])
    observed = np.full((1, 5, 3), np.nan)
    observed[0, chosen] = SHAPE[chosen] @ exponential(vector).T + place
    weights = random.uniform(0.2, 3.0, 5)
    result = fit_poses(SHAPE, observed, weights)
    # Rounding of positions of 5 m, 1e-15, over a cluster of 0.05 m.
    assert result.rotation[0] == pytest.approx(exponential(vector), abs=1e-12)
    assert result.position[0] == pytest.approx(np.array(place), abs=1e-12)
    assert np.nanmax(np.abs(result.residuals)) < 1e-13


def test_weights_pull_the_pose_to_the_surer_markers():
    seen, position, _ = moving(1)
    seen[0, 2] += [0.0, 0.005, 0.0]
    even = fit_poses(SHAPE, seen)
    wary = fit_poses(SHAPE, seen, [1, 1, 1e-9, 1, 1])
    assert np.linalg.norm(wary.position[0] - position[0]) < 1e-8 < np.linalg.norm(even.position[0] - position[0])


def test_the_stated_covariance_of_a_pose_is_that_of_its_scatter():
    seen, position, rotation = moving(1)
    random = np.random.default_rng(4)
    noise = 3e-4
    many = fit_poses(SHAPE, seen + noise * random.normal(size=(6000, 5, 3)))
    turned = logarithm(many.rotation @ rotation[0].T)
    drawn = np.concatenate([many.position - position[0], turned], 1)
    stated = noise**2 * np.linalg.inv(pose_information(SHAPE, rotation, np.ones((1, 5)))[0])
    # 6000 draws give a standard deviation to 0.9%; four times that. Correlations to 1.3%.
    assert np.std(drawn, axis=0) == pytest.approx(np.sqrt(np.diag(stated)), rel=0.037)
    scale = np.sqrt(np.diag(stated))
    assert np.corrcoef(drawn.T) == pytest.approx(stated / np.outer(scale, scale), abs=0.055)


def test_markers_on_a_line_or_too_few_give_no_pose():
    line = np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 0.03], [0.0, 0.0, -0.04]])
    assert np.isnan(fit_poses(line, line[None]).rotation).all()
    two = SHAPE[None].copy()
    two[0, 2:] = np.nan
    assert np.isnan(fit_poses(SHAPE, two).position).all()


def test_the_noise_of_the_markers_is_estimated_from_what_is_left_over():
    result = track(SHAPE, moving(300, 3e-4)[0], NAMES, "x")
    noise, freedom = result.noise(np.ones(300, dtype=bool))
    assert freedom == 300 * 9 - 9
    # 2691 degrees of freedom: to 1.4%.
    assert noise == pytest.approx(3e-4, rel=0.05)


def test_steps_of_white_noise_are_correlated_by_minus_a_half_and_those_of_filtered_noise_as_its_spectrum_has_it():
    """The correlation of the steps is (2 r1 - 1 - r2) / (2 (1 - r1)) with that of the noise, from the filter's gain."""
    frames, every = 1200, np.ones(1200, dtype=bool)
    noise = 3e-4 * np.random.default_rng(7).normal(size=(frames, 5, 3))
    exact, _, rotation = moving(frames)
    drift = 2e-3 * np.sin(np.linspace(0.0, 9.0, frames))[:, None, None] * np.random.default_rng(8).normal(size=(5, 3))
    for slow in (0.0, drift):
        seen = exact + np.einsum("kij,kmj->kmi", rotation, noise + slow)
        seen[::7, 1] = np.nan
        correlation, count = track(SHAPE, seen, NAMES, "x").step_correlation(every)
        # Four standard errors of independent numbers; the fitted pose ties 6 of 15.
        assert correlation == pytest.approx(-0.5, abs=4.0 / np.sqrt(count * 9 / 15))
    for cut in (0.2, 0.4):
        b, a = butter(2, cut)
        w, gain = freqz(b, a, 4096)
        power = np.abs(gain) ** 4  # to and fro
        r1, r2 = (float((power * np.cos(lag * w)).sum() / power.sum()) for lag in (1, 2))
        seen = exact + np.einsum("kij,kmj->kmi", rotation, filtfilt(b, a, noise, axis=0))
        correlation, count = track(SHAPE, seen, NAMES, "x").step_correlation(every)
        assert correlation == pytest.approx((2 * r1 - 1 - r2) / (2 * (1 - r1)), abs=4.0 / np.sqrt(count * 9 / 15))


def test_a_cluster_measured_by_hand_is_refined_by_the_recording():
    wrong = SHAPE + np.random.default_rng(6).normal(size=SHAPE.shape) * 5e-4
    result = track(wrong, moving(100)[0], NAMES, "x")
    noise, _ = result.noise(np.ones(100, dtype=bool))
    assert noise < 1e-9  # nothing of the error of the shape is taken for noise
    apart = np.linalg.norm(result.shape[:, None] - result.shape[None], axis=-1)
    assert apart == pytest.approx(np.linalg.norm(SHAPE[:, None] - SHAPE[None], axis=-1), abs=1e-6)


def test_exchanged_labels_are_found_and_put_right():
    seen = moving(80, 2e-4)[0]
    whole = track(SHAPE, seen, NAMES, "x")
    mixed = seen.copy()
    mixed[20:40, [1, 3]] = mixed[20:40, [3, 1]]
    mixed[60, [0, 1, 4]] = mixed[60, [1, 4, 0]]
    result = track(SHAPE, mixed, NAMES, "x")
    assert result.exchanged["B", "D"] == list(range(20, 40))
    assert result.exchanged["A", "B", "E"] == [60]
    assert result.poses.position == pytest.approx(whole.poses.position, abs=1e-15)
    assert not result.lost
    assert not result.stray


@pytest.mark.parametrize("first", [25, 60])
def test_labels_exchanged_from_some_frame_on_are_put_right(first):
    """Most frames, or the last ones alone, have their labels exchanged, and some lack a marker."""
    seen = moving(80, 2e-4)[0]
    seen[::3, 2] = np.nan
    mixed = seen.copy()
    mixed[first:, [1, 3]] = mixed[first:, [3, 1]]
    result = track(SHAPE, mixed, NAMES, "x")
    assert result.exchanged == {("B", "D"): list(range(first, 80))}
    assert result.poses.position == pytest.approx(track(SHAPE, seen, NAMES, "x").poses.position, abs=1e-15)


def test_a_cluster_of_which_most_frames_fit_in_no_order_is_refused():
    """A third of the frames fits and shows that the cluster is the right one; two markers are moved in the others."""
    seen = moving(90)[0]
    seen[30:, :2] += np.array([[0.02, 0.0, 0.0], [0.0, 0.02, 0.0]])
    with pytest.raises(FileError, match="do not fit the mapping"):
        track(SHAPE, seen, NAMES, "x")


def test_the_reason_names_the_exchanged_markers_although_some_frames_fit():
    seen = moving(40)[0]
    seen[19:, [0, 1]] = seen[19:, [1, 0]]
    with pytest.raises(FileError, match="they fit with A and B exchanged, so correct"):
        track(SHAPE, seen, NAMES, "x")


def test_a_stray_marker_is_left_out():
    seen, position, _ = moving(80, 2e-4)
    seen[30:33, 2] += 0.02
    seen[50] += np.random.default_rng(1).normal(size=(5, 3)) * 0.05
    result = track(SHAPE, seen, NAMES, "x")
    assert result.stray == {"C": [30, 31, 32]}
    assert result.lost == [50]
    assert not result.known[50]
    # 0.2 mm of noise moves a pose's origin, 60 mm from the markers, by up to 0.5 mm.
    assert np.linalg.norm(result.poses.position[30:33] - position[30:33], axis=1).max() < 1.5e-3


def test_an_exchange_that_a_regular_cluster_hides_is_returned():
    square = np.array([[0.0, 0.02, 0.02], [0.0, 0.02, -0.02], [0.0, -0.02, -0.02], [0.0, -0.02, 0.02]])
    alike = look_alikes(square, "ABCD", 1.5e-3)
    assert ("A", "B", "C", "D") in alike
    assert look_alikes(SHAPE, NAMES, 1.5e-3) == []


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda seen: seen * 1000.0, r" 1000 times as far apart.*unit of length"),
        (lambda seen: seen * [1, 1, -1], r"mirror image fits"),
        (lambda seen: seen[:, [1, 0, 2, 3, 4]], r"they fit with A and B exchanged, so correct"),
        (lambda seen: seen * [1.5, 0.6, 1.0], r"check that this is the right club"),
        (
            lambda seen: np.where(np.arange(5)[:, None] < 2, seen, np.nan),
            r"no frame of 80 shows 3 markers.*A in 80.*E in 0",
        ),
    ],
)
def test_a_cluster_that_is_not_the_mappings_is_refused_with_the_reason(spoil, message):
    with pytest.raises(FileError, match=message):
        track(SHAPE, spoil(moving()[0]), NAMES, "x")


def test_the_reason_is_found_in_the_frames_that_show_all_markers():
    """Of the first ten frames, each lacks a marker; the mirror image is seen in the others alone."""
    seen = moving()[0] * [1, 1, -1]
    seen[np.arange(10), np.arange(10) % 5] = np.nan
    seen[:10, 0] = np.nan
    with pytest.raises(FileError, match="mirror image fits"):
        track(SHAPE, seen, NAMES, "x")
    seen[:, 0] = np.nan  # no frame shows all: nothing more can be told
    with pytest.raises(FileError, match="check that this is the right club"):
        track(SHAPE, seen, NAMES, "x")


def test_degrees_of_freedom_are_three_a_marker_less_six():
    residuals = np.zeros((3, 5, 3))
    residuals[1, 0] = np.nan
    residuals[2, :3] = np.nan
    assert degrees_of_freedom(residuals).tolist() == [9, 6, 0]


@pytest.mark.parametrize("angle", [1e-9, 1e-5, 9.9e-5, 1.01e-4, 9.9e-3, 1.01e-2, 0.3, 3.0])
def test_a_rotation_and_its_rate_are_those_of_the_closed_form_at_every_size(angle):
    """Rodrigues' formula in long double, which has four digits more; series stand in for it where angles are small."""
    axis = np.array([2.0, -3.0, 6.0], np.longdouble) / 7
    x = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]], np.longdouble)
    a = np.longdouble(angle)
    half = np.sin(a / 2)
    exact = np.eye(3, dtype=np.longdouble) + np.sin(a) * x + 2 * half * half * (x @ x)
    # Two roundings of numbers of the size of the angle.
    np.testing.assert_allclose(
        exponential(angle * axis.astype(float)) - np.eye(3), (exact - np.eye(3)).astype(float), rtol=2e-14, atol=3e-16
    )
    # The rate of a rotation vector r becomes J r with J = 1 + (1 - cos a) x + (a - sin a) x^2 over a; a - sin a is its
    # series where it would lose digits.
    rest = a**3 / 6 - a**5 / 120 + a**7 / 5040 - a**9 / 362880 if a < 0.1 else a - np.sin(a)
    jacobian = np.eye(3, dtype=np.longdouble) + 2 * half * half / a * x + rest / a * (x @ x)
    np.testing.assert_allclose(left_jacobian(angle * axis.astype(float)), jacobian.astype(float), rtol=0, atol=1e-15)
