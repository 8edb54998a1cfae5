"""What is remarked of a captured delivery: nothing of a usual one, and each limit on its own side."""

import math

import numpy as np
import pytest

import clubface
from clubface import units
from clubface.capture.ball_flight import Launched
from clubface.capture.remarks import delivery_notes, fit_notes, launch_notes

DEG = math.pi / 180
DRIVER = clubface.club("driver")
USUAL = {
    "speed": 47.0, "attack": "2 deg", "path": "-2 deg", "loft": "14 deg", "face": "1 deg", "lie": "3 deg",
    "closure": "2500 deg/s", "pitch_rate": 0.0, "lie_rate": 0.0, "toe": "5 mm", "high": "3 mm",
}  # fmt: skip
DIMENSIONS = {"closure": "angular rate", "toe": "length", "high": "length"}


def si(values):
    return {
        name: units.parse(value, DIMENSIONS.get(name, "angle")) if isinstance(value, str) else value
        for name, value in values.items()
    }


def remarks(deviations=None, assumed=0.0, **changed):
    known = dict.fromkeys(USUAL, 0.0) | si(deviations or {})
    return [(each.code, each.data) for each in delivery_notes(si(USUAL | changed), known, DRIVER, assumed=assumed)]


def test_a_usual_delivery_has_no_remarks_with_or_without_a_flight():
    assert remarks() == []
    assert list(launch_notes(si(USUAL), DRIVER, None, None, 1.0)) == []


@pytest.mark.parametrize(
    ("name", "usual", "odd", "code"),
    [
        # The face is 105 mm wide and 55 mm high.
        ("toe", "52 mm", "53 mm", "off-face"),
        ("toe", "-52 mm", "-53 mm", "off-face"),
        ("high", "27 mm", "28 mm", "off-face"),
        # A putt of 0.3 m/s; long drivers reach 67 m/s.
        ("speed", 0.31, 0.29, "speed"),
        ("speed", 69.0, 120.0, "speed"),
        # The static loft is 9.8 degrees.
        ("loft", "34.7 deg", "34.9 deg", "loft"),
        ("loft", "-15.1 deg", "-15.3 deg", "loft"),
        ("lie", "44 deg", "46 deg", "lie"),
        ("lie", "-44 deg", "-46 deg", "lie"),
        ("path", "29 deg", "31 deg", "path"),
        ("path", "-29 deg", "-31 deg", "path"),
        ("closure", "-490 deg/s", "-510 deg/s", "face-opens"),
    ],
)
def test_a_value_is_doubted_beyond_its_limit_and_not_before(name, usual, odd, code):
    assert remarks(**{name: usual}) == []
    ((noted, data),) = remarks(**{name: odd})
    assert noted == f"capture-{code}"
    assert data[name] == si({name: odd})[name]


def test_an_impact_off_the_face_names_the_face():
    ((_, data),) = remarks(toe="53 mm")
    assert (data["club"], data["face_width"], data["face_height"]) == ("driver", DRIVER.face_width, DRIVER.face_height)


def test_a_closure_that_is_hardly_known_is_not_doubted():
    # Three standard deviations beside the limit of 500 deg/s.
    assert remarks({"closure": "170 deg/s"}, closure="-1000 deg/s") == []
    assert len(remarks({"closure": "160 deg/s"}, closure="-1000 deg/s")) == 1


def test_a_loft_that_is_not_known_to_two_degrees_is_noted_unless_it_was_assumed():
    assert remarks({"loft": "1.9 deg"}) == []
    assert remarks({"loft": "2.1 deg"}) == [("capture-loft-uncertain", {})]
    # What was assumed is known from the start; the rest, in squares, is what the markers do not know.
    assert remarks({"loft": "3 deg"}, assumed=units.to_si(2.5, "deg")) == []  # the rest: 1.66 degrees
    assert len(remarks({"loft": "3 deg"}, assumed=units.to_si(2.0, "deg"))) == 1  # 2.24 degrees


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ((1.0, 1, 100), []), ((1.49, 1, 30), []), ((1.0, 0, 0), []),
        ((1.0, 2, 100), [("capture-path-extended", {"missing": 2})]),
        ((1.6, 0, 100), [("capture-path-misfit", {"misfit": 1.6})]),
        ((1.0, 0, 29), [("capture-few-degrees-of-freedom", {"freedom": 29})]),
        ((1.0, 0, 1), [("capture-few-degrees-of-freedom", {"freedom": 1})]),
    ],
)  # fmt: skip
def test_a_path_is_doubted_where_it_misses_frames_noise_or_freedom(given, expected):
    assert list(fit_notes(*given)) == expected


def launched(*, late=0.2e-3, faster=1.0, higher=0.0, sideways=0.0, known=0.0):
    """The flight of the ball that the usual delivery gives, changed."""
    struck = clubface.impact(DRIVER, si(USUAL))
    speed, launch, azimuth = struck.ball_speed * faster, struck.launch + higher, struck.azimuth + sideways
    velocity = speed * np.array([np.cos(launch) * np.cos(azimuth), np.sin(launch), np.cos(launch) * np.sin(azimuth)])
    return Launched(velocity, np.eye(3) * (known * speed) ** 2, 1.0 + late, 9)


@pytest.mark.parametrize(
    ("change", "codes"),
    [
        ({}, []), ({"late": -0.29e-3}, []), ({"late": 0.74e-3}, []),
        ({"late": -0.31e-3}, ["ball-start"]),
        ({"late": 0.76e-3}, ["ball-starts-late"]),
        # Six degrees, 15% of the speed, and three standard deviations beside both.
        ({"higher": 5.9 * DEG}, []), ({"higher": 6.1 * DEG}, ["flight-contradicts"]),
        ({"sideways": -5.9 * DEG}, []), ({"sideways": -6.1 * DEG}, ["flight-contradicts"]),
        ({"faster": 1.149}, []), ({"faster": 1.151}, ["flight-contradicts"]),
        ({"faster": 0.851}, []), ({"faster": 0.849}, ["flight-contradicts"]),
        ({"faster": 1.2, "known": 0.02}, []), ({"faster": 1.2, "known": 0.016}, ["flight-contradicts"]),
        ({"higher": 7.5 * DEG, "known": 0.01}, []), ({"higher": 8 * DEG, "known": 0.01}, ["flight-contradicts"]),
    ],
)  # fmt: skip
@pytest.mark.filterwarnings("ignore::clubface.errors.RangeWarning")
def test_a_flight_that_the_delivery_cannot_give_is_noted(change, codes):
    result = list(launch_notes(si(USUAL), DRIVER, None, launched(**change), 1.0))
    assert [each.code for each in result] == [f"capture-{code}" for code in codes]
    for each in result:
        if "late" in change:
            assert each.data["late_time"] == pytest.approx(change["late"])
        else:
            ratio = each.data["seen"]["ball_speed"] / each.data["expected"]["ball_speed"]
            assert ratio == pytest.approx(change.get("faster", 1.0))
