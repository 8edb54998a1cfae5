"""A head must be a body in its volume: moments of positive mass pass, whatever its place, and nothing else does."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

from clubface import club
from clubface.design import feasibility
from clubface.design.feasibility import Envelope, Volume
from clubface.errors import InputError

ELLIPSOID = Volume(shape="ellipsoid", centre=(-0.055, 0.002, 0.003), size=(0.115, 0.062, 0.124))
AROUND = Volume(shape="ellipsoid", centre=(-0.055, -0.003, 0.003), size=(0.15, 0.09, 0.16))
"""An ellipsoid around a head; one of its own length, width and height leaves out the corners, where its mass is."""
BOX = Volume(shape="box", centre=(-0.055, 0.002, 0.003), size=(0.115, 0.062, 0.124))
ROUNDING = 1e-12


def moments(places, masses):
    """The pseudo-inertia of point masses, straight from its definition."""
    rows = np.hstack([places, np.ones((len(places), 1))])
    return np.einsum("n,ni,nj->ij", masses, rows, rows)


def in_ellipsoid(volume, parts):
    """Places from numbers in -1..1: shrunk onto the ball, then stretched."""
    length = np.linalg.norm(parts, axis=1, keepdims=True)
    return np.array(volume.centre) + 0.5 * np.array(volume.size) * parts / np.maximum(length, 1.0)


def trace(pseudo, volume):
    return [float(np.sum(pseudo * form.matrix)) for form in volume.forms()]


points = st.lists(
    st.tuples(*[st.floats(-1, 1)] * 3, st.floats(1e-4, 0.1)), min_size=1, max_size=7
)  # fmt: skip


@given(points)
@settings(max_examples=60)
def test_point_masses_in_the_volume_on_a_shell_are_a_head(bodies):
    parts, masses = np.array(bodies)[:, :3], np.array(bodies)[:, 3]
    for volume in (ELLIPSOID, BOX):
        inside = in_ellipsoid(volume, parts) if volume is ELLIPSOID else (
            np.array(volume.centre) + 0.5 * np.array(volume.size) * parts
        )  # fmt: skip
        shell = moments(inside[:, [0, 1, 2]] * 0.5 + 0.5 * np.array(volume.centre), masses * 3.0)
        envelope = Envelope(volume=volume, shell=shell, budget=float(masses.sum()) * (1.0 + 1e-9))
        assert all(each.met for each in envelope.margins(shell + moments(inside, masses)))


@given(points)
@settings(max_examples=30)
def test_moments_and_mass_properties_are_the_same_thing(bodies):
    parts, masses = np.array(bodies)[:, :3], np.array(bodies)[:, 3]
    pseudo = moments(in_ellipsoid(ELLIPSOID, parts), masses)
    again = feasibility.pseudo_inertia(feasibility.mass_properties(pseudo))
    # Inertia about the CG is a difference of moments about the face centre: some digits of 16 are lost.
    assert np.abs(again - pseudo).max() < 1e-13 * masses.sum()


def test_inertia_is_that_of_the_definition():
    """Two masses: the tensor by hand, with minus the products off the diagonal, about their CG."""
    places, masses = np.array([[-0.02, 0.01, 0.03], [-0.06, -0.02, 0.0]]), np.array([0.15, 0.05])
    values = feasibility.mass_properties(moments(places, masses))
    cg = masses @ places / masses.sum()
    expected = sum(m * ((r @ r) * np.eye(3) - np.outer(r, r)) for m, r in zip(masses, places - cg, strict=True))
    assert values[0] == pytest.approx(0.2)
    assert values[1:4] == pytest.approx(-cg)
    tensor = [expected[0, 0], expected[1, 1], expected[2, 2], expected[0, 1], expected[0, 2], expected[1, 2]]
    assert values[4:] == pytest.approx(tensor, abs=1e-15)


def test_a_solid_ellipsoid_keeps_two_fifths_of_its_mass_as_margin():
    """Mean of x^2/a^2 in a solid ellipsoid is 1/5, of the three together 3/5: closed form."""
    a, b, c = 0.5 * np.array(ELLIPSOID.size)
    pseudo = np.diag([a**2 / 5, b**2 / 5, c**2 / 5, 1.0]) * 0.2
    shift = np.eye(4)
    shift[:3, 3] = ELLIPSOID.centre
    assert trace(shift @ pseudo @ shift.T, ELLIPSOID) == pytest.approx([0.4 * 0.2], rel=1e-12)


@given(st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda v: np.linalg.norm(v) > 0.1))
def test_a_point_on_the_surface_is_on_the_boundary_and_one_beyond_is_refused(direction):
    unit = np.array(direction) / np.linalg.norm(direction)
    for far, sign in ((1.0, 0), (1.0 + 1e-6, -1), (1.0 - 1e-6, 1)):
        place = np.array(ELLIPSOID.centre) + 0.5 * np.array(ELLIPSOID.size) * unit * far
        (margin,) = trace(moments(place[None], [1.0]), ELLIPSOID)
        assert abs(margin) < ROUNDING if sign == 0 else sign * margin > 1e-6


def test_derivatives_of_the_moments_are_those_of_differences():
    """Central differences of a polynomial of third degree: h^2 is 1e-10 of the size squared."""
    values = feasibility.of_club(club("driver"))
    exact = feasibility.pseudo_inertia_derivatives(values)
    for index, value in enumerate(values):
        h = 1e-5 * max(abs(value), 1e-6)
        up, down = values.copy(), values.copy()
        up[index] += h
        down[index] -= h
        result = (feasibility.pseudo_inertia(up) - feasibility.pseudo_inertia(down)) / (2 * h)
        assert np.abs(result - exact[index]).max() < 1e-8 * max(np.abs(exact[index]).max(), 1e-3)


def envelope(volume=AROUND, budget=0.03):
    base = feasibility.pseudo_inertia(feasibility.of_club(club("driver")))
    return Envelope(volume=volume, shell=base * (1.0 - budget / 0.204), budget=budget)


def test_the_published_driver_is_a_body_in_a_head_of_today():
    for volume in (AROUND, BOX):
        feasibility.refuse_impossible("driver", envelope(volume), feasibility.of_club(club("driver")))


def is_a_triangle(head):
    principal = np.linalg.eigvalsh(np.array(head.inertia))
    return principal[2] < principal[0] + principal[1]


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"iyy": "9900 g cm2", "izz": "8200 g cm2"}, "the head does not fit into the ellipsoid"),
        ({"ixx": "2300 g cm2"}, "no distribution of mass has these moments of the discretionary mass"),
        ({"cg_x": "33 mm"}, "no distribution of mass has these moments of the discretionary mass"),
        ({"mass": "220 g"}, "46.0 g of discretionary mass"),
    ],
)
@pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")
def test_a_head_that_passes_the_triangle_inequality_may_still_be_refused_with_the_reason(changes, reason):
    head = club("driver").replace(**changes)
    assert is_a_triangle(head)
    with pytest.raises(InputError, match=reason):
        feasibility.refuse_impossible("driver", envelope(), feasibility.of_club(head))


def test_the_shell_limits_what_a_head_may_be():
    """The same head, refused for its small budget, exists where more mass may be placed."""
    head = feasibility.of_club(club("driver").replace(cg_x="39 mm", ixx="2750 g cm2"))
    with pytest.raises(InputError, match="discretionary"):
        feasibility.refuse_impossible("driver", envelope(budget=0.005), head)
    feasibility.refuse_impossible("driver", envelope(budget=0.06), head)


def test_a_box_refuses_what_lies_beyond_an_edge_though_it_is_within_every_slab():
    """Mean squares of 0.97 in both directions, and (1 - x)(1 - y) of -0.17 on average."""
    half = 0.5 * np.array(BOX.size)
    places = np.array(BOX.centre) + half * np.array([[1.4, -1.4, 0.0], [0.85, 0.85, 0.0]])
    margins = trace(moments(places, np.array([0.2, 0.8])), BOX)
    assert min(margins[:3]) > 0.02
    assert min(margins[3:]) == pytest.approx(-0.174, rel=1e-9)


def test_a_body_without_mass_left_is_reported():
    """A shell as heavy as the head leaves nothing, and a heavier one less than that."""
    head = moments(np.array([[-0.055, 0.002, 0.003], [-0.04, 0.01, 0.0]]), np.array([0.1, 0.1]))

    def reason(shell):
        margins = Envelope(volume=BOX, shell=shell, budget=0.03).margins(head)
        return next(each.reason for each in margins if each.name == "the discretionary mass is nowhere negative")

    for heavier in (0.0, 0.01):
        shell = head + np.diag([0.0, 0.0, 0.0, heavier])
        assert reason(shell).endswith(f"its mass would be {-1e3 * heavier + 0.0:.1f} g")
    wider = head - np.diag([0.0, 0.0, 0.0, 0.02]) + np.diag([2e-7, 0.0, 0.0, 0.0])
    assert "the second moment of its mass along the direction (1.00, 0.00, 0.00) would be -2.0 g cm2" in reason(wider)
