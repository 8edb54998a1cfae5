"""Swings of three head markers without a ball: what is assumed for want of measurement, and how far that carries."""

from dataclasses import replace

import numpy as np
import pytest

import clubface
from attached_notes import codes, noted
from captures import damaged, deviations, errors
from clubface.capture.geometry import Assumed, Known
from clubface.capture.markers import MarkerMap
from clubface.capture.reduction import QUANTITIES
from clubface.capture.setup import prepare
from clubface.capture.study import WAYS, bare_study
from clubface.capture.swing import capture
from clubface.capture.synthetic.laboratory import Cameras, bare_map, positions_map, record_bare
from clubface.capture.synthetic.synthetic_swing import random_swing
from clubface.errors import FileError, InputError

CAMERAS = Cameras(rate=360.0, noise=3e-4)
CERTAIN = Assumed(face=1e-5, loft=1e-5, lie=1e-5, sole=1e-6, place=1e-6)
"""Everything is as it is assumed."""


def bare(seed, club="driver", hand=None, assumed=None, cameras=CAMERAS):
    swing = random_swing(seed, club=club, hand=hand)
    return swing, record_bare(swing, cameras, seed, assumed=assumed)


def read(swing, recorded, by="address", cluster=None, cameras=CAMERAS, **changes):
    mapping = replace(bare_map(swing.club, cameras, by, cluster), **changes)
    return capture(recorded.recording, prepare(mapping, swing.club))


def known(result, words):
    [one] = [each for each in result.geometry if words in each.name]
    return one


@pytest.mark.parametrize(("club", "hand"), [("driver", "right"), ("7-iron", "left")])
def test_an_address_exactly_as_assumed_calibrates_the_head_exactly(club, hand):
    cameras = Cameras(rate=720.0, noise=1e-5)
    for seed in range(4):
        swing, recorded = bare(seed, club, hand, CERTAIN, cameras)
        off = errors(read(swing, recorded, cameras=cameras, assumed=CERTAIN), swing)
        result = dict(zip(QUANTITIES, np.abs(off), strict=True))
        # The instant of impact is known to half of what contact times differ by, 0.05 ms; the face closes by 0.12 deg
        # in that, and the head turns by as much about the others.
        assert result["speed"] < 0.1
        assert max(result[name] for name in ("attack", "path", "loft", "face", "lie")) < 0.35
        assert max(result[name] for name in ("closure", "pitch_rate", "lie_rate")) < 1.0


def test_a_face_that_was_not_square_at_address_is_off_by_that_much_at_impact():
    cameras = Cameras(rate=720.0, noise=1e-5)
    swing, recorded = bare(3, assumed=replace(CERTAIN, face=np.radians(3.0)), cameras=cameras)
    result = read(swing, recorded, cameras=cameras)
    off = result.delivery.face - swing.truth["face"]
    assert off == pytest.approx(-recorded.angles[1], abs=np.radians(0.4))
    assert result.uncertainty["face"] > np.radians(1.9)


def test_every_result_lists_its_assumptions_and_their_width():
    swing, recorded = bare(5)
    result = read(swing, recorded)
    assert known(result, "face angle at address") == Known(
        "face angle at address", "assumed", "face", [0.0], [np.radians(2.0)]
    )
    assert known(result, "loft at address").values == pytest.approx([np.radians(9.8)])
    assert known(result, "mean of the markers").deviations == pytest.approx([0.020, 0.010, 0.015])
    assert known(result, "height of the face centre").deviations == pytest.approx([0.005])
    assert known(result, "ball").how.startswith("assumed")
    assert known(result, "instant of first touch").how == "measured"
    (face,) = [
        each for each in result.to_result().table("geometry").records() if each["quantity"] == "face angle at address"
    ]
    assert (face["unit"], face["value"], face["deviation"]) == ("deg", 0.0, pytest.approx(2.0))
    assert "face angle at address" in repr(result)
    wider = read(swing, recorded, assumed=Assumed(face=np.radians(5.0), toe=0.02))
    assert known(wider, "face angle at address").deviations == pytest.approx([np.radians(5.0)])
    assert wider.uncertainty["face"] == pytest.approx(np.radians(5.0), rel=0.03)
    # The ball is nowhere but on the face: the impact point is what is assumed of it.
    assert wider.uncertainty["toe"] == pytest.approx(0.02, rel=1e-3)


def test_measured_markers_and_the_sole_make_the_place_certain():
    swing, recorded = bare(5)
    guessed = read(swing, recorded)
    one = dict.fromkeys(recorded.cluster) | {"HEAD3": recorded.cluster["HEAD3"]}
    measured = read(swing, recorded, cluster=one, accuracy=1e-3)
    assert measured.uncertainty["speed"] < 0.5 * guessed.uncertainty["speed"]
    assert known(measured, "1 marker from the face centre").how == "given"
    assert np.abs(errors(measured, swing) / deviations(measured)).max() < 4.0
    floating = read(swing, recorded, ground=None)
    assert floating.uncertainty["speed"] > guessed.uncertainty["speed"]


def test_positions_that_contradict_the_address_are_noted():
    swing, recorded = bare(5)
    turned = {name: (x, z, y) for name, (x, y, z) in recorded.cluster.items()}
    result = read(swing, recorded, cluster=turned, accuracy=1e-3)
    assert "capture-attitude-contradicted" in codes(result)
    assert "capture-attitude-contradicted" not in codes(read(swing, recorded, cluster=recorded.cluster))


@pytest.mark.parametrize("hand", ["right", "left"])
def test_an_impact_at_the_centre_shows_loft_and_face_angle(hand):
    cameras = Cameras(rate=720.0, noise=1e-5)
    usual = Assumed(
        delivered_loft=0.5, delivered_face=0.5, delivered_lie=0.01, impulse=1e-3, toe=1e-4, high=1e-4, place=1e-6
    )
    off = []
    for seed in range(3, 9):
        swing = random_swing(seed, hand=hand, toe=0.0, high=0.0, lie=0.0)
        recorded = record_bare(swing, cameras, seed, assumed=usual)
        result = read(swing, recorded, "swing", cameras=cameras, assumed=usual)
        off.append([getattr(result.delivery, name) - swing.truth[name] for name in ("loft", "face")])
    # Of 16 m/s that are lost, 0.2 m/s of the fits before and after are 0.7 degrees. The mean of the markers, 45 mm from
    # the CG, turns about it by 0.5 m/s and more, and a face that closes starts the ball 0.7 degrees to the left: two
    # degrees, if these were forgotten.
    assert (np.sqrt(np.mean(np.square(off), axis=0)) < np.radians(1.0)).all()


def test_deviations_that_are_stated_hold_the_truth():
    result = bare_study(20, ways=("address", "swing"), seed=4)
    for name in ("address", "swing"):
        rates = result.coverage(name, 0.9)
        # 20 intervals hold to 90 +- 7%: all eleven together hang loosely, so that their mean scatters by 3%. Deviations
        # half as large would hold 59%. Many swings are a study.
        assert 0.80 < np.mean(list(rates.values())) < 0.985, name
        assert min(rates.values()) >= 0.65, (name, rates)
    # The face is known by the loss of speed to some degrees only, and rates do not need to know where it looks.
    stated = {name: result.stated(name) for name in result.errors}
    assert stated["swing"]["face"] > 1.3 * stated["address"]["face"]
    assert stated["swing"]["closure"] == pytest.approx(stated["address"]["closure"], rel=0.05)


@pytest.mark.study
@pytest.mark.parametrize(("club", "hand"), [("driver", "right"), ("7-iron", "left")])
def test_ninety_percent_hold_the_truth_in_many_swings_of_bare_files(club, hand):
    result = bare_study(200, club=club, hand=hand, seed=5)
    for name in WAYS:
        read = np.isfinite(result.errors[name][:, 0]).mean()
        # An impact far off centre spins an iron so fast that the swing alone may not calibrate it; that is refused. So
        # are three of these 200 irons however they are calibrated: their markers seem to lose 8% of the speed or less.
        assert read > (0.75 if name == "swing" else 0.98), name
        for quantity, rate in result.coverage(name, 0.9).items():
            # 200 intervals scatter by 2.1%, to first order: 80 to 98% is four to five times that about 90%.
            assert 0.80 <= rate <= 0.98, (name, quantity, rate)


def guessed_ball(seed, by, **changes):
    """A swing seen by five markers whose ball somebody put ``by`` metres further to the target."""
    swing = random_swing(seed)
    cameras = Cameras(rate=360.0, noise=2e-4)
    recording = cameras.record(swing, seed)
    place = recording.positions[0, 5] + [0.0, by, 0.0]  # the target is +y
    recording = replace(recording, labels=recording.labels[:5], positions=recording.positions[:, :5])
    mapping = replace(positions_map(swing.club, cameras), ball=None, ball_position=tuple(place), **changes)
    return swing, recording, mapping


def test_a_ball_that_is_guessed_wrongly_does_not_turn_the_face():
    for seed, by in ((1, 0.07), (2, -0.07), (3, 0.0)):
        swing, recording, mapping = guessed_ball(seed, by, ball_accuracy=0.05)
        result = capture(recording, prepare(mapping, swing.club))
        assert np.abs(errors(result, swing) / deviations(result)).max() < 4.0
        assert result.delivery.face == pytest.approx(swing.truth["face"], abs=np.radians(0.8))
        assert result.uncertainty["face"] < np.radians(0.6)


def test_a_guessed_ball_is_as_uncertain_as_it_is_said_where_no_impact_is_seen():
    swing, recording, mapping = guessed_ball(1, -0.03, ball_accuracy=0.07)
    positions = recording.positions.copy()
    positions[int(0.25 * 360) + 4 :] = np.nan  # three frames after impact
    result = capture(replace(recording, positions=positions), prepare(mapping, swing.club))
    assert "capture-ball-place-alone" in codes(result)
    # 70 mm at 49 m/s are 1.4 ms, in which a face that closes with 2600 deg/s turns by 3.7 degrees.
    expected = swing.truth["closure"] * 0.07 / swing.truth["speed"]
    assert result.uncertainty["face"] == pytest.approx(expected, rel=0.25)
    assert abs(result.delivery.face - swing.truth["face"]) < 2.0 * result.uncertainty["face"]


def test_a_position_without_accuracy_is_not_taken_to_be_exact():
    swing, recording, mapping = guessed_ball(1, 0.0)
    untold = replace(mapping, accuracy=None)
    assert untold.ball_deviation == 0.010
    assert untold.position_deviation == 0.001
    result = capture(recording, prepare(untold, swing.club))
    assert known(result, "centre of the ball").deviations == [0.010]
    assert result.uncertainty["loft"] > capture(recording, prepare(mapping, swing.club)).uncertainty["loft"]


def test_a_ball_far_from_where_the_head_slows_is_noted():
    swing, recording, mapping = guessed_ball(1, 0.15, ball_accuracy=0.01)
    (contradiction,) = noted(capture(recording, prepare(mapping, swing.club)), "capture-contradicts-ball")
    assert contradiction["surprise"] > 2.5


def test_a_swing_without_a_ball_has_no_impact():
    swing, recorded = bare(5)
    free = replace(swing, slowed=(np.zeros(3), np.zeros(3)))
    recorded = record_bare(free, CAMERAS, 5)
    for by in ("address", "swing"):
        with pytest.raises(FileError, match=r"nowhere loses speed as at impact \(at most \d+% .*under \[ball\]"):
            read(free, recorded, by)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"frames": (1, 9000)}, r"frames of the address are \[1, 9000\].* frames 1 to \d+;"),
        ({"frames": (500, 560)}, None),
    ],
)
def test_frames_of_the_address_can_be_named(change, message):
    swing, recorded = bare(5)
    if message is None:
        # Frames of the backswing: the head is anything but square there, and the delivery is nonsense that is told.
        with pytest.raises(
            FileError, match=r"not plausible.*frames under \[calibration\].*frames 500 to 560"
        ) as refused:
            read(swing, recorded, **change)
        assert "as the target axis" not in str(refused.value)  # that would not help
        return
    with pytest.raises(FileError, match=message):
        read(swing, recorded, **change)


def test_a_file_without_an_address_says_what_to_do():
    swing, recorded = bare(5)
    late = replace(recorded.recording, positions=recorded.recording.positions[230:])
    with pytest.raises(FileError, match=r'no address: .* by = "swing"'):
        capture(late, prepare(bare_map(swing.club, CAMERAS), swing.club))
    assert capture(late, prepare(bare_map(swing.club, CAMERAS, "swing"), swing.club)).delivery.speed > 40.0


def test_a_wrong_axis_or_hand_is_noted_where_nothing_else_contradicts_it():
    swing, recorded = bare(5)
    assert not {"capture-path", "capture-face-opens"} & codes(read(swing, recorded))
    assert "capture-path" in codes(read(swing, recorded, target="+x"))
    mapping = bare_map(swing.club, CAMERAS)
    left = capture(recorded.recording, prepare(mapping, swing.club, hand="left"))
    assert "capture-face-opens" in codes(left)


def test_the_address_may_be_a_file_of_its_own(tmp_path):
    from clubface.capture.recording import write_c3d

    swing, recorded = bare(5)
    rest = replace(recorded.recording, positions=recorded.recording.positions[:200])
    write_c3d(rest, tmp_path / "address.c3d")
    mapping = replace(bare_map(swing.club, CAMERAS), calibration="address.c3d", path=str(tmp_path / "map.toml"))
    result = capture(recorded.recording, prepare(mapping, swing.club))
    assert result.delivery.face == pytest.approx(read(swing, recorded).delivery.face, abs=np.radians(0.05))
    assert noted(result, "capture-address-of-file")[0]["file"].endswith("address.c3d")


def test_a_mapping_of_a_bare_file_reads_back_as_it_was_written():
    club = clubface.club("driver")
    made = replace(
        bare_map(club, CAMERAS), frames=(1, 90), ball_position=(0.0, 1.0, 0.0), ball_accuracy=0.03,
        assumed=Assumed(face=np.radians(3.0), toe=0.02),
    )  # fmt: skip
    result = MarkerMap.from_text(made.to_toml())
    assert (result.by, result.frames, result.ground, result.ball_accuracy) == ("address", (1, 90), 0.01, 0.03)
    assert (result.assumed.face, result.assumed.toe) == (pytest.approx(np.radians(3.0)), 0.02)
    assert result.assumed.lie == Assumed().lie


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"by": "adress"}, r"unknown by 'adress' \(did you mean address\?\)"),
        (
            {"by": "swing", "ground": 0.0},
            r'ground is 0\.0; leave it out, or give by = "address"; by = "swing"',
        ),
        ({"by": "positions"}, "without the position of A, B, C"),
        ({"frames": (90, 1)}, r"the first and the last frame of the address"),
        ({"by": None}, r'give one of these: positions .*by = "address" .*by = "swing"'),
    ],
)
def test_a_mapping_that_lacks_its_calibration_says_which_there_are(changes, message):
    good = MarkerMap(cluster=dict.fromkeys("ABC"), by="address")
    with pytest.raises(InputError, match=message):
        replace(good, **changes)
    with pytest.raises(InputError, match="above 0"):
        Assumed(toe=0.0)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("S:C1 = 'seen'", r'map\.toml:2: this is not TOML.*put the name into quotes: "S:C1" = \.\.\.'),
        ("C = 'seen'\n[assumed]\nface = '-2 deg'", r"map\.toml:4: assumed.face is '-2 deg'; it must be above 0"),
        ("S.C1 = 'seen'", r"map\.toml:2: cluster.S is .* in quotes"),
    ],
)
def test_a_line_that_cannot_be_used_is_reported_with_what_to_write(line, message):
    with pytest.raises(FileError, match=message):
        MarkerMap.from_text(f"[cluster]\n{line}\n", "map.toml")


def test_the_template_names_the_markers_of_a_file_in_quotes_where_they_need_them():
    from clubface.capture.markers import template

    text = template(["Subject:CLUB1", "HEAD", "A B"])
    assert '\n"Subject:CLUB1" = "seen"\nHEAD = "seen"\n"A B" = "seen"\n' in text
    assert list(MarkerMap.from_text(text).cluster) == ["Subject:CLUB1", "HEAD", "A B"]


def test_the_picture_shows_the_frames_and_the_delivery():
    pytest.importorskip("matplotlib")
    from clubface.capture.captured import swing_picture
    from clubface.present.drawing import draw

    swing = random_swing(5, hand="left", face=0.08)
    result = read(swing, record_bare(swing, CAMERAS, 5))
    side, above, _, face, left = draw(swing_picture(result)).axes
    assert f"attack angle of {np.degrees(result.delivery.attack):.1f}" in side.get_title(loc="left")
    assert f"path of {np.degrees(result.delivery.path):.1f}" in above.get_title(loc="left")
    [point] = [each for each in face.lines if each.get_marker() == "s"]
    assert point.get_ydata()[0] == pytest.approx(np.degrees(result.delivery.face))
    # From the last frame before impact the face turns on, for the part of a frame that is left; noise is 0.3 degrees.
    when, before = face.lines[0].get_data()
    ahead = before[-1] - when[-1] * (before[-1] - before[-2]) / (when[-1] - when[-2])
    assert ahead == pytest.approx(np.degrees(result.delivery.face), abs=1.5)
    assert np.nanmean(left.lines[0].get_ydata()) == pytest.approx(0.3, rel=0.15)


@pytest.mark.parametrize("by", ["address", "swing"])
def test_whatever_happens_to_a_bare_recording_it_is_read_or_refused(by):
    """Recordings hidden, shifted, cut, shuffled, reversed and scaled in part; numpy must not warn either."""
    import warnings

    swing, recorded = bare(5)
    ready = prepare(bare_map(swing.club, CAMERAS, by), swing.club)
    random = np.random.default_rng(6)
    outcomes = []
    for number in range(24):
        positions = recorded.recording.positions.copy()
        first, last = np.sort(random.integers(0, len(positions), 2))
        if number % 2:
            first, last = np.sort(len(positions) - 1 - random.integers(0, 40, 2))  # about impact
        some = random.permutation(3)[: random.integers(1, 4)]
        positions = damaged(positions, number, first, last, some, random)
        with warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            try:
                result = capture(replace(recorded.recording, positions=positions), ready)
                assert np.isfinite(list(result.uncertainty.values())).all()
                outcomes.append("read")
            except FileError:
                outcomes.append("refused")
    assert 3 < outcomes.count("refused") < 24


def test_the_instant_of_impact_is_less_certain_where_the_paths_do_not_meet():
    swing, recorded = bare(5)
    times = []
    for up in (0.0, 5e-3):
        positions = recorded.recording.positions.copy()
        # As by cameras that were knocked: all after impact, which is in frame 631, lies 5 mm higher.
        positions[631:, :, 2] += up
        result = read(swing, replace(recorded, recording=replace(recorded.recording, positions=positions)))
        times.append(known(result, "instant of first touch").deviations[0])
    # Half of what contact times differ by, 0.05 ms, and the paths: 0.3 mm of a speed lost of some 10 m/s.
    assert 0.05e-3 < times[0] < 0.1e-3
    assert times[1] > 1.5 * times[0]
