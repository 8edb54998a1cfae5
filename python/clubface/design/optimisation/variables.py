"""The optimiser's variables, scaled to about 1, the club they define, and point masses that realise it.

A club field is one variable, from 0 at its lower bound to 1 at its upper; a radius is interpolated as curvature, on
which launch depends almost linearly. A free mass distribution has nine variables for the discretionary mass: in
coordinates with the origin at the centre of the volume and its surface at 1, the first moments and the lower triangle
of a matrix C, where C C' are the central second moments. Its pseudo-inertia is then always positive semidefinite, and
belongs to a body in an ellipsoid if the squares of the nine sum to at most 1.

Point masses with the moments of the discretionary mass are found by linear programming on a grid of places, which is
refined repeatedly around the places in use: the best head often needs mass exactly on the surface.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from clubface import units
from clubface.design.feasibility import (
    MASS_PROPERTIES,
    Envelope,
    Volume,
    mass_properties,
    of_club,
    pseudo_inertia,
    pseudo_inertia_derivatives,
)
from clubface.design.optimisation.landings import own_value
from clubface.equipment.clubs import Club
from clubface.errors import InputError, RuleWarning
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings

RADII = ("bulge", "roll")
LIE_MOST = units.to_si(90.0, "deg")
"""Largest lie [rad]; beyond it the head would be upside down."""
PLACED = 9
"""Number of variables for placed mass: its CG and the lower triangle of the root of its central second moments."""
_ROOT, _ENTRIES = np.tril_indices(3), np.triu_indices(4)
"""Indices of the six entries of a root and of the ten independent entries of a pseudo-inertia."""


@dataclass(frozen=True, kw_only=True)
class Variables:
    """The optimiser's variables for changes of a ``base`` club.

    Every field with ``bounds`` [SI] is one variable. If mass moves, the head stays in an ``envelope``; if it is
    ``distributed``, the whole mass distribution is free, and the mass is the base's unless it has bounds. Fields that
    are ``held`` [SI] have the same value in every club, different from the base.
    """

    base: Club
    bounds: Mapping[str, tuple[float, float]]
    envelope: Envelope | None = None
    distributed: bool = False
    held: Mapping[str, float] = field(default_factory=dict)

    @property
    def fields(self) -> tuple[str, ...]:
        """The fields of the club that may change."""
        if not self.distributed:
            return tuple(self.bounds)
        return (*MASS_PROPERTIES, *(name for name in self.bounds if name not in MASS_PROPERTIES))

    @property
    def count(self) -> int:
        """Number of variables."""
        return len(self.bounds) + (PLACED if self.distributed else 0)

    @property
    def box(self) -> Floats:
        """Bounds of the variables, shape (count, 2)."""
        result = np.tile([0.0, 1.0], (self.count, 1))
        if self.distributed:
            result[-PLACED:] = [-2.0, 2.0]
        return result

    def club(self, point: Floats) -> dict[str, float]:
        """Return variable and held fields by name [SI]."""
        result = {name: self._field(name, at) for name, at in zip(self.bounds, point, strict=False)}
        if self.distributed:
            mass = result.get("mass", self.base.mass)
            values = mass_properties(self._shell + self._placed_inertia(mass, point[-PLACED:]))
            result |= dict(zip(MASS_PROPERTIES, map(float, values), strict=True))
        return {**self.held, **{name: result[name] for name in self.fields}}

    def slopes(self, point: Floats) -> Floats:
        """Return the derivatives of the fields with respect to the variables, shape (fields, count)."""
        slopes, fields = np.zeros((len(self.fields), self.count)), self.fields
        own = {name: self._slope(name, at) for name, at in zip(self.bounds, point, strict=False)}
        for column, (name, slope) in enumerate(own.items()):
            if not self.distributed or name not in MASS_PROPERTIES:
                slopes[fields.index(name), column] = slope
        if self.distributed:
            self._add_placed_slopes(slopes, point, own.get("mass"))
        return slopes

    def start(self) -> Floats:
        """Return the variables of the base club, clipped to the bounds."""
        own = []
        for name, (low, high) in self.bounds.items():
            value = own_value(self.base, name)
            if name in RADII:
                low, high, value = 1.0 / high, 1.0 / low, 1.0 / value
            own.append((value - low) / (high - low))
        own = np.clip(own, 0.0, 1.0)
        if not self.distributed:
            return own
        pseudo = pseudo_inertia(of_club(self.base))
        return np.concatenate([own, self._placed_variables(pseudo - self._shell)])

    def random(self, uniform: Floats) -> Floats:
        """Return variables spread over their bounds, from numbers uniform between 0 and 1.

        The variables for placed mass lie in the unit ball.
        """
        from scipy.special import ndtri

        result = np.array(uniform[: self.count], dtype=float)
        if self.distributed:
            direction = ndtri(np.clip(result[-PLACED:], 1e-9, 1.0 - 1e-9))
            radius = 0.9 * float(uniform[-1]) ** (1.0 / PLACED)
            result[-PLACED:] = radius * direction / np.linalg.norm(direction)
        return result

    def _field(self, name: str, at: float) -> float:
        low, high = self.bounds[name]
        if name in RADII:
            return float(1.0 / (1.0 / high + at * (1.0 / low - 1.0 / high)))
        return float(low + at * (high - low))

    def _slope(self, name: str, at: float) -> float:
        low, high = self.bounds[name]
        if name in RADII:
            return -(self._field(name, at) ** 2) * (1.0 / low - 1.0 / high)
        return high - low

    @property
    def _shell(self) -> Floats:
        assert self.envelope is not None  # a free distribution needs a volume
        return self.envelope.shell

    @property
    def _frame(self) -> Floats:
        assert self.envelope is not None
        return self.envelope.volume.frame

    def _placed_inertia(self, mass: float, numbers: Floats) -> Floats:
        """Return the pseudo-inertia about the face centre of the discretionary mass, for a head of a given mass."""
        rows, frame = _inertia_root(numbers), self._frame
        return (mass - self._shell[3, 3]) * frame @ rows @ rows.T @ frame.T

    def _placed_variables(self, placed: Floats) -> Floats:
        """Return the nine variables of a pseudo-inertia, moved to the nearest feasible one if necessary."""
        inverse = np.linalg.inv(self._frame)
        own = inverse @ placed @ inverse.T / placed[3, 3]
        first = own[:3, 3]
        values, vectors = np.linalg.eigh(own[:3, :3] - np.outer(first, first))
        spread = (vectors * np.maximum(values, 1e-6)) @ vectors.T
        root = np.linalg.cholesky(spread)
        return np.concatenate([first, root[_ROOT]])

    def _add_placed_slopes(self, slopes: Floats, point: Floats, by_mass: float | None) -> None:
        """Fill in the derivatives of the mass properties."""
        mass = self.club(point)["mass"]
        numbers, frame = point[-PLACED:], self._frame
        rows, loose = _inertia_root(numbers), mass - self._shell[3, 3]
        values = mass_properties(self._shell + self._placed_inertia(mass, numbers))
        by_values = pseudo_inertia_derivatives(values)
        forward = by_values[:, *_ENTRIES].T
        empty = _inertia_root(np.zeros(PLACED))
        slopes_of_rows = [_inertia_root(each) - empty for each in np.eye(PLACED)]
        changes = [loose * frame @ (each @ rows.T + rows @ each.T) @ frame.T for each in slopes_of_rows]
        columns = list(range(self.count - PLACED, self.count))
        if by_mass is not None:
            changes.append(by_mass * frame @ rows @ rows.T @ frame.T)
            columns.append(list(self.bounds).index("mass"))
        wanted = np.array(changes)[:, *_ENTRIES].T
        places = [self.fields.index(name) for name in MASS_PROPERTIES]
        # Mass properties differ widely in size, so rows and columns are scaled first.
        by_row = 1.0 / np.abs(forward).max(axis=1)[:, None]
        by_column = 1.0 / np.abs(forward * by_row).max(axis=0)
        solved = by_column[:, None] * np.linalg.solve(forward * by_row * by_column, wanted * by_row)
        slopes[np.ix_(places, columns)] = solved


def check_bounds(base: Club, bounds: Mapping[str, tuple[float, float]], place: str) -> None:
    """Raise an error for impossible bounds of the face or the lie; ``place`` is their place in a file.

    Bounds of the characteristic time and of mass properties depend on each other and are not checked here.
    """
    for name in ("loft", "bulge", "roll", "lie"):
        for value in bounds.get(name, ()):
            if name == "lie" and not abs(value) <= LIE_MOST:
                raise InputError(f"{place}.{name}", units.show(value, "deg"), "from -90 to 90 deg")
            if name != "lie":
                try:
                    with without_warnings(RuleWarning):
                        base.replace(**{name: value})
                except InputError as error:
                    error.parameter = f"{place}.{name}"
                    raise


def _inertia_root(numbers: Floats) -> Floats:
    """Return a root, shape (4, 4), of the pseudo-inertia of a unit mass: its CG and the root of central moments."""
    result = np.zeros((4, 4))
    result[:3, 0], result[3, 0] = numbers[:3], 1.0
    result[:3, 1:][_ROOT] = numbers[3:]
    return result


STEPS = 13
"""Number of grid places along each axis of the volume, including both ends."""
ROUNDS = 20
"""Maximum number of grid refinements, down to a millionth of the volume's size."""
NEAR = 1e-6
"""Largest error of a moment, relative to mass and half size, accepted in a solution."""
NEGLIGIBLE = 1e-9
"""Share of the discretionary mass below which a point mass is left out."""


class PointMass(NamedTuple):
    """A point mass [kg], and its place relative to the face centre: to the target, up, to the toe [m]."""

    mass: float
    place: tuple[float, float, float]


def placement(envelope: Envelope, pseudo: Floats) -> list[PointMass]:
    """Return point masses with the moments of a head's discretionary mass, the heaviest first.

    ``pseudo`` is the pseudo-inertia of the head about the face centre, shape (4, 4). There are at most ten masses, one
    per moment; the list is empty if no solution is found.
    """
    volume, placed = envelope.volume, envelope.placed(pseudo)
    inverse = np.linalg.inv(volume.frame)
    own = inverse @ placed @ inverse.T / placed[3, 3]
    step = 2.0 / (STEPS - 1)
    parts = _move_inside(volume, _lattice(STEPS) * step)
    masses, missed = _fit_masses(parts, own)
    for _ in range(ROUNDS):
        if not 1e-3 * NEAR < missed < np.inf:
            break
        step *= 0.5
        parts = parts[masses > NEGLIGIBLE]
        parts = np.vstack([parts, _move_inside(volume, (parts[:, None] + _lattice(3) * step).reshape(-1, 3))])
        masses, missed = _fit_masses(parts, own)
    if missed > NEAR:
        return []
    places = np.array(volume.centre) + parts * 0.5 * np.array(volume.size)
    order = [each for each in np.argsort(-masses, kind="stable") if masses[each] > NEGLIGIBLE]
    return [
        PointMass(float(mass), (float(x), float(y), float(z)))
        for mass, (x, y, z) in zip(masses[order] * placed[3, 3], places[order], strict=True)
    ]


def _lattice(count: int) -> Floats:
    """Return integer grid points centred on 0, ``count`` along each axis, shape (count^3, 3)."""
    return np.indices((count,) * 3, dtype=float).reshape(3, -1).T - (count - 1) // 2


def _move_inside(volume: Volume, parts: Floats) -> Floats:
    """Return places, in coordinates with the surface at 1, with those outside moved onto the surface."""
    if volume.shape == "box":
        return np.clip(parts, -1.0, 1.0)
    return parts / np.maximum(np.linalg.norm(parts, axis=1), 1.0)[:, None]


def _fit_masses(parts: Floats, own: Floats) -> tuple[Floats, float]:
    """Return the masses at given places, summing to 1, that best match the moments, and the largest error."""
    from scipy.optimize import linprog

    rows = np.hstack([parts, np.ones((len(parts), 1))])
    first, second = _ENTRIES
    moments, wanted = (rows[:, first] * rows[:, second]).T, own[_ENTRIES]
    # The total mass is exact; the sum of the errors of the other moments is minimised.
    free = np.eye(len(wanted))[:, :-1]
    equal = np.hstack([moments, free, -free])
    cost = np.concatenate([np.zeros(len(parts)), np.ones(2 * free.shape[1])])
    result = linprog(cost, A_eq=equal, b_eq=wanted, bounds=(0.0, None), method="highs-ds")
    if result.status != 0:
        return np.zeros(len(parts)), np.inf
    masses = result.x[: len(parts)]
    return masses, float(np.abs(moments @ masses - wanted).max())
