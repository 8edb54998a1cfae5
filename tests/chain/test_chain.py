"""The chain from torques to carry: equations of motion against energy, Lagrange and MuJoCo; derivatives."""

import numpy as np
import pytest

import clubface
from clubface.errors import InputError

jax = pytest.importorskip("jax", reason="the extra jax is not installed")
import jax.numpy as jnp  # noqa: E402

from clubface import chain  # noqa: E402
from clubface.chain.flexible import attached_inputs  # noqa: E402
from clubface.chain.mechanics import (  # noqa: E402
    accelerations,
    head_motion,
    kinetic_energy,
    mass_matrix,
    pose,
    potential_energy,
)
from clubface.equipment.shafts import Shaft  # noqa: E402
from clubface.simulation.beam import beam_axes  # noqa: E402

VARIED = ("onset", "maximum_torque", "bending_stiffness", "torsional_stiffness")


@pytest.fixture(autouse=True, scope="module")
def double_precision():
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", False)


@pytest.fixture(scope="module")
def swing():
    return chain.Swing("driver", "graphite", links=8)


@pytest.fixture(scope="module")
def rigid():
    return chain.Swing("driver", "graphite", modes=0, links=1, step=1e-4)


@pytest.fixture(scope="module")
def values(swing):
    return {name: swing.values()[name] for name in VARIED}


@pytest.fixture(scope="module")
def carry(swing):
    return jax.jit(lambda values: swing.shot(**values).flight["carry"])


@pytest.fixture(scope="module")
def gradient(swing, values):
    return jax.jit(jax.grad(lambda values: swing.shot(**values).flight["carry"]))(values)


@pytest.fixture(scope="module")
def somewhere(swing):
    """Coordinates and rates of a bent shaft in the middle of a swing."""
    joints, modes = swing.mechanism.joints, len(swing.flexible.frequency)
    bent = 0.03 * np.random.default_rng(1).normal(size=modes) / np.arange(1, modes + 1) ** 2
    coordinates = np.concatenate([np.linspace(-0.9, -1.4, joints), bent])
    return jnp.array(coordinates), jnp.array(np.concatenate([[5.0, 9.0, 20.0], 30.0 * bent[::-1]]))


def test_velocities_are_the_derivatives_of_places_and_rotations(swing, somewhere):
    mechanism = swing.mechanism

    @jax.jit
    def computed(coordinates, rates):
        (_, turns), (moving, turning) = jax.jvp(lambda x: pose(mechanism, x), (coordinates,), (rates,))
        head = head_motion(mechanism, coordinates, rates)
        moved = jax.jvp(lambda x: head_motion(mechanism, x, rates).position, (coordinates,), (rates,))[1]
        return turns, moving, turning, head, moved, kinetic_energy(mechanism, coordinates, rates)

    turns, moving, turning, head, moved, energy = map_numpy(computed(*somewhere))
    spin = np.einsum("bij,bkj->bik", turning, turns)
    assert np.allclose(spin, -np.swapaxes(spin, 1, 2), atol=1e-12)  # a rotation stays one
    about = np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], -1)
    assert np.allclose(about[-1], head.angular_velocity, rtol=1e-12)
    assert np.allclose(moved, head.velocity, rtol=1e-12)
    # The energy is the sum over the bodies of what their own velocities have.
    own = np.einsum("bij,bi->bj", turns, about)
    expected = 0.5 * np.einsum("b,bi,bi", mechanism.mass, moving, moving)
    expected += 0.5 * np.einsum("bi,bij,bj", own, mechanism.inertia, own)
    assert energy == pytest.approx(expected, rel=1e-12)


def test_accelerations_satisfy_lagranges_equations(swing, somewhere):
    """d/dt (dL/dv) - dL/dx = Q, by derivatives of the energies alone."""
    mechanism, joints = swing.mechanism, swing.mechanism.joints
    driven = jnp.array([60.0, 40.0, 10.0])

    @jax.jit
    def computed(coordinates, rates):
        stiffness = swing._stiffness(swing.values())
        forces = jnp.concatenate([driven, -stiffness @ coordinates[joints:]])

        def lagrangian(x, v):
            return kinetic_energy(mechanism, x, v) - potential_energy(mechanism, x, stiffness)

        solved = accelerations(mechanism, coordinates, rates, forces)
        momentum = jax.grad(lagrangian, 1)
        change = jax.jvp(momentum, (coordinates, rates), (rates, solved))[1]
        inertia = jax.jacfwd(momentum, 1)(coordinates, rates) - mass_matrix(mechanism, coordinates)
        return change - jax.grad(lagrangian)(coordinates, rates), inertia

    left, inertia = computed(*somewhere)
    # Rounding: terms of thousands, through an inertia matrix whose condition is 1e4.
    assert np.allclose(left[:joints], driven, atol=1e-8)
    assert np.allclose(left[joints:], 0.0, atol=1e-8)
    assert np.allclose(inertia, 0.0, atol=1e-12)


def test_the_work_of_the_torques_is_the_gain_of_energy_and_the_heat(swing):
    """At every time of the swing; fourth order leaves 1e-6 of the energy with steps of half a millisecond."""
    motion = swing.motion()
    kinetic, potential = jax.jit(jax.vmap(swing.energy))(motion.coordinates, motion.rates)
    gained = kinetic + potential - potential[0]
    work = motion.work.sum(axis=1)
    assert gained[-1] > 200.0
    assert np.abs(gained + motion.heat - work).max() < 1e-6 * gained[-1]
    assert 0.1 < motion.heat[-1] < 20.0


def test_a_swing_ends_square_on_the_ball_and_is_that_of_a_golfer(swing):
    shot = swing.shot()
    assert shot.delivery["face"] == pytest.approx(0.0, abs=1e-9)
    assert 38.0 < shot.delivery["speed"] < 50.0
    assert 0.2 < shot.time < 0.32
    # The shaft leads and droops: more loft than the club has, and the toe down.
    assert shot.delivery["loft"] > swing.club.loft
    assert shot.delivery["lie"] < 0.0
    # Once more by the head's pose, through the package without JAX.
    head = swing.head(shot.coordinates, shot.rates)
    delivery = clubface.Delivery.from_pose(*map(np.asarray, head), club=swing.club, ball_position=np.asarray(shot.ball))
    launch = clubface.impact(swing.club.on_shaft("graphite"), delivery)
    assert float(shot.launch["ball_speed"]) == pytest.approx(float(launch.ball_speed), rel=1e-9)
    assert float(shot.launch["backspin"]) == pytest.approx(float(launch.backspin), rel=1e-7)


def test_a_ball_further_ahead_is_met_later_and_with_a_more_closed_face(swing):
    square = swing.shot()
    ahead = swing.shot(ball_forward=square.ball[0] + 0.05)
    assert float(ahead.ball[0] - square.ball[0]) == pytest.approx(0.05, abs=1e-9)
    assert ahead.time > square.time
    assert ahead.delivery["face"] < -0.01
    assert ahead.delivery["attack"] > square.delivery["attack"]


def test_the_gradient_of_carry_is_that_of_central_differences(carry, gradient, values):
    """Fourth-order differences agree to six digits: flights are integrated to 1e-8, a difference divides by 1e-3.

    All components of a value change together, each by another amount, so that an error in one of them shows. Where they
    cancel, one digit is lost.
    """
    for name, step in (("onset", 2e-4), ("maximum_torque", 0.2), ("bending_stiffness", 0.1)):
        direction = np.linspace(1.0, 0.4, len(values[name]))

        def at(steps, name=name, change=step * direction):
            return float(carry({**values, name: values[name] + steps * change}))

        difference = (8.0 * (at(1) - at(-1)) - at(2) + at(-2)) / (12.0 * step)
        assert float(gradient[name] @ direction) == pytest.approx(difference, rel=2e-5), name


@pytest.mark.study
def test_forward_mode_gives_the_same_gradient(carry, gradient, values):
    tangent = {name: jnp.linspace(0.5, 1.0, len(value)) * value for name, value in values.items()}
    _, change = jax.jvp(carry, (values,), (tangent,))
    assert float(change) == pytest.approx(float(sum((gradient[n] * tangent[n]).sum() for n in values)), rel=1e-9)


def test_the_stiffness_of_an_attached_shaft_has_exact_derivatives():
    club, shaft = clubface.club("driver"), Shaft.builtin("graphite")
    inputs = attached_inputs(club, shaft)
    bending, torsional = (jnp.array(each) for each in (shaft.bending_stiffness, shaft.torsional_stiffness))
    slope = jax.jacfwd(inputs)(bending, torsional)["added_mass_xx"]
    for place in (0, 4):

        def at(share, place=place):
            return float(inputs(bending.at[place].mul(1.0 + share), torsional)["added_mass_xx"])

        step = 2e-3
        difference = (8.0 * (at(step) - at(-step)) - at(2 * step) + at(-2 * step)) / (12.0 * step * bending[place])
        assert float(slope[place]) == pytest.approx(float(difference), rel=1e-5)
    assert inputs(bending, torsional)["added_mass_xx"] == pytest.approx(club.on_shaft(shaft).added_inertia[0][0])


def test_five_shapes_have_the_frequencies_of_the_beam(swing):
    """By Rayleigh and Ritz from above; the head outweighs the shaft, so that statics come within 1e-4 and 2e-3."""
    fine = chain.Swing("driver", "graphite", modes=10, links=8).flexible.frequency
    share = swing.flexible.frequency[:3] / fine[:3] - 1.0
    assert (share > -1e-12).all()
    assert share[:2].max() < 1e-4
    assert share[2] < 2e-3


def map_numpy(values):
    return jax.tree.map(np.asarray, values)


def simulated(swing, links, until, step):
    """The same golfer in MuJoCo, under the same torques, at a time [s]."""
    mujoco = pytest.importorskip("mujoco", reason="the extra mujoco is not installed")
    model = mujoco.MjModel.from_xml_string(swing.mjcf(links=links))
    model.opt.timestep = step
    data = mujoco.MjData(model)
    joints = swing.mechanism.joints
    values = swing.values()
    data.qpos[:joints] = swing.golfer.start
    if links:
        bend = swing.motion().coordinates[0, joints:]
        own = np.einsum("m,mli->li", bend, swing.flexible.turn) @ beam_axes(np.array(swing.shaft.axis))[[1, 2, 0]].T
        data.qpos[joints:] = own.ravel()

    def drive(_, state):
        state.qfrc_applied[:joints] = swing._compiled_torques(
            state.time, state.qpos[:joints], state.qvel[:joints], values
        )

    mujoco.set_mjcb_control(drive)
    try:
        for _ in range(round(until / step)):
            mujoco.mj_step(model, data)
        mujoco.mj_forward(model, data)
    finally:
        mujoco.set_mjcb_control(None)
    velocity = np.zeros(6)
    mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_BODY, model.body("head").id, velocity, 0)
    return data, velocity


def test_mujoco_moves_a_rigid_club_alike(rigid):
    motion = rigid.motion()
    place = int(np.searchsorted(motion.time, 0.22 - 1e-9))
    data, velocity = simulated(rigid, 0, float(motion.time[place]), 2e-4)
    # Both integrate to fourth order, and MuJoCo's rounding is coarser: 1e-8 rad, 1e-7 m/s.
    assert np.allclose(data.qpos, motion.coordinates[place], atol=1e-8)
    head = rigid.head(motion.coordinates[place], motion.rates[place])
    assert np.allclose(velocity[3:], head.velocity, atol=1e-6)


def test_mujoco_bends_a_shaft_of_rigid_links_alike():
    """MuJoCo turns its links about one axis after another: their error falls with the square of the length of
    a link, to 0.06 mm with 20 links; with 8 it is 0.32 mm, 0.014 m/s and 0.0006 rad."""
    swing = chain.Swing("driver", "graphite", modes=9, links=8, damping=0.0, step=2.5e-4)
    motion = swing.motion()
    place = int(np.searchsorted(motion.time, 0.24 - 1e-9))
    data, velocity = simulated(swing, 8, float(motion.time[place]), 5e-5)
    head = swing.head(motion.coordinates[place], motion.rates[place])
    straight = motion.coordinates[place].at[3:].set(0.0)
    bent = np.linalg.norm(head.position - swing.head(straight, motion.rates[place]).position)
    assert bent > 0.01
    assert np.linalg.norm(data.body("head").xpos - head.position) < 4e-4
    assert np.linalg.norm(velocity[3:] - head.velocity) < 0.02
    assert np.abs(data.body("head").xmat.reshape(3, 3) - head.rotation).max() < 1e-3


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"onset": [0.0, 0.1]}, "onset"),
        ({"colour": 1.0}, "colour"),
        ({"maximum_torque": [0.0, 0.0, 0.0]}, "without impact"),
    ],
)
def test_mistakes_are_named(swing, values, message):
    with pytest.raises((InputError, ValueError), match=message):
        swing.shot(**values)


def test_the_shaft_begins_in_balance_with_its_weight(swing):
    joints = len(swing.golfer.segments)
    start = swing.motion().coordinates[0]

    @jax.jit
    def pull(coordinates):
        """Force on the coordinates of the shaft, which gravity and its springs make."""
        rest = jnp.zeros_like(coordinates)
        return jnp.linalg.norm(jax.grad(lambda q: swing.energy(q, rest)[1])(coordinates)[joints:])

    # The balance is that of small bending, which misses a part in a hundred of the weight.
    assert pull(start) < 0.02 * pull(start.at[joints:].set(0.0))


def test_a_golfer_needs_a_value_for_each_joint():
    with pytest.raises(InputError, match="onset"):
        chain.GolferBody.three_segments(onset=(0.0, 0.1))
    with pytest.raises(InputError, match="hands"):
        chain.Swing(hands=2.0)
    with pytest.raises(InputError, match="hand"):
        chain.Swing(clubface.club("driver").replace(hand=-1))
