"""What an optimum must not break: rules, bounds, what can be built, and what a study demands of the shots."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from clubface import units
from clubface.design.feasibility import MASS_PROPERTIES, Envelope, of_club, pseudo_inertia, pseudo_inertia_derivatives
from clubface.support.arrays import Floats

if TYPE_CHECKING:
    from clubface.equipment.clubs import Club


@dataclass(frozen=True)
class State:
    """What is known at a point of an optimiser, by the names of fields and of objectives.

    ``club`` has the fields of the club that may change [SI], and ``judged`` the objectives in use, the mean over the
    golfers. ``slopes`` and ``gradients`` are their derivatives by the numbers of the optimiser, each of shape
    (numbers,); there are no ``gradients`` where they were not asked for.
    """

    club: Mapping[str, float]
    slopes: Mapping[str, Floats]
    judged: Mapping[str, float]
    gradients: Mapping[str, Floats]


@dataclass(frozen=True, kw_only=True)
class RangeLimit:
    """A field of the club, or an objective, that must stay within limits [SI], which are infinite where there is none.

    The limit has its ``name`` in reports; ``limited`` is what is limited. Margins are made numbers by the ``size``
    [SI], or by that of each limit itself.
    """

    name: str
    limited: str
    least: float
    most: float
    unit: str
    size: float | None = None

    def margins(self, state: State) -> Floats:
        """Return the distance from each limit."""
        value = {**state.club, **state.judged}[self.limited]
        return np.array([side * (value - limit) / size for side, limit, size in self._sides()])

    def gradients(self, state: State) -> Floats:
        """Return the derivatives of the margins."""
        slope = {**state.slopes, **state.gradients}[self.limited]
        return np.array([side * slope / size for side, _, size in self._sides()])

    def describe(self, state: State) -> tuple[str, str]:
        """Return the value of a club and the values allowed, in words."""
        allowed = " to ".join(units.show(limit, self.unit, 4) for _, limit, _ in self._sides())
        if len(self._sides()) == 1:
            allowed = f"{'at least' if math.isfinite(self.least) else 'at most'} {allowed}"
        return units.show({**state.club, **state.judged}[self.limited], self.unit, 5), allowed

    def _sides(self) -> list[tuple[float, float, float]]:
        return [
            (side, limit, self.size or max(abs(limit), 1e-9))
            for side, limit in ((1.0, self.least), (-1.0, self.most)) if math.isfinite(limit)
        ]  # fmt: skip


class Buildable:
    """The discretionary mass must be mass in the volume, and within its budget.

    Where the mass properties among ``fields`` do not change, they are those of ``base``. Where the mass is
    ``distributed``, the variables make the moments positive semidefinite by themselves; unless the mass changes, the
    budget is no limit, and a solver would stumble over a margin that is 0.
    """

    name = "the head"

    def __init__(
        self, base: Club, envelope: Envelope, fields: tuple[str, ...], *, distributed: bool, mass_changes: bool
    ) -> None:
        self.envelope, self._values, self._distributed = envelope, of_club(base), distributed
        self._mass_changes = mass_changes
        self._changing = [name for name in fields if name in MASS_PROPERTIES]
        self._forms = np.array([each.matrix for each in envelope.volume.forms()])

    def values(self, state: State) -> Floats:
        """Return the mass properties of a head, in the order of ``MASS_PROPERTIES``."""
        result = self._values.copy()
        for name in self._changing:
            result[MASS_PROPERTIES.index(name)] = state.club[name]
        return result

    def margins(self, state: State) -> Floats:
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

    def gradients(self, state: State) -> Floats:
        """Return their derivatives; that of an eigenvalue is its vector's change (Magnus, 1985)."""
        values, budget = self.values(state), self.envelope.budget
        by_name: dict[str, Floats] = dict(zip(MASS_PROPERTIES, pseudo_inertia_derivatives(values), strict=True))
        by_numbers = sum(by_name[name][..., None] * state.slopes[name] for name in self._changing)
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


Limit = RangeLimit | Buildable
"""One or several margins, scaled to size 1, that must not be negative."""
