"""Swings that cannot be read or can be doubted: each is told what is wrong with it."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import butter, filtfilt

import clubface
from attached_notes import codes, noted
from captures import captured, damaged, deviations, errors
from clubface.capture.setup import prepare
from clubface.capture.swing import capture, read_swing, read_swings
from clubface.capture.synthetic.laboratory import Cameras, positions_map, synthesize
from clubface.capture.synthetic.synthetic_swing import random_swing
from clubface.errors import CaptureWarning, FileError, InputError

CAMERAS = Cameras(noise=2e-4)
SWING = random_swing(11)
RECORDING = CAMERAS.record(SWING, 3, path="swing.c3d")
MAPPING = positions_map(SWING.club, CAMERAS)
HEAD, BALL = slice(0, 5), 5
IMPACT = int(np.argmax(np.linalg.norm(np.diff(RECORDING.positions[:, BALL], axis=0), axis=-1) > 5e-3)) + 1
"""The first frame in which the ball has moved."""


def read(change=None, mapping=MAPPING, club="driver", **options):
    """Read the swing with its positions changed."""
    positions = RECORDING.positions.copy()
    if change is not None:
        positions = change(positions)
    return capture(replace(RECORDING, positions=positions), prepare(mapping, club, **options))


def changed(frames, markers, value):
    def change(positions):
        positions[frames, markers] = value
        return positions

    return change


def still_ball(positions):
    positions[:, BALL] = positions[:IMPACT, BALL].mean(0)
    return positions


def test_an_undisturbed_swing_has_no_notes():
    assert read().notes == ()
    assert read().frames == (IMPACT, IMPACT + 1)  # counted from 1


def test_a_swing_beside_the_ball_is_no_impact():
    def sideways(positions):
        positions[:, BALL] = positions[0, BALL] + [0.5, 0.0, 0.0]
        return positions

    with pytest.raises(
        FileError, match=r"swing\.c3d: no impact: the face does not pass the ball; its centre comes no"
    ) as e:
        read(sideways)
    assert "and the ball stays" in str(e.value)
    millimetres = float(str(e.value).split("nearer than ")[1].split(" mm")[0])
    assert 420 < millimetres < 520


def test_a_face_that_passes_a_ball_without_moving_it_is_no_impact():
    with pytest.raises(
        FileError,
        match=r"no impact: the face passes the .* between frames \d+ and \d+",
    ):
        read(still_ball)


def test_without_a_ball_to_see_the_head_must_be_slowed():
    place = tuple(RECORDING.positions[:IMPACT, BALL].mean(0))
    fixed = replace(MAPPING, ball=None, ball_position=place, accuracy=2e-4)
    result = read(mapping=fixed)
    assert "capture-ball-not-seen" in codes(result)
    assert np.abs(errors(result, SWING) / deviations(result)).max() < 4.0

    free = replace(SWING, slowed=(np.zeros(3), np.zeros(3)))
    with pytest.raises(
        FileError, match=r"no impact: .*but the head keeps its speed \(\d+\.\d m/s before, \d+\.\d m/s after\)"
    ):
        capture(CAMERAS.record(free, 3, path="swing.c3d"), prepare(fixed, "driver"))


def test_ball_and_head_may_both_vanish_at_impact():
    def vanish(positions):
        positions[IMPACT:] = np.nan
        return positions

    result = read(vanish)
    assert {"capture-head-lost", "capture-nothing-seen-after-impact"} <= codes(result)
    whole = read()
    assert result.delivery.speed == pytest.approx(whole.delivery.speed, abs=0.02)
    assert result.launch == {}


def test_a_head_lost_before_impact_is_extended_across_the_gap_with_less_certainty():
    result = read(changed(slice(IMPACT - 5, IMPACT + 2), HEAD, np.nan))
    assert noted(result, "capture-path-extended") == [{"missing": 5}]
    assert result.uncertainty["speed"] > 2 * read().uncertainty["speed"]
    assert np.abs(errors(result, SWING) / deviations(result)).max() < 4.0


def test_a_head_lost_for_long_before_impact_is_refused_with_the_frames():
    with pytest.raises(FileError, match=rf"not seen in frames {IMPACT - 10} to \d+"):
        read(changed(slice(IMPACT - 11, IMPACT + 2), HEAD, np.nan))


def test_a_ball_carried_about_before_is_met_where_it_lies_at_last():
    def carried(positions):
        elsewhere = np.linspace([0.3, 0.5, 0.2], [0.0, 0.0, 0.0], 30)
        positions[20:50, BALL] = positions[20:50, BALL] + elsewhere
        positions[:20, BALL] = positions[:20, BALL] + elsewhere[0]
        return positions

    assert read(carried).delivery.toe == pytest.approx(read().delivery.toe, abs=1e-4)


def test_a_practice_swing_before_is_not_the_impact():
    gap = np.full((10, 6, 3), np.nan)
    practice = np.array(RECORDING.positions[: IMPACT + 15])
    practice[:, BALL] = RECORDING.positions[0, BALL]
    slower = np.repeat(practice, 2, axis=0)  # at half the speed
    positions = np.concatenate([slower, gap, RECORDING.positions])
    result = capture(replace(RECORDING, positions=positions), prepare(MAPPING, "driver"))
    assert result.frames[0] == len(slower) + len(gap) + IMPACT
    assert result.delivery.speed == pytest.approx(read().delivery.speed, abs=0.05)


def test_a_swing_where_the_ball_will_lie_is_not_the_impact():
    practice = np.array(RECORDING.positions[::2])  # at twice the speed
    practice[:, BALL] = RECORDING.positions[0, BALL] + [0.5, 0.0, 0.0]
    shot = RECORDING.positions.copy()
    shot[IMPACT:, BALL] = np.nan
    result = capture(replace(RECORDING, positions=np.concatenate([practice, shot])), prepare(MAPPING, "driver"))
    assert result.frames[0] == len(practice) + IMPACT


def test_frames_after_first_touch_are_not_used_even_if_they_are_offered():
    from clubface.capture.impact_frame import Extrapolation, FrameInterval, follow
    from clubface.capture.tracking import track

    ready = prepare(MAPPING, "driver")
    cluster = ready.cluster(RECORDING)
    turn = ready.turn(RECORDING)
    followed = track(cluster.shape, RECORDING.markers(cluster.names) @ turn.T, cluster.names, "x")
    ball = RECORDING.positions[:IMPACT, BALL].mean(0) @ turn.T
    how = Extrapolation(noise=2e-4, name="smoother", roughness=0.6, where="x")
    result = [
        follow(RECORDING.times, followed, FrameInterval(last, last + 1), ball, ready.club, ready.ball.radius, how)
        for last in (IMPACT - 1, IMPACT, IMPACT + 1)
    ]
    assert [each.frames[-1] for each in result] == [IMPACT - 1] * 3
    assert result[2].touch == pytest.approx(result[0].touch, abs=1e-9)


def test_exchanged_and_stray_markers_are_repaired_and_noted():
    def mixed(positions):
        positions[IMPACT - 8 : IMPACT + 1, [0, 2]] = positions[IMPACT - 8 : IMPACT + 1, [2, 0]]
        positions[IMPACT - 20, 4] += 0.05
        return positions

    result = read(mixed)
    first, last = IMPACT - 7, IMPACT + 1
    (exchanged,) = noted(result, "capture-markers-exchanged")
    assert exchanged == {"markers": ["HEAD1", "HEAD3"], "frames": [*range(first, last + 1)]}
    assert noted(result, "capture-marker-strays") == [{"marker": "HEAD5", "frames": [IMPACT - 19]}]
    assert result.delivery.speed == pytest.approx(read().delivery.speed, abs=0.02)


@pytest.mark.parametrize(
    ("change", "options", "message"),
    [
        (lambda p: p * 1000.0, {}, r"1000 times as far apart as in the mapping .*: a unit of length is wrong"),
        (None, {"hand": "left"}, r"mirror image fits, so the hand"),
        (None, {"target": "-y"}, r"moves away from the target; .* as the target axis"),
        (changed(slice(None), slice(2, 5), np.nan), {}, r"no frame of \d+ shows 3 markers of the clubhead at once"),
        (changed(slice(None), BALL, np.nan), {}, r"the ball's marker BALL is never seen; give its position"),
        (changed(slice(0, IMPACT - 4), HEAD, np.nan), {}, "4 frames before impact show the clubhead; .* needs 8"),
        (changed(slice(None), HEAD, np.nan), {}, r"no frame of \d+ shows 3 markers.*HEAD1 in 0"),
    ],
)  # fmt: skip
def test_what_cannot_be_read_is_refused_with_the_reason(change, options, message):
    with pytest.raises(FileError, match=message):
        read(change, **options)


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ({"up": "-z"}, "capture-lie"),
        ({"club": "7-iron", "mapping": replace(MAPPING, club=None)}, "capture-flight-contradicts"),
    ],
)
def test_doubtful_deliveries_are_noted(options, code):
    assert code in codes(read(**options))


def test_a_ball_that_flies_off_otherwise_puts_the_club_in_doubt():
    result = read(club="7-iron", mapping=replace(MAPPING, club=None))
    assert [each["club"] for each in noted(result, "capture-flight-contradicts")] == ["7-iron"]


def test_a_ball_that_leaves_before_the_face_arrives_puts_the_mapping_in_doubt():
    def early(positions):
        positions[:-2, BALL] = positions[2:, BALL].copy()
        return positions

    (start,) = noted(read(early), "capture-ball-start")
    # Two frames of 1.39 ms early, and half a contact late: -2.78 + 0.22 ms.
    assert start["late_time"] == pytest.approx(-2.55e-3, abs=0.02e-3)


FAST = Cameras(noise=2e-4, rate=720.0)


def filtered(cut, seed):
    """Read a swing at 720 Hz after a Butterworth filter of second order, run to and fro across the impact."""
    recording = FAST.record(SWING, seed, path="swing.c3d")
    if cut is not None:
        recording = replace(recording, positions=filtfilt(*butter(2, cut / 360.0), recording.positions, axis=0))
    return capture(recording, prepare(MAPPING, "driver"))


@pytest.mark.parametrize("seed", range(4))
def test_a_recording_that_was_filtered_is_noted_and_a_raw_one_is_not(seed):
    raw = filtered(None, seed)
    assert not noted(raw, "capture-filtered")
    smooth = filtered(100.0, seed)
    assert len(noted(smooth, "capture-filtered")) == 1
    # What the note warns of: the loss of speed reaches back over 2 ms, and the head reads slower than it is.
    assert smooth.delivery.speed < 0.97 * raw.delivery.speed
    assert len(noted(filtered(150.0, seed), "capture-filtered")) == 1


def test_a_ball_that_the_face_does_not_reach_after_filtering_names_the_filter():
    with pytest.raises(FileError, match=r"the face does not pass the ball"):
        filtered(30.0, 0)


@pytest.mark.parametrize("times", [4.5, 6.0])
def test_a_frame_rate_that_is_too_low_makes_the_contact_too_long_by_as_much(times):
    recording = FAST.record(SWING, 5, path="swing.c3d")
    slow = capture(replace(recording, rate=recording.rate / times), prepare(MAPPING, "driver"))
    (late,) = noted(slow, "capture-ball-starts-late")
    # The ball of the simulation starts after 0.22 ms, and the flight gives that to 0.03 ms.
    assert late["late_time"] == pytest.approx(times * 0.22e-3, abs=times * 0.03e-3)
    assert late["times"] == pytest.approx(times, rel=0.25)


def test_an_impact_off_the_face_is_noted():
    wide = random_swing(2, club=clubface.club("driver").replace(face_width="150 mm"), toe=0.06)
    result = captured(replace(wide, club=SWING.club), CAMERAS)
    (off,) = noted(result, "capture-off-face")
    assert (off["face_width"], off["face_height"]) == (0.105, 0.055)


def test_a_moved_marker_is_noted():
    cluster = dict(MAPPING.cluster)
    x, y, z = cluster["HEAD3"]
    cluster["HEAD3"] = (x + 0.005, y, z)
    assert noted(read(mapping=replace(MAPPING, cluster=cluster)), "capture-marker-moved")[0]["marker"] == "HEAD3"


def test_options_are_checked():
    for options, message in (
        ({"estimator": "kalman"}, "unknown estimator"),
        ({"noise": "0 mm"}, "noise is '0 mm'; it must be above 0 m"),
        ({"noise": "1 deg"}, "noise"),
        ({"hand": "both"}, "hand"),
        ({"unit": "furlong"}, "units"),
        ({"up": "+y"}, "perpendicular to the up axis"),
        ({"roughness": -1}, "roughness"),
    ):
        with pytest.raises(InputError, match=message):
            prepare(MAPPING, "driver", **options)
    with pytest.raises(InputError, match=r"club is '7-iron'"):
        prepare(MAPPING, "7-iron")


def test_calibrations_that_cannot_be_used_are_refused(tmp_path):
    from clubface.capture.calibration import calibrated
    from clubface.capture.synthetic.laboratory import calibration_map

    club = clubface.club("driver")
    mapping = calibration_map(club, CAMERAS)
    ready = prepare(MAPPING, "driver")
    seen = CAMERAS.calibrate(club, 1, path="static.c3d")
    turn = ready.turn(seen)
    hidden, spread = seen.positions.copy(), seen.positions.copy()
    hidden[:, 6] = np.nan
    spread[:, 6] += 0.02
    for positions, message in (
        (hidden, "at once: FACE_CENTRE, FACE_TOE"),
        (spread, r"face points miss their positions by \d+\.\d mm, most of all FACE_TOE"),
        (seen.positions * 1e-3, "times as far apart as in the mapping"),
    ):
        with pytest.raises(FileError, match=message):
            calibrated(mapping, club, replace(seen, positions=positions), turn)
    outside = replace(mapping, face={**mapping.face, "FACE_TOE": mapping.face["FACE_TOE"]._replace(toe=0.08)})
    with pytest.raises(FileError, match=r"FACE_TOE lies outside the face of driver"):
        calibrated(outside, club, seen, turn)
    two = seen.positions.copy()
    two[:, :3] = np.nan
    with pytest.raises(FileError, match="no frame shows the face together with: HEAD1, HEAD2, HEAD3"):
        calibrated(mapping, club, replace(seen, positions=two), turn)
    one = seen.positions.copy()
    one[:, 0] = np.nan
    placed = calibrated(mapping, club, replace(seen, positions=one), turn)
    assert placed.names == ("HEAD2", "HEAD3", "HEAD4", "HEAD5")
    assert placed.notes == (("capture-markers-not-calibrated", {"markers": ["HEAD1"]}),)


def test_of_many_files_the_bad_ones_are_listed_and_the_good_ones_read(tmp_path):
    files = synthesize(tmp_path, 3, cameras=CAMERAS)
    files[1].write_bytes(files[1].read_bytes()[:2000])
    result = read_swings(files[:3], tmp_path / "markers.toml", "driver")
    assert result.places == (1, 3)
    assert [each.line for each in result.rejected] == [2]
    assert "cut short" in result.rejected[0].reason
    written = result.write(tmp_path / "shots.csv")
    assert [each.name for each in written] == ["shots.csv", "shots.sd.csv"]
    from clubface.shots.reading import read_shots

    table = read_shots(written[0])
    assert table.deliveries["loft"] == pytest.approx(result.shots.deliveries["loft"], rel=1e-12)
    assert read_shots(written[1]).deliveries["loft"] == pytest.approx(result.uncertainty.deliveries["loft"], rel=1e-12)
    with pytest.raises(InputError, match="at least one swing"):
        _ = read_swings([files[1]], tmp_path / "markers.toml", "driver").shots


def test_an_interruption_keeps_what_was_read(tmp_path):
    files = synthesize(tmp_path, 3)

    def stop(done, whole):
        if done == 2:
            raise KeyboardInterrupt

    result = read_swings(files[:3], tmp_path / "markers.toml", "driver", progress=stop)
    assert result.interrupted
    assert result.places == (1, 2)


def test_notes_are_warnings_of_a_single_reading(tmp_path):
    files = synthesize(tmp_path, 1, cameras=CAMERAS)
    from clubface.capture.recording import read_c3d, write_c3d

    seen = read_c3d(files[0])
    positions = seen.positions.copy()
    positions[100, 0] += 0.05
    write_c3d(replace(seen, positions=positions), files[0])
    with pytest.warns(CaptureWarning, match=r"swing-001\.c3d: HEAD1 is out of place in frame 101"):
        read_swing(files[0], tmp_path / "markers.toml", "driver")


def test_whatever_happens_to_a_recording_it_is_read_or_refused():
    """Forty recordings hidden, shifted, cut, shuffled, reversed and scaled in part; numpy must not warn either."""
    import warnings

    random = np.random.default_rng(5)
    ready = [prepare(MAPPING, "driver", estimator=name) for name in ("smoother", "polynomial", "linear")]
    outcomes = []
    for number in range(40):
        positions = RECORDING.positions.copy()
        first, last = np.sort(random.integers(0, len(positions), 2))
        some = random.permutation(6)[: random.integers(1, 7)]
        positions = damaged(positions, number, first, last, some, random)
        with warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            try:
                result = capture(replace(RECORDING, positions=positions), ready[number % 3])
            except FileError as error:
                outcomes.append(str(error))
            else:
                outcomes.append("read")
                assert np.isfinite(list(result.uncertainty.values())).all()
    assert outcomes.count("read") >= 5
    assert len(set(outcomes)) >= 5


def turned(degrees):
    """Turn everything about the vertical axis of the laboratory, which is z."""
    angle = np.radians(degrees)
    turn = np.array([[np.cos(angle), -np.sin(angle), 0.0], [np.sin(angle), np.cos(angle), 0.0], [0.0, 0.0, 1.0]])
    return lambda positions: positions @ turn.T


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_head_that_goes_more_aside_than_ahead_is_refused_and_one_far_aside_is_doubted(sign):
    sideways = np.degrees(read().delivery.path)
    doubted = read(turned(sign * 80.0))
    assert "capture-path" in codes(doubted)
    assert abs(np.degrees(doubted.delivery.path) - sideways) == pytest.approx(80.0, abs=0.5)
    with pytest.raises(FileError, match=r"moves away from the target; .* as the target axis"):
        read(turned(sign * 100.0))
