"""Whether a clubhead can exist: non-negative mass in its volume must be able to give its mass, CG and inertia.

The moments of a body up to second order form one symmetric 4 by 4 matrix J, its pseudo-inertia: the integral of (x, y,
z, 1)(x, y, z, 1)' over its mass. A body with these moments exists if and only if J is positive semidefinite, which is a
stronger condition than the triangle inequality of the principal moments of inertia. Such a body fits into the region
where a quadratic form (x, y, z, 1) Q (x, y, z, 1)' is non-negative only if trace(J Q) is non-negative; for an ellipsoid
these two conditions are sufficient (Wensing, Kim and Slotine, 2018). Moments are additive, so the discretionary mass of
a head has the moments of the head minus those of the shell and must meet the same conditions.

An unknown volume is scaled from the driver's or the 7-iron's.

The origin is the face centre, the axes are those of the club: x to the target, y up, z to the toe.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from clubface import _core as core, units
from clubface.equipment.clubs import Club
from clubface.errors import InputError, Wording
from clubface.quantities import Quantity, Reading
from clubface.support.arrays import Floats
from clubface.support.checks import check_choice

MASS_PROPERTIES = ("mass", "cg_x", "cg_y", "cg_z", "ixx", "iyy", "izz", "ixy", "ixz", "iyz")
"""Club fields determined by the mass distribution."""
SHAPES = ("ellipsoid", "box")
ROUNDING = 1e-9
"""Relative tolerance for rounding in a margin."""
_PAIRS = ((0, 1), (0, 2), (1, 2))

DRIVER_VOLUME = units.to_si(460.0, "cm3")
DRIVER_WIDTH, IRON_WIDTH = 0.105, 0.07
"""Face widths of the two reference heads [m], by which other heads are scaled."""
FREE = 0.03
"""Discretionary mass [kg], typical of a driver and assumed for other heads; the rest is shell."""


def pseudo_inertia(values: Floats) -> Floats:
    """Return the pseudo-inertia about the face centre [kg m2, kg m and kg], shape (4, 4).

    ``values`` are mass properties [SI] in the order of ``MASS_PROPERTIES``, with the inertia about the CG.
    """
    return np.array(core.pseudo_inertia(values.tolist()))


def pseudo_inertia_derivatives(values: Floats) -> Floats:
    """Return the derivatives of the pseudo-inertia with respect to the mass properties, shape (10, 4, 4)."""
    mass, place = values[0], -values[1:4]
    result = np.zeros((10, 4, 4))
    result[0] = np.outer([*place, 1.0], [*place, 1.0])
    for axis in range(3):
        along = np.zeros(3)
        along[axis] = -1.0
        result[1 + axis, :3, :3] = mass * (np.outer(along, place) + np.outer(place, along))
        result[1 + axis, :3, 3] = result[1 + axis, 3, :3] = mass * along
    for entry, (row, column) in enumerate(((0, 0), (1, 1), (2, 2), *_PAIRS)):
        tensor = np.zeros((3, 3))
        tensor[row, column] = tensor[column, row] = 1.0
        result[4 + entry, :3, :3] = 0.5 * np.trace(tensor) * np.eye(3) - tensor
    return result


def mass_properties(pseudo: Floats) -> Floats:
    """Return the mass properties of a pseudo-inertia, in the order of ``MASS_PROPERTIES``."""
    mass = pseudo[3, 3]
    place = pseudo[:3, 3] / mass
    spread = pseudo[:3, :3] - mass * np.outer(place, place)
    inertia = np.trace(spread) * np.eye(3) - spread
    return np.array([mass, *-place, *np.diag(inertia), *(inertia[i, j] for i, j in _PAIRS)])


def of_club(head: Club) -> Floats:
    """Return the mass properties of a club in the order of ``MASS_PROPERTIES`` [SI], shape (10,)."""
    return np.array([getattr(head, name) for name in MASS_PROPERTIES])


class QuadraticForm(NamedTuple):
    """A condition trace(J Q) >= 0 on mass in a volume: what its violation means, and Q, shape (4, 4)."""

    words: str
    matrix: Floats


@dataclass(frozen=True, kw_only=True)
class Volume:
    """The space that contains the mass of a head.

    Attributes
    ----------
    shape
        "ellipsoid", for which the conditions are exact, or "box", for which they are necessary but not sufficient.
    centre, size
        Its centre relative to the face centre, and its size from face to back, sole to crown, heel to toe [m].
    """

    shape: str
    centre: tuple[float, float, float]
    size: tuple[float, float, float]

    def __post_init__(self) -> None:
        check_choice("shape", self.shape, SHAPES)
        for axis, each in zip("xyz", self.size, strict=True):
            if not each > 0.0:
                raise InputError("size", units.show(each, "mm"), f"above 0 along {axis}")

    def forms(self) -> tuple[QuadraticForm, ...]:
        """Return the conditions that mass inside it meets."""
        return tuple(QuadraticForm(words, np.array(matrix)) for words, matrix in core.volume_forms(self.space))

    @property
    def space(self) -> tuple[str, tuple[float, float, float], tuple[float, float, float]]:
        """Shape, centre and size, as the core takes them."""
        return self.shape, self.centre, self.size

    @property
    def frame(self) -> Floats:
        """Affine map, shape (4, 4), from coordinates scaled to -1..1 to positions relative to the face centre [m]."""
        result = np.eye(4)
        result[:3, :3] = np.diag(0.5 * np.array(self.size))
        result[:3, 3] = self.centre
        return result


SPIRAL = 400
"""Number of directions in which the room inside a mesh is measured."""
WALL = 1e-3
"""Minimum distance of placed mass from the surface of a mesh [m]."""


def room_inside(places: Floats, volume: Volume) -> Volume:
    """Return the largest axis-aligned ellipsoid inside the convex hull of points, shape (n, 3), and inside a volume.

    The conditions of an ellipsoid are sufficient, so a solution for it can be built inside the mesh; a hull has no such
    conditions. Raises an ``InputError`` if hull and volume have no room in common.
    """
    from scipy.optimize import minimize

    # A spiral from pole to pole gives evenly spread directions; the axes are added.
    number = np.arange(SPIRAL) + 0.5
    height, turn = 1.0 - 2.0 * number / SPIRAL, np.pi * (1.0 + 5.0**0.5) * number
    ring = np.sqrt(1.0 - height**2)
    normals = np.vstack([np.eye(3), -np.eye(3), np.stack([ring * np.cos(turn), ring * np.sin(turn), height], axis=1)])
    half, centre = 0.5 * np.array(volume.size), np.array(volume.centre)
    order = 1 if volume.shape == "box" else 2
    most = np.minimum(
        (places @ normals.T).max(axis=0) - WALL, normals @ centre + np.linalg.norm(normals * half, order, axis=1)
    )
    low, high = -most[3:6], most[:3]
    size = float((high - low).max())
    if (high - low).min() < 1e-3:
        middle = ", ".join(f'"{units.fixed(float(each), "mm", 0)}"' for each in 0.5 * (places.min(0) + places.max(0)))
        raise InputError("head.centre", Wording("outside the mesh of the club"), f"inside it, such as [{middle}]")

    def left(numbers: Floats) -> Floats:
        """Return the room left in each direction, relative to the size."""
        return (most - normals @ numbers[:3] * size - np.linalg.norm(normals * numbers[3:] * size, axis=1)) / size

    def slopes(numbers: Floats) -> Floats:
        reach = np.linalg.norm(normals * numbers[3:], axis=1)
        return -np.hstack([normals, normals**2 * numbers[3:] / reach[:, None]])

    start = np.concatenate([0.5 * (low + high), 0.25 * (high - low)]) / size
    optimum = minimize(
        lambda numbers: -np.log(numbers[3:]).sum(), start,
        jac=lambda numbers: np.append(np.zeros(3), -1.0 / numbers[3:]),
        constraints={"type": "ineq", "fun": left, "jac": slopes}, bounds=[(None, None)] * 3 + [(1e-3, 1.0)] * 3,
        method="SLSQP", options={"maxiter": 200},
    )  # fmt: skip
    shrunk = 1.0 + min(0.0, float((left(optimum.x) / np.linalg.norm(normals * optimum.x[3:], axis=1)).min()))
    x, y, z, a, b, c = (optimum.x * size).tolist()
    return Volume(shape="ellipsoid", centre=(x, y, z), size=(2 * a * shrunk, 2 * b * shrunk, 2 * c * shrunk))


class Margin(NamedTuple):
    """One condition on a head.

    Attributes
    ----------
    name
        Quantity of the head or of the discretionary mass that must be positive.
    value, reason
        Its value, dimensionless, and what is wrong if it is negative; no such body exists then.
    """

    name: str
    value: float
    reason: str

    @property
    def met(self) -> bool:
        """Whether the condition is met, within rounding."""
        return self.value >= -ROUNDING


@dataclass(frozen=True, kw_only=True)
class Envelope:
    """Limits on a head: a volume, a fixed shell in it, and a budget of discretionary mass.

    Attributes
    ----------
    volume
        Where discretionary mass may be placed.
    shell
        Pseudo-inertia of the mass that cannot be moved, shape (4, 4).
    budget
        Maximum discretionary mass [kg].
    whole
        The volume of the whole head; None if it is ``volume``.
    """

    volume: Volume
    shell: Floats
    budget: float
    whole: Volume | None = None

    def placed(self, pseudo: Floats) -> Floats:
        """Return the pseudo-inertia of a head's discretionary mass."""
        return pseudo - self.shell

    @property
    def scale(self) -> Floats:
        """Row and column factors that scale the moments of the discretionary mass to about 1, shape (4,)."""
        return np.array([*(2.0 / np.array(self.volume.size)), 1.0]) / np.sqrt(self.budget)

    def margins(self, pseudo: Floats) -> list[Margin]:
        """Return all conditions on a head with this pseudo-inertia."""
        whole = (self.whole or self.volume).space
        margins = core.head_margins(self.volume.space, whole, self.shell.tolist(), self.budget, pseudo.tolist())
        return [Margin(*each) for each in margins]


def refuse_impossible(name: str, envelope: Envelope, values: Floats) -> None:
    """Raise an error, with the reason, if no body in an envelope has these values of ``MASS_PROPERTIES``."""
    # The walls of a mesh lie outside the room for placed mass, so the present head may use all of its volume.
    now = replace(envelope, volume=envelope.whole or envelope.volume)
    missed = [each for each in now.margins(pseudo_inertia(values)) if not each.met]
    if missed:
        advice = "give other mass properties or another volume, shell or budget"
        raise InputError("club", name, f"a head that can be built: {missed[0].reason}; {advice}")


DRIVER = Volume(shape="box", centre=(-0.055, -0.001, 0.003), size=(0.115, 0.062, 0.124))
"""Box of a driver at the volume limit of the rules."""
IRON = Volume(shape="box", centre=(-0.00661, -0.00069, 0.0), size=(0.03454, 0.05613, 0.078))
"""Bounding box of the mesh of the built-in head 7-iron."""


def _length(name: str, label: str, meaning: str) -> Quantity:
    return Quantity(name, "m", Reading("mm", 1), Reading("mm", 1), label, meaning=meaning)


QUANTITIES = (
    _length("face_to_back", "face to back", "length of the head from the face to the back"),
    _length("sole_to_crown", "sole to crown", "height of the head from the sole to the crown"),
    _length("heel_to_toe", "heel to toe", "width of the head from the heel to the toe"),
    Quantity("volume", "m3", Reading("cm3", 0), Reading("cm3", 0), "volume", meaning="volume of the head"),
    Quantity(
        "free_mass", "kg", Reading("g", 1), Reading("g", 1), "free mass",
        meaning="mass that may be placed anywhere in the head; the rest is shell",
    ),
)  # fmt: skip
"""Quantities that describe a space."""


class Space(NamedTuple):
    """Assumed space of a head about which nothing else is known."""

    volume: Volume  # contains its mass
    displaced: float | None  # its volume as the rules measure it [m3]
    free: float  # discretionary mass [kg]
    origin: str  # of these values


def usual_space(club: Club) -> Space:
    """Return the space that the head of a club is assumed to fill."""
    is_iron = club.kind == "iron"
    usual, width = (IRON, IRON_WIDTH) if is_iron else (DRIVER, DRIVER_WIDTH)
    scale = club.face_width / width
    x, y, z = (scale * each for each in usual.centre)
    depth, height, length = (scale * each for each in usual.size)
    origin = "the box around the meshed head 7-iron" if is_iron else "that of a driver of 460 cm3"
    if scale != 1.0:
        origin += f" times {scale:.3g}, as the widths of the faces"
    displaced = None if is_iron else DRIVER_VOLUME * scale**3
    volume = Volume(shape="box", centre=(x, y, z), size=(depth, height, length))
    return Space(volume, displaced, FREE, f"assumed: {origin}")
