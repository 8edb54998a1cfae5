"""Laws every model declares to obey, on shots drawn at random, at the Python boundary.

Attitude and geometry are computed here once more, from the definitions in the conventions, not by the core.
"""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import clubface
from clubface.equipment.models import models

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")

IMPULSE = [name for name, each in models().items() if each.kind == "impulse"]
CONTACT = [name for name, each in models().items() if each.kind == "contact"]


def degrees(low, high):
    return st.floats(np.radians(low), np.radians(high))


deliveries = st.fixed_dictionaries(
    {
        "speed": st.floats(20.0, 60.0),
        "attack": degrees(-8, 8),
        "path": degrees(-8, 8),
        "loft": degrees(5, 40),
        "face": degrees(-8, 8),
        "lie": degrees(-8, 8),
        "toe": st.floats(-0.02, 0.02),
        "high": st.floats(-0.01, 0.01),
        "closure": st.floats(-50.0, 50.0),
        "pitch_rate": st.floats(-50.0, 50.0),
        "lie_rate": st.floats(-50.0, 50.0),
    }
)
clubs = st.sampled_from(["driver", "7-iron", "hybrid"])

quick = settings(max_examples=40)
slow = settings(max_examples=12)


def obeys(model, law):
    """Whether the law holds for the published parameters, whose area damping is zero."""
    declared = models()[model]
    without = declared.laws_without[1] if declared.laws_without else ()
    return law in declared.laws or law in without


def vector(launch, name):
    return np.array([launch.get(f"{name}_{axis}") for axis in "xyz"])


def adjustments(launch):
    """Extra mass of the clubhead [kg] and displacement of the ball's CG in x'y'z' [m] of the adjusted model."""
    values = launch.parameters.values
    return values.get("extra_mass", 0.0), np.array([values.get(f"dcg_{axis}", 0.0) for axis in "xyz"])


def incoming(delivery):
    attack, path = delivery["attack"], delivery["path"]
    way = [np.cos(attack) * np.cos(path), np.sin(attack), np.cos(attack) * np.sin(path)]
    return delivery["speed"] * np.array(way), np.array(
        [-delivery["lie_rate"], delivery["closure"], delivery["pitch_rate"]]
    )


def about(axis, angle):
    """Right-handed rotation about a world axis."""
    c, s = np.cos(angle), np.sin(angle)
    i, j = [(1, 2), (2, 0), (0, 1)][axis]
    turn = np.eye(3)
    turn[i, i] = turn[j, j] = c
    turn[i, j], turn[j, i] = -s, s
    return turn


def attitude(delivery, club):
    """Rotation from the pose at static loft to the delivered one: tilt, yaw back, raise, yaw right."""
    tilt = about(0, -delivery["lie"])
    normal = tilt @ about(2, club.loft) @ [1.0, 0.0, 0.0]
    back = about(1, np.arctan2(normal[2], normal[0]))
    raised = about(2, delivery["loft"] - np.arcsin(normal[1]))
    return about(1, -delivery["face"]) @ raised @ back @ tilt


def test_every_model_keeps_momentum_and_one_says_that_it_does_not_keep_angular_momentum():
    assert all(obeys(model, "momentum") for model in models())
    assert [model for model in models() if not obeys(model, "angular_momentum")] == ["jorgensen"]


@pytest.mark.parametrize("model", models())
@settings(parent=slow)
@given(delivery=deliveries, club=clubs)
def test_momentum_is_kept(model, delivery, club):
    """To rounding for closed forms; contact models keep it exactly by construction: 1e-12 of what there is."""
    launch = clubface.impact(club, delivery, model=model)
    velocity, _ = incoming(delivery)
    head = launch.club.mass + adjustments(launch)[0]
    gained = launch.ball.mass * vector(launch, "velocity")
    lost = head * (velocity - vector(launch, "club_velocity"))
    assert np.abs(gained - lost).max() < 1e-12 * head * delivery["speed"]


@pytest.mark.parametrize("model", [name for name in IMPULSE if obeys(name, "angular_momentum")])
@settings(parent=quick)
@given(delivery=deliveries)
def test_angular_momentum_is_kept_by_the_models_that_say_so(model, delivery):
    """About the clubhead's CG, an iron's plane face: bodies do not move during an impulse; rounding alone, 1e-12.

    In ``response`` they do, by distances that it does not tell: no displacement changes the part along the impulse.
    """
    launch = clubface.impact("7-iron", delivery, model=model)
    club, ball = launch.club, launch.ball
    turn = attitude(delivery, club)
    loft = about(2, club.loft)
    point = np.array(club.cg) + loft @ [0.0, delivery["high"], delivery["toe"]]
    centre = turn @ (point + loft @ (np.array([ball.radius, 0.0, 0.0]) + adjustments(launch)[1]))
    inertia = turn @ np.array(club.inertia) @ turn.T
    before = inertia @ incoming(delivery)[1]
    after = inertia @ vector(launch, "club_spin") + ball.inertia * vector(launch, "spin")
    after = after + np.cross(centre, ball.mass * vector(launch, "velocity"))
    size = ball.mass * delivery["speed"] * np.linalg.norm(centre)
    change = after - before
    if model == "response":
        change = change @ vector(launch, "velocity") / np.linalg.norm(vector(launch, "velocity"))
    assert np.abs(change).max() < 1e-12 * size


@pytest.mark.parametrize("model", [name for name in IMPULSE if obeys(name, "energy")])
@settings(parent=quick)
@given(delivery=deliveries, club=clubs)
def test_an_impulse_creates_no_energy(model, delivery, club):
    """Kinetic energy of both bodies, the published parameters; 1e-12 of it for rounding."""
    launch = clubface.impact(club, delivery, model=model)
    head, ball = launch.club, launch.ball
    turn = attitude(delivery, head)
    inertia = turn @ np.array(head.inertia) @ turn.T

    mass = head.mass + adjustments(launch)[0]

    def energy(velocity, spin):
        return 0.5 * mass * velocity @ velocity + 0.5 * spin @ inertia @ spin

    before = energy(*incoming(delivery))
    after = energy(vector(launch, "club_velocity"), vector(launch, "club_spin"))
    after += 0.5 * ball.mass * vector(launch, "velocity") @ vector(launch, "velocity")
    after += 0.5 * ball.inertia * vector(launch, "spin") @ vector(launch, "spin")
    assert after <= before * (1.0 + 1e-12)


@pytest.mark.parametrize("model", CONTACT)
@settings(parent=slow)
@given(delivery=deliveries, club=clubs)
def test_the_account_of_energy_of_a_contact_balances(model, delivery, club):
    """Kinetic + stored + work taken is constant: to 1e-7 with steps of tolerance 1e-9; rings are of lower order."""
    contact = clubface.history(club, delivery, model=model, accuracy=1e-9)
    total = contact.kinetic_energy + contact.face_energy + contact.layer_energy
    total = total + contact.normal_work + contact.friction_work + contact.layer_work
    tolerance = 1e-3 if model == "rings" else 1e-7
    assert np.abs(total - total[0]).max() < tolerance * total[0]
    if obeys(model, "energy"):
        assert contact.kinetic_energy[-1] <= contact.kinetic_energy[0]


@pytest.mark.parametrize("model", [name for name in CONTACT if obeys(name, "friction_cone")])
@settings(parent=slow)
@given(delivery=deliveries, club=clubs)
def test_friction_stays_in_its_cone(model, delivery, club):
    """|F_t| <= mu F_N at every step; rings are solved to 1e-10 of the traction and summed."""
    contact = clubface.history(club, delivery, model=model)
    friction = np.hypot(contact.force_y, contact.force_z)
    limit = contact.launch.parameters.values["friction"] * contact.normal_force
    assert np.all(friction <= limit * (1.0 + 1e-6) + 1e-6)


@pytest.mark.parametrize("model", models())
@settings(parent=slow)
@given(delivery=deliveries, club=clubs)
def test_a_left_handed_shot_is_the_mirror_image(model, delivery, club):
    """Exact: the mirror changes signs alone."""
    right = clubface.impact(club, delivery, model=model)
    mirrored = {**delivery, "path": -delivery["path"], "face": -delivery["face"]}
    left = clubface.impact(club, mirrored, model=model, hand="left")
    for name in ("ball_speed", "smash", "launch", "backspin", "total_spin", "velocity_x", "velocity_y", "spin_z"):
        assert left.get(name) == right.get(name), name
    for name in ("azimuth", "sidespin", "spin_axis", "velocity_z", "spin_x", "spin_y"):
        assert left.get(name) == -right.get(name), name


@pytest.mark.parametrize("model", models())
@settings(parent=slow)
@given(delivery=deliveries, club=clubs, turn=degrees(-20, 20))
def test_aiming_elsewhere_only_turns_the_launch(model, delivery, club, turn):
    """Path, face and the head's rotation turned about the vertical turn the azimuth alone.

    Closed forms differ by rounding, 1e-11; contact models by how rounding moves their steps, well below their 1e-4.
    """
    tolerance = 1e-11 if model in IMPULSE else 2e-5
    rates = np.array([-delivery["lie_rate"], 0.0, delivery["pitch_rate"]])
    turned = about(1, -turn) @ rates
    elsewhere = {
        **delivery,
        "path": delivery["path"] + turn,
        "face": delivery["face"] + turn,
        "lie_rate": -turned[0],
        "pitch_rate": turned[2],
    }
    here, there = clubface.impact(club, delivery, model=model), clubface.impact(club, elsewhere, model=model)
    assert there.azimuth == pytest.approx(here.azimuth + turn, abs=tolerance)
    for name in ("ball_speed", "launch"):
        assert there.get(name) == pytest.approx(here.get(name), rel=tolerance)
    for name in ("backspin", "sidespin"):
        assert there.get(name) == pytest.approx(here.get(name), abs=tolerance * here.total_spin + 1e-12)


@pytest.mark.parametrize("model", models())
@settings(parent=slow)
@given(several=st.lists(deliveries, min_size=1, max_size=9), place=st.integers(0, 8))
def test_a_shot_does_not_feel_its_neighbours(model, several, place):
    """To the last bit, wherever it stands in its pack of lanes."""
    place %= len(several)
    columns = {name: np.array([each[name] for each in several]) for name in several[0]}
    batch = clubface.impact("driver", columns, model=model, on_error="nan")
    alone = clubface.impact("driver", several[place], model=model, on_error="nan")
    assert np.array_equal(batch._values[:, place], alone._values[:, 0], equal_nan=True)


@pytest.mark.parametrize("model", models())
@settings(parent=slow)
@given(delivery=deliveries)
def test_faster_clubs_make_faster_balls(model, delivery):
    slower = {**delivery, "speed": 0.9 * delivery["speed"]}
    fast, slow_one = (clubface.impact("driver", each, model=model) for each in (delivery, slower))
    assert fast.ball_speed > slow_one.ball_speed


flights = st.fixed_dictionaries(
    {
        "ball_speed": st.floats(20.0, 85.0),
        "launch": degrees(2, 45),
        "azimuth": degrees(-10, 10),
        "backspin": st.floats(50.0, 1000.0),
        "sidespin": st.floats(-150.0, 150.0),
    }
)


@settings(parent=quick)
@given(shot=flights, wind=st.tuples(st.floats(-8, 8), st.just(0.0), st.floats(-8, 8)))
def test_a_mirrored_flight_lands_on_the_other_side(shot, wind):
    """Exact: the mirror changes signs alone."""
    mirrored = {**shot, "azimuth": -shot["azimuth"], "sidespin": -shot["sidespin"]}
    one, other = clubface.fly(shot, wind=wind), clubface.fly(mirrored, wind=(wind[0], 0.0, -wind[2]))
    assert (other.carry, other.apex, other.total) == (one.carry, one.apex, one.total)
    assert (other.side, other.total_side) == (-one.side, -one.total_side)


@settings(parent=quick)
@given(shot=flights)
def test_air_at_rest_gives_no_energy_to_a_ball(shot):
    """It lands at the height it left from, no faster; 1e-9 for the steps."""
    assert clubface.fly(shot).landing_speed <= shot["ball_speed"] * (1.0 + 1e-9)
