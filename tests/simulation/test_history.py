"""Histories: the course of one contact, step by step."""

import numpy as np
import pytest

import clubface
from clubface.errors import InputError, ShotError

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

DRIVE = {"speed": "113 mph", "attack": "-1.3 deg", "loft": "12.8 deg"}
CONTACT = ("volumetric", "rings", "area")


@pytest.mark.parametrize("model", CONTACT)
def test_a_history_runs_from_first_touch_to_the_launch(model):
    contact = clubface.history("driver", **DRIVE, toe="8 mm", model=model)
    shot = clubface.impact("driver", **DRIVE, toe="8 mm", model=model)
    assert contact.time[0] == 0.0
    assert np.all(np.diff(contact.time) > 0.0)
    assert contact.normal_force.min() >= 0.0
    # The peak lies between two steps; the steps of the fast setting are about a twentieth of the contact.
    assert contact.normal_force.max() == pytest.approx(shot.peak_force, rel=0.02)
    for axis, name in enumerate("xyz"):
        assert contact.ball_velocity[-1, axis] == pytest.approx(shot.get(f"velocity_{name}"), abs=1e-9)
        assert contact.ball_spin[-1, axis] == pytest.approx(shot.get(f"spin_{name}"), abs=1e-7)
    assert contact.launch.ball_speed == pytest.approx(shot.ball_speed, rel=1e-12)
    assert contact.get("time", "us")[-1] == pytest.approx(contact.time[-1] * 1e6)


def test_histories_make_tables():
    pytest.importorskip("xarray")
    rings = clubface.history("driver", **DRIVE, model="rings")
    data = rings.to_xarray()
    assert data["ring_slip"].dims == ("time", "ring")
    assert data["ball_spin"].dims == ("time", "axis")
    assert data["club_attitude"].sizes["component"] == 4
    assert data["normal_force"].attrs["units"] == "N"
    table = clubface.history("driver", **DRIVE, model="area").to_pandas()
    assert {"time", "normal_force", "ball_spin_z", "club_attitude_w"} <= set(table.columns)
    assert "ring_slip" not in dir(clubface.history("driver", **DRIVE, model="area"))


def test_only_single_shots_by_contact_models_have_a_history():
    with pytest.raises(InputError, match="volumetric, rings, area"):
        clubface.history("driver", **DRIVE, model="standard")
    with pytest.raises(InputError, match="single shot"):
        clubface.history("driver", speed=[50.0, 51.0])
    with pytest.raises(ShotError, match=r"52\.5 mm"):
        clubface.history("driver", speed=50.0, toe=0.06)


def test_cover_and_core_of_a_layered_ball_turn_by_themselves():
    """Both together have the ball's angular momentum, and their difference winds up the spring between them."""
    shot = {"speed": "88.95 mph", "attack": "-5.5 deg", "loft": "25.65 deg", "toe": "8 mm", "face": "3 deg"}
    history = clubface.history("7-iron", shot, model="volumetric", accuracy=1e-12)
    values, ball = history.launch.parameters.values, history.launch.ball
    core_part = (1.0 - values["cover_thickness"] / ball.radius) ** 5  # equal densities
    both = core_part * history.core_spin + (1.0 - core_part) * history.cover_spin
    assert both == pytest.approx(history.ball_spin, rel=1e-12, abs=1e-9)
    assert (history.core_spin[0] == 0.0).all()
    twisting = history.cover_spin - history.core_spin
    lost = values["layer_damping"] * (twisting**2).sum(axis=1)
    # Some 2000 steps, trapezoids: 1e-4 leaves room for both.
    assert np.trapezoid(lost, history.time) == pytest.approx(history.layer_work[-1], rel=1e-4)


def test_a_ball_in_one_piece_turns_as_a_whole():
    history = clubface.history("driver", speed="108 mph", loft="13 deg", model="area")
    assert history.cover_spin == pytest.approx(history.ball_spin)
    assert (history.core_spin == history.cover_spin).all()
