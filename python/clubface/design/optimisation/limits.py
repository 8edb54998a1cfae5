"""What an optimum must not break: rules, bounds, what can be built, and what a study demands of the shots."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.design.feasibility import MASS_PROPERTIES, Envelope, of_club, pseudo_inertia, pseudo_inertia_derivatives
from clubface.design.optimisation.landings import Objective
from clubface.design.optimisation.solve import State

if TYPE_CHECKING:
    from clubface.equipment.clubs import Club


def in_words(value: float, low: float, high: float, unit: str) -> tuple[str, str]:
    """Return a value, and the limits that are finite, with their unit."""
    parts = [words for each, words in ((low, "at least"), (high, "at most")) if math.isfinite(each)]
    shown = [units.show(each, unit, 4) for each in (low, high) if math.isfinite(each)]
    allowed = f"{shown[0]} to {shown[1]}" if len(shown) == 2 else " ".join([*parts, *shown])
    return units.show(value, unit, 5), allowed


@dataclass(frozen=True, kw_only=True)
class FieldLimit:
    """A field of the club that must stay within limits.

    Attributes
    ----------
    name
        What the limit is called in reports.
    field
        The field of the club.
    least, most
        [SI]; infinite where there is none.
    unit
        In which the field is shown.
    scale
        Size of the field, which makes margins numbers [SI].
    fields
        All fields that change, in the order of the slopes.
    """

    name: str
    field: str
    least: float
    most: float
    unit: str
    scale: float
    fields: tuple[str, ...]

    def margins(self, state: State) -> NDArray[Any]:
        """Return the distance from each limit."""
        value = state.club[self.field]
        return np.array([side * (value - limit) / self.scale for side, limit in self._sides()])

    def gradients(self, state: State) -> NDArray[Any]:
        """Return the derivatives of the margins."""
        slope = state.slopes[self.fields.index(self.field)]
        return np.array([side * slope / self.scale for side, _ in self._sides()])

    def describe(self, state: State) -> tuple[str, str]:
        """Return the value of a club and the values allowed, in words."""
        return in_words(state.club[self.field], self.least, self.most, self.unit)

    def _sides(self) -> list[tuple[float, float]]:
        return [each for each in ((1.0, self.least), (-1.0, self.most)) if math.isfinite(each[1])]


@dataclass(frozen=True, kw_only=True)
class ShotLimit:
    """A number of the shots, such as the mean carry, that must stay within limits.

    Attributes
    ----------
    objective
        The number.
    least, most
        [SI]; infinite where there is none.
    """

    objective: Objective
    least: float
    most: float

    @property
    def name(self) -> str:
        """What the limit is called in reports."""
        return self.objective.meaning

    def margins(self, state: State) -> NDArray[Any]:
        """Return the distance from each limit, as a part of it."""
        value = state.judged[self.objective.name]
        return np.array([side * (value - limit) / max(abs(limit), 1e-9) for side, limit in self._sides()])

    def gradients(self, state: State) -> NDArray[Any]:
        """Return the derivatives of the margins."""
        slope = state.gradients[self.objective.name]
        return np.array([side * slope / max(abs(limit), 1e-9) for side, limit in self._sides()])

    def describe(self, state: State) -> tuple[str, str]:
        """Return the value of a club and the values allowed, in words."""
        return in_words(state.judged[self.objective.name], self.least, self.most, self.objective.unit)

    def _sides(self) -> list[tuple[float, float]]:
        return [each for each in ((1.0, self.least), (-1.0, self.most)) if math.isfinite(each[1])]


class Buildable:
    """The discretionary mass must be mass in the volume, and within its budget.

    Parameters
    ----------
    base
        The club whose mass properties hold where they do not change.
    envelope
        Volume, shell and budget.
    fields
        All fields that change, in the order of the slopes.
    distributed
        Whether the variables make the moments positive semidefinite by themselves.
    mass_changes
        Whether the mass does; otherwise the budget is no limit, and a solver would stumble over a margin that is 0.
    """

    name = "the head"

    def __init__(
        self, base: Club, envelope: Envelope, fields: Sequence[str], *, distributed: bool, mass_changes: bool
    ) -> None:
        self.envelope, self._values, self._distributed = envelope, of_club(base), distributed
        self._mass_changes = mass_changes
        self._changing = [
            (MASS_PROPERTIES.index(name), row) for row, name in enumerate(fields) if name in MASS_PROPERTIES
        ]
        self._fields = tuple(fields)
        self._forms = np.array([each.matrix for each in envelope.volume.forms()])

    def values(self, state: State) -> NDArray[Any]:
        """Return the mass properties of a head, in the order of ``MASS_PROPERTIES``."""
        result = self._values.copy()
        for place, row in self._changing:
            result[place] = state.club[self._fields[row]]
        return result

    def margins(self, state: State) -> NDArray[Any]:
        """Return the traces, the rest of the budget and, where it may be negative, every principal moment."""
        placed = self.envelope.placed(pseudo_inertia(self.values(state)))
        result = [np.einsum("fij,ij->f", self._forms, placed) / self.envelope.budget]
        if self._mass_changes:
            result.append(np.array([1.0 - placed[3, 3] / self.envelope.budget]))
        if not self._distributed:
            scale = np.outer(self.envelope.scale, self.envelope.scale)
            result.append(np.linalg.eigvalsh(placed * scale))
        return np.concatenate(result)

    def describe(self, state: State) -> tuple[str, str]:
        """Return that it cannot be built, and what is wrong with it, in words."""
        margins = self.envelope.margins(pseudo_inertia(self.values(state)))
        return "impossible", f"one that can be built: {min(margins, key=lambda each: each.value).reason}"

    def gradients(self, state: State) -> NDArray[Any]:
        """Return their derivatives; that of an eigenvalue is its vector's change (Magnus, 1985)."""
        values, budget = self.values(state), self.envelope.budget
        by_values = pseudo_inertia_derivatives(values)
        by_numbers = sum(by_values[place][..., None] * state.slopes[row] for place, row in self._changing)
        assert isinstance(by_numbers, np.ndarray)  # there is at least one mass property that changes
        result = [np.einsum("fij,ijn->fn", self._forms, by_numbers) / budget]
        if self._mass_changes:
            result.append(-by_numbers[3, 3][None] / budget)
        if not self._distributed:
            scale = self.envelope.scale
            placed = self.envelope.placed(pseudo_inertia(values)) * np.outer(scale, scale)
            vectors = np.linalg.eigh(placed)[1] * scale[:, None]
            result.append(np.einsum("ik,ijn,jk->kn", vectors, by_numbers, vectors))
        return np.concatenate(result)
