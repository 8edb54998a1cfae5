"""Added masses: point masses at given places, spread over nearby nodes of a head."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError
from clubface.schema import NAME, PhysicalValue, Place as FilePlace, Record, Tables

SPREAD = 8e-3
"""Nodes carry an added mass if they are at most this much farther from its place than the nearest node [m]."""

REACH = 0.3
"""Limit for the coordinates of an added mass [m]."""

Place = tuple[Any, Any, Any, Any]
"""x, y, z and mass, as text with units or SI numbers."""
_COORDINATE = PhysicalValue(
    "mm", -1e3 * REACH, 1e3 * REACH, decimals=4,
    allowed='within 300 mm of the face centre; numbers are metres, "-33 mm" is text',
)  # fmt: skip


class Places(Tables):
    """Type of tables of masses at places, read as places [m] and masses [kg] by name."""

    def read(self, given: Any, place: FilePlace) -> Any:
        """Read the tables; return x, y, z and mass by name."""
        return {each.pop("name"): tuple(each.values()) for each in super().read(given, place)}

    def check(self, value: Any, place: FilePlace) -> dict[str, Place]:
        """Check places given by name; return x, y, z and mass by name."""
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
        """Return one table per mass."""
        return [dict(zip(self.table.keys(), (name, *place), strict=True)) for name, place in value.items()]


def places(what: str, mass: str, least: float) -> Places:
    """Return the type of tables of masses; ``mass`` is the key of each mass, ``least`` its minimum in grams."""
    keys = {"name": NAME, **dict.fromkeys("xyz", _COORDINATE), mass: PhysicalValue("g", least, 500, decimals=4)}
    return Places(Record(keys, keys), what)


TRIMS, MASSES = places("trim", "most", 0.01), places("mass", "mass", 0.0)
"""Masses that may be added up to a maximum, which must be above zero; and masses that are added."""
MOST_CHANGE = 0.2
"""Largest relative change of a wall's metal mass that is made to keep the head's moments exact."""
TRIES, STEEPEST = 40, 2.0
"""Maximum number of Newton steps for the nodes' fractions of a mass, and the largest change of a logarithm per step."""
NEGLIGIBLE = 1e-3
"""Smallest relative error of a moment of inertia that is noted; for the CG, the error in m is a hundredth of it."""


class SpreadMass(NamedTuple):
    """Mass carried by the nodes, and the remaining errors compared with true point masses."""

    added: NDArray[Any]  # at each node, beyond its metal [kg]; negative where metal is removed
    away: float  # error of the CG [m]
    inertia: float  # largest relative error of a moment of inertia about the CG


def spread(places: Mapping[str, tuple[float, float, float, float]], nodes: NDArray[Any], metal: NDArray[Any],
           face: NDArray[Any]) -> SpreadMass:  # fmt: skip
    """Spread masses over nodes so that mass, CG and inertia of the head are those with point masses at the places.

    Each mass goes to the nodes nearest to its place. As no node lies exactly there, its moments are slightly off; the
    metal of the other nodes is adjusted to compensate, by a fraction that is a quadratic function of position and at
    most ``MOST_CHANGE``. Mass and CG are then exact. So, nearly, is the inertia, except for a mass off the walls: the
    nodes of a shell all lie near one quadric, whose moment no distribution over them can change.

    ``places`` are x, y, z [m] and mass [kg] by name, ``nodes`` the nodes of the mesh [m], shape (n, 3), ``metal`` the
    metal mass at each [kg], and ``face`` the nodes of the face, whose metal is not changed.
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
        # Penalise the change; only residuals of the second moments may remain.
        allowed = np.diag(soft) * 10.0 ** (step / 4.0) * free.sum()
        part = np.linalg.lstsq(weighed + allowed, asked - added @ moments, rcond=None)[0]
        change = moments @ part
        if np.abs(change[free > 0.0]).max(initial=0.0) <= MOST_CHANGE:
            added = added + free * change
            break
    return SpreadMass(added, *_errors(metal @ moments + asked, (metal + added) @ moments, size))


def _shares(arms: NDArray[Any], usual: NDArray[Any]) -> NDArray[Any]:
    """Return fractions of a mass for nodes so that its centre is the origin of their ``arms``, close to the usual ones.

    Newton's method finds the fractions of greatest entropy relative to ``usual``. If the origin is not within the
    nodes, as for a mass off a wall, the usual fractions are returned.
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
    """Return 1, x, y, z and the pairwise products of coordinates for each place, shape (n, 10)."""
    products = [places[:, i] * places[:, j] for i in range(3) for j in range(i, 3)]
    return np.column_stack([np.ones(len(places)), places, *products])


def _errors(asked: NDArray[Any], result: NDArray[Any], size: float) -> tuple[float, float]:
    """Return the distance between the CGs of two bodies [m] and the largest relative difference in inertia."""

    def body(values: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
        cg = values[1:4] / values[0]
        second = np.zeros((3, 3))
        second[np.triu_indices(3)] = values[4:]
        own = np.diag(second) - values[0] * cg * cg
        return cg * size, own.sum() - own

    (cg, inertia), (other, moved) = body(asked), body(result)
    return float(np.linalg.norm(other - cg)), float(np.abs(moved / inertia - 1.0).max())


def spread_note(result: SpreadMass, negligible: float = NEGLIGIBLE) -> str | None:
    """Return a note if the masses are not exact on this mesh, else None."""
    misses = []
    if result.away > 1e-2 * negligible:
        misses.append(f"the CG is {units.fixed(result.away, 'mm', 2)} off")
    if result.inertia > negligible:
        misses.append(f"a moment of inertia {100.0 * result.inertia:.2g}% off")
    if not misses:
        return None
    return f"masses act at nodes of the mesh, so {' and '.join(misses)}; place them on the walls to make them exact"
