"""Settings of the finite elements: time, steps, contact, and what to keep."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.schema import FLAG, Choice, PhysicalValue, check_values, count, file_key

__all__ = ["Settings"]

METHODS = ("penalty", "augmented-lagrange")
"""How nodes are kept out of the face."""

SAFETIES = (None, 0.65, 0.55)
"""Time steps over the stable one that are tried in turn where none is asked for; the first is chosen by the core."""


@dataclass(frozen=True, kw_only=True)
class Settings:
    """How to run a finite element impact.

    Attributes
    ----------
    safety
        Time step divided by the stable step of the undeformed bodies. If left out, it is 0.75 of the ball's stable step
        (0.9 if no piece of the ball can be subcycled) and at most 0.95 of the head's. Hard impacts squeeze elements,
        which then need shorter steps; a run whose elements fail is therefore repeated with 0.65, and then with 0.55.
        The settings of a result hold the value that was used.
    contact
        How nodes are kept out of the face: "penalty" uses springs, which give way in proportion to their load;
        "augmented-lagrange" adds multipliers that take over the load from the springs.
    bulk_viscosity
        Coefficient of a pressure against fast changes of volume in solid elements: this pressure divided by density,
        wave speed, element size and rate of the volume. 0.06 is usual in other programs; 0 for none.
    """

    duration: float = file_key(PhysicalValue("us", 1, 1e5, allowed="1 us to 0.1 s"), "simulated time", default=1e-3)
    safety: float | None = file_key(
        PhysicalValue("1", 0.05, 1, allowed="0.05 to 1, the stable step"),
        "time step divided by the stable step of the undeformed bodies; chosen by default", default=None,
    )  # fmt: skip
    interval: float = file_key(
        PhysicalValue("us", 0.01, allowed="0.01 us to the duration"),
        "time between the records of motion; contact is recorded at every step", default=5e-6,
    )  # fmt: skip
    until_separation: bool = file_key(
        FLAG, "whether to end soon after the last touch, before or after `duration` (0.1 s at most)", default=False
    )
    contact: str = file_key(Choice(METHODS), "contact method", default="penalty")
    bulk_viscosity: float = file_key(
        PhysicalValue("1", 0, 1, allowed="0 to 1; 0.06 is usual"),
        "coefficient of a pressure against fast changes of volume", default=0.0,
    )  # fmt: skip
    frames: int = file_key(count(0, 10_000), "deformed shapes to keep, evenly over `duration`", default=0)
    fields: bool = file_key(FLAG, "whether to keep stress and strain of every element with the shapes", default=False)
    threads: int = file_key(count(0, 1024), "0 for all cores; the result does not depend on it", default=0)

    def __post_init__(self) -> None:
        check_values(self)
        if self.interval > self.duration:
            raise InputError("interval", units.show(self.interval, "us"), "0.01 us to the duration")

    def values(self) -> dict[str, Any]:
        """Return the settings as the core takes them."""
        return {name: getattr(self, name) for name in self.__dataclass_fields__}

    def safeties(self) -> tuple[float | None, ...]:
        """Return the safety, or the values to try in turn if none is given."""
        return SAFETIES if self.safety is None else (self.safety,)


def settings_of(given: Settings | None) -> Settings:
    """Return the settings given, checked, or those by default."""
    if given is None:
        return Settings()
    if not isinstance(given, Settings):
        raise InputError("settings", given, "a clubface.fem.Settings")
    return given
