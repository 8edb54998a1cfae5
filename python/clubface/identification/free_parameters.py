"""The free parameters, their bounds, and the unit cube in which the search moves."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.equipment.models import Parameter, model as model_named
from clubface.equipment.parameters import ParameterSet
from clubface.errors import InputError
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice, check_names
from clubface.support.frozen import Frozen
from clubface.support.shipped import DATA
from clubface.support.strict_toml import Document

ALL = "all"
"""Asks for every parameter of the model."""

DECADE = 10.0
"""A positive parameter whose bounds are further apart than this factor is searched by its logarithm."""


@dataclass(frozen=True, kw_only=True, eq=False)
class FreeParameters:
    """The parameters that are identified; the others keep the value of a set.

    A point of the search is an array of one coordinate a free parameter, 0 at the lower bound and 1 at the upper,
    in between linear in the value or, where the bounds span more than a decade, in its logarithm.

    Attributes
    ----------
    fixed
        The set that holds every other parameter.
    names
        The free parameters, in the order of the registry.
    lower, upper
        Their bounds [SI], shape (free,).
    logarithmic
        Which are searched by their logarithm, shape (free,).
    tied
        Parameters that take the value of a free one, by name.
    """

    fixed: ParameterSet
    names: tuple[str, ...]
    lower: Floats
    upper: Floats
    logarithmic: NDArray[np.bool_]
    tied: Mapping[str, str]

    def __len__(self) -> int:
        return len(self.names)

    def values(self, points: Floats) -> Floats:
        """Return parameter values [SI] at points of the unit cube, both of shape (..., free)."""
        linear = self.lower + points * (self.upper - self.lower)
        if self.logarithmic.any():
            low, high = self._logarithms()
            linear = np.where(self.logarithmic, np.exp(low + points * (high - low)), linear)
        return np.clip(linear, self.lower, self.upper)

    def points(self, values: Floats) -> Floats:
        """Return the points of the unit cube at parameter values [SI], both of shape (..., free)."""
        points = (values - self.lower) / (self.upper - self.lower)
        if self.logarithmic.any():
            low, high = self._logarithms()
            positive = np.where(self.logarithmic, values, 1.0)
            points = np.where(self.logarithmic, (np.log(positive) - low) / (high - low), points)
        return np.clip(points, 0.0, 1.0)

    def slopes(self, points: Floats) -> Floats:
        """Return the derivatives of the values by the coordinates, shape (..., free)."""
        low, high = self._logarithms()
        return np.where(self.logarithmic, self.values(points) * (high - low), self.upper - self.lower)

    def columns(self, points: Floats, shots: int) -> list[Any]:
        """Return the columns of the core for points of shape (n, free): each point is repeated for all shots."""
        values = self.values(points)
        found = []
        for name, value in self.fixed.values.items():
            place = self._place(name)
            found.append(value if place is None else np.repeat(values[:, place], shots))
        return found

    def single(self, point: Floats) -> list[float]:
        """Return the value of every parameter at one point, as the core takes them."""
        values = self.values(point)
        places = ((self._place(name), value) for name, value in self.fixed.values.items())
        return [value if place is None else float(values[place]) for place, value in places]

    def driven(self) -> list[list[int]]:
        """Return, for each free parameter, the places in the registry of those that follow it, itself included."""
        order = list(self.fixed.values)
        return [[place for place, each in enumerate(order) if self.tied.get(each, each) == name] for name in self.names]

    def parameters(self, point: Floats, **told: Any) -> ParameterSet:
        """Return the set at one point; ``told`` are its name, source and the like."""
        values = dict(zip(self.fixed.values, self.single(point), strict=True))
        return ParameterSet(
            model=self.fixed.model,
            club=self.fixed.club,
            values=values,
            includes_face=self.fixed.includes_face,
            characteristic_time=self.fixed.characteristic_time,
            **told,
        )

    def declared(self) -> list[Parameter]:
        """Return what the registry says of the free parameters."""
        return [model_named(self.fixed.model).parameter(name) for name in self.names]

    def _place(self, name: str) -> int | None:
        leader = self.tied.get(name, name)
        return self.names.index(leader) if leader in self.names else None

    def _logarithms(self) -> tuple[Floats, Floats]:
        """Return the logarithms of the bounds; 0 and 1 where they are not used."""
        return (
            np.log(np.where(self.logarithmic, self.lower, 1.0)),
            np.log(np.where(self.logarithmic, self.upper, np.e)),
        )


def free_parameters(
    fixed: ParameterSet,
    names: str | Iterable[str] | None = None,
    *,
    bounds: Mapping[str, Any] | None = None,
    tied: Mapping[str, str] | None = None,
) -> FreeParameters:
    """Choose the free parameters of the model of ``fixed``.

    Parameters
    ----------
    fixed
        Holds the parameters that are not free.
    names
        Those that are; "all" for every one; left out, those that the publication identified.
    bounds
        Pairs of values, text with a unit or SI, by name; left out, those of ``identification.toml``, else of the model.
    tied
        Parameters that follow a free one, by name; left out, as the publication had it where ``names`` is left out.
    """
    declared = model_named(fixed.model)
    everything = [each.name for each in declared.parameters]
    default = published_choice(fixed.model)
    if names is None:
        names = default[0] or everything
        tied = default[1] if tied is None else tied
    elif names == ALL:
        names = everything
    asked = [names] if isinstance(names, str) else list(names)
    for name in asked:
        declared.parameter(name)
    if not asked:
        raise InputError("free", asked, "at least one parameter of " + ", ".join(everything))
    tied = dict(tied or {})
    for follower, leader in tied.items():
        declared.parameter(follower)
        check_choice(f"free parameter for {follower} to follow", leader, asked)
        if follower in asked:
            raise InputError(f"tied {follower}", leader, "a parameter that is not free itself")
    chosen = [each for each in declared.parameters if each.name in asked]
    check_names("free parameter with bounds", bounds or {}, asked)
    given = {**default[2], **(bounds or {})}
    pairs = np.array([_bounds(each, given.get(each.name), tied, fixed.model) for each in chosen])
    lower, upper = pairs[:, 0], pairs[:, 1]
    return FreeParameters(
        fixed=fixed, names=tuple(each.name for each in chosen), lower=lower, upper=upper,
        logarithmic=(lower > 0.0) & (upper > DECADE * lower), tied=Frozen(tied),
    )  # fmt: skip


@cache
def published_choice(model: str) -> tuple[tuple[str, ...], Mapping[str, str], Mapping[str, list[str]]]:
    """Return the parameters of a model that its publication identified (none: all), what it tied, and bounds."""
    document = Document.read(DATA / "identification.toml")
    entry = document.data.get(model, {})
    tied, bounds = (Frozen(entry.get(key, {})) for key in ("tied", "bounds"))
    return tuple(entry.get("free", ())), tied, bounds


def _bounds(of: Parameter, given: Any, tied: Mapping[str, str], model: str) -> tuple[float, float]:
    """Return the bounds of one parameter: what was given within what the registry allows it and its followers."""
    followers = [model_named(model).parameter(name) for name, leader in tied.items() if leader == of.name]
    low = max(each.lower for each in (of, *followers))
    high = min(each.upper for each in (of, *followers))
    if given is None:
        return low, high
    dimension = units.unit(of.unit, name=of.name).dimension
    try:
        first, second = given
    except (TypeError, ValueError):
        raise InputError(f"bounds of {of.name}", given, "a pair, the lower one first") from None
    pair = tuple(units.parse(each, dimension, name=f"bound of {of.name}") for each in (first, second))
    if not low <= pair[0] < pair[1] <= high:
        allowed = f"increasing, within {units.show(low, of.unit)} to {units.show(high, of.unit)}"
        raise InputError(f"bounds of {of.name}", given, allowed)
    return pair[0], pair[1]
