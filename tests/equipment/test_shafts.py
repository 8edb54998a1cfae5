"""Shafts as data, and what they add to a head."""

import numpy as np
import pytest

import clubface
from clubface import Shaft
from clubface.equipment.shafts import shaft, shaft_names
from clubface.errors import ClubfaceError, InputError

CLUBS = {"graphite": "driver", "steel": "7-iron"}


@pytest.mark.parametrize("name", shaft_names())
def test_a_shaft_written_to_a_file_reads_back_the_same(name, tmp_path):
    path = tmp_path / "shaft.toml"
    path.write_text(shaft(name).to_toml())
    assert shaft(path) == Shaft.builtin(name)


def test_the_template_is_a_shaft():
    assert Shaft.from_text(Shaft.template()).name == "my-shaft"


def test_builtin_shafts_weigh_what_their_descriptions_say():
    # Masses per length have three digits or four.
    assert shaft("graphite").mass == pytest.approx(0.062, rel=1e-3)
    assert shaft("steel").mass == pytest.approx(0.120, rel=1e-3)
    assert shaft("graphite").length == pytest.approx(1.05)


@pytest.mark.parametrize(("name", "club"), CLUBS.items())
@pytest.mark.parametrize("grip", ["free", "pinned", "clamped"])
@pytest.mark.parametrize(
    ("time", "matching"), [("200 us", "motion"), ("450 us", "motion"), ("450 us", "work"), ("1500 us", "work")]
)
def test_no_motion_of_the_head_is_pushed_along(name, club, grip, time, matching):
    each = clubface.club(club)
    added = np.array(shaft(name).replace(grip=grip).added_inertia(each, contact_time=time, matching=matching))
    assert (added == added.T).all()
    size = np.sqrt(np.diag(added))
    # Directions are made comparable; rounding of the inverse of the mobility is 1e-12 of the head's own.
    assert np.linalg.eigvalsh(added / np.outer(size, size))[0] > -1e-9
    assert each.replace(added_inertia=added).added_inertia is not None  # the core agrees


def test_the_hands_are_too_far_away_to_matter():
    # Bending waves come 0.4 m far in a contact; only waves along the shaft return, and change 2% of what it adds.
    driver = clubface.club("driver")
    free, clamped = (
        driver.on_shaft(shaft("graphite").replace(grip=grip)).effective_mass for grip in ("free", "clamped")
    )
    added = free - driver.effective_mass
    assert abs(clamped - free) < 0.05 * added


def test_a_heavier_shaft_adds_more():
    driver = clubface.club("driver")
    light = shaft("graphite")
    heavy = light.replace(mass_per_length=[1.3 * each for each in light.mass_per_length])
    masses = [driver.on_shaft(each).effective_mass for each in (light, heavy)]
    assert driver.effective_mass < masses[0] < masses[1]


def test_a_spring_holds_the_hands_between_pinned_and_clamped():
    driver = clubface.club("driver")
    # In 2 ms waves return from the hands.
    pinned, soft, stiff, clamped = (
        driver.on_shaft(shaft("graphite").replace(**grip), contact_time="2 ms", matching="work").added_inertia[0][0]
        for grip in (
            {"grip": "pinned"},
            {"grip": "pinned", "grip_stiffness": 100.0},
            {"grip": "pinned", "grip_stiffness": 1e7},
            {"grip": "clamped"},
        )
    )
    assert (pinned < soft < stiff) or (pinned > soft > stiff)
    assert stiff == pytest.approx(clamped, rel=1e-4)  # a spring some 200 000 times as stiff as the shaft


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"position": ["0 mm", "500 mm", "400 mm", "800 mm", "900 mm"]}, "increasing"),
        ({"position": ["10 mm", "500 mm", "600 mm", "800 mm", "900 mm"]}, "0 mm at the tip"),
        ({"diameter": ["8 mm", "9 mm"]}, "one for each station"),
        ({"mass_per_length": [0.06, 0.06, -0.01, 0.06, 0.06]}, "above 0"),
        ({"grip": "loose"}, "clamped"),
        ({"grip_stiffness": 10.0}, "pinned"),
        ({"lie": "120 deg"}, "90"),
        ({"colour": "red"}, "colour"),
    ],
)
def test_a_mistake_in_a_shaft_is_named(change, words):
    with pytest.raises(ClubfaceError, match=words):
        shaft("graphite").replace(**change)


def test_an_unknown_shaft_and_a_time_that_no_contact_has_are_refused():
    with pytest.raises(ClubfaceError, match="graphite"):
        clubface.club("driver").on_shaft("titanium")
    with pytest.raises(InputError, match="50 to 2000 us"):
        clubface.club("driver").on_shaft("graphite", contact_time="5 s")
