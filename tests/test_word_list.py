"""Names that no engineer would look for are seen, each with a reason."""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "scripts"))
from check_words import PARAMETERS, WORDS, findings


def names(code):
    return [(line, name) for line, name, _ in findings(code)]


@pytest.mark.parametrize(
    ("code", "name"),
    [
        ("def told(x): pass", "told"),
        ("def _say_kept(): pass", "_say_kept"),
        ("class Found: pass", "Found"),
        ("result_found = 1", "result_found"),
        ("def loft(of): pass", "of"),
        ("def loft(*, which=None): pass", "which"),
    ],
)
def test_a_listed_word_is_seen_in_functions_classes_variables_and_parameters(code, name):
    assert names(code) == [(1, name)]


@pytest.mark.parametrize("code", ["foundation = 1", "def test_what_was_said(): pass", "x.found()", "loft_of = 1"])
def test_other_names_names_of_tests_and_what_others_named_are_left_alone(code):
    assert names(code) == []


def test_every_word_has_a_reason_and_a_better_one():
    assert all("write " in reason for reason in (*WORDS.values(), *PARAMETERS.values()))
