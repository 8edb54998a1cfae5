"""Impacts and flights as functions of JAX, with exact derivatives.

>>> import jax, clubface.jax
>>> def carry(loft):
...     launch = clubface.jax.impact("driver", speed=50.0, loft=loft)
...     return clubface.jax.fly(launch, outputs=["carry"])["carry"]
>>> slope = jax.grad(carry)(0.2)

Inputs that are arrays of JAX are variables, everything else stays fixed. ``jit``, ``vmap``, ``jvp``, ``grad``,
``jacfwd`` and ``jacrev`` work in any order. Value and Jacobian come from one run of the compiled core on the host, in
double precision; results have the precision of the variables, single unless ``jax_enable_x64`` is set.

Second derivatives (``hessian``) are differences of the exact first ones: good to 1e-9 of the largest first derivative,
scaled by the size of the variables, for models in closed form, to 1e-6 for flights without ``total`` and
``total_side``, and to 1e-3 for ``volumetric`` with ``accuracy=1e-10``. Other contact models have none, nor have third
derivatives; asking for them raises an error that says so.

No warning is given of shots outside the range for which a model is valid; :func:`clubface.impact` gives it.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from typing import Any, Literal

import jax
import jax.numpy as jnp
import numpy as np
from jax.core import Tracer

from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.equipment.models import DEFAULT_MODEL
from clubface.errors import InputError
from clubface.simulation.differentiable import Differentiable, flight_function, launch_function
from clubface.simulation.flight import Air
from clubface.simulation.impact import Parameters
from clubface.simulation.inputs import Delivery
from clubface.simulation.pose import Pose
from clubface.simulation.pose_arrays import array_delivery, array_pose

__all__ = ["delivery_from_pose", "fly", "impact", "pose"]


def impact(
    club: str | os.PathLike[str] | Club,
    delivery: Delivery | Mapping[str, Any] | None = None,
    *,
    model: str = DEFAULT_MODEL,
    parameters: Parameters | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    accuracy: float | None = None,
    hand: Any = None,
    outputs: Iterable[str] | None = None,
    threads: int | None = None,
    on_error: Literal["raise", "nan"] = "raise",
    **values: Any,
) -> dict[str, jax.Array]:
    """Compute the launch of a ball hit by a club, as :func:`clubface.impact`.

    Parameters
    ----------
    club, delivery, model, parameters, ball, accuracy, hand, threads, **values
        As for :func:`clubface.impact`; any of the values and of the parameters may be an array of JAX [SI], by which
        the launch is then differentiable. They broadcast.
    outputs
        Names of launch quantities; left out, all that the model gives.
    on_error
        What happens to a shot that cannot be computed: "raise" raises an error of JAX that quotes the reason, "nan"
        gives NaN.

    Returns
    -------
    dict
        The quantities by name [SI].

    Raises
    ------
    InputError
        A name or a value is not allowed, or second derivatives are asked for that do not exist.
    """
    function, arrays = launch_function(
        _is_array, club, delivery, values, parameters, model=model, ball=ball, accuracy=accuracy, hand=hand,
        outputs=outputs, threads=threads, on_error=on_error,
    )  # fmt: skip
    return _call(function, arrays)


def fly(
    launch: Mapping[str, Any],
    *,
    air: Air | Mapping[str, Any] | None = None,
    wind: Any = None,
    ground: str | Mapping[str, Any] | None = None,
    ball: str | os.PathLike[str] | Ball | None = None,
    outputs: Iterable[str] | None = None,
    threads: int | None = None,
    on_error: Literal["raise", "nan"] = "raise",
) -> dict[str, jax.Array]:
    """Compute where a launched ball goes, as :func:`clubface.fly`.

    Parameters
    ----------
    launch
        What :func:`impact` returned with all outputs, or values as for :func:`clubface.fly`: velocity and spin as
        vectors, or ``ball_speed``, ``launch``, ``azimuth`` with backspin and sidespin or total spin and spin axis.
    air, wind, ground, threads
        As for :func:`clubface.fly`; ``temperature``, ``pressure``, ``humidity``, the wind and the values of the ground
        may be arrays of JAX [SI].
    ball
        As for :func:`clubface.ball`: give it if the impact was with another ball than the default one.
    outputs
        Names of quantities of a flight; left out, all. Second derivatives need that ``total``, ``total_side`` and
        ``outside_fit`` are left out: bounces make steps in them.
    on_error
        As for :func:`impact`.

    Returns
    -------
    dict
        The quantities by name [SI].
    """
    function, arrays = flight_function(
        _is_array, jnp, launch, air=air, wind=wind, ground=ground, ball=ball, outputs=outputs, threads=threads,
        on_error=on_error,
    )  # fmt: skip
    return _call(function, arrays)


def delivery_from_pose(
    rotation: Any,
    position: Any,
    velocity: Any,
    angular_velocity: Any,
    *,
    club: str | os.PathLike[str] | Club,
    ball: str | os.PathLike[str] | Ball | None = None,
    ball_position: Any = (0.0, 0.0, 0.0),
    point: Any = "cg",
    hand: Any = None,
) -> dict[str, jax.Array]:
    """Return the values of a delivery by the pose and the motion of the head, as :meth:`clubface.Delivery.from_pose`.

    Everything may be traced but ``club``, ``ball`` and ``hand``. Nothing is checked: a head that does not touch the
    ball within a millisecond or so gives values without meaning.

    Returns
    -------
    dict
        The values by name [SI], as :func:`impact` takes them.
    """
    given = Pose(rotation, position, velocity, angular_velocity)
    values = array_delivery(jnp, jnp.asarray, given, ball_position, club, ball, point, hand, _repeated)
    kind = _kind([*given, ball_position, point])
    return {name: each.astype(kind) for name, each in values.items()}


def pose(
    delivery: Delivery | Mapping[str, Any],
    club: str | os.PathLike[str] | Club,
    *,
    ball: str | os.PathLike[str] | Ball | None = None,
    ball_position: Any = (0.0, 0.0, 0.0),
    point: Any = "cg",
    hand: Any = None,
) -> Pose:
    """Return where the head of a delivery is at first touch and how it moves, as :meth:`clubface.Delivery.pose`."""
    result = array_pose(jnp, jnp.asarray, delivery, ball_position, club, ball, point, hand)
    given = delivery.values() if isinstance(delivery, Delivery) else delivery
    kind = _kind([*given.values(), ball_position, point])
    return Pose(*(each.astype(kind) for each in result))


def _repeated(step: Callable[[Any], Any], count: int) -> Any:
    """Return what ``count`` steps make of 0, compiled as a loop: compilation takes seconds instead of a minute."""
    shape = jax.eval_shape(step, 0.0)
    return jax.lax.scan(lambda value, _: (step(value), None), jnp.zeros(shape.shape, shape.dtype), length=count)[0]


def _is_array(value: Any) -> bool:
    return isinstance(value, jax.Array)


def _kind(values: Iterable[Any]) -> Any:
    """Return the precision of results: that of the arrays among the values, or the default one."""
    kinds = [each.dtype for each in values if _is_array(each) and jnp.issubdtype(each.dtype, jnp.floating)]
    return jnp.result_type(*kinds) if kinds else jnp.result_type(float)


def _call(function: Differentiable, arrays: list[Any]) -> dict[str, jax.Array]:
    kind = _kind(arrays)
    shape = np.broadcast_shapes(function.shape, *(each.shape for each in arrays))
    columns = [jnp.broadcast_to(each, shape).astype(kind) for each in arrays]
    x = jnp.stack(columns, axis=-1) if columns else jnp.zeros((*shape, 0), kind)
    y = _with_rules(function)(x)
    return {name: y[..., place] for place, name in enumerate(function.outputs)}


def _with_rules(function: Differentiable) -> Callable[[jax.Array], jax.Array]:
    """Return the function with its derivatives; each rule is linear in the tangents, so that it can be transposed."""
    rows, width = len(function.outputs), len(function.variables)

    @jax.custom_jvp
    def values(x: jax.Array) -> jax.Array:
        return _on_host(function.values, x, (rows,))

    @jax.custom_jvp
    def values_and_jacobian(x: jax.Array) -> tuple[jax.Array, jax.Array]:
        return _on_host(function.values_and_jacobian, x, (rows,), (rows, width))

    @jax.custom_jvp
    def hessian(x: jax.Array) -> jax.Array:
        return _on_host(function.hessian, x, (rows, width, width))

    @values.defjvp
    def first(primals: Any, tangents: Any) -> Any:
        y, jacobian = values_and_jacobian(*primals)
        return y, _product("...ij,...j->...i", jacobian, *tangents)

    @values_and_jacobian.defjvp
    def second(primals: Any, tangents: Any) -> Any:
        function.check_twice()
        y, jacobian = values_and_jacobian(*primals)
        changes = _product("...ij,...j->...i", jacobian, *tangents)
        return (y, jacobian), (changes, _product("...ijk,...k->...ij", hessian(*primals), *tangents))

    @hessian.defjvp
    def third(primals: Any, tangents: Any) -> Any:
        raise InputError("order of derivatives", 3, "1 or 2")

    return values


def _product(subscripts: str, derivatives: jax.Array, tangent: jax.Array) -> jax.Array:
    return jnp.einsum(subscripts, derivatives, tangent, precision="highest")


def _on_host(compute: Callable[[np.ndarray], Any], x: jax.Array, *shapes: tuple[int, ...]) -> Any:
    """Call a function of the core; its results have the batch of ``x``, followed by each of ``shapes``."""
    if not isinstance(x, Tracer):  # at once, and an error of the core is raised as it is
        return jax.tree.map(lambda each: jnp.asarray(each, x.dtype), compute(np.asarray(x, np.float64)))
    results = tuple(jax.ShapeDtypeStruct((*x.shape[:-1], *each), x.dtype) for each in shapes)

    def host(x: Any) -> Any:
        given = np.asarray(x)
        computed = compute(given.astype(np.float64))
        computed = computed if isinstance(computed, tuple) else (computed,)
        return tuple(np.asarray(each, dtype=given.dtype) for each in computed)

    answer = jax.pure_callback(host, results, x, vmap_method="expand_dims")
    return answer if len(shapes) > 1 else answer[0]
