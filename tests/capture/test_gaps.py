"""Gaps of markers are not impacts: hidden ones, and those that the capture program filled."""

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from attached_notes import codes
from captures import captured, deviations, errors
from clubface.capture.recording import filled, read_c3d
from clubface.capture.reduction import QUANTITIES
from clubface.capture.remarks import implausible
from clubface.capture.setup import prepare
from clubface.capture.swing import capture
from clubface.capture.synthetic.laboratory import Cameras, bare_map, positions_map, record_bare
from clubface.capture.synthetic.synthetic_swing import random_swing
from clubface.equipment.clubs import club
from clubface.errors import FileError

DATA = Path(__file__).parents[1] / "data"
RECORDING = read_c3d(DATA / "follow_through_gap_driver.c3d")
MAPPING = DATA / "follow_through_gap.toml"
WAYS = ("nan", "zero", "hold", "line", "spline", "overshoot")
CUBIC = np.array([[2.0, -3.0, 0.0, 1.0], [1.0, -2.0, 1.0, 0.0], [-2.0, 3.0, 0.0, 0.0], [1.0, -1.0, 0.0, 0.0]])
"""Hermite's: coefficients of the place before, the slope there, the place after, and the slope there."""


def with_gap(positions, first, last, way, markers=(0, 1, 2)):
    """Hide markers from one frame to before another, or fill the gap as a capture program does."""
    positions, markers = positions.copy(), list(markers)
    before, after = positions[first - 1, markers], positions[last, markers]
    part = ((np.arange(first, last) - first + 1.0) / (last - first + 1.0))[:, None, None]
    if way == "nan":
        filling = np.nan
    elif way in ("zero", "hold"):
        filling = 0.0 if way == "zero" else before
    elif way == "line":
        filling = before + part * (after - before)
    else:
        steeper = (last - first + 1.0) * (4.0 if way == "overshoot" else 1.0)
        slopes = before - positions[first - 2, markers], positions[last + 1, markers] - after
        basis = [np.polyval(row, part) for row in CUBIC]
        filling = basis[0] * before + basis[1] * slopes[0] * steeper + basis[2] * after + basis[3] * slopes[1] * steeper
    positions[first:last, markers] = filling
    if way == "zero":
        positions[np.all(positions == 0.0, axis=-1)] = np.nan  # as the reader of the file does it
    return positions


@cache
def bare(seed=5, rate=360.0, club="driver", hand="right", after=0.25, **wanted):
    """A swing that shows three markers and no ball, its recording, how it is read, and the frame before impact."""
    swing = random_swing(seed, club=club, hand=hand, **wanted)
    cameras = Cameras(rate=rate, noise=3e-4, after=after)
    recorded = record_bare(swing, cameras, seed)
    return swing, recorded.recording, prepare(bare_map(swing.club, cameras), swing.club), int(-recorded.first * rate)


@cache
def whole_delivery(**swing):
    """What is read from a swing that shows its markers in every frame."""
    _, recording, ready, _ = bare(**swing)
    return capture(recording, ready)


def values(result):
    return np.array([getattr(result.delivery, name) for name in QUANTITIES])


def test_a_gap_in_the_follow_through_changes_nothing():
    """Hidden from frame 519 to 551, 42 frames after impact: the whole recording gives what frames 1 to 518 give."""
    ready = prepare(MAPPING, "driver-as-printed")
    whole, short = capture(RECORDING, ready), capture(replace(RECORDING, positions=RECORDING.positions[:518]), ready)
    assert whole.frames == short.frames == (477, 478)
    off = np.abs(values(whole) - values(short)) / np.array(list(short.uncertainty.values()))
    assert off.max() < 0.05
    assert whole.get("speed", "mph")[0] == pytest.approx(114.9, abs=0.1)
    assert whole.plausible


@pytest.mark.parametrize(
    ("rate", "club", "hand", "first", "last", "way"),
    [
        *((360.0, "driver", "right", 30, 63, way) for way in WAYS),
        *((240.0, "7-iron", "left", 8, 30, way) for way in ("nan", "hold", "overshoot")),
        *((720.0, "driver", "left", -60, -20, way) for way in ("zero", "line", "spline")),
        *((500.0, "7-iron", "right", -16, -11, way) for way in ("nan", "spline")),
        *((1000.0, "driver", "right", 20, 80, way) for way in ("line", "overshoot")),
    ],
)
def test_a_gap_before_or_after_impact_is_not_the_impact_whatever_fills_it(rate, club, hand, first, last, way):
    """The delivery is that of the whole recording, to a tenth of its standard deviations where the gap comes after
    impact and to three where frames before it are missing; and it holds the truth within four."""
    swing, recording, ready, impact = bare(rate=rate, club=club, hand=hand)
    whole = whole_delivery(rate=rate, club=club, hand=hand)
    positions = with_gap(recording.positions, impact + first, impact + last, way)
    result = capture(replace(recording, positions=positions), ready)
    assert result.frames == whole.frames
    stated = np.array(list(result.uncertainty.values()))
    assert (np.abs(values(result) - values(whole)) / stated).max() < (3.0 if first < 0 else 0.1)
    assert np.abs(errors(result, swing) / deviations(result)).max() < 4.0
    assert ("capture-filled" in codes(result)) == (way not in ("nan", "zero"))


@pytest.mark.parametrize("way", WAYS)
def test_a_long_gap_across_the_impact_is_refused_with_its_frames(way):
    _, recording, ready, impact = bare()
    first, last = impact - 5, impact + 7
    with pytest.raises(FileError, match=r"not seen in frames \d+ to \d+"):
        capture(replace(recording, positions=with_gap(recording.positions, first, last, way)), ready)


@pytest.mark.parametrize("way", ["nan", "line", "overshoot"])
def test_one_marker_of_five_that_is_hidden_across_the_impact_costs_little(way):
    swing = random_swing(3)
    cameras = Cameras(rate=720.0, noise=2e-4, after=0.1)
    mapping = replace(positions_map(swing.club, cameras), ball=None)
    recording = cameras.record(swing, 3)
    positions = with_gap(recording.positions, 170, 200, way, markers=[1])
    result = capture(replace(recording, positions=positions), prepare(mapping, swing.club))
    assert np.abs(errors(result, swing) / deviations(result)).max() < 4.0
    assert result.delivery.speed == pytest.approx(
        captured(swing, cameras, seed=3, mapping=mapping).delivery.speed, abs=0.2
    )


@cache
def free(seed=5):
    """A swing without a ball."""
    swing, _, ready, impact = bare(seed)
    cameras = Cameras(rate=360.0, noise=3e-4, after=0.25)
    missed = replace(swing, slowed=(np.zeros(3), np.zeros(3)))
    return record_bare(missed, cameras, seed).recording, ready, impact


@pytest.mark.parametrize("size", [-0.4, -0.1, 0.1, 0.4])
@pytest.mark.parametrize("length", [2, 4, 6])
def test_a_speed_that_drops_or_rises_and_comes_back_is_no_impact(size, length):
    """All markers lag behind, or run ahead, for some frames, as a filter that rings or a bad frame makes them do."""
    recording, ready, impact = free()
    positions = recording.positions.copy()
    step = np.nanmean(positions[impact + 1] - positions[impact], axis=0)
    bump = size * step * np.sin(np.pi * np.arange(1, length + 1) / (length + 1.0))[:, None, None]
    positions[impact - 3 : impact - 3 + length] += bump
    with pytest.raises(FileError, match="nowhere loses speed as at impact"):
        capture(replace(recording, positions=positions), ready)


def test_of_two_impacts_the_harder_is_taken_and_the_other_named():
    swing, recording, ready, impact = bare()
    slower = random_swing(7, speed=0.7 * swing.truth["speed"])
    cameras = Cameras(rate=360.0, noise=3e-4, after=0.2)
    first = record_bare(slower, cameras, 7).recording
    gap = np.full((20, 3, 3), np.nan)
    both = replace(recording, positions=np.concatenate([recording.positions, gap, first.positions]))
    ready = replace(ready, mapping=replace(ready.mapping, frames=(1, 60)))
    result = capture(both, ready)
    assert result.frames[0] == pytest.approx(impact + 1, abs=1)
    assert "capture-impact-again" in codes(result)


def test_noise_never_lies_on_a_polynomial_and_a_filled_gap_does():
    """Each filled frame is recognised, and none besides: in files of single precision, and of tenths of millimetres."""
    _, recording, _, impact = bare(rate=500.0)
    seen = recording.positions
    for scale in (1.0, 1e3):
        for way in ("hold", "line", "spline", "overshoot"):
            made = with_gap(seen, impact - 40, impact - 20, way)
            in_file = (made * scale).astype(np.float32).astype(np.float64) / scale
            marked = np.flatnonzero(filled(in_file, 500.0).any(1))
            assert set(range(impact - 40, impact - 20)) <= set(marked)
            assert len(marked) <= 22
    for digits in (3, 4):  # whole and tenths of millimetres
        assert not filled(np.round(seen, digits), 500.0).any()
    assert not filled(seen, 500.0).any()


def test_a_gap_that_is_filled_by_a_polynomial_through_three_frames_on_each_side_is_recognised():
    _, recording, _, impact = bare(rate=500.0)
    made, gap = recording.positions.copy(), np.arange(impact - 40, impact - 20)
    around = np.r_[gap[0] - 3 : gap[0], gap[-1] + 1 : gap[-1] + 4]
    for marker in range(made.shape[1]):
        quintic = np.polynomial.polynomial.polyfit(around - impact + 30.0, made[around, marker], 5)
        made[gap, marker] = np.polynomial.polynomial.polyval(gap - impact + 30.0, quintic).T
    assert set(gap) <= set(np.flatnonzero(filled(made, 500.0).all(1)))


def test_a_straight_line_may_fill_the_end_of_a_recording_and_a_curve_is_a_smooth_motion():
    _, recording, _, impact = bare(rate=500.0)
    after = np.arange(len(recording.positions) - impact)[:, None, None]
    line, curve = recording.positions.copy(), recording.positions.copy()
    step = line[impact] - line[impact - 1]
    line[impact:] = line[impact] + after * step
    curve[impact:] = curve[impact] + after * step - 1e-4 * after**3
    assert filled(line, 500.0)[impact + 1 :].all()
    assert filled(line[::-1], 500.0)[: -impact - 1].all()
    assert not filled(curve, 500.0).any()


@pytest.mark.parametrize("rate", [120.0, 720.0, 2000.0])
def test_a_swing_without_noise_is_not_taken_for_one_that_was_filled(rate):
    swing = random_swing(2)
    recorded = record_bare(swing, Cameras(rate=rate, after=0.1), 2).recording
    assert not filled(recorded.positions, rate).any()
    assert not filled((recorded.positions * 1e3).astype(np.float32).astype(np.float64) / 1e3, rate).any()


def test_an_axis_is_doubted_only_if_another_makes_the_delivery_plausible():
    with pytest.raises(FileError, match=r"\+z as the target axis gives a plausible delivery"):
        capture(RECORDING, prepare(MAPPING, "driver", target="-z"))
    result = capture(RECORDING, prepare(MAPPING, "driver", target="+z"))
    assert result.plausible


def test_a_delivery_that_no_shot_has_stands_under_a_warning():
    """With the club upside down it has a lie of 170 degrees: the first note says so, and the document."""
    swing = random_swing(2)
    cameras = Cameras(rate=720.0, noise=2e-4)
    result = captured(swing, cameras, up="-z")
    assert not result.plausible
    assert result.notes[0].code == "capture-not-plausible"
    assert "lie" in result.notes[0].data["values"]
    assert result.to_result().table("swings")["plausible"].values == [False]
    assert captured(swing, cameras).plausible


@pytest.mark.parametrize(
    ("name", "value", "deviation"),
    [("speed", 80.0, 17.0), ("speed", 150.0, 1.0), ("path", 1.2, 0.01), ("loft", 1.0, 0.01), ("lie", -1.2, 0.01)],
)
def test_each_value_that_no_swing_has_and_a_speed_that_is_hardly_known_is_not_plausible(name, value, deviation):
    driver = club("driver")
    values = {"speed": 50.0, "path": 0.02, "loft": driver.loft + 0.05, "lie": 0.1}
    deviations = dict.fromkeys(values, 0.01)
    assert implausible(values, deviations, driver) == []
    (message,) = implausible(values | {name: value}, deviations | {name: deviation}, driver)
    assert message.data["values"] == {name: [value, deviation]}


@pytest.mark.parametrize("later", [0, 1, 3])
@pytest.mark.parametrize(("rate", "club"), [(360.0, "driver"), (720.0, "7-iron")])
def test_a_recording_that_ends_at_the_impact_is_read_from_its_last_frames(rate, club, later):
    """When between two frames the ball is met is not known: that is a part of a frame in every rate and angle."""
    swing, recording, ready, impact = bare(rate=rate, club=club)
    result = capture(replace(recording, positions=recording.positions[: impact + 1 + later]), ready)
    assert np.abs(errors(result, swing) / deviations(result)).max() < 3.0
    assert {"capture-ends-with-impact", "capture-ends-after-impact"} & codes(result)
    turned = 2500.0 / rate * (1.0 if later == 0 else 12.0**-0.5)  # degrees that the face closes in that time
    assert result.get("face", "deg")[1] > 0.5 * turned


def test_a_recording_that_ends_in_the_backswing_or_follow_through_has_no_impact():
    recording, ready, impact = free()
    for last in (impact - 60, impact + 25, impact + 60):
        with pytest.raises(FileError, match="no impact"):
            capture(replace(recording, positions=recording.positions[:last]), ready)


def test_a_swing_after_which_the_club_is_slowly_put_back_has_no_impact_at_its_end():
    recording, ready, impact = free()
    there = recording.positions[: impact + 25]
    with pytest.raises(FileError, match="no impact"):
        capture(replace(recording, positions=np.concatenate([there, there[::-1]])), ready)
