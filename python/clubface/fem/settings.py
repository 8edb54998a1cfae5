"""Settings of a finite element run: time, steps, contact, and what to record."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from clubface import units
from clubface.errors import InputError
from clubface.schema import FLAG, Choice, PhysicalValue, check_values, count, file_key

__all__ = ["Settings"]

METHODS = ("penalty", "augmented-lagrange")
"""Contact methods, which keep nodes out of the face."""

SAFETIES = (None, 0.65, 0.55)
"""Values of ``safety`` tried in turn if none is given; None lets the core choose."""


@dataclass(frozen=True, kw_only=True)
class Settings:
    """Settings of a finite element run.

    Attributes
    ----------
    safety
        Time step divided by the stable step of the undeformed bodies. Default: 0.75 of the ball's stable step (0.9 if
        no piece of the ball can be subcycled), but at most 0.95 of the head's. Elements compressed in a hard impact
        need shorter steps, so a run in which elements fail is repeated with 0.65, then with 0.55. The settings of a
        result hold the value used.
    contact
        How nodes are kept out of the face: "penalty" uses springs, which yield in proportion to their load;
        "augmented-lagrange" adds multipliers that take over the load from the springs.
    bulk_viscosity
        Coefficient of a pressure that resists fast volume changes in solid elements: the pressure divided by density,
        wave speed, element size and rate of volume change. Other programs commonly use 0.06; 0 switches it off.
    """

    duration: float = file_key(PhysicalValue("us", 1, 1e5, allowed="1 us to 0.1 s"), "simulated time", default=1e-3)
    safety: float | None = file_key(
        PhysicalValue("1", 0.05, 1, allowed="0.05 to 1 (the stable step)"),
        "time step divided by the stable step of the undeformed bodies; chosen by default", default=None,
    )  # fmt: skip
    interval: float = file_key(
        PhysicalValue("us", 0.01, allowed="0.01 us to the duration"),
        "time between records of motion; contact is recorded at every step", default=5e-6,
    )  # fmt: skip
    until_separation: bool = file_key(
        FLAG, "end soon after the last touch, before or after `duration` (0.1 s at most)", default=False
    )
    contact: str = file_key(Choice(METHODS), "contact method", default="penalty")
    bulk_viscosity: float = file_key(
        PhysicalValue("1", 0, 1, allowed="0 to 1; 0.06 is usual"),
        "coefficient of a pressure that resists fast volume changes", default=0.0,
    )  # fmt: skip
    frames: int = file_key(count(0, 10_000), "number of deformed shapes to record, evenly over `duration`", default=0)
    fields: bool = file_key(FLAG, "also record stress and strain of every element with the shapes", default=False)
    threads: int = file_key(count(0, 1024), "number of threads, 0 for all cores; does not affect the result", default=0)

    def __post_init__(self) -> None:
        check_values(self)
        if self.interval > self.duration:
            raise InputError("interval", units.show(self.interval, "us"), "0.01 us to the duration")

    def values(self) -> dict[str, Any]:
        """Return the settings in the core's format."""
        return {name: getattr(self, name) for name in self.__dataclass_fields__}

    def safeties(self) -> tuple[float | None, ...]:
        """Return the value of ``safety``, or the values to try in turn if it is None."""
        return SAFETIES if self.safety is None else (self.safety,)


def settings_of(given: Settings | None) -> Settings:
    """Return the given settings, or the defaults; raise InputError for anything else."""
    if given is None:
        return Settings()
    if not isinstance(given, Settings):
        raise InputError("settings", given, "a clubface.fem.Settings")
    return given
