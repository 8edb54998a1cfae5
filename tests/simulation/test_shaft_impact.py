"""The matrix that stands for a shaft, against a beam that is integrated through the impact."""

import sys
from pathlib import Path

import numpy as np
import pytest

import clubface
from clubface.equipment.shafts import shaft

sys.path.insert(0, str(Path(__file__).parents[2] / "studies"))
import shaft_impact

CASES = [("driver", "graphite", "105 mph", "14 deg"), ("7-iron", "steel", "85 mph", "27 deg")]
STRIKES = [(0.0, 0.0), (0.015, 0.0), (-0.015, 0.005), (0.0, -0.006)]


def contact_load(history):
    """Force on the head and moment about its CG, in its axes at first touch, between the steps of a contact."""
    launch = history.launch
    step = np.diff(history.time)
    force = np.diff(history.ball_velocity, axis=0) * launch.input("ball_mass") / step[:, None]
    turning = np.diff(history.ball_spin, axis=0) * launch.input("ball_inertia") / step[:, None]
    arm = history.ball_position - history.club_position
    moment = -np.cross(0.5 * (arm[1:] + arm[:-1]), force) - turning
    turn = clubface.Delivery(**launch.delivery).pose(launch.club, ball=launch.ball).rotation
    return 0.5 * (history.time[1:] + history.time[:-1]), np.hstack([-force @ turn, moment @ turn])


@pytest.mark.parametrize(("name", "of_shaft", "speed", "loft"), CASES)
@pytest.mark.parametrize(("toe", "high"), STRIKES)
def test_a_beam_under_the_force_of_an_attached_impact_moves_the_head_as_that_impact(
    name, of_shaft, speed, loft, toe, high
):
    club = clubface.club(name)
    on = club.on_shaft(of_shaft)
    history = clubface.history(on, speed=speed, loft=loft, toe=toe, high=high, accuracy=1e-8)
    time, wrench = contact_load(history)
    time, wrench = np.concatenate([[0.0], time]), np.vstack([np.zeros(6), wrench])
    beam = shaft(of_shaft).modes(club).velocities(time, wrench)[-1]
    free, matrix = (shaft_impact.rigid(each.spatial_inertia).velocities(time, wrench)[-1] for each in (club, on))
    # The head of the impact itself, which turns by a degree: a hundredth of its change of velocity.
    turn = clubface.Delivery(**history.launch.delivery).pose(on).rotation
    ran = np.concatenate(
        [turn.T @ (history.club_velocity[-1] - history.club_velocity[0]), turn.T @ history.club_spin[-1]]
    )
    scale = np.repeat([1.0, 0.04], 3)  # rotations as velocities at 40 mm
    effect = np.linalg.norm((free - beam) * scale)
    assert np.linalg.norm((ran - matrix) * scale) < 0.01 * np.linalg.norm(free * scale)
    # The pulse is no half sine, and not exactly as long as one of 450 us, which leaves a tenth of the shaft's effect.
    assert np.linalg.norm((matrix - beam) * scale) < 0.12 * effect


@pytest.mark.parametrize("name", shaft_impact.STRIKES)
def test_contact_with_the_matrix_ends_as_contact_with_the_beam(name, monkeypatch):
    """With a contact that is integrated along, so that its force differs as well.

    The bounds are what one matrix can do: it follows the motion of the head to a seventh of what the shaft changes,
    while the beam keeps energy as vibration, which is worth up to 0.64 m/s of ball speed. Steps of 1 us change 2e-3 of
    the differences.
    """
    monkeypatch.setattr(shaft_impact, "STEP", 1e-6)
    club_name, shaft_name, speed, strikes = shaft_impact.STRIKES[name]
    club, on = clubface.club(club_name), shaft(shaft_name)
    heads = {"free": shaft_impact.rigid(club.spatial_inertia), "beam": on.modes(club)}
    for matching in ("motion", "work"):
        heads[matching] = shaft_impact.rigid(club.on_shaft(on, matching=matching).spatial_inertia)
    for place in strikes[:3]:
        point = shaft_impact.strike_point(club, *place)
        ends = {each: shaft_impact.strike(head, *point, speed) for each, head in heads.items()}

        def from_beam(head, ends=ends):
            """Of ball speed, spin at the surface of the ball, velocity of the head, and its turning at 40 mm [m/s]."""
            one, beam = ends[head], ends["beam"]
            return (
                abs(np.linalg.norm(one.ball_velocity) - np.linalg.norm(beam.ball_velocity)),
                shaft_impact.BALL_RADIUS * np.linalg.norm(one.ball_spin - beam.ball_spin),
                np.linalg.norm(one.head_velocity - beam.head_velocity),
                0.04 * np.linalg.norm(one.head_spin - beam.head_spin),
            )

        free, (ball_speed, spin, head, turning) = from_beam("free"), from_beam("motion")
        assert spin < 0.3  # 130 rpm
        assert head < 0.25 * free[2]
        assert turning < 0.25 * free[3]
        assert ball_speed < 0.7
        # By the work of the force the ball has its speed, however much energy stays in the shaft: to 0.02 m/s, or to
        # 6% of a large effect, which the form of the pulse decides.
        assert from_beam("work")[0] < 0.06 * max(free[0], 0.3)
