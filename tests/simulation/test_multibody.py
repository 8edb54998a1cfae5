"""Contacts of a program that moves the bodies, against the impact of the same model and conservation laws."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import clubface
from clubface.errors import ClubfaceError
from clubface.simulation.multibody import BallMotion
from clubface.simulation.pose import Pose

DELIVERY = {
    "speed": "105 mph", "attack": "3 deg", "path": "-2 deg", "loft": "13 deg", "face": "1 deg", "lie": "2 deg",
    "toe": "12 mm", "high": "-6 mm", "closure": "2000 deg/s", "pitch_rate": "500 deg/s",
}  # fmt: skip
PLACE = np.array([0.4, 0.1, -0.2])
OUTPUTS = ("velocity_x", "velocity_y", "velocity_z", "spin_x", "spin_y", "spin_z")


def cross_matrix(v):
    x, y, z = v
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def touching(club, hand="right", **delivery):
    """Head and ball at first touch."""
    head = clubface.Delivery(**delivery).pose(club, ball_position=PLACE, hand=hand)
    return Pose(*(np.asarray(each) for each in head)), BallMotion(PLACE)


def spun(pose, time):
    """The head a time later, at constant velocities."""
    spin = pose.angular_velocity
    rate = np.linalg.norm(spin)
    axis = cross_matrix(spin / rate)
    turn = np.eye(3) + np.sin(rate * time) * axis + (1.0 - np.cos(rate * time)) * axis @ axis
    return pose._replace(rotation=turn @ pose.rotation, position=pose.position + time * pose.velocity)


def integrated(contact, club, ball, head, motion):
    """Head and ball after separation, by scipy and the equations of Newton and Euler in world axes."""
    mass, inertia = club.mass, np.array(club.inertia)
    ball_mass, ball_inertia = ball.mass, ball.inertia

    def split(y):
        pose = Pose(y[3:12].reshape(3, 3), y[:3], y[12:15], y[15:18])
        return pose, BallMotion(y[18:21], y[21:24], y[24:27]), y[27:]

    def rates(_, y):
        pose, moving, internal = split(y)
        wrench, internal_rates = contact.evaluate(pose, moving, internal)
        spin, turn = pose.angular_velocity, pose.rotation
        whole = turn @ inertia @ turn.T
        spin_rate = np.linalg.solve(whole, wrench.head_torque - np.cross(spin, whole @ spin))
        return np.concatenate([
            pose.velocity, (cross_matrix(spin) @ turn).ravel(), -wrench.force / mass, spin_rate,
            moving.velocity, wrench.force / ball_mass, wrench.ball_torque / ball_inertia, internal_rates,
        ])  # fmt: skip

    class Parted:
        terminal, direction = True, -1.0

        def __call__(self, _, y):
            return contact.evaluate(*split(y))[0].penetration

    start = np.concatenate([
        head.position, head.rotation.ravel(), head.velocity, head.angular_velocity, motion.position, motion.velocity,
        motion.angular_velocity, contact.initial,
    ])  # fmt: skip
    run = solve_ivp(rates, (0.0, 2e-3), start, rtol=1e-8, atol=1e-9, events=Parted(), first_step=1e-7, method="LSODA")
    assert run.status == 1
    return split(run.y[:, -1])


@pytest.mark.parametrize("model", ["volumetric", "area"])
def test_a_program_with_an_integrator_of_its_own_has_the_impact(model):
    club, ball = clubface.club("driver"), clubface.ball("modern")
    head, motion = touching(club, **DELIVERY)
    contact = clubface.SteppedContact(head, motion, club=club, model=model)
    assert len(contact.names) == len(contact.initial)
    after, launched, _ = integrated(contact, club, ball, head, motion)
    launch = clubface.impact(club, **DELIVERY, model=model, accuracy=1e-10)
    expected = np.array([getattr(launch, name) for name in OUTPUTS])
    values = np.concatenate([launched.velocity, launched.angular_velocity])
    # The tolerance of the integrator, and the spin of the core that goes on turning in the cover.
    assert values == pytest.approx(expected, rel=1e-5, abs=1e-3)
    # Momentum of both, to rounding.
    before = club.mass * head.velocity
    assert club.mass * after.velocity + ball.mass * launched.velocity == pytest.approx(before, rel=1e-9)


@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("model", ["volumetric", "rings", "area"])
def test_a_ball_struck_in_one_step_is_that_of_the_impact(model, hand):
    head, _ = touching("driver", hand, **DELIVERY)
    struck = clubface.StruckBall(club="driver", model=model, hand=hand, position=PLACE)
    assert (struck.phase, struck.launch) == ("waiting", None)
    struck.advance(spun(head, -2e-4), "1 ms")
    assert struck.phase == "launched"
    launch = clubface.impact("driver", **DELIVERY, model=model, hand=hand, accuracy=1e-9)
    for name, value in struck.launch.items():
        # Stages of a quarter of a microsecond: 5e-5, and for the rings, of which one more or less may stick, 3e-3.
        tolerance = 3e-3 if model == "rings" else 5e-5
        size = launch.total_spin if "spin" in name else abs(getattr(launch, name))
        assert abs(value - getattr(launch, name)) < tolerance * max(size, 1.0), name
    flown = struck.motion
    assert np.linalg.norm(flown.velocity) == pytest.approx(struck.launch["ball_speed"])
    # It goes on at this velocity, and the head no longer feels it.
    loads = struck.advance(head, 1e-3)
    assert struck.motion.position - flown.position == pytest.approx(1e-3 * flown.velocity)
    assert not loads.force.any()


def test_an_attached_head_gives_way_with_its_shaft():
    club = clubface.club("driver").on_shaft("graphite")
    head, _ = touching(club, **DELIVERY)
    struck = clubface.StruckBall(club=club, position=PLACE)
    struck.advance(spun(head, -1e-4), 1e-3)
    launch = clubface.impact(club, **DELIVERY, model="volumetric", accuracy=1e-9)
    free = clubface.impact("driver", **DELIVERY, model="volumetric", accuracy=1e-9)
    assert struck.launch["ball_speed"] == pytest.approx(launch.ball_speed, rel=2e-5)
    assert abs(free.ball_speed - launch.ball_speed) > 0.1


def test_mean_forces_over_steps_keep_momentum():
    head, _ = touching("7-iron", speed="85 mph", attack="-4 deg", toe="5 mm", closure="1000 deg/s")
    struck = clubface.StruckBall(club="7-iron", position=PLACE, head_gives_way=False)
    head, impulse, step = spun(head, -3e-6), np.zeros(3), 5e-6
    while struck.phase != "launched":
        impulse += step * struck.advance(head, step).force
        head = spun(head, step)
    mass = clubface.ball("modern").mass
    assert impulse == pytest.approx(-mass * struck.motion.velocity, rel=1e-10, abs=1e-12)


def test_derivatives_of_what_acts_are_those_of_differences():
    head, motion = touching("driver", **DELIVERY)
    contact = clubface.SteppedContact(head, motion, club="driver")
    deeper = motion._replace(position=PLACE - [1e-3, 0.0, 0.0])
    result = contact.jacobian(head, deeper, contact.initial)
    wrench, rates = contact.evaluate(head, deeper, contact.initial)
    assert result.wrench.force == pytest.approx(wrench.force)
    assert result.rates == pytest.approx(rates)
    along = np.array([0.3, -0.8, 0.5])
    for place, change in (
        (6, lambda by: (head._replace(velocity=head.velocity + by * along), deeper)),
        (3, lambda by: (head._replace(rotation=head.rotation + by * cross_matrix(along) @ head.rotation), deeper)),
        (18, lambda by: (head, deeper._replace(angular_velocity=by * along))),
    ):
        more, less = (contact.evaluate(*change(by), contact.initial)[0] for by in (1e-6, -1e-6))
        slopes = (more.force - less.force) / 2e-6
        derivatives = result.wrench_derivatives.force[:, place : place + 3] @ along
        # Central differences of a smooth force: rounding of 1e4 N over 1e-6.
        assert derivatives == pytest.approx(slopes, rel=1e-5, abs=1e-2)


def mistakes():
    head, motion = touching("driver", **DELIVERY)
    contact = clubface.SteppedContact(head, motion, club="driver")
    struck = clubface.StruckBall(club="driver")
    parting = head._replace(velocity=-head.velocity)
    return {
        "a model without a contact": lambda: clubface.SteppedContact(head, motion, club="driver", model="response"),
        "a club that is not": lambda: clubface.StruckBall(club="drivr"),
        "a face that moves away": lambda: clubface.SteppedContact(parting, motion, club="driver"),
        "no rotation": lambda: contact.evaluate(head._replace(rotation=2.0 * head.rotation), motion, contact.initial),
        "a rotation of a plane": lambda: contact.evaluate(head._replace(rotation=np.eye(2)), motion, contact.initial),
        "a quaternion of nothing": lambda: struck.advance(head._replace(rotation=np.zeros(4)), 1e-6),
        "two numbers": lambda: contact.evaluate(head, motion._replace(position=[1.0, 2.0]), contact.initial),
        "words": lambda: contact.evaluate(head, motion._replace(position="here"), contact.initial),
        "a missing number": lambda: contact.evaluate(head, motion, [*contact.initial[:-1]]),
        "not a number": lambda: contact.evaluate(head, motion._replace(position=[np.nan] * 3), contact.initial),
        "a step backwards": lambda: struck.advance(head, -1e-6),
        "a step of a second": lambda: struck.advance(head, "1 s"),
        "a step in metres": lambda: struck.advance(head, "1 m"),
        "arrays": lambda: clubface.StruckBall(club="driver", parameters={"friction": [0.1, 0.2]}),
    }


@pytest.mark.parametrize("mistake", mistakes())
def test_mistakes_are_named(mistake):
    with pytest.raises(ClubfaceError):
        mistakes()[mistake]()


def test_quaternions_of_any_length_are_rotations():
    head, motion = touching("driver", **DELIVERY)
    contact = clubface.SteppedContact(head, motion, club="driver")
    w = np.sqrt(1.0 + np.trace(head.rotation)) / 2.0
    skew = (head.rotation - head.rotation.T) / (4.0 * w)
    quaternion = 3.0 * np.array([w, skew[2, 1], skew[0, 2], skew[1, 0]])
    deeper = motion._replace(position=PLACE - [1e-3, 0.0, 0.0])
    one, other = (
        contact.evaluate(head._replace(rotation=each), deeper, contact.initial)[0].force
        for each in (head.rotation, quaternion)
    )
    assert one == pytest.approx(other, rel=1e-9)
