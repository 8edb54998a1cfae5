"""What a mechanism adds to the inertia of a head: as a value of a club, and as inputs of the core.

Shaft and hands are a symmetric 6 x 6 matrix, force and moment about the CG by velocity and angular velocity.
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
"""How long a driver and a ball touch [s]; with irons it is a tenth more, and what a shaft adds some hundredths less."""
SIZE = 6
SHAPE = "6 rows of 6 numbers [kg, kg m, kg m2]"
ADDED_INERTIA = Items(Items(PhysicalValue("1"), SIZE, SIZE, SHAPE), SIZE, SIZE, SHAPE)
"""The kind of the matrix in a file."""
ASYMMETRY = 1e-6
"""By how much opposite elements may differ, as a part of the geometric mean of the elements on the diagonal."""
_SYMMETRIC = ("xx", 0, 0), ("yy", 1, 1), ("zz", 2, 2), ("xy", 0, 1), ("xz", 0, 2), ("yz", 1, 2)
_ALL = tuple((f"{one}{other}", i, j) for i, one in enumerate("xyz") for j, other in enumerate("xyz"))
_PLACES = {
    **{f"added_mass_{name}": (i, j) for name, i, j in _SYMMETRIC},
    **{f"added_coupling_{name}": (i, 3 + j) for name, i, j in _ALL},
    **{f"added_inertia_{name}": (3 + i, 3 + j) for name, i, j in _SYMMETRIC},
}
"""Row and column of each input of the core."""
ADDED_NAMES = _PLACES.keys()
"""The inputs of a shot that the matrix gives, in the order of the core."""


def added_inputs(rows: Rows | None) -> dict[str, float]:
    """Return the inputs of the core that are not 0 for an attached head; none for a free one."""
    return {} if rows is None else {name: rows[i][j] for name, (i, j) in _PLACES.items()}


def matrix_of(values: Mapping[str, float]) -> Any:
    """Return the matrix of which the inputs of the core are the elements, shape (6, 6)."""
    import numpy as np

    matrix = np.zeros((SIZE, SIZE))
    for name, (i, j) in _PLACES.items():
        matrix[i, j] = matrix[j, i] = values[name]
    return matrix


def symmetric_rows(given: Any) -> Any:
    """Return rows of numbers, symmetric to the last bit; what is none stays for the schema to refuse.

    Raises
    ------
    InputError
        Opposite elements differ by more than rounding.
    """
    rows = given.tolist() if hasattr(given, "tolist") else given
    if not _is_square(rows):
        return rows
    for i in range(SIZE):
        for j in range(i):
            difference, scale = abs(rows[i][j] - rows[j][i]), (abs(rows[i][i]) * abs(rows[j][j])) ** 0.5
            if difference > ASYMMETRY * scale + 1e-12:
                places = f"{rows[j][i]:g} in row {j + 1}, column {i + 1} and {rows[i][j]:g} opposite to it"
                raise InputError("added_inertia", Wording(places), "a symmetric matrix")
    return tuple(tuple(0.5 * (rows[i][j] + rows[j][i]) for j in range(SIZE)) for i in range(SIZE))


def _is_square(rows: Any) -> bool:
    is_list = isinstance(rows, Sequence) and not isinstance(rows, str) and len(rows) == SIZE
    return is_list and all(
        isinstance(row, Sequence) and len(row) == SIZE
        and all(isinstance(each, int | float) and not isinstance(each, bool) for each in row) for row in rows
    )  # fmt: skip


def spatial_inertia(mass: float, inertia: Sequence[Sequence[float]], added: Rows | None = None) -> Rows:
    """Return the spatial inertia of a head about its CG, with what is added to it."""
    total = [[0.0] * SIZE for _ in range(SIZE)] if added is None else [list(row) for row in added]
    for i in range(3):
        total[i][i] += mass
        for j in range(3):
            total[3 + i][3 + j] += inertia[i][j]
    return tuple(map(tuple, total))


def on_mechanism(mass: float, inertia: Sequence[Sequence[float]], operational_inertia: Any) -> Rows:
    """Return what a mechanism adds, from the whole spatial inertia of the head in it, shape (6, 6)."""
    import numpy as np

    from clubface.simulation.beam import added_inertia

    total = np.asarray(operational_inertia, dtype=np.float64)
    if total.shape != (SIZE, SIZE) or not np.isfinite(total).all():
        raise InputError("operational_inertia", Wording(f"of shape {total.shape}"), SHAPE)
    own = np.array(spatial_inertia(mass, inertia))
    try:
        added = added_inertia(total, own)
    except ValueError as error:
        shown = Wording(f"less than the free head by {str(error).lstrip('-')} in some motion")
        allowed = "at least the spatial inertia of the head about its CG, in its axes; check mass, axes and order"
        raise InputError("operational_inertia", shown, allowed) from None
    return tuple(tuple(float(each) for each in row) for row in added)
