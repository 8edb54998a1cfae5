"""Stress and strain in the elements of a body, at the times of its deformed shapes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

COMPONENTS = ("xx", "yy", "zz", "xy", "xz", "yz")
"""Order of the components of tensors."""


@dataclass(frozen=True)
class ElementFields:
    """Stress and strain in the elements of a body.

    Attributes
    ----------
    stress
        Cauchy stress [Pa], shape (frames, elements, components) with :data:`COMPONENTS`; for shells (frames, elements,
        sides, components), the outer side first. In the axes of the frames.
    strain
        Logarithmic strain in the same shape (shear is not doubled); for shells only the elastic part.
    plastic_strain
        Equivalent plastic strain, shape (frames, elements); for shells the largest one through the thickness.

    Notes
    -----
    One-point hexahedra give the values at their centre, and fully integrated ones the average of their points. Shells
    give the values of their surfaces, or of the outermost points if they have points through the thickness, without
    transverse shear. The numbers have single precision.
    """

    stress: NDArray[Any]
    strain: NDArray[Any]
    plastic_strain: NDArray[Any]

    @classmethod
    def from_core(cls, told: dict[str, NDArray[Any]], frames: int, elements: int, *, shells: bool) -> ElementFields:
        """Return the fields of a body as the core tells them, both sides of all elements."""
        shape = (frames, elements, 2, len(COMPONENTS))
        stress, strain = (told[name].reshape(shape) for name in ("stress", "strain"))
        if not shells:
            stress, strain = stress[:, :, 0], strain[:, :, 0]
        return cls(stress, strain, told["plastic_strain"].reshape(frames, elements))

    @property
    def pressure(self) -> NDArray[Any]:
        """Minus the mean stress [Pa]; positive in compression."""
        return -self.stress[..., :3].mean(axis=-1)

    @property
    def von_mises(self) -> NDArray[Any]:
        """Equivalent stress of von Mises [Pa]."""
        return von_mises(self.stress)


def von_mises(stress: NDArray[Any]) -> NDArray[Any]:
    """Return the equivalent stress of von Mises of tensors, components last."""
    xx, yy, zz, xy, xz, yz = np.moveaxis(stress, -1, 0)
    differences = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    return np.sqrt(0.5 * differences + 3.0 * (xy**2 + xz**2 + yz**2))


def turned(tensors: NDArray[Any], rotation: NDArray[Any]) -> NDArray[Any]:
    """Return symmetric tensors (components last) in axes in which the old ones are the columns of ``rotation``."""
    xx, yy, zz, xy, xz, yz = np.moveaxis(tensors, -1, 0)
    whole = np.stack([np.stack(row, axis=-1) for row in ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))], axis=-2)
    seen = rotation @ whole @ rotation.T
    return np.stack([seen[..., i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))], axis=-1)
