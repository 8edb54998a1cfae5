"""Rotations, attitude and face of motion capture against closed forms and against the compiled core."""

import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

import clubface
from clubface.capture.rotations import about, angles, delivered, exponential, face_axes, left_jacobian, logarithm, skew
from clubface.equipment.face import face_point, nearest

ANGLE = st.floats(-0.6, 0.6)


@given(st.tuples(*[st.floats(-1.8, 1.8)] * 3))
def test_the_logarithm_undoes_the_exponential(vector):
    # 1.8 sqrt(3) < pi. Rounding of the matrix, 1e-16, reaches the vector over the sine, 0.02 at worst.
    assert logarithm(exponential(vector)) == pytest.approx(np.array(vector), abs=1e-13)


def test_a_quarter_turn_about_y_takes_z_to_x():
    assert about(1, math.pi / 2) @ [0, 0, 1] == pytest.approx([1, 0, 0], abs=1e-15)
    assert skew([1, 2, 3]) @ [4, 5, 6] == pytest.approx(np.cross([1, 2, 3], [4, 5, 6]))


@pytest.mark.parametrize("size", [1e-6, 0.009, 0.011, 1.5])
def test_the_left_jacobian_gives_the_angular_velocity_of_a_rotation_vector(size):
    random = np.random.default_rng(3)
    vector, rate = size * random.normal(size=3), random.normal(size=3)
    h = 1e-5
    turned = logarithm(exponential(vector + h * rate) @ exponential(vector - h * rate).T) / (2 * h)
    # Central differences: h^2 of the third derivative, 1e-10; rounding 1e-16/h = 1e-11.
    assert left_jacobian(vector) @ rate == pytest.approx(turned, abs=1e-9)


@given(loft=st.floats(0.02, 0.9), face=ANGLE, lie=ANGLE, static=st.floats(0.0, 1.2))
def test_loft_face_and_lie_are_read_back_from_the_attitude(loft, face, lie, static):
    assert np.array(angles(delivered(loft, face, lie, static), static)) == pytest.approx([loft, face, lie], abs=1e-13)


def test_the_delivered_normal_has_its_loft_and_face_angle_at_any_lie():
    for lie in (-0.3, 0.0, 0.2):
        normal = (delivered(0.3, 0.1, lie, 0.17) @ face_axes(0.17))[:, 0]
        expected = [math.cos(0.3) * math.cos(0.1), math.sin(0.3), math.cos(0.3) * math.sin(0.1)]
        assert normal == pytest.approx(expected, abs=1e-15)
    assert (delivered(0.3, 0.0, 0.2, 0.17) @ [0, 0, 1])[1] > 0.1  # toe up


@pytest.mark.parametrize("hand", ["right", "left"])
def test_attitude_and_face_are_those_of_the_core(hand):
    """A frictionless impact of an immovable head drives the ball along the face's normal at the point of impact."""
    heavy = {f"i{a}{b}": 1e9 if a == b else 0.0 for a, b in ("xx", "yy", "zz", "xy", "xz", "yz")}
    club = clubface.club("driver").replace(roll="250 mm", hand=hand)
    given = {"loft": 0.2, "face": 0.07, "lie": 0.15, "toe": 0.021, "high": -0.012}
    sent = clubface.impact(
        club, speed=40.0, model="slip", parameters={"slip_y": -1.0, "slip_z": -1.0}, club_mass=1e6, **heavy, **given
    )
    sign = club.hand
    rotation = delivered(given["loft"], given["face"] * sign, given["lie"], club.loft) @ face_axes(club.loft)
    normal = nearest(face_point(given["toe"], given["high"], club.bulge, club.roll), club.bulge, club.roll)[1]
    velocity = np.array([sent.velocity_x, sent.velocity_y, sent.velocity_z * sign])
    # The head's mass of 1e6 kg leaves a recoil of 5e-8.
    assert velocity / np.linalg.norm(velocity) == pytest.approx(rotation @ normal, abs=1e-6)


@given(
    toe=st.floats(-0.05, 0.05), high=st.floats(-0.025, 0.025), out=st.floats(-0.02, 0.05),
    bulge=st.sampled_from([0.25, 0.305, math.inf]), roll=st.sampled_from([0.2, 0.305, math.inf]),
)  # fmt: skip
def test_a_point_over_the_face_is_as_far_from_it_as_it_was_raised(toe, high, out, bulge, roll):
    point = face_point(toe, high, bulge, roll)
    distance, normal = nearest(point, bulge, roll)
    assert distance == pytest.approx(0.0, abs=1e-15)
    raised, same = nearest(point + out * normal, bulge, roll)
    assert raised == pytest.approx(out, abs=1e-15)
    assert same == pytest.approx(normal, abs=1e-13)


def test_a_face_of_one_radius_is_a_sphere():
    # Worked by hand: 30 mm aside on a sphere of 250 mm lies 250 - sqrt(250^2 - 30^2) = 1.80648... mm back.
    back = 0.25 - math.sqrt(0.25**2 - 0.03**2)
    assert face_point(0.03, 0.0, 0.25, 0.25) == pytest.approx([-back, 0.0, 0.03], abs=1e-16)
    assert nearest([0.1, 0.0, 0.0], 0.25, 0.25)[0] == pytest.approx(0.1, abs=1e-16)
    assert nearest([-0.25, 0.02, 0.03], 0.25, 0.25)[0] == pytest.approx(math.hypot(0.02, 0.03) - 0.25, abs=1e-15)
