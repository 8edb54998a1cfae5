"""Inertia that an attached mechanism, such as shaft and hands, adds to a head: as a club property and as core inputs.

It is a symmetric 6 x 6 matrix from velocity and angular velocity to impulse and its moment about the CG.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from clubface.errors import InputError, Wording
from clubface.schema import Items, PhysicalValue

__all__ = [
    "ADDED_INERTIA", "ADDED_NAMES", "CONTACT_TIME", "added_inputs", "matrix_of", "on_mechanism",
    "spatial_inertia", "symmetric_rows",
]  # fmt: skip

Rows = tuple[tuple[float, ...], ...]

CONTACT_TIME = 450e-6
"""Contact time of driver and ball [s]. Irons have a tenth more, which lowers the shaft's effect by a few hundredths."""
SIZE = 6
SHAPE = "6 rows of 6 numbers [kg, kg m, kg m2]"
ADDED_INERTIA = Items(Items(PhysicalValue("1"), SIZE, SIZE, SHAPE), SIZE, SIZE, SHAPE)
"""Type of the matrix in a file."""
ASYMMETRY = 1e-6
"""Tolerance for opposite elements, relative to the geometric mean of the diagonal elements."""
_SYMMETRIC = ("xx", 0, 0), ("yy", 1, 1), ("zz", 2, 2), ("xy", 0, 1), ("xz", 0, 2), ("yz", 1, 2)
_ALL = tuple((f"{one}{other}", i, j) for i, one in enumerate("xyz") for j, other in enumerate("xyz"))
_PLACES = {
    **{f"added_mass_{name}": (i, j) for name, i, j in _SYMMETRIC},
    **{f"added_coupling_{name}": (i, 3 + j) for name, i, j in _ALL},
    **{f"added_inertia_{name}": (3 + i, 3 + j) for name, i, j in _SYMMETRIC},
}
"""Row and column in the matrix of each core input."""
ADDED_NAMES = _PLACES.keys()
"""Shot inputs given by the matrix, in the core's order."""


def added_inputs(rows: Rows | None) -> dict[str, float]:
    """Return the core inputs of an attached head; empty for a free one."""
    return {} if rows is None else {name: rows[i][j] for name, (i, j) in _PLACES.items()}


def matrix_of(values: Mapping[str, float]) -> Any:
    """Return the matrix of the core inputs, shape (6, 6)."""
    import numpy as np

    matrix = np.zeros((SIZE, SIZE))
    for name, (i, j) in _PLACES.items():
        matrix[i, j] = matrix[j, i] = values[name]
    return matrix


def symmetric_rows(given: Any) -> Any:
    """Return the rows of the matrix, made exactly symmetric; anything else is returned as is, for the schema to reject.

    Raises InputError if opposite elements differ by more than rounding.
    """
    rows = given.tolist() if hasattr(given, "tolist") else given
    if not _is_square(rows):
        return rows
    for i in range(SIZE):
        for j in range(i):
            difference, scale = abs(rows[i][j] - rows[j][i]), (abs(rows[i][i]) * abs(rows[j][j])) ** 0.5
            if difference > ASYMMETRY * scale + 1e-12:
                places = f"{rows[j][i]:g} in row {j + 1}, column {i + 1} but {rows[i][j]:g} in the opposite element"
                raise InputError("added_inertia", Wording(places), "a symmetric matrix")
    return tuple(tuple(0.5 * (rows[i][j] + rows[j][i]) for j in range(SIZE)) for i in range(SIZE))


def _is_square(rows: Any) -> bool:
    is_list = isinstance(rows, Sequence) and not isinstance(rows, str) and len(rows) == SIZE
    return is_list and all(
        isinstance(row, Sequence) and len(row) == SIZE
        and all(isinstance(each, int | float) and not isinstance(each, bool) for each in row) for row in rows
    )  # fmt: skip


def spatial_inertia(mass: float, inertia: Sequence[Sequence[float]], added: Rows | None = None) -> Rows:
    """Return the spatial inertia of a head about its CG, including any added inertia."""
    total = [[0.0] * SIZE for _ in range(SIZE)] if added is None else [list(row) for row in added]
    for i in range(3):
        total[i][i] += mass
        for j in range(3):
            total[3 + i][3 + j] += inertia[i][j]
    return tuple(map(tuple, total))


def on_mechanism(mass: float, inertia: Sequence[Sequence[float]], operational_inertia: Any) -> Rows:
    """Return the inertia that a mechanism adds, from the spatial inertia of the head attached to it, shape (6, 6)."""
    import numpy as np

    from clubface.simulation.beam import added_inertia

    total = np.asarray(operational_inertia, dtype=np.float64)
    if total.shape != (SIZE, SIZE) or not np.isfinite(total).all():
        raise InputError("operational_inertia", Wording(f"of shape {total.shape}"), SHAPE)
    own = np.array(spatial_inertia(mass, inertia))
    try:
        added = added_inertia(total, own)
    except ValueError as error:
        shown = Wording(f"less than that of the free head by {str(error).lstrip('-')} in some motion")
        allowed = "at least the spatial inertia of the free head about its CG, in its axes; check mass, axes and order"
        raise InputError("operational_inertia", shown, allowed) from None
    return tuple(tuple(float(each) for each in row) for row in added)
