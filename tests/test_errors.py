"""Errors say what, where and what is allowed, and survive the way between processes."""

import pickle

import pytest

from clubface import club
from clubface.errors import (
    ClubfaceError,
    FileError,
    InputError,
    UnitError,
    UnknownNameError,
    Wording,
    in_a_line,
    nearest_names,
)

EXAMPLES = [
    InputError("mass", -1.0, "above 0 kg"),
    UnitError("loft", "3 kg", "an angle"),
    UnknownNameError("club", "drivr", ["driver", "hybrid"]),
    FileError("mine.toml", 7, "unknown key", "mas"),
]


@pytest.mark.parametrize(
    ("error", "message"),
    [
        (EXAMPLES[0], "mass is -1.0; it must be above 0 kg"),
        (InputError("speed", None, "above 0 m/s"), "speed is missing; it must be above 0 m/s"),
        (InputError("mass", "3 g", "leave it out"), "mass is '3 g'; leave it out"),
        (InputError("ball", Wording("given twice"), "give one"), "ball is given twice; give one"),
        (EXAMPLES[2], "unknown club 'drivr' (did you mean driver?); it must be one of driver, hybrid"),
        (EXAMPLES[3], "mine.toml:7: unknown key"),
        (FileError("mine.toml", None, "empty"), "mine.toml: empty"),
    ],
)  # fmt: skip
def test_an_error_says_what_where_and_what_to_do_also_in_another_process(error, message):
    assert str(error) == str(pickle.loads(pickle.dumps(error))) == message


def test_errors_are_those_that_python_code_expects():
    assert all(isinstance(error, ClubfaceError) and isinstance(error, ValueError) for error in EXAMPLES)
    assert isinstance(EXAMPLES[2], KeyError)


@pytest.mark.parametrize("error", EXAMPLES, ids=lambda error: type(error).__name__)
def test_an_error_crosses_a_process_boundary_whole(error):
    copy = pickle.loads(pickle.dumps(error))
    assert str(copy) == str(error)
    assert vars(copy) == vars(error)


def test_a_huge_value_does_not_flood_the_message():
    assert len(str(InputError("speed", "9" * 10**6, "finite"))) < 150
    # Of a value that is shown in many lines, the first stands for all.
    message = str(InputError("speed", club("driver").replace(description="a head"), "finite"))
    assert message == "speed is driver: a head...; it must be finite"


def test_nearest_names_ignore_case_and_put_the_best_first():
    assert nearest_names("DRIVR", ["hybrid", "driver", "drive"])[0] == "driver"
    assert nearest_names("zzz", ["driver"]) == ()


@pytest.mark.parametrize(
    "error",
    [
        FileError("shots.csv", 3, f"the cell {'x y ' * 5000!r} is no number"),
        FileError("shots.csv", 3, "z" * 10**6),
        FileError("shots.csv", 3, "word " * 10**5),
        FileError("/folder/" + "f" * 5000 + ".csv", 3, "empty"),
        InputError("x" * 10**5, 1.0, "above 0"),
        UnknownNameError("club", "d" * 10**5, ["driver"]),
        FileError("a\nb.csv", None, "sends \x1b[31m to the terminal"),
    ],
)
def test_a_message_is_one_line_whatever_was_given(error):
    assert str(error).isprintable()
    assert len(str(error)) <= 1000


def test_a_message_shortens_what_is_quoted_and_nothing_else():
    message = in_a_line(f"the ball's value {'a b ' * 100!r} of {'driver'!r} isn't allowed; the others' are 0 to 2")
    assert message.startswith("the ball's value 'a b a b ")
    assert message.endswith("' of 'driver' isn't allowed; the others' are 0 to 2")
    assert len(message) < 200
    plain = "the ball's own words, and the club's, " * 5
    assert in_a_line(plain) == plain
