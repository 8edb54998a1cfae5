"""Impacts and flights in PyTorch: the launch itself, and its exact derivatives in both modes."""

import numpy as np
import pytest

import clubface
from clubface.errors import InputError, ShotError

torch = pytest.importorskip("torch", reason="the extra torch is not installed")
from torch.autograd import forward_ad, gradcheck, gradgradcheck  # noqa: E402
from torch.func import grad, hessian, jacfwd, jacrev, jvp, vmap  # noqa: E402

import clubface.torch  # noqa: E402

DRIVE = {"speed": 48.0, "attack": 0.03, "path": 0.02, "loft": 0.22, "face": -0.01, "lie": 0.03, "toe": 0.008,
         "high": 0.004, "closure": 40.0}  # fmt: skip
MODELS = ["response", "standard", "adjusted", "slip", "volumetric", "rings", "area"]
SIZES = {"speed": 50.0, "attack": 0.1, "path": 0.1, "loft": 0.2, "face": 0.1, "lie": 0.1, "toe": 0.01, "high": 0.01,
         "closure": 50.0}  # fmt: skip


def tensors(values, **options):
    return {name: torch.tensor(value, dtype=torch.float64, **options) for name, value in values.items()}


def carry(values):
    launch = clubface.torch.impact("driver", values)
    return clubface.torch.fly(launch, wind=(-3.0, 0.0, 1.0), outputs=["carry"])["carry"]


def scaled(function):
    """A function of numbers near 1, for the checks of PyTorch, which move every variable by as much."""
    unit = torch.tensor(list(SIZES.values()), dtype=torch.float64)

    def of_numbers(x):
        return function(dict(zip(SIZES, (x * unit).unbind(-1), strict=True)))

    return of_numbers, torch.tensor([DRIVE[name] for name in SIZES], dtype=torch.float64) / unit


@pytest.mark.parametrize("hand", ["right", "left"])
@pytest.mark.parametrize("model", MODELS)
def test_the_launch_and_its_derivatives_are_those_of_the_package(model, hand):
    """One code computes both; packs of other widths may differ in the last bits, which a contact magnifies."""
    table = clubface.sensitivity("driver", DRIVE, model=model, hand=hand, variables=list(DRIVE))

    def launch(values):
        return clubface.torch.impact("driver", values, model=model, hand=hand)

    values = tensors(DRIVE)
    for name, value in launch(values).items():
        assert value.item() == pytest.approx(getattr(table.launch, name), rel=1e-10, abs=1e-12), name
    for jacobian in (jacfwd(launch)(values), jacrev(launch)(values)):
        assert set(jacobian) == set(table.outputs)
        for output, row in jacobian.items():
            for name, derivative in row.items():
                assert derivative.item() == pytest.approx(table.value(output, name), rel=1e-8, abs=1e-8), (output, name)


def test_backward_gives_the_gradient_of_a_carry():
    values = tensors(DRIVE, requires_grad=True)
    carry(values).backward()
    gradient = grad(carry)(tensors(DRIVE))
    for name, each in values.items():
        assert each.grad.item() == pytest.approx(gradient[name].item(), rel=1e-12), name


def test_the_checks_of_pytorch_pass_in_both_modes_and_twice():
    """Differences over 1e-5 of the size of a variable; a carry is 200 m, so that they round at 1e-5 m of it."""
    function, point = scaled(carry)
    batch = torch.stack([point, 1.02 * point]).requires_grad_()
    assert gradcheck(function, batch, eps=1e-5, atol=1e-4, rtol=1e-5, check_forward_ad=True, check_batched_grad=True)
    assert gradgradcheck(function, batch, eps=1e-5, atol=1e-2, rtol=1e-4, check_fwd_over_rev=True)


def test_second_derivatives_agree_in_every_order_of_modes():
    function, point = scaled(carry)
    results = [hessian(function)(point), jacrev(jacrev(function))(point), jacfwd(jacfwd(function))(point)]
    for each in results:
        torch.testing.assert_close(each, each.mT, rtol=1e-9, atol=1e-9)
        torch.testing.assert_close(each, results[0], rtol=1e-9, atol=1e-9)
    assert results[0].abs().max() > 1.0


def test_forward_mode_is_a_column_of_the_jacobian():
    values = tensors(DRIVE)
    tangents = {name: torch.zeros_like(each) for name, each in values.items()} | {
        "loft": torch.ones_like(values["loft"])
    }
    _, slope = jvp(carry, (values,), (tangents,))
    assert slope.item() == pytest.approx(grad(carry)(values)["loft"].item(), rel=1e-12)
    with forward_ad.dual_level():
        loft = forward_ad.make_dual(values["loft"], tangents["loft"])
        dual = forward_ad.unpack_dual(carry({**values, "loft": loft}))
    assert dual.tangent.item() == pytest.approx(slope.item(), rel=1e-12)


def test_a_mapped_batch_is_its_shots():
    offsets = torch.linspace(-0.02, 0.02, 7, dtype=torch.float64)

    def at(toe, speed):
        return carry({**DRIVE, "toe": toe, "speed": speed})

    speed = torch.tensor(48.0, dtype=torch.float64)
    one = grad(at)
    together = vmap(one, in_dims=(0, None))(offsets, speed)
    torch.testing.assert_close(together, torch.stack([one(each, speed) for each in offsets]), rtol=1e-9, atol=1e-9)
    grid = vmap(vmap(at, (0, None)), (None, 0))(offsets, torch.tensor([40.0, 50.0], dtype=torch.float64))
    assert grid.shape == (2, 7)
    curvature = vmap(hessian(at), in_dims=(0, None))(offsets, speed)
    assert curvature[2].item() == pytest.approx(hessian(at)(offsets[2], speed).item(), rel=1e-6)


def test_fixed_arrays_broadcast_with_tensors_and_with_the_axes_of_vmap():
    lofts, offsets = np.linspace(0.15, 0.25, 4), torch.tensor([0.0, 0.01, 0.02], dtype=torch.float64)
    result = vmap(lambda toe: clubface.torch.impact("driver", speed=48.0, loft=lofts, toe=toe)["ball_speed"])(offsets)
    expected = clubface.impact("driver", speed=48.0, loft=lofts, toe=offsets.numpy()[:, None]).ball_speed
    np.testing.assert_allclose(result, expected, rtol=1e-12)


def test_parameters_air_and_ground_are_variables():
    friction, warmth, rolling = (torch.tensor(x, dtype=torch.float64, requires_grad=True) for x in (0.3, 288.0, 0.13))

    def total(friction, warmth, rolling):
        launch = clubface.torch.impact("7-iron", DRIVE, parameters={"friction": friction})
        flown = clubface.torch.fly(launch, air={"temperature": warmth}, outputs=["carry"])
        rolled = clubface.torch.fly(
            {"ball_speed": 70.0, "launch": 0.2, "backspin": 270.0, "sidespin": 0.0},
            ground={"rolling_friction": rolling},
        )
        return flown["carry"], rolled["total"]

    assert gradcheck(total, (friction, warmth, rolling), eps=1e-5, atol=1e-4, rtol=1e-4)


def test_single_precision_stays_single_and_is_computed_in_double():
    """Only what goes in and out is rounded, to 6e-8 of it, which the loft passes on to the launch."""
    values = {name: torch.tensor(value, dtype=torch.float32) for name, value in DRIVE.items()}
    result, exact = clubface.torch.impact("driver", values), clubface.impact("driver", DRIVE)
    for name in ("ball_speed", "launch", "backspin"):
        assert result[name].dtype == torch.float32
        assert result[name].item() == pytest.approx(getattr(exact, name), rel=2e-6), name
    gradient, double = grad(carry)(values), grad(carry)(tensors(DRIVE))
    for name, slope in gradient.items():
        assert slope.dtype == torch.float32
        assert slope.item() == pytest.approx(double[name].item(), rel=1e-4, abs=1e-6), name


@pytest.mark.parametrize("kind", [torch.float32, torch.float64])
def test_a_pose_is_differentiated_down_to_the_carry(kind):
    there = clubface.torch.pose(tensors(DRIVE), "driver")
    for one, other in zip(there, clubface.Delivery(**DRIVE).pose("driver"), strict=True):
        np.testing.assert_allclose(one, other, atol=1e-14)

    def distance(position, velocity, angular_velocity):
        delivery = clubface.torch.delivery_from_pose(
            there.rotation.to(kind), position, velocity, angular_velocity, club="driver"
        )
        return clubface.torch.fly(clubface.torch.impact("driver", delivery), outputs=["carry"])["carry"]

    earlier = there.position - 2.5e-4 * there.velocity
    point = tuple(each.to(kind).requires_grad_() for each in (earlier, there.velocity, there.angular_velocity))
    assert distance(*point).dtype == kind
    if kind == torch.float64:
        assert gradcheck(distance, point, eps=1e-6, atol=1e-1, rtol=1e-4)


def test_jax_gives_the_same_gradient():
    jax = pytest.importorskip("jax", reason="the extra jax is not installed")
    import clubface.jax

    jax.config.update("jax_enable_x64", True)
    try:
        launch = clubface.jax.impact
        other = jax.grad(lambda each: launch("driver", each)["backspin"])(
            {n: jax.numpy.asarray(x) for n, x in DRIVE.items()}
        )
    finally:
        jax.config.update("jax_enable_x64", False)
    ours = grad(lambda each: clubface.torch.impact("driver", each)["backspin"])(tensors(DRIVE))
    for name, slope in ours.items():
        assert slope.item() == float(other[name]), name


def test_impossible_shots_and_derivatives_are_errors():
    speeds = torch.tensor([45.0, 500.0], dtype=torch.float64, requires_grad=True)
    with pytest.raises(ShotError, match="speed"):
        clubface.torch.impact("driver", speed=speeds)
    clubface.torch.impact("driver", speed=speeds, on_error="nan")["launch"].sum().backward()
    assert speeds.grad.isnan().tolist() == [False, True]
    speed = torch.tensor(45.0, dtype=torch.float64)
    for options, advice in (({"model": "rings"}, "closed form"), ({"model": "volumetric"}, "accuracy=1e-10")):
        with pytest.raises(InputError, match=advice):
            hessian(lambda x, o=options: clubface.torch.impact("driver", speed=x, **o)["backspin"])(speed)
    with pytest.raises(InputError, match="1 or 2"):
        grad(lambda x: hessian(lambda y: clubface.torch.impact("driver", speed=y)["launch"])(x))(speed)
