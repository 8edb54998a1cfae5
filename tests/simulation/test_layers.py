"""The spins of cover and core, followed from the history of the whole ball."""

import numpy as np
import pytest

import clubface
from clubface.errors import InputError
from clubface.simulation.layers import layer_spins

SHOTS = {
    "driver": {"speed": "111.65 mph", "attack": "0.8 deg", "loft": "16.2 deg"},
    "7-iron": {"speed": "88.95 mph", "attack": "-5.5 deg", "loft": "25.65 deg", "toe": "8 mm", "face": "3 deg"},
}


@pytest.fixture(scope="module", params=SHOTS)
def contact(request):
    return clubface.history(request.param, SHOTS[request.param], model="volumetric", accuracy=1e-12)


def test_the_energies_of_spring_and_damper_are_those_the_core_recorded(contact):
    """The core integrates twist and dissipation itself; here they follow from the difference of the two spins."""
    spins, values = layer_spins(contact), contact.launch.parameters.values
    twisting, steps = spins.cover - spins.core, np.diff(contact.time)[:, None]
    twist = np.concatenate([np.zeros((1, 3)), np.cumsum(0.5 * steps * (twisting[1:] + twisting[:-1]), axis=0)])
    spring = 0.5 * values["layer_stiffness"] * (twist**2).sum(axis=1)
    lost = values["layer_damping"] * (twisting**2).sum(axis=1)
    damper = np.concatenate([[0.0], np.cumsum(0.5 * steps[:, 0] * (lost[1:] + lost[:-1]))])
    # Some 2000 steps, trapezoids: 1e-4 leaves room for both.
    assert spring == pytest.approx(contact.layer_energy, abs=1e-4 * contact.layer_energy.max())
    assert damper == pytest.approx(contact.layer_work, abs=1e-4 * contact.layer_work.max())


def test_both_layers_together_have_the_balls_angular_momentum(contact):
    spins, ball = layer_spins(contact), contact.launch.ball
    share = (1.0 - contact.launch.parameters.values["cover_thickness"] / ball.radius) ** 5
    both = share * spins.core + (1.0 - share) * spins.cover
    assert both == pytest.approx(contact.ball_spin, rel=1e-12, abs=1e-9)
    assert (spins.core[0] == 0.0).all()


@pytest.mark.parametrize(("club", "cover", "core"), [("driver", 3425, 1514), ("7-iron", 5008, 6074)])
def test_the_cover_of_a_drive_turns_faster_than_its_core_and_that_of_an_iron_slower(club, cover, core):
    delivery = {name: SHOTS[club][name] for name in ("speed", "attack", "loft")}
    spins = layer_spins(clubface.history(club, delivery, model="volumetric", accuracy=1e-10))
    at_take_off = [np.linalg.norm(each) * 30 / np.pi for each in (spins.cover_at_take_off, spins.core_at_take_off)]
    assert at_take_off == pytest.approx([cover, core], abs=3)
    # The steps of a plain history do almost as well.
    plain = layer_spins(clubface.history(club, delivery, model="volumetric"))
    assert np.linalg.norm(plain.cover_at_take_off) * 30 / np.pi == pytest.approx(cover, abs=15)


def test_a_ball_in_one_piece_has_no_layers():
    contact = clubface.history("driver", SHOTS["driver"], model="area")
    with pytest.raises(InputError, match="model is 'area'; it must be volumetric"):
        layer_spins(contact)
