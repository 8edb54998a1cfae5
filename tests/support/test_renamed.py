"""Old names work for one minor version, say what they are called now, and go in time."""

import warnings

import pytest

from clubface import __version__, fem
from clubface.support import checks
from clubface.support.renamed import GONE_WITH, renamed_arguments


@pytest.fixture(autouse=True)
def forget_warnings(monkeypatch):
    monkeypatch.setattr(checks, "_given", {})


@renamed_arguments(which="ball")
def mass(club, *, ball=None):
    """Return what came in."""
    return club, ball


def test_an_argument_by_its_old_name_arrives_and_draws_a_warning_that_has_the_new_one():
    with pytest.warns(DeprecationWarning, match="'which' of mass.. is called 'ball' now") as caught:
        assert mass("driver", which="modern") == ("driver", "modern")
    assert caught[0].filename == __file__


def test_the_new_name_draws_no_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert mass("driver", ball="modern") == ("driver", "modern")


def test_both_names_at_once_are_refused():
    with pytest.raises(TypeError, match="'ball' twice"):
        mass("driver", which="modern", ball="distance")


def test_finite_elements_take_the_ball_by_the_name_that_it_had():
    with pytest.warns(DeprecationWarning, match="'ball'"):
        assert fem.variables("driver", which="modern") == fem.variables("driver", ball="modern")


def test_no_old_name_outlives_the_minor_version_in_which_it_was_given_up():
    now, gone = ([int(part) for part in each.split(".")[:2]] for each in (__version__, GONE_WITH))
    assert now < gone, "take out the old names (_MOVED, renamed_arguments), and raise GONE_WITH"
