"""Settings of the finite elements: time, steps, contact, and what to keep."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.support.checks import check_choice, check_count

METHODS = ("penalty", "augmented-lagrange")
"""How nodes are kept out of the face."""

SAFETIES = (None, 0.65, 0.55)
"""Time steps over the stable one that are tried in turn where none is asked for; the first is chosen by the core."""


@dataclass(frozen=True, kw_only=True)
class Settings:
    """How to run a finite element impact.

    Attributes
    ----------
    duration
        Simulated time [s].
    safety
        Time step divided by the stable step of the undeformed bodies. If left out, it is 0.75 of the ball's stable step
        (0.9 if no piece of the ball can be subcycled) and at most 0.95 of the head's. Hard impacts squeeze elements,
        which then need shorter steps; a run whose elements fail is therefore repeated with 0.65, and then with 0.55.
        The settings of a result hold the value that was used.
    interval
        Time between the records of motion [s]; contact is recorded at every step.
    until_separation
        Whether to end soon after the last touch, whether that is before or after ``duration`` (0.1 s at most).
    contact
        How nodes are kept out of the face: "penalty" uses springs, which give way in proportion to their load;
        "augmented-lagrange" adds multipliers that take over the load from the springs.
    bulk_viscosity
        Coefficient of a pressure against fast changes of volume in solid elements: this pressure divided by density,
        wave speed, element size and rate of the volume. 0.06 is usual in other programs; 0 for none.
    frames
        Number of deformed shapes to keep, evenly over ``duration``.
    fields
        Whether to keep stress and strain of every element with the deformed shapes.
    threads
        Number of threads, 0 for all cores. The result does not depend on it.
    """

    duration: float = 1e-3
    safety: float | None = None
    interval: float = 5e-6
    until_separation: bool = False
    contact: str = "penalty"
    bulk_viscosity: float = 0.0
    frames: int = 0
    fields: bool = False
    threads: int = 0

    def __post_init__(self) -> None:
        for name in ("duration", "interval"):
            object.__setattr__(self, name, units.parse(getattr(self, name), "time", name=name))
        if not 1e-6 <= self.duration <= 0.1:
            raise InputError("duration", units.show(self.duration, "us"), "1 us to 0.1 s")
        if not 1e-8 <= self.interval <= self.duration:
            raise InputError("interval", units.show(self.interval, "us"), "0.01 us to the duration")
        for name in ("safety", "bulk_viscosity"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, units.parse(getattr(self, name), units.DIMENSIONLESS, name=name))
        if self.safety is not None and not 0.05 <= self.safety <= 1.0:
            raise InputError("safety", self.safety, "0.05 to 1, the stable step")
        if not 0.0 <= self.bulk_viscosity <= 1.0:
            raise InputError("bulk_viscosity", self.bulk_viscosity, "0 to 1; 0.06 is usual")
        check_count("frames", self.frames, 0, 10_000)
        check_count("threads", self.threads, 0, 1024)
        check_choice("contact", self.contact, METHODS)
        for name in ("until_separation", "fields"):
            if not isinstance(getattr(self, name), bool):
                raise InputError(name, getattr(self, name), "true or false")

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
