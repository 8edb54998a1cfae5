"""What is remarked of a captured delivery: nothing of a usual one, and each limit on its own side."""

import math

import numpy as np
import pytest

import clubface
from clubface import units
from clubface.capture.ball_flight import Launched
from clubface.capture.remarks import delivery_remarks, fit_remarks, launch_remarks

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
    return delivery_remarks(si(USUAL | changed), known, DRIVER, assumed=assumed)


def test_nothing_is_remarked_of_a_usual_delivery():
    assert remarks() == []


@pytest.mark.parametrize(
    ("name", "usual", "odd", "words"),
    [
        # The face is 105 mm wide and 55 mm high.
        ("toe", "52 mm", "53 mm", "53.0 mm towards the toe and 3.0 mm high, outside the face of driver (105 x 55 mm)"),
        ("toe", "-52 mm", "-53 mm", "-53.0 mm towards the toe"),
        ("high", "27 mm", "28 mm", "28.0 mm high, outside the face"),
        # A putt of 0.3 m/s; long drivers reach 67 m/s.
        ("speed", 0.31, 0.29, "a clubhead of 0.29 m/s: the unit of length"),
        ("speed", 69.0, 120.0, "a clubhead of 120 m/s: the unit of length"),
        # The static loft is 9.8 degrees.
        ("loft", "34.7 deg", "34.9 deg", "the dynamic loft of 34.9 deg is far from the 9.8 deg of driver"),
        ("loft", "-15.1 deg", "-15.3 deg", "the dynamic loft of -15.3 deg is far"),
        ("lie", "44 deg", "46 deg", "the lie of 46 deg is no club's"),
        ("lie", "-44 deg", "-46 deg", "the lie of -46 deg is no club's"),
        ("path", "29 deg", "31 deg", "goes 31 deg to the right of the target"),
        ("path", "-29 deg", "-31 deg", "goes -31 deg to the right of the target"),
        ("closure", "-490 deg/s", "-510 deg/s", "the face opens through impact, with 510 deg/s"),
    ],
)
def test_a_value_is_doubted_beyond_its_limit_and_not_before(name, usual, odd, words):
    assert remarks(**{name: usual}) == []
    (message,) = remarks(**{name: odd})
    assert words in message


def test_a_closure_that_is_hardly_known_is_not_doubted():
    # Three standard deviations beside the limit of 500 deg/s.
    assert remarks({"closure": "170 deg/s"}, closure="-1000 deg/s") == []
    assert len(remarks({"closure": "160 deg/s"}, closure="-1000 deg/s")) == 1


def test_a_loft_that_is_not_known_to_two_degrees_is_told_unless_it_was_assumed():
    assert remarks({"loft": "1.9 deg"}) == []
    (message,) = remarks({"loft": "2.1 deg"})
    assert "the dynamic loft is not known to 2 deg" in message
    # What was assumed is known from the start; the rest, in squares, is what the markers do not know.
    assert remarks({"loft": "3 deg"}, assumed=units.to_si(2.5, "deg")) == []  # the rest: 1.66 degrees
    assert len(remarks({"loft": "3 deg"}, assumed=units.to_si(2.0, "deg"))) == 1  # 2.24 degrees


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ((1.0, 1, 100), []), ((1.49, 1, 30), []), ((1.0, 0, 0), []),
        ((1.0, 2, 100), ["the last 2 frames before impact do not show"]),
        ((1.6, 0, 100), ["departs from the estimator's by 1.6 times the variance expected"]),
        ((1.0, 0, 29), ["estimated from 29 degrees of freedom only"]),
        ((1.0, 0, 1), ["estimated from 1 degrees of freedom only"]),
    ],
)  # fmt: skip
def test_a_path_is_doubted_where_it_misses_frames_noise_or_freedom(given, message):
    result = fit_remarks(*given)
    assert len(result) == len(message)
    assert all(words in note for words, note in zip(message, result, strict=True))


def launched(*, late=0.2e-3, faster=1.0, higher=0.0, aside=0.0, known=0.0):
    """The flight of the ball that the usual delivery gives, changed."""
    hit = clubface.impact(DRIVER, si(USUAL))
    speed, launch, azimuth = hit.ball_speed * faster, hit.launch + higher, hit.azimuth + aside
    velocity = speed * np.array([np.cos(launch) * np.cos(azimuth), np.sin(launch), np.cos(launch) * np.sin(azimuth)])
    return Launched(velocity, np.eye(3) * (known * speed) ** 2, 1.0 + late, 9)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({}, []), ({"late": -0.29e-3}, []), ({"late": 0.74e-3}, []),
        ({"late": -0.31e-3}, ["the ball starts -0.31 ms after"]),
        ({"late": 0.76e-3}, ["the ball starts 0.76 ms after"]),
        # Six degrees, 15% of the speed, and three standard deviations beside both.
        ({"higher": 5.9 * DEG}, []), ({"higher": 6.1 * DEG}, ["the ball flies off with"]),
        ({"aside": -5.9 * DEG}, []), ({"aside": -6.1 * DEG}, ["the ball flies off with"]),
        ({"faster": 1.149}, []), ({"faster": 1.151}, ["the ball flies off with"]),
        ({"faster": 0.851}, []), ({"faster": 0.849}, ["the ball flies off with"]),
        ({"faster": 1.2, "known": 0.02}, []), ({"faster": 1.2, "known": 0.016}, ["the ball flies off with"]),
        ({"higher": 7.5 * DEG, "known": 0.01}, []), ({"higher": 8 * DEG, "known": 0.01}, ["the ball flies off with"]),
    ],
)  # fmt: skip
@pytest.mark.filterwarnings("ignore::clubface.errors.RangeWarning")
def test_a_flight_that_the_delivery_cannot_give_is_told(change, message):
    result = launch_remarks(si(USUAL), DRIVER, None, launched(**change), 1.0)
    assert len(result) == len(message)
    assert all(words in note for words, note in zip(message, result, strict=True))


def test_without_a_flight_nothing_is_said_of_it():
    assert launch_remarks(si(USUAL), DRIVER, None, None, 1.0) == []
