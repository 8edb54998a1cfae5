"""Impacts and flights in JAX: the launch itself, its exact derivatives, and every transformation of them."""

import numpy as np
import pytest

import clubface
from clubface.errors import InputError, ShotError, UnknownNameError

jax = pytest.importorskip("jax", reason="the extra jax is not installed")
import jax.numpy as jnp  # noqa: E402
from jax.test_util import check_grads  # noqa: E402

import clubface.jax  # noqa: E402

DRIVE = {"speed": 48.0, "attack": 0.03, "path": 0.02, "loft": 0.22, "face": -0.01, "lie": 0.03, "toe": 0.008,
         "high": 0.004, "closure": 40.0}  # fmt: skip
MODELS = ["response", "standard", "adjusted", "slip", "jorgensen", "volumetric", "rings", "area"]
NAMES = ("ball_speed", "launch", "azimuth", "backspin", "sidespin")


@pytest.fixture(autouse=True)
def double_precision():
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", False)


def traced(values):
    return {name: jnp.asarray(value) for name, value in values.items()}


def swing_of(model):
    """The drive, at the face centre for a model that knows no other place."""
    return DRIVE if clubface.models()[model].gear_effect else {**DRIVE, "toe": 0.0, "high": 0.0}


def carry(values):
    launch = clubface.jax.impact("driver", values)
    return clubface.jax.fly(launch, wind=(-3.0, 0.0, 1.0), outputs=["carry"])["carry"]


@pytest.mark.parametrize(
    ("model", "hand"), [*((model, "right") for model in MODELS), ("slip", "left"), ("volumetric", "left")]
)
def test_the_launch_and_its_derivatives_are_those_of_the_package(model, hand):
    """One code computes both; packs of other widths may differ in the last bits, which a contact magnifies."""
    table = clubface.sensitivity("driver", swing_of(model), model=model, hand=hand, variables=list(DRIVE))

    def launch(values):
        return clubface.jax.impact("driver", values, model=model, hand=hand)

    values = traced(swing_of(model))
    for name, value in launch(values).items():
        assert value == pytest.approx(getattr(table.launch, name), rel=1e-10, abs=1e-12), name
    for jacobian in (jax.jacfwd(launch)(values), jax.jacrev(launch)(values)):
        assert set(jacobian) == set(table.outputs)
        for output, row in jacobian.items():
            for name, derivative in row.items():
                assert derivative == pytest.approx(table.value(output, name), rel=1e-8, abs=1e-8), (output, name)


def test_parameters_club_and_ball_are_variables_too():
    def spin(friction, mass, radius):
        given = {"club_mass": mass, "ball_radius": radius}
        launch = clubface.jax.impact("7-iron", DRIVE, model="volumetric", parameters={"friction": friction}, **given)
        return launch["backspin"]

    point = jnp.asarray(0.3), jnp.asarray(0.26), jnp.asarray(0.0213)
    gradient = jax.grad(spin, (0, 1, 2))(*point)
    fixed = {"club_mass": 0.26, "ball_radius": 0.0213, "model": "volumetric", "parameters": {"friction": 0.3}}
    table = clubface.sensitivity("7-iron", DRIVE, **fixed)
    for name, slope in zip(("friction", "club_mass", "ball_radius"), gradient, strict=True):
        assert slope == pytest.approx(table.value("backspin", name), rel=1e-8), name


def test_a_carry_is_differentiated_twice_in_both_modes():
    """Against differences by JAX's own check over 1e-5 and 1e-4, which the third and fourth derivatives limit."""
    check_grads(carry, (traced(DRIVE),), order=1, modes=["fwd", "rev"], eps=1e-5, atol=1e-4, rtol=1e-5)
    check_grads(carry, (traced(DRIVE),), order=2, modes=["fwd", "rev"], eps=1e-4, atol=1e-1, rtol=1e-3)


@pytest.mark.parametrize("model", ["standard", "slip"])
def test_a_launch_that_is_proportional_to_the_swing_has_no_curvature_along_it(model):
    """Impulses are linear in the velocities, so that by Euler's theorem H v = 0 and, of the ball's speed, J v = y."""
    swing = traced({"speed": 48.0, "closure": 40.0, "pitch_rate": -9.0, "lie_rate": 6.0})
    rest = {name: value for name, value in DRIVE.items() if name not in swing}
    names, point = list(swing), jnp.stack(list(swing.values()))

    def ball_speed(x):
        values = dict(zip(names, x, strict=True))
        return clubface.jax.impact("driver", {**rest, **values}, model=model)["ball_speed"]

    speed, gradient, hessian = ball_speed(point), jax.grad(ball_speed)(point), jax.hessian(ball_speed)(point)
    assert gradient @ point == pytest.approx(float(speed), rel=1e-12)
    assert np.abs(hessian @ point).max() < 1e-9 * np.abs(gradient).max()
    assert np.abs(hessian).max() > 1e-6


def test_second_derivatives_of_a_contact_are_those_of_its_gradient():
    """To the part in a thousand that the module states; the same swing by differences over four times the distance."""
    names = ["speed", "loft", "toe"]
    point, size = np.array([DRIVE[name] for name in names]), np.array([48.0, 0.22, 0.02])

    def spin(x):
        values = {**DRIVE, **dict(zip(names, x, strict=True))}
        return clubface.jax.impact("driver", values, model="volumetric", accuracy=1e-11)["backspin"]

    hessian = jax.hessian(spin)(jnp.asarray(point))
    gradient = jax.vmap(jax.grad(spin))
    step = 0.05 * size
    moved = jnp.stack([gradient(point + side * np.diag(step)) for side in (1.0, -1.0)])
    differences = (moved[0] - moved[1]) / (2.0 * step[:, None])
    unit = np.abs(jax.grad(spin)(jnp.asarray(point)) * size).max()
    # Differences of second order over a twentieth of the size are themselves good to a few thousandths.
    np.testing.assert_allclose(
        hessian * size * size[:, None] / unit, differences * size * size[:, None] / unit, atol=1e-2
    )


def test_transformations_of_a_batch_are_those_of_its_shots():
    offsets = jnp.linspace(-0.02, 0.02, 7)

    def at(toe, speed):
        return carry({**DRIVE, "toe": toe, "speed": speed})

    one = jax.jit(jax.grad(at))
    together = jax.jit(jax.vmap(one, in_axes=(0, None)))(offsets, 48.0)
    np.testing.assert_allclose(together, [one(each, 48.0) for each in offsets], rtol=1e-9)
    grid = jax.vmap(jax.vmap(jax.value_and_grad(at), (0, None)), (None, 0))(offsets, jnp.array([40.0, 50.0]))
    assert [each.shape for each in grid] == [(2, 7), (2, 7)]
    assert grid[1][1, 3] == pytest.approx(float(one(offsets[3], 50.0)), rel=1e-9)
    bent = jax.jit(jax.hessian(at))
    curvature = jax.vmap(bent, (0, None))(offsets, 48.0)
    assert curvature[2] == pytest.approx(float(bent(offsets[2], 48.0)), rel=1e-6)


def test_fixed_arrays_broadcast_with_variables_and_with_the_axes_of_vmap():
    lofts = np.linspace(0.15, 0.25, 4)

    def speeds(toe):
        return clubface.jax.impact("driver", speed=48.0, loft=lofts, toe=toe)["ball_speed"]

    offsets = jnp.array([0.0, 0.01, 0.02])
    result = jax.vmap(speeds)(offsets)
    expected = clubface.impact("driver", speed=48.0, loft=lofts, toe=np.asarray(offsets)[:, None]).ball_speed
    np.testing.assert_allclose(result, expected, rtol=1e-12)
    assert jax.jacfwd(speeds)(offsets[0]).shape == (4,)


def test_without_variables_the_result_is_that_of_the_package():
    result = clubface.jax.impact("driver", speed="108 mph", loft="12 deg")
    assert result["launch"] == pytest.approx(clubface.impact("driver", speed="108 mph", loft="12 deg").launch)


def test_single_precision_stays_single_and_is_computed_in_double():
    """Only what goes in and out is rounded, to 6e-8 of it, which the loft passes on to the launch."""
    values = {name: jnp.asarray(value, jnp.float32) for name, value in DRIVE.items()}
    result, exact = clubface.jax.impact("driver", values), clubface.impact("driver", DRIVE)
    for name in NAMES:
        assert result[name].dtype == jnp.float32
        assert result[name] == pytest.approx(getattr(exact, name), rel=2e-6), name
    gradient = jax.jit(jax.grad(carry))(values)
    assert {each.dtype for each in gradient.values()} == {jnp.dtype(jnp.float32)}
    double = jax.grad(carry)(traced(DRIVE))
    for name, slope in gradient.items():
        assert slope == pytest.approx(float(double[name]), rel=1e-4, abs=1e-6), name


def test_a_flight_starts_from_vectors_or_from_the_terms_of_a_monitor():
    terms = {"ball_speed": 70.0, "launch": 0.2, "azimuth": 0.03, "backspin": 270.0, "sidespin": -30.0}
    spin = {"total_spin": float(np.hypot(270.0, 30.0)), "spin_axis": float(np.arctan2(-30.0, 270.0))}
    expected = clubface.fly(terms, air={"altitude": 300.0}, ground="soft fairway")
    polar = {name: terms[name] for name in ("ball_speed", "launch", "azimuth")} | spin
    for given in (traced(terms), traced(polar), {**terms, "launch": jnp.asarray(0.2)}):
        flown = clubface.jax.fly(given, air={"altitude": 300.0}, ground="soft fairway")
        for name, value in flown.items():
            assert value == pytest.approx(getattr(expected, name), rel=1e-10, abs=1e-9), name
    with pytest.raises(InputError, match="total_spin and spin_axis"):
        clubface.jax.fly(traced({**terms, "spin_axis": 0.1}))


def test_air_wind_and_ground_are_variables():
    launch = {"ball_speed": 70.0, "launch": 0.2, "backspin": 270.0}

    def total(temperature, headwind, friction):
        air, ground = {"temperature": temperature}, {"rolling_friction": friction}
        return clubface.jax.fly(launch, air=air, wind=(-headwind, 0.0, 0.0), ground=ground)["total"]

    point = jnp.asarray(288.0), jnp.asarray(4.0), jnp.asarray(0.13)
    check_grads(total, point, order=1, modes=["fwd", "rev"], eps=1e-5, atol=1e-5, rtol=1e-4)


def test_the_ball_of_the_impact_flies_on():
    launch = clubface.jax.impact("driver", DRIVE, ball="published")
    flown = clubface.jax.fly(launch, ball="published")["carry"]
    assert flown == pytest.approx(clubface.fly(clubface.impact("driver", DRIVE, ball="published")).carry)


@pytest.mark.parametrize("hand", ["right", "left"])
def test_a_pose_and_its_delivery_are_those_of_the_package(hand):
    there = clubface.jax.pose(traced(DRIVE), "driver", hand=hand)
    flat = clubface.Delivery(**DRIVE).pose("driver", hand=hand)
    for one, other in zip(there, flat, strict=True):
        np.testing.assert_allclose(one, other, atol=1e-14)
    single = [each.astype(jnp.float32) for each in there]
    delivery = clubface.jax.delivery_from_pose(*single, club="driver", hand=hand)
    assert {each.dtype for each in delivery.values()} == {jnp.dtype(jnp.float32)}
    for name, value in DRIVE.items():  # coordinates are rounded to 1e-8 m or so, and what is left of a sum may be more
        assert delivery[name] == pytest.approx(value, rel=1e-4, abs=1e-5), name


def test_a_pose_is_differentiated_down_to_the_carry():
    """A head a quarter of a millisecond before impact, as an integrator leaves it, against differences over 1e-5."""
    there = clubface.jax.pose(traced(DRIVE), "driver", hand="left")

    @jax.jit
    def distance(position, velocity, angular_velocity):
        delivery = clubface.jax.delivery_from_pose(
            there.rotation, position, velocity, angular_velocity, club="driver", hand="left"
        )
        return clubface.jax.fly(clubface.jax.impact("driver", delivery, hand="left"), outputs=["carry"])["carry"]

    point = there.position - 2.5e-4 * there.velocity, there.velocity, there.angular_velocity
    check_grads(distance, point, order=1, modes=["fwd", "rev"], eps=1e-5, atol=1e-2, rtol=1e-4)
    assert jax.vmap(distance)(*(jnp.stack([each, each]) for each in point)).shape == (2,)


def test_shots_that_cannot_be_computed_are_nan_or_an_error():
    speeds = jnp.array([45.0, 500.0])
    with pytest.raises(ShotError, match="speed"):
        clubface.jax.impact("driver", speed=speeds)
    with pytest.raises(jax.errors.JaxRuntimeError, match=r"speed.*150"):
        jax.jit(lambda speed: clubface.jax.impact("driver", speed=speed)["launch"])(speeds).block_until_ready()

    def launch(speed):
        return clubface.jax.impact("driver", speed=speed, on_error="nan")["launch"]

    assert np.isnan(jax.vmap(jax.grad(launch))(speeds)).tolist() == [False, True]


def test_inputs_without_derivatives_are_errors():
    speed = jnp.asarray(48.0)

    def spin(x, **options):
        return clubface.jax.impact("driver", speed=x, **options)["backspin"]

    with pytest.raises(InputError, match="plain number"):
        clubface.jax.impact("driver", speed=48.0, face_width=jnp.asarray(0.1))
    with pytest.raises(UnknownNameError, match="speed"):
        clubface.jax.impact("driver", spede=speed)
    for model, advice in (("rings", "closed form"), ("volumetric", "accuracy=1e-10")):
        with pytest.raises(InputError, match=advice):
            jax.hessian(lambda x, model=model: spin(x, model=model))(speed)
    with pytest.raises(InputError, match="1 or 2"):
        jax.grad(jax.hessian(spin))(speed)
    with pytest.raises(InputError, match="leave total, total_side"):
        jax.hessian(lambda x: clubface.jax.fly({"ball_speed": x, "launch": 0.2, "backspin": 250.0})["carry"])(speed)
