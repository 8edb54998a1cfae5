"""Beams against closed forms, rigid bodies and time integration by other code."""

import math
import sys
from pathlib import Path

import numpy as np
import pytest

import clubface
from clubface.equipment.shafts import shaft
from clubface.simulation.beam import MATCHINGS, Beam, added_inertia, cross_matrix, modes

STUDIES = Path(__file__).parents[2] / "studies"
LENGTH, MASS, BENDING, TORSION, AXIAL = 1.05, 0.06, 40.0, 20.0, 3e6
HEAD = np.diag([0.2, 0.2, 0.2, 2.8e-4, 5.6e-4, 4.0e-4])
TIP, AXIS = np.array([0.027, 0.034, -0.056]), np.array([0.0, 0.85, -0.53])


def uniform(*, gyration=1e-4, bending=BENDING, torsion=TORSION, axial=AXIAL, **grip):
    """A uniform beam with a station in the middle."""
    values = (np.full(3, each) for each in (MASS, bending, torsion, axial, gyration))
    return Beam(np.array([0.0, 0.4, LENGTH]), *values, **grip)


def frequencies(beam, held, elements=60):
    """Angular frequencies of a beam without the freedoms ``held``, numbered as in its matrices from either end."""
    stiffness, mass = beam.matrices(elements)
    kept = np.delete(np.arange(len(mass)), held)
    values = np.linalg.eigvals(np.linalg.solve(mass[np.ix_(kept, kept)], stiffness[np.ix_(kept, kept)]))
    return np.sqrt(np.sort(np.maximum(values.real, 0.0)))


def bending(roots, beam=BENDING):
    """Of an Euler beam, twice each: it bends in two planes."""
    return np.repeat(np.array(roots) ** 2 * math.sqrt(beam / MASS) / LENGTH**2, 2)


def test_a_free_and_a_clamped_beam_have_the_frequencies_of_euler():
    # cosh x cos x = 1 and -1. Cubics of 60 elements err by (x h)^4 / 720 < 1e-6; a section's rotary inertia by less.
    computed = frequencies(uniform(), [])
    assert computed[6:12] == pytest.approx(bending([4.730041, 7.853205, 10.995608]), rel=2e-6)
    assert computed[:6] == pytest.approx(0.0, abs=1.0)
    computed = frequencies(uniform(), range(6))
    assert computed[:6] == pytest.approx(bending([1.875104, 4.694091, 7.854757]), rel=2e-6)


def test_rotary_inertia_lowers_the_frequencies_of_a_hinged_beam_as_rayleigh_says():
    # m (1 + r^2 k^2) w^2 = EI k^4, with k a multiple of pi / length.
    radius = 0.02
    hinged = [1, 2, 3, -5, -4, -3]  # both directions across at both ends, and the twist at both
    computed = frequencies(uniform(gyration=radius, torsion=1e5), [0, *hinged])
    k = math.pi * np.array([1.0, 2.0, 3.0, 4.0]) / LENGTH
    expected = np.repeat(np.sqrt(BENDING * k**4 / (MASS * (1.0 + (radius * k) ** 2))), 2)
    assert computed[:8] == pytest.approx(expected, rel=2e-6)


@pytest.mark.parametrize(("stiffness", "density", "freedoms"), [(AXIAL, MASS, 0), (TORSION, 2.0 * MASS * 0.02**2, 3)])
def test_waves_along_a_rod_that_is_fixed_at_one_end_have_quarter_wavelengths(stiffness, density, freedoms):
    beam = uniform(gyration=0.02)
    stiff, mass = beam.matrices(60)
    own = np.arange(len(mass))[freedoms::6][1:]
    values = np.linalg.eigvals(np.linalg.solve(mass[np.ix_(own, own)], stiff[np.ix_(own, own)]))
    expected = (np.arange(3) + 0.5) * math.pi / LENGTH * math.sqrt(stiffness / density)
    # Linear shapes err by (k h)^2 / 24, here 7e-4 in the third.
    assert np.sort(np.sqrt(values.real))[:3] == pytest.approx(expected, rel=8e-4)


def test_a_head_on_a_rigid_beam_moves_as_one_rigid_body():
    stiff = uniform(bending=1e9, torsion=1e9, axial=1e11, gyration=0.02, grip_mass=0.05)
    along = AXIS / np.linalg.norm(AXIS)
    centre = TIP + 0.5 * LENGTH * along
    # A rod about its own centre: m L^2 / 12 + m r^2 across, 2 m r^2 along.
    rod = MASS * LENGTH
    across = rod * (LENGTH**2 / 12.0 + 0.02**2)
    inertia = across * np.eye(3) + (2.0 * rod * 0.02**2 - across) * np.outer(along, along)
    total = HEAD.copy()
    for mass, place, own in ((rod, centre, inertia), (0.05, TIP + LENGTH * along, np.zeros((3, 3)))):
        cross = cross_matrix(place)
        total += np.block([[mass * np.eye(3), -mass * cross], [mass * cross, own - mass * cross @ cross]])
    scale = np.sqrt(np.outer(np.diag(total), np.diag(total)))
    for matching in MATCHINGS:
        computed = np.linalg.inv(modes(stiff, HEAD, TIP, AXIS).mobility(450e-6, matching))
        # Stiff, not rigid: the butt swings at 2e5 rad/s, and gives way by (pi / (w T))^2 = 1.2e-3 of what it adds.
        assert (computed - total) / scale == pytest.approx(0.0, abs=1.3e-3)


def test_the_mobility_is_what_a_half_sine_leaves():
    each = modes(shaft("graphite").beam(), HEAD, TIP, AXIS)
    time = np.linspace(0.0, 450e-6, 2001)
    pulse = 0.5 * math.pi / time[-1] * np.sin(math.pi * time / time[-1])
    for direction in np.eye(6):
        velocity = each.velocities(time, np.outer(pulse, direction))[-1]
        # Straight pieces between 2001 points miss a half sine by (pi / 2000)^2 / 8.
        assert velocity == pytest.approx(each.mobility(time[-1]) @ direction, rel=1e-5, abs=1e-5)


def test_the_mobility_of_work_is_the_work_of_a_half_sine():
    each = modes(shaft("graphite").beam(), HEAD, TIP, AXIS)
    time = np.linspace(0.0, 450e-6, 2001)
    pulse = 0.5 * math.pi / time[-1] * np.sin(math.pi * time / time[-1])
    mobility = each.mobility(time[-1], "work")
    for direction in np.eye(6):
        power = pulse * (each.velocities(time, np.outer(pulse, direction)) @ direction)
        # An impulse p on a body of mobility w does the work w p^2 / 2.
        assert np.trapezoid(power, time) == pytest.approx(0.5 * direction @ mobility @ direction, rel=1e-5)


def test_a_uniform_tube_agrees_with_time_integration_by_other_code():
    sys.path.insert(0, str(STUDIES))
    import attached_shaft as other

    young, shear, density = other.STEEL
    outer, wall, length = other.TUBE
    inner = outer - 2.0 * wall
    area, second = math.pi / 4.0 * (outer**2 - inner**2), math.pi / 64.0 * (outer**4 - inner**4)
    beam = Beam(
        np.array([0.0, length]),
        *(
            np.full(2, each)
            for each in (
                density * area, young * second, 2.0 * shear * second, young * area, math.sqrt(second / area),
            )
        ),
    )  # fmt: skip
    iron = clubface.club("7-iron")
    axis = np.array([0.0, math.sin(other.LIE), -math.cos(other.LIE)])
    head = np.array(iron.spatial_inertia)
    own = np.linalg.inv(modes(beam, head, other.HOSEL, axis).mobility(500e-6))
    theirs = other.effective_inertia(iron.mass, np.array(iron.inertia), 500e-6, elements=60)
    scale = np.sqrt(np.outer(np.diag(own), np.diag(own)))
    # That code has no rotary inertia across, and integrates with steps of a two hundredth.
    assert np.abs((own - theirs) / scale).max() < 2e-3


@pytest.mark.parametrize("name", ["graphite", "steel"])
def test_sixty_elements_are_enough(name):
    def added(elements):
        mobility = modes(shaft(name).beam(), HEAD, TIP, AXIS, elements=elements).mobility(450e-6)
        return added_inertia(np.linalg.inv(mobility), HEAD)

    coarse, usual, fine = (added(count) for count in (30, 60, 120))
    scale = np.sqrt(np.outer(np.diag(fine), np.diag(fine)))
    error = np.abs((usual - fine) / scale).max()
    assert error < 1e-4  # a hundredth of what the matrix itself misses of the shaft
    assert error < 0.4 * np.abs((coarse - fine) / scale).max()  # second order, by the linear shapes
