"""Impacts and flights as functions of PyTorch, with exact derivatives.

>>> import torch, clubface.torch
>>> loft = torch.tensor(0.2, dtype=torch.float64, requires_grad=True)
>>> launch = clubface.torch.impact("driver", speed=50.0, loft=loft)
>>> clubface.torch.fly(launch, outputs=["carry"])["carry"].backward()
>>> slope = loft.grad

Inputs that are tensors are variables, everything else is constant. Backward, forward-mode derivatives and the
transformations of ``torch.func`` (``grad``, ``jvp``, ``vmap``, ``jacfwd``, ``jacrev``, ``hessian``) work. The compiled
core computes on the processor, in double precision; results have the precision and the device of the variables.

Derivatives are computed on request, for all variables in one run. Second derivatives are differences of the exact first
ones, available for models in closed form, flights, and ``volumetric`` with ``accuracy=1e-10``; see :mod:`clubface.jax`.
No warning is given for shots outside the range of validity of a model.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import reduce
from typing import Any

import numpy as np
import torch  # pyright: ignore[reportMissingImports]
from torch.autograd import forward_ad  # pyright: ignore[reportMissingImports]

from clubface.errors import InputError
from clubface.simulation.array_functions import ArrayFunctions
from clubface.simulation.differentiable import Differentiable

__all__ = ["delivery_from_pose", "fly", "impact", "pose"]


class _TorchFunctions(ArrayFunctions["torch.Tensor"]):
    xp = torch

    def _is_array(self, value: Any) -> bool:
        return isinstance(value, torch.Tensor)

    def _as_array(self, value: Any) -> torch.Tensor:
        return value if self._is_array(value) else torch.as_tensor(np.asarray(value, dtype=np.float64))

    def _cast(self, array: torch.Tensor, dtype: Any) -> torch.Tensor:
        return array.to(dtype)

    def _precision(self, arrays: Sequence[torch.Tensor]) -> torch.dtype:
        dtypes = [each.dtype for each in arrays if each.is_floating_point()]
        return reduce(torch.promote_types, dtypes) if dtypes else torch.get_default_dtype()

    def _evaluate(self, function: Differentiable, x: torch.Tensor) -> Sequence[torch.Tensor]:
        return _Values.apply(x, function).unbind(-1)


_FUNCTIONS = _TorchFunctions()
impact, fly, pose = _FUNCTIONS.impact, _FUNCTIONS.fly, _FUNCTIONS.pose
delivery_from_pose = _FUNCTIONS.delivery_from_pose


class _OnCore(torch.autograd.Function):
    """A function of the core over the last axis of a tensor, differentiated by the function of next higher order."""

    @staticmethod
    def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
        x, ctx.function = inputs
        ctx.save_for_backward(x)
        ctx.save_for_forward(x)

    @classmethod
    def vmap(cls, info: Any, in_dims: Any, x: Any, function: Differentiable) -> Any:
        """Return the result for a tensor with one more axis, and the position of that axis."""
        return cls.apply(x.movedim(in_dims[0], 0), function), 0


class _Values(_OnCore):
    """Outputs, shape (..., outputs)."""

    @staticmethod
    def forward(x: Any, function: Differentiable) -> Any:
        return _computed(function.values, x)

    @staticmethod
    def backward(ctx: Any, *gradients: Any) -> Any:
        (x,), (gradient,) = ctx.saved_tensors, gradients
        return torch.matmul(gradient[..., None, :], _Jacobian.apply(x, ctx.function)).squeeze(-2), None

    @staticmethod
    def jvp(ctx: Any, *tangents: Any) -> Any:
        return _change(_Jacobian, ctx, tangents[0][..., None, :])


class _Jacobian(_OnCore):
    """First derivatives, shape (..., outputs, variables)."""

    @staticmethod
    def forward(x: Any, function: Differentiable) -> Any:
        return _computed(lambda each: function.values_and_jacobian(each)[1], x)

    @staticmethod
    def backward(ctx: Any, *gradients: Any) -> Any:
        (x,), (gradient,) = ctx.saved_tensors, gradients
        return (_Hessian.apply(x, ctx.function) * gradient[..., None]).sum((-3, -2)), None

    @staticmethod
    def jvp(ctx: Any, *tangents: Any) -> Any:
        return _change(_Hessian, ctx, tangents[0][..., None, None, :])


class _Hessian(_OnCore):
    """Second derivatives, shape (..., outputs, variables, variables)."""

    @staticmethod
    def forward(x: Any, function: Differentiable) -> Any:
        return _computed(function.hessian, x)

    @staticmethod
    def backward(ctx: Any, *gradients: Any) -> Any:
        raise InputError("order of derivatives", 3, "1 or 2")

    @staticmethod
    def jvp(ctx: Any, *tangents: Any) -> Any:
        raise InputError("order of derivatives", 3, "1 or 2")


def _change(derivatives: type[_OnCore], ctx: Any, tangent: Any) -> Any:
    """Return the directional derivative along a tangent, whose last axis is that of the variables."""
    with forward_ad._set_fwd_grad_enabled(True):
        x = forward_ad.unpack_dual(*ctx.saved_tensors).primal
        return (derivatives.apply(x, ctx.function) * tangent).sum(-1)


def _computed(compute: Callable[[np.ndarray], np.ndarray], x: torch.Tensor) -> torch.Tensor:
    result = compute(x.detach().cpu().double().numpy())
    return torch.as_tensor(np.ascontiguousarray(result), dtype=x.dtype, device=x.device)
