"""A head's pose and motion against its delivery: each way back, conservation of momentum, and mirror images."""

import numpy as np
import pytest
from hypothesis import given, settings, strategies as st

import clubface
from clubface.errors import InputError
from clubface.simulation.inputs import equipment, head_of
from clubface.simulation.pose import Pose, delivery_of_pose, pose_of_delivery

ANGLE = st.floats(-0.3, 0.3)
RATE = st.floats(-50.0, 50.0)
DELIVERIES = st.fixed_dictionaries({
    "speed": st.floats(10.0, 60.0), "attack": ANGLE, "path": ANGLE, "loft": st.floats(0.0, 1.0), "face": ANGLE,
    "lie": ANGLE, "toe": st.floats(-0.02, 0.02), "high": st.floats(-0.015, 0.015), "closure": RATE,
    "pitch_rate": RATE, "lie_rate": RATE,
})  # fmt: skip
HANDS = st.sampled_from(["right", "left"])
POINTS = st.one_of(st.sampled_from(["cg", "face_centre"]), st.tuples(*[st.floats(-1.0, 1.0)] * 3))
CLUBS = st.sampled_from(["driver", "7-iron"])
OPEN_DRIVE = {"speed": 50.0, "attack": 0.05, "path": -0.04, "loft": 0.22, "face": 0.03, "lie": 0.06, "toe": 0.012,
              "high": -0.004, "closure": 40.0, "pitch_rate": -8.0, "lie_rate": 12.0}  # fmt: skip


def cross(v):
    """The matrix of v x."""
    return np.cross(np.eye(3), v)


@given(values=DELIVERIES, hand=HANDS, club=CLUBS, point=POINTS, ball_position=st.tuples(*[st.floats(-9, 9)] * 3))
@settings(max_examples=60, deadline=None)
def test_a_delivery_comes_back_from_its_pose_and_launches_alike(values, hand, club, point, ball_position):
    """A lever of up to 1.7 m from a ball up to 16 m away rounds at 1e-15 m or so, which the offsets see."""
    setup = {"club": club, "hand": hand}
    delivery = clubface.Delivery(**values)
    pose = delivery.pose(**setup, point=point, ball_position=ball_position)
    back = clubface.Delivery.from_pose(*pose, **setup, point=point, ball_position=ball_position)
    for name, value in values.items():
        assert getattr(back, name) == pytest.approx(value, rel=1e-12, abs=1e-12), name
    one, other = (clubface.impact(delivery=each, **setup, on_error="nan") for each in (delivery, back))
    for name in ("ball_speed", "launch", "azimuth", "backspin", "sidespin"):
        assert getattr(other, name) == pytest.approx(getattr(one, name), rel=1e-10, abs=1e-10, nan_ok=True), name


@pytest.mark.parametrize("hand", [1.0, -1.0])
def test_the_head_and_the_ball_keep_their_momenta_in_the_axes_of_the_pose(hand):
    """The impulse that launches the ball acts where the ball touches the head: m (v' - v) = -J, I (w' - w) = -r x J.

    With a model of impulses the head does not move during contact, so that both hold to rounding.
    """
    club, setup = clubface.club("driver"), {"club": "driver", "hand": hand}
    rotation, place, velocity, spin = clubface.Delivery(**OPEN_DRIVE).pose(**setup)
    shot = clubface.impact(delivery=OPEN_DRIVE, model="slip", **setup)
    ball, after, turning = (
        np.array([getattr(shot, f"{name}_{axis}") for axis in "xyz"])
        for name in ("velocity", "club_velocity", "club_spin")
    )
    impulse = shot.ball.mass * ball
    np.testing.assert_allclose(club.mass * (after - velocity), -impulse, rtol=1e-10, atol=1e-12)

    mirror = np.diag([1.0, 1.0, hand])
    inertia = rotation @ mirror @ np.array(club.inertia) @ mirror @ rotation.T
    moment = inertia @ (turning - spin)
    # The moment gives the arm up to a part along the impulse; the ball's centre is a radius away along the normal.
    arm = np.linalg.lstsq(-cross(impulse), -moment, rcond=None)[0]
    assert np.allclose(np.cross(arm, impulse), -moment, rtol=1e-9, atol=1e-12)
    normal_of_face = rotation @ mirror @ _normal(club, OPEN_DRIVE["toe"], OPEN_DRIVE["high"])
    contact = -place - shot.ball.radius * normal_of_face
    # The distance of the contact point from the line of the impulse is 0, to rounding of the least squares.
    assert np.linalg.norm(np.cross(contact - arm, impulse)) < 1e-9 * np.linalg.norm(impulse)


def _normal(club, toe, high):
    """The normal of a face with equal radii, a sphere, in the axes of the head."""
    assert club.bulge == club.roll
    x = np.sqrt(club.bulge**2 - toe**2 - high**2)
    s, c = np.sin(club.loft), np.cos(club.loft)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]) @ np.array([x, high, toe]) / club.bulge


def test_the_axes_of_the_head_are_those_of_the_world_at_the_static_loft():
    driver = clubface.club("driver")
    pose = clubface.Delivery(speed=50.0).pose(driver, point="face_centre")
    np.testing.assert_allclose(pose.rotation, np.eye(3), atol=1e-15)
    radius = clubface.ball().radius
    np.testing.assert_allclose(pose.position, [-radius * np.cos(driver.loft), -radius * np.sin(driver.loft), 0.0])


@given(values=DELIVERIES, hand=HANDS)
@settings(max_examples=20, deadline=None)
def test_a_mirror_turns_path_and_face_round_and_leaves_the_rest(values, hand):
    other = "left" if hand == "right" else "right"
    pose = clubface.Delivery(**values).pose("driver", hand=hand)
    mirror = np.diag([1.0, 1.0, -1.0])
    seen = (mirror @ pose.rotation @ mirror, mirror @ pose.position, mirror @ pose.velocity)
    delivery = clubface.Delivery.from_pose(*seen, -mirror @ pose.angular_velocity, club="driver", hand=other)
    expected = {**values, "path": -values["path"], "face": -values["face"]}
    for name, value in expected.items():
        assert getattr(delivery, name) == pytest.approx(value, rel=1e-12, abs=1e-13), name


def test_a_head_on_its_way_is_moved_on_to_first_touch():
    """Poses along a motion with constant velocities have the same first touch; here to rounding of the positions."""
    pose = clubface.Delivery(**OPEN_DRIVE).pose("driver")
    axis = pose.angular_velocity / np.linalg.norm(pose.angular_velocity)
    for time in (-0.9e-3, -1e-4, 3e-4):
        angle = np.linalg.norm(pose.angular_velocity) * time
        turn = np.eye(3) + np.sin(angle) * cross(axis) + (1 - np.cos(angle)) * cross(axis) @ cross(axis)
        earlier = (turn @ pose.rotation, pose.position + time * pose.velocity)
        back = clubface.Delivery.from_pose(*earlier, pose.velocity, pose.angular_velocity, club="driver")
        for name, value in OPEN_DRIVE.items():
            assert getattr(back, name) == pytest.approx(value, rel=1e-10, abs=1e-12), name


def test_a_quaternion_of_any_length_is_its_rotation():
    half = 0.1
    quaternion = 3.0 * np.array([np.cos(half), 0.0, np.sin(half), 0.0])  # about the vertical, so that the face closes
    motion = {"position": [-0.065, -0.016, 0.0], "velocity": [45.0, 0.0, 0.0], "angular_velocity": [0.0, 40.0, 0.0]}
    delivery = clubface.Delivery.from_pose(quaternion, **motion, club="driver")
    assert delivery.face == pytest.approx(-2.0 * half, abs=40.0 * 1e-3)
    c, s = np.cos(2.0 * half), np.sin(2.0 * half)
    matrix = [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]]
    other = clubface.Delivery.from_pose(matrix, **motion, club="driver")
    assert delivery.face == pytest.approx(other.face, rel=1e-13)
    assert delivery.toe == pytest.approx(other.toe, rel=1e-12)


def test_leading_axes_broadcast():
    speeds, tilts = np.linspace(30.0, 50.0, 4), np.linspace(-0.1, 0.1, 3)[:, None]
    delivery = clubface.Delivery(speed=speeds, lie=tilts, loft=0.2)
    pose = delivery.pose("driver")
    assert [each.shape for each in pose] == [(3, 4, 3, 3), (3, 4, 3), (3, 4, 3), (3, 4, 3)]
    back = clubface.Delivery.from_pose(*pose, club="driver")
    np.testing.assert_allclose(back.lie, np.broadcast_to(tilts, (3, 4)), atol=1e-14)
    single = clubface.Delivery.from_pose(*(each[1, 2] for each in pose), club="driver")
    assert single.speed == pytest.approx(speeds[2], rel=1e-14)
    assert isinstance(single.speed, float)


def test_the_spin_of_the_ball_is_given_in_the_world():
    pose = clubface.Delivery(speed=50.0).pose("driver")
    delivery = clubface.Delivery.from_pose(*pose, club="driver", ball_angular_velocity=[1.0, 2.0, 3.0])
    assert (delivery.ball_riflespin, delivery.ball_sidespin, delivery.ball_backspin) == (1.0, -2.0, 3.0)


@given(values=DELIVERIES, hand=st.sampled_from([1.0, -1.0]))
@settings(max_examples=20, deadline=None)
def test_a_complex_step_gives_derivatives(values, hand):
    """Down the whole way from a displaced pose to a delivery, against central differences, good to 1e-6 or so."""
    head = head_of(equipment("driver", None), hand)
    pose = pose_of_delivery(
        np, {name: np.asarray(each) for name, each in values.items()}, np.zeros(3), head, np.zeros(3)
    )

    def at(amount):
        twist = amount * np.array([1.0, -2.0, 0.5])
        moved = Pose(
            pose.rotation + np.array([np.cross(twist, each) for each in pose.rotation.T]).T,
            pose.position + amount * np.array([0.2, 0.5, -0.7]),
            pose.velocity + amount * np.array([2.0, 5.0, -7.0]),
            pose.angular_velocity,
        )
        return delivery_of_pose(np, moved, np.zeros(3), head, np.zeros(3)).values

    exact, ahead, behind = at(1e-30j), at(1e-6), at(-1e-6)
    for name in values:
        derivative = np.imag(exact[name]) / 1e-30
        assert derivative == pytest.approx((ahead[name] - behind[name]) / 2e-6, rel=1e-6, abs=1e-6), name


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"rotation": np.diag([1.0, 1.0, -1.0])}, "rotation"),
        ({"rotation": 1.1 * np.eye(3)}, "orthogonal"),
        ({"rotation": np.zeros(4)}, "length 0"),
        ({"rotation": np.eye(2)}, r"\(\.\.\., 3, 3\)"),
        ({"velocity": [1.0, 2.0]}, r"velocity .*\(\.\.\., 3\)"),
        ({"position": [-0.5, 0.0, 0.0]}, "first touch"),
        ({"velocity": [0.0, 0.0, 0.0]}, "first touch"),
        ({"position": np.zeros((2, 3)), "velocity": np.ones((5, 3))}, "broadcast"),
        ({"point": "hosel"}, "face_centre"),
    ],
)
def test_a_mistake_is_named(wrong, message):
    good = dict(zip(Pose._fields, clubface.Delivery(speed=50.0).pose("driver"), strict=True))
    with pytest.raises(InputError, match=message):
        clubface.Delivery.from_pose(**{**good, **wrong}, club="driver")
