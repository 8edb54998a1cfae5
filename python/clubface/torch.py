"""Impacts and flights as functions of PyTorch, with exact derivatives.

>>> import torch, clubface.torch
>>> loft = torch.tensor(0.2, dtype=torch.float64, requires_grad=True)
>>> launch = clubface.torch.impact("driver", speed=50.0, loft=loft)
>>> clubface.torch.fly(launch, outputs=["carry"])["carry"].backward()
>>> slope = loft.grad

Inputs that are tensors are variables, everything else stays fixed. Backward, forward-mode derivatives and the
transformations of ``torch.func`` (``grad``, ``jvp``, ``vmap``, ``jacfwd``, ``jacrev``, ``hessian``) work. The compiled
core computes on the processor, in double precision; results have the precision and the device of the variables.

Derivatives are computed when they are asked for, those by all variables in one run. Second ones are as
:mod:`clubface.jax` describes them: differences of the exact first ones, for models in closed form, flights, and
``volumetric`` with ``accuracy=1e-10``. No warning is given of shots outside the range for which a model is valid.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping
from functools import reduce
from typing import Any, Literal

import numpy as np
import torch  # pyright: ignore[reportMissingImports]
from torch.autograd import forward_ad  # pyright: ignore[reportMissingImports]

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
) -> dict[str, torch.Tensor]:
    """Compute the launch of a ball hit by a club, as :func:`clubface.impact`.

    Parameters
    ----------
    club, delivery, model, parameters, ball, accuracy, hand, threads, on_error, **values
        As for :func:`clubface.impact`; any of the values and of the parameters may be a tensor [SI], by which the
        launch is then differentiable. They broadcast.
    outputs
        Names of launch quantities; left out, all that the model gives.

    Returns
    -------
    dict
        The quantities by name [SI].

    Raises
    ------
    ShotError
        A shot cannot be computed, unless ``on_error`` is "nan".
    InputError
        A name or a value is not allowed, or second derivatives are asked for that do not exist.
    """
    function, tensors = launch_function(
        _is_tensor, club, delivery, values, parameters, model=model, ball=ball, accuracy=accuracy, hand=hand,
        outputs=outputs, threads=threads, on_error=on_error,
    )  # fmt: skip
    return _call(function, tensors)


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
) -> dict[str, torch.Tensor]:
    """Compute where a launched ball goes, as :func:`clubface.fly`.

    Parameters
    ----------
    launch
        What :func:`impact` returned with all outputs, or values as for :func:`clubface.fly`: velocity and spin as
        vectors, or ``ball_speed``, ``launch``, ``azimuth`` with backspin and sidespin or total spin and spin axis.
    air, wind, ground, threads, on_error
        As for :func:`clubface.fly`; ``temperature``, ``pressure``, ``humidity``, the wind and the values of the ground
        may be tensors [SI].
    ball
        As for :func:`clubface.ball`: give it if the impact was with another ball than the default one.
    outputs
        Names of quantities of a flight; left out, all. Second derivatives need that ``total``, ``total_side`` and
        ``outside_fit`` are left out: bounces make steps in them.

    Returns
    -------
    dict
        The quantities by name [SI].
    """
    function, tensors = flight_function(
        _is_tensor, torch, launch, air=air, wind=wind, ground=ground, ball=ball, outputs=outputs, threads=threads,
        on_error=on_error,
    )  # fmt: skip
    return _call(function, tensors)


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
) -> dict[str, torch.Tensor]:
    """Return the values of a delivery by the pose and the motion of the head, as :meth:`clubface.Delivery.from_pose`.

    Everything may be a tensor but ``club``, ``ball`` and ``hand``. Nothing is checked: a head that does not touch the
    ball within a millisecond or so gives values without meaning.

    Returns
    -------
    dict
        The values by name [SI], as :func:`impact` takes them.
    """
    given = Pose(rotation, position, velocity, angular_velocity)
    values = array_delivery(torch, _as_tensor, given, ball_position, club, ball, point, hand)
    kind = _kind([*given, ball_position, point])
    return {name: each.to(kind) for name, each in values.items()}


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
    result = array_pose(torch, _as_tensor, delivery, ball_position, club, ball, point, hand)
    given = delivery.values() if isinstance(delivery, Delivery) else delivery
    kind = _kind([*given.values(), ball_position, point])
    return Pose(*(each.to(kind) for each in result))


def _is_tensor(value: Any) -> bool:
    return isinstance(value, torch.Tensor)


def _as_tensor(value: Any) -> torch.Tensor:
    return value if _is_tensor(value) else torch.as_tensor(np.asarray(value, dtype=np.float64))


def _kind(values: Iterable[Any]) -> torch.dtype:
    """Return the precision of results: that of the tensors among the values, or the default one."""
    kinds = [each.dtype for each in values if _is_tensor(each) and each.is_floating_point()]
    return reduce(torch.promote_types, kinds) if kinds else torch.get_default_dtype()


def _call(function: Differentiable, tensors: list[Any]) -> dict[str, torch.Tensor]:
    kind = _kind(tensors)
    shape = torch.broadcast_shapes(function.shape, *(each.shape for each in tensors))
    columns = [each.to(kind).expand(shape) for each in tensors]
    x = torch.stack(columns, dim=-1) if columns else torch.zeros((*shape, 0), dtype=kind)
    y = _Values.apply(x, function)
    return dict(zip(function.outputs, y.unbind(-1), strict=True))


class _OnCore(torch.autograd.Function):
    """A function of the core whose rows are the last axis of a tensor; the next higher derivative gives its own."""

    @staticmethod
    def setup_context(ctx: Any, inputs: Any, output: Any) -> None:
        x, ctx.function = inputs
        ctx.save_for_backward(x)
        ctx.save_for_forward(x)

    @classmethod
    def batched(cls, in_dims: Any, x: Any, function: Differentiable) -> Any:
        """Return the result for a tensor with one more axis, and where that axis is."""
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
        with forward_ad._set_fwd_grad_enabled(True):
            x = forward_ad.unpack_dual(*ctx.saved_tensors).primal
            return torch.matmul(_Jacobian.apply(x, ctx.function), tangents[0][..., None]).squeeze(-1)

    @staticmethod
    def vmap(info: Any, in_dims: Any, x: Any, function: Differentiable) -> Any:
        return _Values.batched(in_dims, x, function)


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
        with forward_ad._set_fwd_grad_enabled(True):
            x = forward_ad.unpack_dual(*ctx.saved_tensors).primal
            return (_Hessian.apply(x, ctx.function) * tangents[0][..., None, None, :]).sum(-1)

    @staticmethod
    def vmap(info: Any, in_dims: Any, x: Any, function: Differentiable) -> Any:
        return _Jacobian.batched(in_dims, x, function)


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

    @staticmethod
    def vmap(info: Any, in_dims: Any, x: Any, function: Differentiable) -> Any:
        return _Hessian.batched(in_dims, x, function)


def _computed(compute: Callable[[np.ndarray], np.ndarray], x: torch.Tensor) -> torch.Tensor:
    result = compute(x.detach().cpu().double().numpy())
    return torch.as_tensor(np.ascontiguousarray(result), dtype=x.dtype, device=x.device)
