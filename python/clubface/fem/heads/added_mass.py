"""Masses added to a head at places."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError
from clubface.schema import NAME, PhysicalValue, Place as FilePlace, Record, Tables

SPREAD = 8e-3
"""Radius about the place of an added mass within which nodes carry it [m], beyond the nearest."""

REACH = 0.3
"""Farthest place of an added mass along an axis [m]."""

Place = tuple[Any, Any, Any, Any]
"""x, y, z and mass, text with units or SI."""
_COORDINATE = PhysicalValue(
    "mm", -1e3 * REACH, 1e3 * REACH, decimals=4,
    allowed='within 300 mm of the face centre; numbers are metres, "-33 mm" is text',
)  # fmt: skip


class Places(Tables):
    """The kind of tables of masses at places, read as places [m] and masses [kg] by name."""

    def read(self, given: Any, place: FilePlace) -> Any:
        """Return x, y, z and mass by name."""
        return {each.pop("name"): tuple(each.values()) for each in super().read(given, place)}

    def check(self, value: Any, place: FilePlace) -> dict[str, Place]:
        """Return the same of places by name."""
        kinds = {key: kind for key, kind in self.table.keys().items() if key != "name"}
        result = {}
        for name, given in value.items():
            label = f"{self.what} {name}"
            if len(given) != len(kinds):
                raise InputError(label, given, "x, y, z and a mass")
            pairs = zip(kinds.items(), given, strict=True)
            result[name] = tuple(kind.read(each, FilePlace(name=key, label=label)) for (key, kind), each in pairs)
        return result

    def rows(self, value: Any) -> list[dict[str, Any]]:
        """Return the tables."""
        return [dict(zip(self.table.keys(), (name, *place), strict=True)) for name, place in value.items()]


def places(what: str, mass: str, least: float) -> Places:
    """Return the kind of tables of masses; ``mass`` is the key of each mass, which is at least that many grams."""
    keys = {"name": NAME, **dict.fromkeys("xyz", _COORDINATE), mass: PhysicalValue("g", least, 500, decimals=4)}
    return Places(Record(keys, keys), what)


TRIMS, MASSES = places("trim", "most", 0.01), places("mass", "mass", 0.0)
"""Masses that may be added, of which one that may weigh nothing is none; and masses that are."""
MOST_CHANGE = 0.2
"""Largest part by which the metal of a wall may be made lighter or heavier, so that moments of the head are exact."""
TRIES, STEEPEST = 40, 2.0
"""Newton steps for the shares of nodes, and the most that a step changes the logarithm of one."""
NEGLIGIBLE = 1e-3
"""Part of a moment of inertia, and a hundredth of it in metres of the CG, below which no note is made."""


class SpreadMass(NamedTuple):
    """What the nodes carry, and by how much the head misses what points at the places would give it."""

    added: NDArray[Any]  # of each node beyond its metal [kg]; negative where the metal is made lighter
    away: float  # how far the CG is off [m]
    inertia: float  # largest part by which a moment of inertia about the CG is off


def spread(places: Mapping[str, tuple[float, float, float, float]], nodes: NDArray[Any], metal: NDArray[Any],
           face: NDArray[Any]) -> SpreadMass:  # fmt: skip
    """Return what nodes carry so that the head has mass, CG and inertia as if the masses were points at their places.

    Each mass stands on the nodes nearest to its place. No node lies there, so its moments are a little off; the rest of
    the head makes up for that: the metal of each node changes by a part that is a quadratic function of its place, at
    most by ``MOST_CHANGE``. Mass and CG are exact then. The inertia of a mass off the walls is nearly so: nodes of a
    shell all lie near one quadric, whose moment no distribution over them changes.

    ``places`` are x, y, z [m] and mass [kg] by name, ``nodes`` those of the mesh [m], shape (n, 3), ``metal`` the mass
    of the metal at each [kg], and ``face`` the nodes of the face, whose metal stays as it is.
    """
    added = np.zeros(len(nodes))
    points = np.array([place[:3] for place in places.values()]).reshape(-1, 3)
    masses = np.array([place[3] for place in places.values()])
    for point, mass in zip(points, masses, strict=True):
        away = np.linalg.norm(nodes - point, axis=1)
        near = np.flatnonzero(away < away.min() + SPREAD)
        added[near] += mass * _shares(nodes[near] - point, 1.0 - away[near] / (away.min() + SPREAD))
    if not masses.sum() > 0.0:
        return SpreadMass(added, 0.0, 0.0)
    size = float(np.abs(nodes).max())
    moments = _moments(nodes / size)
    asked = masses @ _moments(points / size)
    free = metal.copy()
    free[face] = 0.0
    weighed = moments.T @ (free[:, None] * moments)
    soft = np.array([0.0] * 4 + [1.0] * 6)
    for step in range(-36, 13):
        # A penalty on what the change is; residuals of the second moments alone may stay.
        allowed = np.diag(soft) * 10.0 ** (step / 4.0) * free.sum()
        part = np.linalg.lstsq(weighed + allowed, asked - added @ moments, rcond=None)[0]
        change = moments @ part
        if np.abs(change[free > 0.0]).max(initial=0.0) <= MOST_CHANGE:
            added = added + free * change
            break
    return SpreadMass(added, *_missed(metal @ moments + asked, (metal + added) @ moments, size))


def _shares(arms: NDArray[Any], usual: NDArray[Any]) -> NDArray[Any]:
    """Return the shares of nodes in a mass whose centre is the origin of their ``arms``: the nearest to the usual ones.

    They are those of the greatest entropy relative to ``usual``, by Newton's method; where the origin is not among the
    nodes, such as off a wall, the usual ones.
    """
    usual = usual / usual.sum()
    slope = np.zeros(3)
    for _ in range(TRIES):
        exponents = arms @ slope
        share = usual * np.exp(exponents - exponents.max())
        share /= share.sum()
        mean = share @ arms
        if np.abs(mean).max() < 1e-12:
            return share
        spread = (share[:, None] * arms).T @ arms - np.outer(mean, mean)
        step = np.linalg.lstsq(spread, mean, rcond=1e-9)[0]
        slope -= step * min(1.0, STEEPEST / max(float(np.abs(arms @ step).max()), 1e-300))
    return usual


def _moments(places: NDArray[Any]) -> NDArray[Any]:
    """Return 1, x, y, z and the products of two of them at places, shape (n, 10)."""
    products = [places[:, i] * places[:, j] for i in range(3) for j in range(i, 3)]
    return np.column_stack([np.ones(len(places)), places, *products])


def _missed(asked: NDArray[Any], result: NDArray[Any], size: float) -> tuple[float, float]:
    """Return how far two bodies' CGs are apart [m], and the greatest part by which their moments of inertia differ."""

    def body(values: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
        cg = values[1:4] / values[0]
        second = np.zeros((3, 3))
        second[np.triu_indices(3)] = values[4:]
        own = np.diag(second) - values[0] * cg * cg
        return cg * size, own.sum() - own

    (cg, inertia), (other, moved) = body(asked), body(result)
    return float(np.linalg.norm(other - cg)), float(np.abs(moved / inertia - 1.0).max())


def note_of(result: SpreadMass, negligible: float = NEGLIGIBLE) -> str | None:
    """Return what to say of masses that are not exact on this mesh."""
    misses = []
    if result.away > 1e-2 * negligible:
        misses.append(f"the CG is {units.fixed(result.away, 'mm', 2)} off")
    if result.inertia > negligible:
        misses.append(f"a moment of inertia {100.0 * result.inertia:.2g}% off")
    if not misses:
        return None
    return f"masses stand on nodes of the mesh, and {' and '.join(misses)}; place them on the walls to have them exact"
