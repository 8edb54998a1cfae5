"""What an optimiser turns: numbers of size 1, the club they make, and where to put its masses.

A field of the club is one number, from 0 at its lower bound to 1 at its upper; of a radius it is the curvature, which a
launch depends on almost linearly. Where the whole distribution of mass is free, nine numbers place the discretionary
mass: in coordinates that start at the centre of the volume and end at its surface, its second moments about the centre
are a product C C', and its first moments and the lower triangle of C fill the nine. So its pseudo-inertia is positive
semidefinite whatever they are, and that of a body in an ellipsoid if the sum of their squares is at most 1.

Point masses that have the moments of the discretionary mass are found by linear programming. Places lie on a grid, and
the best head often needs mass at a place between, exactly on the surface. So the grid is made finer again and again
about the places that are taken.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from clubface import units
from clubface.design.feasibility import (
    MASS_PROPERTIES,
    Envelope,
    mass_properties,
    of_club,
    pseudo_inertia,
    pseudo_inertia_derivatives,
)
from clubface.design.optimisation.landings import own_value
from clubface.errors import InputError, RuleWarning
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings

if TYPE_CHECKING:
    from clubface.design.feasibility import Volume
    from clubface.equipment.clubs import Club


RADII = ("bulge", "roll")
LIE_MOST = units.to_si(90.0, "deg")
"""A lie beyond it turns the head over; no impact has one."""
PLACED = 9
"""Numbers that place a mass: its CG and the lower triangle of the root of its second moments about it."""
_ROOT = [(row, column) for row in range(3) for column in range(row + 1)]
_ENTRIES = [(i, j) for i in range(4) for j in range(i, 4)]
"""The ten different entries of a pseudo-inertia."""


@dataclass(frozen=True, kw_only=True)
class Variables:
    """The numbers that an optimiser turns, from a ``base`` club.

    Every field with ``bounds`` [SI] is a number of its own. Where the distribution of mass changes, the head is in an
    ``envelope``; where all of it is free, it is ``distributed``, and the mass is that of the base unless it has bounds.
    Fields that are ``held`` [SI] are the same in every club, and other than those of the base.
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
        """How many numbers there are."""
        return len(self.bounds) + (PLACED if self.distributed else 0)

    @property
    def box(self) -> Floats:
        """Bounds of the numbers, shape (count, 2)."""
        result = np.tile([0.0, 1.0], (self.count, 1))
        if self.distributed:
            result[-PLACED:] = [-2.0, 2.0]
        return result

    def club(self, point: Floats) -> dict[str, float]:
        """Return the fields that may change, and those that are held, by name [SI]."""
        result = {name: self._field(name, at) for name, at in zip(self.bounds, point, strict=False)}
        if self.distributed:
            mass = result.get("mass", self.base.mass)
            values = mass_properties(self._shell + self._placed(mass, point[-PLACED:]))
            result |= dict(zip(MASS_PROPERTIES, map(float, values), strict=True))
        return {**self.held, **{name: result[name] for name in self.fields}}

    def slopes(self, point: Floats) -> Floats:
        """Return the derivatives of the fields by the numbers, shape (fields, count)."""
        slopes, fields = np.zeros((len(self.fields), self.count)), self.fields
        own = {name: self._slope(name, at) for name, at in zip(self.bounds, point, strict=False)}
        for column, (name, slope) in enumerate(own.items()):
            if not self.distributed or name not in MASS_PROPERTIES:
                slopes[fields.index(name), column] = slope
        if self.distributed:
            self._add_placed(slopes, point, own.get("mass"))
        return slopes

    def start(self) -> Floats:
        """Return the numbers of the base club, or the nearest within the bounds."""
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
        return np.concatenate([own, self._numbers(pseudo - self._shell)])

    def random(self, uniform: Floats) -> Floats:
        """Return numbers spread over their bounds, from as many that are uniform from 0 to 1.

        Those that place a mass lie in the ball of radius 1.
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
        assert self.envelope is not None  # a distribution has a volume to be in
        return self.envelope.shell

    @property
    def _frame(self) -> Floats:
        assert self.envelope is not None
        return self.envelope.volume.frame

    def _placed(self, mass: float, numbers: Floats) -> Floats:
        """Return the pseudo-inertia about the face centre of the discretionary mass of a head of some mass."""
        rows, frame = _rows(numbers), self._frame
        return (mass - self._shell[3, 3]) * frame @ rows @ rows.T @ frame.T

    def _numbers(self, placed: Floats) -> Floats:
        """Return the nine numbers of a pseudo-inertia, which is moved into the possible where it is not."""
        inverse = np.linalg.inv(self._frame)
        own = inverse @ placed @ inverse.T / placed[3, 3]
        first = own[:3, 3]
        values, vectors = np.linalg.eigh(own[:3, :3] - np.outer(first, first))
        spread = (vectors * np.maximum(values, 1e-6)) @ vectors.T
        root = np.linalg.cholesky(spread)
        return np.array([*first, *(root[place] for place in _ROOT)])

    def _add_placed(self, slopes: Floats, point: Floats, by_mass: float | None) -> None:
        """Add the derivatives of the mass properties to those of the fields."""
        mass = self.club(point)["mass"]
        numbers, frame = point[-PLACED:], self._frame
        rows, loose = _rows(numbers), mass - self._shell[3, 3]
        values = mass_properties(self._shell + self._placed(mass, numbers))
        by_values = pseudo_inertia_derivatives(values)
        forward = np.array([[each[entry] for each in by_values] for entry in _ENTRIES])
        empty = _rows(np.zeros(PLACED))
        slopes_of_rows = [_rows(each) - empty for each in np.eye(PLACED)]
        changes = [loose * frame @ (each @ rows.T + rows @ each.T) @ frame.T for each in slopes_of_rows]
        columns = list(range(self.count - PLACED, self.count))
        if by_mass is not None:
            changes.append(by_mass * frame @ rows @ rows.T @ frame.T)
            columns.append(list(self.bounds).index("mass"))
        wanted = np.array([[each[entry] for each in changes] for entry in _ENTRIES])
        places = [self.fields.index(name) for name in MASS_PROPERTIES]
        slopes[np.ix_(places, columns)] = _solved(forward, wanted)


def check_bounds(base: Club, bounds: Mapping[str, tuple[float, float]], place: str) -> None:
    """Refuse bounds of the face or the lie that no club has; ``place`` is where a file gives them.

    What the characteristic time may be depends on the mass properties, and what these may be on each other.
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


def _solved(forward: Floats, wanted: Floats) -> Floats:
    """Solve for mass properties of very different sizes, kilograms and kg m2: rows and columns are scaled first."""
    rows = 1.0 / np.abs(forward).max(axis=1)
    columns = 1.0 / np.abs(forward * rows[:, None]).max(axis=0)
    return columns[:, None] * np.linalg.solve(forward * rows[:, None] * columns, wanted * rows[:, None])


def _rows(numbers: Floats) -> Floats:
    """Return a root of the pseudo-inertia of a mass of 1, shape (4, 4): its CG, and the root of moments about it."""
    result = np.zeros((4, 4))
    result[:3, 0] = numbers[:3]
    for number, place in zip(numbers[3:], _ROOT, strict=True):
        result[place[0], 1 + place[1]] = number
    result[3, 0] = 1.0
    return result


STEPS = 13
"""Places along each axis of the volume, both ends among them."""
ROUNDS = 20
"""How often the grid is halved, at most: places are then distinguished by a millionth of the volume's size."""
NEAR = 1e-6
"""Greatest error of a moment, in parts of mass and half size, with which masses count as a solution."""
NEGLIGIBLE = 1e-9
"""Part of the discretionary mass below which a point mass is left out."""


class PointMass(NamedTuple):
    """A mass at a place.

    Attributes
    ----------
    mass
        [kg].
    place
        Seen from the face centre: to the target, up, to the toe [m].
    """

    mass: float
    place: tuple[float, float, float]


def placement(envelope: Envelope, pseudo: Floats) -> list[PointMass]:
    """Return point masses that have the moments of the discretionary mass of a head, the heaviest first.

    ``pseudo`` is the pseudo-inertia of the head about the face centre, shape (4, 4). There are at most ten masses, as
    there are ten moments, and none where none were found.
    """
    volume, placed = envelope.volume, envelope.placed(pseudo)
    inverse = np.linalg.inv(volume.frame)
    own = inverse @ placed @ inverse.T / placed[3, 3]
    step = 2.0 / (STEPS - 1)
    parts = _inside(volume, _lattice(STEPS) * step)
    masses, missed = _least_missed(parts, own)
    for _ in range(ROUNDS):
        if not 1e-3 * NEAR < missed < np.inf:
            break
        step *= 0.5
        parts = parts[masses > NEGLIGIBLE]
        parts = np.vstack([parts, _inside(volume, (parts[:, None] + _lattice(3) * step).reshape(-1, 3))])
        masses, missed = _least_missed(parts, own)
    if missed > NEAR:
        return []
    places = np.array(volume.centre) + parts * 0.5 * np.array(volume.size)
    order = [each for each in np.argsort(-masses, kind="stable") if masses[each] > NEGLIGIBLE]
    return [
        PointMass(float(mass), (float(x), float(y), float(z)))
        for mass, (x, y, z) in zip(masses[order] * placed[3, 3], places[order], strict=True)
    ]


def _lattice(count: int) -> Floats:
    """Return whole numbers about 0, ``count`` along each axis, shape (count^3, 3)."""
    along = np.arange(count, dtype=float) - (count - 1) // 2
    return np.stack(np.meshgrid(along, along, along, indexing="ij"), axis=-1).reshape(-1, 3)


def _inside(volume: Volume, parts: Floats) -> Floats:
    """Return places, in parts of the way to the surface, with those beyond it moved onto it."""
    if volume.shape == "box":
        return np.clip(parts, -1.0, 1.0)
    return parts / np.maximum(np.linalg.norm(parts, axis=1), 1.0)[:, None]


def _least_missed(parts: Floats, own: Floats) -> tuple[Floats, float]:
    """Return the masses at given places, 1 in all, that miss moments the least, and the greatest miss."""
    from scipy.optimize import linprog

    rows = np.hstack([parts, np.ones((len(parts), 1))])
    moments = np.array([rows[:, i] * rows[:, j] for i, j in _ENTRIES])
    wanted = np.array([own[entry] for entry in _ENTRIES])
    # The mass is exact; of the other moments, the sum of what they miss is made least.
    free = np.eye(len(_ENTRIES))[:, :-1]
    equal = np.hstack([moments, free, -free])
    cost = np.concatenate([np.zeros(len(parts)), np.ones(2 * free.shape[1])])
    result = linprog(cost, A_eq=equal, b_eq=wanted, bounds=(0.0, None), method="highs-ds")
    if result.status != 0:
        return np.zeros(len(parts)), np.inf
    masses = result.x[: len(parts)]
    return masses, float(np.abs(moments @ masses - wanted).max())
