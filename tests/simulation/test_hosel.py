"""What a head does to its shaft, against the laws of conservation."""

import numpy as np
import pytest

import clubface
from clubface.equipment.shafts import shaft
from clubface.errors import InputError

DRIVE = {
    "speed": "113 mph", "attack": "2 deg", "path": "-3 deg", "loft": "13 deg", "face": "1 deg", "toe": "12 mm",
    "high": "6 mm", "closure": "2000 deg/s", "lie": "2 deg",
}  # fmt: skip
LOSSLESS = {
    "standard": {"cor": 1.0},
    "volumetric": {"damping": 0.0, "friction": 0.0},
}


def driver(hand="right"):
    return clubface.club("driver").replace(hand=hand, characteristic_time="0 us").on_shaft("graphite")


@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("model", ["standard", "volumetric", "response"])
def test_head_shaft_and_ball_keep_their_momentum(model, hand):
    club = driver(hand)
    launch = clubface.impact(club, **DRIVE, model=model, accuracy=1e-10)
    pose = clubface.Delivery(**DRIVE).pose(club)
    reaction = clubface.hosel_reaction(launch)
    change = [np.array([getattr(launch, f"{name}_{axis}") for axis in "xyz"]) for name in ("velocity", "club_velocity")]
    ball, head = launch.input("ball_mass") * change[0], club.mass * (change[1] - pose.velocity)
    # In contact models the head turns by a degree, about an axis that is known from its ends only: a per cent of that.
    tolerance = 1e-9 if model != "volumetric" else 2e-4
    assert ball + head + pose.rotation @ reaction.impulse == pytest.approx(0.0, abs=tolerance * np.linalg.norm(ball))


@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("model", LOSSLESS)
def test_an_impact_without_losses_loses_no_energy(model, hand):
    given = {**DRIVE, "toe": "0 mm"} if model == "volumetric" else DRIVE
    launch = clubface.impact(driver(hand), **given, model=model, parameters=LOSSLESS[model], accuracy=1e-10)
    reaction = clubface.hosel_reaction(launch, "graphite")
    # Standard ends sliding at once, which costs half a per cent here. Without friction nothing is lost; the turn of the
    # head, known from its ends only, gives an error of a few millionths.
    if model == "volumetric":
        assert reaction.lost_energy == pytest.approx(0.0, abs=5e-5 * reaction.ball_energy)
    else:
        assert 0.0 < reaction.lost_energy < 0.05 * reaction.ball_energy


def test_the_moment_at_the_hosel_is_that_at_the_cg_less_that_of_the_force():
    launch = clubface.impact(driver(), **DRIVE)
    at_cg, at_hosel = clubface.hosel_reaction(launch), clubface.hosel_reaction(launch, "graphite")
    assert (at_cg.impulse == at_hosel.impulse).all()
    assert at_cg.moment - np.cross(at_hosel.point, at_cg.impulse) == pytest.approx(at_hosel.moment, rel=1e-12)
    # The file of the shaft says 40 mm, to the millimetre.
    assert np.linalg.norm(np.cross(at_hosel.point, shaft("graphite").axis)) == pytest.approx(0.04, abs=0.001)


def test_the_head_is_slowed_and_the_shaft_with_it():
    reaction = clubface.hosel_reaction(clubface.impact(driver(), speed="113 mph"), "graphite")
    assert reaction.impulse[0] < 0.0
    assert reaction.head_energy < reaction.shaft_energy < 0.0 < reaction.ball_energy


def test_a_free_head_has_no_reaction():
    with pytest.raises(InputError, match="a free head"):
        clubface.hosel_reaction(clubface.impact("driver", speed="113 mph"))
    with pytest.raises(InputError, match="a single launch"):
        clubface.hosel_reaction(clubface.impact(driver(), speed=[45.0, 50.0]))
