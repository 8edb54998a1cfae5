"""What finite elements take: the last value of a range is taken, the next refused and told in the unit of the limit."""

import math

import pytest

from clubface.errors import InputError
from clubface.fem.balls import Ball, Piece
from clubface.fem.heads import Group, Metal
from clubface.fem.materials import Material, Maxwell
from clubface.fem.run import throw_values

DEG = math.pi / 180
RUBBER = Material.linear("20 MPa", 0.45, "1150 kg/m3")


def ball(**changes):
    core = Piece(name="core", material=Material.linear("20 MPa", 0.45), layers=4)
    return Ball(**{"name": "one", "diameter": "42.7 mm", "mass": "45.9 g", "pieces": (core,)} | changes)


def heavy(mass):
    """A ball of one piece and 200 mm, so that any mass leaves the core a density that can be."""
    return ball(diameter=0.2, mass=mass)


LIMITS = [
    # What is made, the name told, values that are taken, values that are refused and how they are told.
    (lambda x: Metal(youngs=x), "youngs", [1e8, 1e12], {0.99e8: "'0.099 GPa'", 1.01e12: "'1010 GPa'"}),
    (lambda x: Metal(poisson=x), "poisson", [-0.999, 0.499], {-1.0: "-1.0", 0.5: "0.5"}),
    (lambda x: Metal(density=x), "density", [100.0, 25e3], {99.0: "'99 kg/m3'", 25_001.0: "'25001 kg/m3'"}),
    (lambda x: Metal(youngs=1e11, yield_stress=x), "yield", [1e6, 1e10], {0.9e6: "'0.9 MPa'", 1.01e10: "'10100 MPa'"}),
    (lambda x: Group(name="face", thickness=x), "thickness of face", [2e-4, 0.02],
     {1.9e-4: "'0.19 mm'", 0.021: "'21 mm'"}),
    (lambda x: Maxwell(modulus=x, time=1e-3), "modulus", [1e-9, 1e3], {0.0: "0.0", 1001.0: "1001.0"}),
    (lambda x: Maxwell(modulus=0.1, time=x), "time", [1e-7, 1e3], {0.9e-7: "'0.09 us'", 1001.0: "'1.001e+09 us'"}),
    (lambda x: Material.linear(2e7, x), "poisson", [-0.9, 0.4999], {-0.91: "-0.91", 0.49991: "0.49991"}),
    (lambda x: Material(law="linear", constants={"shear": 1e7}, poisson=x), "poisson", [-0.9, 0.4999],
     {-0.91: "-0.91", 0.49991: "0.49991"}),
    (lambda x: Material.linear(2e7, 0.4, x), "density", [10.0, 30e3], {9.0: "'9 kg/m3'", 30_001.0: "'30001 kg/m3'"}),
    # E = 2 G (1 + nu), G from 1 kPa to 1 TPa.
    (lambda x: Material.linear(x, 0.0), "youngs", [2e3, 2e12],
     {1.9e3: "'0.0019 MPa'", 2.1e12: "'2.1e+06 MPa'", 0.0: "'0 MPa'"}),
    (lambda x: Material(law="linear", constants={"shear": x}, poisson=0.4), "shear", [1e3, 1e12],
     {0.9e3: "'0.0009 MPa'", 1.1e12: "'1.1e+06 MPa'"}),
    (lambda x: ball(diameter=x, mass=None, pieces=(Piece(name="core", material=RUBBER, layers=4),)), "diameter",
     [0.01, 0.2], {0.0099: "'9.9 mm'", 0.201: "'201 mm'"}),
    (heavy, "mass", [0.05, 1.0], {0.9e-3: "'0.9 g'", 1.001: "'1001 g'"}),
    (lambda x: ball(cube=x), "cube", [2, 96], {0: "0", 97: "97", 3: "3", 98: "98"}),
    (lambda x: Piece(name="cover", material=RUBBER, layers=2, thickness=x), "thickness of cover", [1e-5, 0.02],
     {0.9e-5: "'0.009 mm'", 0.021: "'21 mm'"}),
    (lambda x: Piece(name="cover", material=RUBBER, layers=x, thickness=1e-3), "layers of cover", [1, 48],
     {0: "0", 49: "49"}),
    (lambda x: throw_values(x, 0.0), "speed", [0.01, 150.0], {0.009: "'0.009 m/s'", 150.1: "'150.1 m/s'"}),
    (lambda x: throw_values(30.0, x), "angle", [0.0, 80 * DEG],
     {-1e-3 * DEG: "'-0.001 deg'", 80.01 * DEG: "'80.01 deg'"}),
]  # fmt: skip


@pytest.mark.parametrize(
    ("make", "name", "taken", "refused"), LIMITS, ids=[f"{x[1]}-{i}" for i, x in enumerate(LIMITS)]
)
def test_a_value_is_taken_up_to_its_limit_and_refused_beyond(make, name, taken, refused):
    for value in taken:
        make(value)
    for value, shown in refused.items():
        with pytest.raises(InputError) as caught:
            make(value)
        assert str(caught.value).startswith(f"{name} is {shown};")


def test_a_core_that_the_layers_leave_no_mass_is_refused_with_what_is_left():
    """A core of 20 mm under a cover of 1.35 mm and 1150 kg/m3: the density left is (mass - cover) over its volume."""
    cover = Piece(name="cover", material=RUBBER, layers=2, thickness=1.35e-3)
    core = Piece(name="core", material=Material.linear("20 MPa", 0.45), layers=4)
    volume, whole = (math.pi / 6 * diameter**3 for diameter in (20e-3, 22.7e-3))
    around = 1150.0 * (whole - volume)
    for density, fits in ((10.1, True), (9.9, False), (29_900.0, True), (30_100.0, False)):
        mass = around + density * volume
        if fits:
            Ball(name="two", diameter=22.7e-3, mass=mass, pieces=(core, cover))
            continue
        with pytest.raises(InputError, match=f"have {density:.0f} kg/m3"):
            Ball(name="two", diameter=22.7e-3, mass=mass, pieces=(core, cover))


def test_a_ball_has_one_to_five_pieces_and_a_material_up_to_four_branches():
    cover = [Piece(name=f"cover {place}", material=RUBBER, layers=1, thickness=1e-3) for place in range(5)]
    core = Piece(name="core", material=Material.linear("20 MPa", 0.45), layers=4)
    assert len(ball(pieces=(core, *cover[:4])).pieces) == 5
    with pytest.raises(InputError, match="pieces is 6; it must be 1 to 5"):
        ball(pieces=(core, *cover))
    with pytest.raises(InputError, match="pieces is 0"):
        ball(pieces=())
    branch = Maxwell(modulus=0.1, time=1e-3)
    assert len(Material.linear(2e7, 0.4, maxwell=[branch] * 4).maxwell) == 4
    with pytest.raises(InputError, match=r"maxwell is 5.*at most 4"):
        Material.linear(2e7, 0.4, maxwell=[branch] * 5)


def test_a_linear_material_keeps_its_moduli():
    made = Material.linear("30 MPa", 0.25)
    assert made.shear == pytest.approx(12e6, rel=1e-14)
    assert made.youngs == pytest.approx(30e6, rel=1e-14)
    assert made.bulk == pytest.approx(20e6, rel=1e-14)  # E / (3 (1 - 2 nu))
