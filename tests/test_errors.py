"""Errors say what, where and what is allowed, and survive the way between processes."""

import pickle

import pytest

from clubface.errors import ClubfaceError, FileError, InputError, Told, UnitError, UnknownNameError, nearest_names

EXAMPLES = [
    InputError("mass", -1.0, "above 0 kg"),
    UnitError("loft", "3 kg", "an angle"),
    UnknownNameError("club", "drivr", ["driver", "hybrid"]),
    FileError("mine.toml", 7, "unknown key", "mas"),
]


@pytest.mark.parametrize("error", EXAMPLES, ids=lambda error: type(error).__name__)
def test_every_error_is_a_clubface_error_and_a_value_error(error):
    assert isinstance(error, ClubfaceError)
    assert isinstance(error, ValueError)


@pytest.mark.parametrize("error", EXAMPLES, ids=lambda error: type(error).__name__)
def test_an_error_crosses_a_process_boundary_whole(error):
    copy = pickle.loads(pickle.dumps(error))
    assert str(copy) == str(error)
    assert vars(copy) == vars(error)


def test_an_input_error_names_parameter_value_and_range():
    assert str(EXAMPLES[0]) == "mass is -1.0; it must be above 0 kg"


def test_an_input_error_says_what_is_missing_and_what_to_do_instead():
    assert str(InputError("speed", None, "above 0 m/s")) == "speed is missing; it must be above 0 m/s"
    assert str(InputError("mass", "3 g", "leave it out")) == "mass is '3 g'; leave it out"
    twice = InputError("ball", Told("given twice"), "give either its marker or its position")
    assert str(twice) == "ball is given twice; give either its marker or its position"
    assert str(pickle.loads(pickle.dumps(twice))) == str(twice)


def test_an_unknown_name_is_a_key_error_with_a_readable_message():
    error = EXAMPLES[2]
    assert isinstance(error, KeyError)
    assert str(error) == "unknown club 'drivr' (did you mean driver?); it must be one of driver, hybrid"


def test_a_file_error_starts_with_file_and_line():
    assert str(EXAMPLES[3]) == "mine.toml:7: unknown key"
    assert str(FileError("mine.toml", None, "empty")) == "mine.toml: empty"


def test_a_huge_value_does_not_flood_the_message():
    assert len(str(InputError("speed", "9" * 10**6, "finite"))) < 150


def test_nearest_names_ignore_case_and_put_the_best_first():
    assert nearest_names("DRIVR", ["hybrid", "driver", "drive"])[0] == "driver"
    assert nearest_names("zzz", ["driver"]) == ()
