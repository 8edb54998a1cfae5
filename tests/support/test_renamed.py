"""Old names work for one minor version, say what they are called now, and go in time."""

import warnings

import pytest

from clubface import __version__, design, fem
from clubface.cli import options
from clubface.design import shells
from clubface.errors import InputError
from clubface.fem import stress
from clubface.support import checks
from clubface.support.renamed import GONE_WITH, renamed_arguments


@pytest.fixture(autouse=True)
def forget_warnings(monkeypatch):
    monkeypatch.setattr(checks, "_given", {})


@renamed_arguments(which="ball")
def mass(club, *, ball=None):
    """Return what came in."""
    return club, ball


def test_an_argument_by_its_old_name_arrives_with_a_warning_and_not_beside_the_new_one():
    with pytest.warns(DeprecationWarning, match="'which' of mass.. is called 'ball' now") as caught:
        assert mass("driver", which="modern") == ("driver", "modern")
    assert caught[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert mass("driver", ball="modern") == ("driver", "modern")
    with pytest.raises(TypeError, match="'ball' twice"):
        mass("driver", which="modern", ball="distance")


def test_finite_elements_take_the_ball_by_the_name_that_it_had():
    with pytest.warns(DeprecationWarning, match="'ball'"):
        assert fem.variables("driver", which="modern") == fem.variables("driver", ball="modern")


@pytest.mark.parametrize(("module", "old", "new"), [
    (shells, "Blow", "FaceImpact"), (stress, "BlowStress", "ImpactStress"), (stress, "blow_stress", "impact_stress"),
    (design, "Doubts", "SpreadSensitivity"),
])  # fmt: skip
def test_a_module_has_its_names_by_their_old_ones_with_a_warning(module, old, new):
    with pytest.warns(DeprecationWarning, match=f"{module.__name__}.{old} is called {new} now"):
        assert getattr(module, old) is getattr(module, new)


def test_a_name_that_a_module_never_had_is_an_error():
    with pytest.raises(AttributeError, match=r"'clubface\.design\.shells' has no attribute 'Blo'"):
        shells.Blo  # noqa: B018


def test_an_option_by_its_old_name_arrives_and_with_the_new_one_is_refused():
    texts = {"impact_speed": None, "blow": "50 m/s"}
    with pytest.warns(DeprecationWarning, match="--blow is called --impact-speed now"):
        options.take_renamed(texts, blow="impact_speed")
    assert texts == {"impact_speed": "50 m/s"}
    with pytest.raises(InputError, match=r"--blow is '50 m/s'.*--impact-speed"):
        options.take_renamed({"impact_speed": "60 m/s", "blow": "50 m/s"}, blow="impact_speed")


def test_no_old_name_outlives_the_minor_version_in_which_it_was_given_up():
    now, gone = ([int(part) for part in each.split(".")[:2]] for each in (__version__, GONE_WITH))
    assert now < gone, "take out the old names (git grep renamed), and raise GONE_WITH"
