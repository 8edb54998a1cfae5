"""Solid iron heads: what they weigh, their grooves, what is refused, and that a stiff one is a rigid one."""

import re

import numpy as np
import pytest

import clubface
from clubface import fem
from clubface.errors import ClubfaceError, InputError
from fem_runs import coarse

IRON = {
    "loft": "30 deg", "length": "78 mm", "heel_height": "30 mm", "toe_height": "54 mm", "face": "3 mm", "sole": "17 mm",
    "top": "7 mm", "rim": 0.2, "rounding": "9 mm",
}  # fmt: skip


def test_the_built_in_iron_weighs_what_irons_weigh():
    club = fem.head("7-iron").club
    published = clubface.club("7-iron")
    assert club.mass == pytest.approx(published.mass, rel=0.03)
    assert club.loft == pytest.approx(published.loft)
    # A shape that was assumed: moments of inertia of the same size as those of the published iron.
    assert club.iyy == pytest.approx(published.iyy, rel=0.35)
    assert club.kind == "iron"


def test_a_solid_block_has_its_closed_form_mass():
    # Without cavity, rounding and taper the blade is a block.
    shape = {**IRON, "toe_height": "30 mm", "face": "10 mm", "sole": "10 mm", "top": "10 mm", "rounding": "0 mm"}
    club = fem.IronHead(name="block", shape=shape, elements=(16, 8, 2)).mesh().club
    assert club.mass == pytest.approx(7800.0 * 0.078 * 0.03 * 0.01, rel=1e-9)
    # Nodes carry the mass: (1 + 2/n^2) of the integral along an edge of n elements.
    assert np.hypot(club.cg_x, club.cg_y) == pytest.approx(0.005, rel=1e-9)
    about_up = club.mass / 12.0 * (0.078**2 * (1 + 2 / 16**2) + 0.01**2 * (1 + 2 / 2**2))
    up = np.array([-np.sin(club.loft), np.cos(club.loft), 0.0])
    assert up @ np.array(club.inertia) @ up == pytest.approx(about_up, rel=1e-9)


WIDE = {"width": "9 mm", "depth": "1 mm", "pitch": "14 mm", "wall": "3 mm"}


def test_grooves_hold_a_ball_without_friction():
    # Grooves as wide as the elements of a coarse ball, to be quick; without friction nothing else pulls along the face.
    head = {"shape": {**IRON, "face": "9 mm", "top": "9 mm"}, "elements": (16, 12, 1)}
    how = {"speed": "38 m/s", "loft": "30 deg", "friction": 0.0, "ball": coarse()}
    settings = fem.Settings(until_separation=True)
    plain, grooved = (
        fem.strike(fem.IronHead(name="iron", grooves=grooves, **head).mesh(), settings=settings, **how)
        for grooves in (None, WIDE)
    )
    assert grooved.stopped is None
    assert grooved.energy_error < 0.01
    # The head turns back, so that its normal is no longer that of first touch: 2.5% of the force. Walls make several
    # times that.
    along = [abs(result.contact["tangential"]).max() / result.peak_force for result in (plain, grooved)]
    assert along[0] < 0.03
    assert along[1] > 0.06, along
    flat = fem.strike(
        fem.IronHead(name="iron", grooves={**WIDE, "depth": "0 mm"}, **head).mesh(), settings=settings, **how
    )
    assert flat.outcome() == plain.outcome()


def test_grooves_that_the_ball_cannot_feel_are_refused():
    real = {"width": "0.9 mm", "depth": "0.5 mm", "pitch": "3.6 mm", "wall": "0.3 mm"}
    head = fem.IronHead(name="iron", shape=IRON, grooves=real, elements=(16, 12, 1)).mesh()
    with pytest.raises(
        InputError,
        match=r"wide as nodes of the ball are apart, 8\.06 mm.*9\.0 times",
    ):
        fem.strike(head, speed="38 m/s", loft="30 deg", ball=coarse())


def test_a_stiff_iron_is_a_rigid_one():
    stiff = fem.Metal(youngs=1e12, poisson=0.29, density=7800.0)
    shape = {**IRON, "face": "9 mm", "top": "9 mm"}
    head = fem.IronHead(name="stiff", shape=shape, metal=stiff, elements=(16, 12, 1)).mesh()
    how = {"speed": "38 m/s", "loft": "25 deg", "toe": "6 mm", "ball": coarse(), "friction": 0.3}
    settings = fem.Settings(until_separation=True)
    meshed = fem.strike(head, settings=settings, **how).launch
    rigid = fem.strike(head.club, settings=settings, **how).launch
    # The face is flat, so the mesh is exact; 9 mm of five times the stiffness of steel gives a little.
    assert meshed.ball_speed == pytest.approx(rigid.ball_speed, rel=5e-3)
    assert meshed.launch == pytest.approx(rigid.launch, rel=1e-2)
    assert meshed.backspin == pytest.approx(rigid.backspin, rel=2e-2)


@pytest.mark.parametrize(
    ("shape", "grooves", "message"),
    [
        ({"face": "0 mm"}, None, "face is '0 mm'"),
        ({"rim": 0.9}, None, "rim is 0.9"),
        ({"loft": "90 deg"}, None, "loft is '90 deg'"),
        ({"rounding": "16 mm"}, None, "below half of heel_height"),
        ({"lofft": 1}, None, "did you mean loft?"),
        ({}, {"wall": "5 mm"}, "wall"),
        ({}, {"pitch": "8 mm"}, "width"),
        ({}, {"depth": "5 mm"}, "depth"),
        ({}, {"radius": "1 mm"}, "radius"),
        ({}, {"width": None}, "width"),
    ],
)
def test_a_mistake_in_an_iron_or_its_grooves_is_named(shape, grooves, message):
    cut = {} if grooves is None else {"grooves": {**WIDE, **grooves}}
    with pytest.raises(ClubfaceError, match=re.escape(message)):
        fem.IronHead(name="iron", shape={**IRON, **shape}, **cut)
