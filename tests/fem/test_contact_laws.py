"""Laws of simple models held against finite elements: what a law would give is found, and moments add up."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from clubface import fem
from clubface.errors import InputError
from clubface.fem.reduced import area_term
from clubface.fem.result import displaced_centre
from fem_runs import coarse_drive, coarse_throw, throw_case

END = fem.Settings(until_separation=True)


def test_a_force_made_by_the_law_gives_its_eta():
    last, friction, eta = 500e-6, 0.2, 300.0
    time = np.linspace(0.0, last, 1001)
    phase = math.pi * time / last
    normal, area = 7e3 * np.sin(phase) ** 1.5, 5e-4 * np.sin(phase)
    rate = 5e-4 * math.pi / last * np.cos(phase)
    contact = {"time": time, "normal": normal, "area": area, "tangential": friction * (normal + eta * rate)}
    still = {"time": time, "spin": np.zeros((1001, 3)), "radius": np.full(1001, 21.4e-3)}
    run = SimpleNamespace(
        stopped=None, contact_time=last, contact=contact, motion=still, friction=friction,
        ball=SimpleNamespace(diameter=42.8e-3), relative_velocity=lambda: np.full((1001, 3), 20.0),
    )  # fmt: skip
    result = area_term(run)
    assert result.sliding == 1.0
    # The mean over a tenth of the contact takes 2% where curves bend, and more at their ends.
    assert result.damping == pytest.approx(eta, rel=0.05)
    assert (result.free_friction, result.free_damping) == pytest.approx((friction, eta), rel=0.05)
    assert min(result.explained, result.free_explained) > 0.95


def test_a_ball_that_slides_shows_no_area_term_and_one_that_sticks_seems_to():
    sliding, sticking = (
        area_term(fem.throw("paper", speed=35.0, angle=math.radians(angle), friction=0.2, settings=END))
        for angle in (60.0, 11.5)
    )
    assert sliding.sliding == 1.0
    # Coulomb's friction at the nodes leaves nothing for the area: 0.15 N s/m2, and 0.18 with mu free.
    assert abs(sliding.damping) < 5.0
    assert abs(sliding.free_damping) < 5.0
    assert sliding.free_friction == pytest.approx(0.2, rel=1e-3)
    # Elastic grip that reverses looks like an eta a hundred times what sliding may show, with a mu that is less than
    # half the friction: the force along the face changes its sign while that across it does not.
    assert sticking.sliding < 0.5
    assert sticking.free_damping > 100.0 * 5.0
    assert sticking.free_friction < 0.5 * 0.2
    # Where it still slides by the law's own measure the sign is the other: grip is less than mu F_N from the start.
    assert sticking.damping < -100.0 * 5.0
    # The area is half as large again as pi R d.
    deepest = sticking.sinking.argmax()
    assert sticking.area[deepest] / (math.pi * 21.4e-3 * sticking.sinking[deepest]) == pytest.approx(1.5, abs=0.1)


@pytest.mark.parametrize("run", [coarse_throw, coarse_drive])
def test_the_displaced_centre_gives_the_moment_of_the_contact(run):
    result = run()
    moved, radius = displaced_centre(result), 0.5 * result.ball.diameter
    time, contact = result.contact["time"], result.contact
    across, along = (np.trapezoid(contact[key], time) for key in ("normal", "tangential"))
    spin = result.ball.properties()["inertia"] * result.backspin
    # Records every 5 us, and normals that differ from that of first touch by a degree: 2% of the moment.
    assert spin == pytest.approx((radius + moved.normal) * along + moved.up * across, rel=0.02)
    assert spin == pytest.approx(radius * along + moved.moment * across, rel=0.02)
    # The first is the lever of Roh and Lee's compression factor.
    assert radius + moved.normal == pytest.approx(radius * result.f_prime, rel=0.02)
    # Nothing moves towards the toe of a head whose CG lies behind the face centre.
    assert abs(moved.toe) < 1e-6


def test_runs_that_did_not_end_have_neither():
    early = throw_case(duration=2e-4).run()
    for figure in (area_term, displaced_centre):
        with pytest.raises(InputError, match="complete"):
            figure(early)
