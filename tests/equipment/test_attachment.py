"""What shaft and hands add to the inertia of a club: as data, as inputs of the core, from a multibody program."""

import math
from dataclasses import replace

import numpy as np
import pytest

import clubface
from clubface import Club, fem
from clubface.errors import ClubfaceError, InputError
from clubface.simulation.results import inputs

DRIVE = {"speed": "113 mph", "attack": "-1 deg", "loft": "12 deg", "toe": "8 mm", "high": "-4 mm"}


def attached(*masses):
    """What masses [kg] at points from the CG [m] add when they are fixed to the head."""
    added = np.zeros((6, 6))
    for mass, (x, y, z) in masses:
        cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        added += mass * np.block([[np.eye(3), -cross], [cross, -cross @ cross]])
    return added


def test_a_head_with_a_mass_fixed_to_it_is_the_heavier_head():
    driver = clubface.club("driver")
    point = np.array([-0.03, 0.02, -0.05])
    part = driver.replace(added_inertia=attached((0.01, point)))
    # The same body by mass, CG and inertia of the whole; its CG moves as that of the head, which does not turn.
    centre = point * 0.01 / 0.214
    cg = np.array(driver.cg) - centre
    inertia = np.array(driver.inertia) + attached((0.01, point))[3:, 3:] - attached((0.214, centre))[3:, 3:]
    names = {"ixx": (0, 0), "iyy": (1, 1), "izz": (2, 2), "ixy": (0, 1), "ixz": (0, 2), "iyz": (1, 2)}
    whole = driver.replace(
        mass=0.214, **dict(zip(("cg_x", "cg_y", "cg_z"), cg, strict=True)),
        **{name: inertia[place] for name, place in names.items()},
    )  # fmt: skip
    for model in ("standard", "slip", "volumetric", "area"):  # others have features of the free head
        one, other = (clubface.impact(club, **DRIVE, model=model, accuracy=1e-10) for club in (part, whole))
        # The whole differs by rounding and, in contact models, by the accuracy of a step.
        assert one.ball_speed == pytest.approx(other.ball_speed, rel=1e-7)
        assert one.backspin == pytest.approx(other.backspin, rel=1e-6)


def test_finite_elements_strike_the_attached_head():
    free = clubface.club("driver").replace(characteristic_time="0 us")
    coarse = replace(fem.ball("modern"), cube=6)
    gains = []
    for options in ({"model": "fem", "ball": coarse}, {"model": "response"}):
        one, other = (clubface.impact(club, **DRIVE, **options) for club in (free, free.on_shaft("graphite")))
        gains.append(other.ball_speed - one.ball_speed)
    # The same 0.4 m/s: balls of both kinds return from heavier heads alike, to a tenth of the gain with so
    # coarse a mesh.
    assert gains[0] == pytest.approx(gains[1], rel=0.15)


def test_a_left_handed_club_on_its_shaft_is_the_mirror_image():
    right = clubface.club("driver").on_shaft("graphite")
    one = clubface.impact(right, **DRIVE)
    other = clubface.impact(right.replace(hand=-1), **DRIVE)
    # To rounding, of which the components to the side, as differences, have more.
    assert other.ball_speed == pytest.approx(one.ball_speed, rel=1e-12)
    assert other.azimuth == pytest.approx(-one.azimuth, rel=1e-9)
    assert other.sidespin == pytest.approx(-one.sidespin, rel=1e-9)


def test_an_attached_club_reads_back_the_same_from_its_file(tmp_path):
    club = clubface.club("7-iron").on_shaft("steel")
    path = tmp_path / "club.toml"
    path.write_text(club.to_toml())
    again = clubface.club(path)
    assert again == club
    assert again.inputs() == club.inputs()
    assert again.sources["added_inertia"] == "on the shaft steel"
    assert clubface.impact(again, **DRIVE).ball_speed == clubface.impact(club, **DRIVE).ball_speed


def test_its_elements_are_the_inputs_of_the_core():
    club = clubface.club("driver").on_shaft("graphite")
    names = [name for name, each in inputs().items() if each.group == "attachment"]
    assert [name for name in club.inputs() if name.startswith("added_")] == names
    assert club.inputs()["added_coupling_xz"] == club.added_inertia[0][5]
    assert club.inputs()["added_inertia_xz"] == club.added_inertia[3][5]
    launch = clubface.impact(club, **DRIVE)
    assert launch.input("added_mass_yy") == club.added_inertia[1][1]


def test_a_free_club_again():
    driver = clubface.club("driver")
    assert driver.on_shaft("graphite").replace(added_inertia=None) == driver
    assert driver.added_inertia is None
    assert clubface.impact(driver.replace(added_inertia=np.zeros((6, 6))), **DRIVE).ball_speed == pytest.approx(
        clubface.impact(driver, **DRIVE).ball_speed, rel=1e-12
    )


def test_the_inertia_of_a_mechanism_is_taken_less_that_of_the_head():
    driver = clubface.club("driver")
    own, added = np.array(driver.spatial_inertia), attached((0.02, (0.0, 0.1, 0.0)))
    on = driver.on_mechanism(own + added)
    # Subtracting the head's own leaves its rounding.
    assert np.array(on.added_inertia) == pytest.approx(added, abs=1e-12)
    assert np.array(on.spatial_inertia) == pytest.approx(own + added, rel=1e-12, abs=1e-15)
    # What is negative by rounding only, as programs return it, is none.
    assert driver.on_mechanism(own * (1.0 - 1e-11)).added_inertia is not None


def test_a_mechanism_that_is_lighter_than_the_head_is_refused():
    driver = clubface.club("driver")
    with pytest.raises(InputError, match=r"0.102 kg"):
        driver.on_mechanism(0.5 * np.array(driver.spatial_inertia))
    with pytest.raises(InputError, match="6 rows"):
        driver.on_mechanism(np.eye(3))


LOPSIDED = np.diag([0.01, 0.01, 0.01, 1e-5, 1e-5, 1e-5])
LOPSIDED[0, 4] = 1e-3


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (np.eye(3), "6 rows"),
        ("stiff", "6 rows"),
        (0.01, "6 rows"),
        ([[1.0] * 6] * 5, "6 rows"),
        ([["1 kg"] * 6] * 6, "not a mass"),
        (LOPSIDED, "symmetric"),
        (-0.01 * np.eye(6), "positive semidefinite"),
        (np.diag([math.nan] * 6), "added_inertia"),
    ],
)
def test_a_matrix_that_no_mechanism_has_is_refused(given, words):
    with pytest.raises(ClubfaceError, match=words) as error:
        clubface.club("driver").replace(added_inertia=given)
    assert "added_inertia" in str(error.value)


def test_a_mistake_in_a_file_names_its_line():
    text = clubface.club("driver").on_shaft("graphite").to_toml()
    line = next(each for each in text.splitlines() if each.startswith("added_inertia"))
    with pytest.raises(ClubfaceError, match=rf":{text.splitlines().index(line) + 1}: added_inertia"):
        Club.from_text(text.replace(line, "added_inertia = [[1.0, 2.0]]"))
