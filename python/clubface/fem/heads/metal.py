"""What heads are made of."""

from __future__ import annotations

from dataclasses import dataclass

from clubface import units
from clubface.errors import InputError


@dataclass(frozen=True, kw_only=True)
class Metal:
    """An elastic metal; left out, the usual titanium alloy Ti-6Al-4V.

    Attributes
    ----------
    youngs
        Young's modulus [Pa].
    poisson
        Poisson's ratio.
    density
        [kg/m3].
    """

    youngs: float = 114e9
    poisson: float = 0.34
    density: float = 4430.0

    def __post_init__(self) -> None:
        for name, dimension in (("youngs", "pressure"), ("density", "density"), ("poisson", units.DIMENSIONLESS)):
            object.__setattr__(self, name, units.parse(getattr(self, name), dimension, name=name))
        if not 1e8 <= self.youngs <= 1e12:
            raise InputError("youngs", units.show(self.youngs, "GPa"), "0.1 to 1000 GPa")
        if not -1.0 < self.poisson < 0.5:
            raise InputError("poisson", self.poisson, "above -1 and below 0.5")
        if not 100.0 <= self.density <= 25e3:
            raise InputError("density", units.show(self.density, "kg/m3"), "100 to 25000 kg/m3")
