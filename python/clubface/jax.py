"""Impacts and flights as functions of JAX, with exact derivatives.

>>> import jax, clubface.jax
>>> def carry(loft):
...     launch = clubface.jax.impact("driver", speed=50.0, loft=loft)
...     return clubface.jax.fly(launch, outputs=["carry"])["carry"]
>>> slope = jax.grad(carry)(0.2)

Inputs that are JAX arrays are variables, everything else is constant. ``jit``, ``vmap``, ``jvp``, ``grad``, ``jacfwd``
and ``jacrev`` work in any order. Value and Jacobian come from one run of the compiled core on the host, in double
precision; results have the precision of the variables, single unless ``jax_enable_x64`` is set.

Second derivatives (``hessian``) are differences of the exact first ones, with an error relative to the largest first
derivative, scaled by the size of the variables, of 1e-9 for models in closed form, 1e-6 for flights without ``total``
and ``total_side``, and 1e-3 for ``volumetric`` with ``accuracy=1e-10``. Second derivatives of other contact models, and
third derivatives, do not exist and raise an error.

No warning is given for shots outside the range of validity of a model, unlike in :func:`clubface.impact`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax.core import Tracer

from clubface.errors import InputError
from clubface.simulation.array_functions import ArrayFunctions
from clubface.simulation.differentiable import Differentiable

__all__ = ["delivery_from_pose", "fly", "impact", "pose"]


class _JaxFunctions(ArrayFunctions[jax.Array]):
    xp = jnp

    def _is_array(self, value: Any) -> bool:
        return isinstance(value, jax.Array)

    def _as_array(self, value: Any) -> jax.Array:
        return jnp.asarray(value)

    def _cast(self, array: jax.Array, dtype: Any) -> jax.Array:
        return array.astype(dtype)

    def _precision(self, arrays: Sequence[jax.Array]) -> Any:
        dtypes = [each.dtype for each in arrays if jnp.issubdtype(each.dtype, jnp.floating)]
        return jnp.result_type(*(dtypes or [float]))

    def _evaluate(self, function: Differentiable, x: jax.Array) -> Sequence[jax.Array]:
        y = _with_rules(function)(x)
        return [y[..., place] for place in range(len(function.outputs))]

    def _repeated(self, step: Callable[[Any], Any], count: int) -> Any:
        """Apply a step ``count`` times in a compiled loop; compilation takes seconds instead of a minute."""
        shape = jax.eval_shape(step, 0.0)
        return jax.lax.scan(lambda value, _: (step(value), None), jnp.zeros(shape.shape, shape.dtype), length=count)[0]


_FUNCTIONS = _JaxFunctions()
impact, fly, pose = _FUNCTIONS.impact, _FUNCTIONS.fly, _FUNCTIONS.pose
delivery_from_pose = _FUNCTIONS.delivery_from_pose


def _with_rules(function: Differentiable) -> Callable[[jax.Array], jax.Array]:
    """Attach derivative rules to a function; each is linear in the tangents, so that JAX can transpose it."""
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
    if not isinstance(x, Tracer):  # call at once, so that errors of the core are raised unchanged
        return jax.tree.map(lambda each: jnp.asarray(each, x.dtype), compute(np.asarray(x, np.float64)))
    results = tuple(jax.ShapeDtypeStruct((*x.shape[:-1], *each), x.dtype) for each in shapes)

    def host(x: Any) -> Any:
        given = np.asarray(x)
        computed = compute(given.astype(np.float64))
        computed = computed if isinstance(computed, tuple) else (computed,)
        return tuple(np.asarray(each, dtype=given.dtype) for each in computed)

    answer = jax.pure_callback(host, results, x, vmap_method="expand_dims")
    return answer if len(shapes) > 1 else answer[0]
