"""Heads of metal that yields: what it takes from the ball, when it matters, and mistakes in its files."""

import re
from dataclasses import replace

import pytest

from clubface import fem
from clubface.errors import ClubfaceError, FileError, InputError
from clubface.fem import keyword
from clubface.fem.heads.read import from_toml
from clubface.support.files import builtin_path
from fem_runs import coarse, coarse_head, shells_case

IRON = builtin_path("head", "7-iron", "fem_heads")

HEAD = """\
name = "mine"
kind = "mesh"
file = "head.msh"
loft = "11 deg"

[[groups]]
name = "face"
thickness = "3 mm"
face = true
yield = "800 MPa"
hardening = "1 GPa"
points = 7
rule = "lobatto"
"""


def struck(**metal):
    """Roh and Lee's coarse head, its face of some metal, hits a ball at 50 m/s."""
    result = case_of(**metal).run()
    assert result.energy_error < 0.01
    return result


def case_of(**metal):
    head = coarse_head()
    parts = tuple(replace(part, metal=fem.Metal(**metal)) if part.face else part for part in head.parts)
    return shells_case(duration="600 us").replace(club=replace(head, parts=parts), speed="50 m/s")


def test_a_soft_face_yields_and_keeps_energy():
    elastic, soft = struck(), struck(yield_stress="300 MPa", hardening="1 GPa")
    assert elastic.energy["plastic"].max() == 0.0
    assert soft.energy["plastic"][-1] > 0.5
    assert (soft.energy["plastic"][1:] >= soft.energy["plastic"][:-1]).all()
    assert soft.launch.ball_speed < elastic.launch.ball_speed
    # A harder metal keeps less.
    assert struck(yield_stress="300 MPa", hardening="20 GPa").energy["plastic"][-1] < soft.energy["plastic"][-1]


def test_points_through_the_thickness_and_resultants_are_as_good_in_elastic_metal():
    elastic = struck()
    # Rounding, grown over a thousand steps.
    for metal in ({"points": 3}, {"points": 5, "rule": "lobatto"}, {"yield_stress": "10 GPa"}):
        result = struck(**metal)
        assert result.launch.ball_speed == pytest.approx(elastic.launch.ball_speed, rel=1e-7), metal
        assert result.peak_force == pytest.approx(elastic.peak_force, rel=1e-6), metal


def test_a_table_of_two_points_is_linear_hardening():
    linear = struck(yield_stress="300 MPa", hardening="1 GPa")
    table = struck(hardening=[(0, "300 MPa"), ("50 %", "800 MPa")])
    assert table.launch.ball_speed == pytest.approx(linear.launch.ball_speed, rel=1e-7)
    assert table.energy["plastic"][-1] == pytest.approx(linear.energy["plastic"][-1], rel=1e-6)


def test_an_iron_of_soft_metal_yields():
    design = replace(from_toml(IRON), elements=(16, 12, 2))
    how = {"speed": "45 m/s", "loft": "30 deg", "ball": coarse("paper"), "settings": fem.Settings(duration="500 us")}
    hard = fem.strike(design.mesh(), **how)
    soft = fem.strike(replace(design, metal=replace(design.metal, yield_stress="100 MPa")).mesh(), **how)
    assert hard.energy["plastic"].max() == 0.0
    assert soft.energy["plastic"][-1] > 0.0
    assert soft.energy_error < 0.01


def test_a_deck_holds_the_curve_of_a_metal_that_yields(tmp_path):
    text = keyword.write(case_of(yield_stress="300 MPa", hardening="1 GPa"), tmp_path / "deck.k").read_text()
    card, blank, strains, stresses = text.partition("*MAT_PIECEWISE_LINEAR_PLASTICITY\n")[2].splitlines()[1:5]
    assert float(card[40:50]) == 3e8
    assert not blank.strip()
    assert [float(strains[at : at + 10]) for at in (0, 70)] == [0.0, 0.2]
    assert [float(stresses[at : at + 10]) for at in (0, 70)] == [3e8, 5e8]


def test_metals_read_their_values():
    metal = fem.Metal(yield_stress="800 MPa", hardening={"modulus": "1 GPa", "gain": "100 MPa", "rate": 20})
    assert metal.hardening == fem.Hardening(modulus=1e9, gain=1e8, rate=20.0)
    # 800 + 50 + 100 (1 - 1/e).
    assert metal.flow_stress([0.05]) == pytest.approx([913.212e6], rel=1e-6)
    table = fem.Metal(hardening=[[0, "800 MPa"], ["1 %", "900 MPa"]])
    assert table.yield_stress == 8e8
    assert table.flow_stress([0.005, 0.5]) == pytest.approx([850e6, 9e8])
    with pytest.raises(InputError, match="elastic"):
        fem.Metal().flow_stress([0.0])


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('yield = "800 MPa"', 'yield = "800 mm"', "mine.toml:10: yield"),
        (
            'yield = "800 MPa"',
            'yield = "0 MPa"',
            "mine.toml:10: yield of face is '0 MPa'; it must be 1 MPa to a tenth of youngs",
        ),
        ('yield = "800 MPa"\n', "", "hardening"),
        ('hardening = "1 GPa"', 'hardening = "-1 GPa"', "zero or above"),
        ('hardening = "1 GPa"', 'hardening = [[0, "900 MPa"]]', "the stress of the first point of hardening"),
        ('hardening = "1 GPa"', 'hardening = [[0, "800 MPa"], [0.1, "700 MPa"]]', "do not decrease"),
        ('hardening = "1 GPa"', 'hardening = [[0, "800 MPa"], [0, "900 MPa"]]', "begin at 0 and increase"),
        ('hardening = "1 GPa"', 'hardening = {gain = "1 MPa"}', "give rate as well"),
        ('hardening = "1 GPa"', 'hardening = {modulos = "1 GPa"}', "did you mean modulus?"),
        ("points = 7", "points = 2", "mine.toml:12: points of face is 2; it must be a whole number from 3 to 31"),
        ('rule = "lobatto"', 'rule = "labotto"', "did you mean lobatto?"),
    ],
)
def test_a_mistake_in_a_metal_is_named(write, old, new, message):
    path = write(HEAD.replace(old, new), "mine.toml")
    with pytest.raises(FileError, match=re.escape(message)):
        from_toml(path)


def test_points_through_the_thickness_are_for_shells(write):
    path = write(f"{IRON.read_text()}\n[metal]\npoints = 5\n", "iron.toml")
    with pytest.raises(ClubfaceError, match="unknown key 'points'"):
        from_toml(path)


@pytest.mark.parametrize("point", ["05", [0], [0, "800 MPa", 1], 3.0, None])
def test_a_point_of_a_hardening_curve_is_a_strain_and_a_stress(point):
    with pytest.raises(InputError, match=r"hardening is .*points of plastic strain and yield stress"):
        fem.Metal(hardening=[point, ["1 %", "900 MPa"]])
