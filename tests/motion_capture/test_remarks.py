"""What is remarked of a captured delivery: nothing of a usual one, and each limit on its own side."""

import pytest

import clubface
from clubface import units
from clubface.motion_capture import checks

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
    return checks.of_delivery(si(USUAL | changed), known, DRIVER, assumed=assumed)


def test_nothing_is_remarked_of_a_usual_delivery():
    assert remarks() == []


@pytest.mark.parametrize(
    ("name", "usual", "odd", "said"),
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
def test_a_value_is_doubted_beyond_its_limit_and_not_before(name, usual, odd, said):
    assert remarks(**{name: usual}) == []
    (told,) = remarks(**{name: odd})
    assert said in told


def test_a_closure_that_is_hardly_known_is_not_doubted():
    # Three standard deviations beside the limit of 500 deg/s.
    assert remarks({"closure": "170 deg/s"}, closure="-1000 deg/s") == []
    assert len(remarks({"closure": "160 deg/s"}, closure="-1000 deg/s")) == 1


def test_a_loft_that_is_not_known_to_two_degrees_is_told_unless_it_was_assumed():
    assert remarks({"loft": "1.9 deg"}) == []
    (told,) = remarks({"loft": "2.1 deg"})
    assert "the dynamic loft is not known to 2 deg" in told
    # What was assumed is known from the start; the rest, in squares, is what the markers do not know.
    assert remarks({"loft": "3 deg"}, assumed=units.to_si(2.5, "deg")) == []  # the rest: 1.66 degrees
    assert len(remarks({"loft": "3 deg"}, assumed=units.to_si(2.0, "deg"))) == 1  # 2.24 degrees
