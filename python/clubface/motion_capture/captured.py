"""A captured delivery: its values, their uncertainty, and what was noticed while reading it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from statistics import NormalDist
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.clubs import Club
from clubface.errors import InputError
from clubface.motion_capture.geometry import Known
from clubface.motion_capture.reduction import QUANTITIES
from clubface.motion_capture.rotations import Array
from clubface.simulation.delivery import OF_CLUB, Delivery
from clubface.support.checks import MOST_SEED, check_choice, check_count
from clubface.support.memory import check_request

NOT_PLAUSIBLE = "not plausible"
"""How the first note begins of a delivery that no shot has."""


class Trace(NamedTuple):
    """A head through a recording, in world axes.

    Attributes
    ----------
    times
        Of the frames [s].
    face_centre
        [m], shape (frames, 3); NaN without a pose.
    loft, face
        Dynamic loft and face angle [rad], shape (frames,).
    residual
        Root mean square along an axis of what is left between the markers and the head [m], shape (frames,).
    ball, radius
        Centre of the ball at rest, shape (3,), and its radius [m].
    """

    times: Array
    face_centre: Array
    loft: Array
    face: Array
    residual: Array
    ball: Array
    radius: float


@dataclass(frozen=True, kw_only=True, eq=False)
class CapturedDelivery:
    """A delivery from motion capture with its uncertainty, in SI units and radians.

    Attributes
    ----------
    delivery
        The delivery at first touch, with the signs of :class:`Delivery`.
    uncertainty
        Standard deviation of each value [SI], by name.
    covariance
        Covariance of the values in the order of the delivery, shape (11, 11). It contains the noise of the markers,
        what the path may do between the last frame and impact, the uncertainty of the place of the ball, and that of
        the club against its markers.
    launch
        ``ball_speed``, ``launch`` and ``azimuth`` [SI] of the ball as it flies off; empty if the flight is not seen.
    launch_uncertainty
        Their standard deviations.
    club
        The club that was delivered.
    estimator
        Name of the estimator that extended the path to impact.
    time
        Time of first touch [s], from the first frame.
    frames
        The numbers of the frames before and after first touch, as the file counts.
    used
        Number of frames before impact that the estimator used.
    marker_noise
        Standard deviation of a marker along an axis [m].
    marker_noise_freedom
        Degrees of freedom of that estimate; 0 if the noise was given.
    misfit
        Residuals of the path divided by the expected ones. Above 1.5 the uncertainty is too small. NaN for ``linear``.
    notes
        What you should know about the result, warnings first.
    geometry
        How markers, club and ball are known: measured, given, or assumed with which standard deviation.
    trace
        The head through the recording, for pictures.
    source
        The file.
    """

    delivery: Delivery
    uncertainty: dict[str, float]
    covariance: Array
    launch: dict[str, float]
    launch_uncertainty: dict[str, float]
    club: Club
    estimator: str
    time: float
    frames: tuple[int, int]
    used: int
    marker_noise: float
    marker_noise_freedom: int
    misfit: float
    notes: tuple[str, ...]
    geometry: tuple[Known, ...]
    trace: Trace
    source: str

    @property
    def plausible(self) -> bool:
        """Whether a shot can have this delivery; if not, the first of the notes says what is wrong with it."""
        return not (self.notes and self.notes[0].startswith(NOT_PLAUSIBLE))

    def interval(self, name: str, level: float = 0.95) -> tuple[float, float]:
        """Return the limits [SI] between which a value lies with the probability ``level``."""
        check_choice("delivery value", name, QUANTITIES)
        if not 0.0 < level < 1.0:
            raise InputError("level", level, "between 0 and 1")
        half = NormalDist().inv_cdf(0.5 + 0.5 * level) * self.uncertainty[name]
        value = getattr(self.delivery, name)
        return value - half, value + half

    def get(self, name: str, unit: str) -> tuple[float, float]:
        """Return a value of the delivery and its standard deviation in another unit."""
        check_choice("delivery value", name, QUANTITIES)
        units.unit(unit, name=name, dimension=OF_CLUB[name])
        return units.from_si(getattr(self.delivery, name), unit), units.from_si(self.uncertainty[name], unit)

    def sample(self, count: int, seed: int = 0) -> dict[str, Array]:
        """Return ``count`` random deliveries from the covariance, as :func:`impact` takes them, by name."""
        count, seed = check_count("count", count, 1, 2**32), check_count("seed", seed, 0, MOST_SEED)
        check_request(count, 4 * 8 * len(QUANTITIES))
        values = np.array([getattr(self.delivery, name) for name in QUANTITIES])
        drawn = np.random.default_rng(seed).multivariate_normal(values, self.covariance, size=count, method="eigh")
        return dict(zip(QUANTITIES, drawn.T, strict=True))

    def document(self) -> dict[str, Any]:
        """Return the whole result as plain values, in SI units."""
        return {
            "source": self.source,
            "club": self.club.name,
            "hand": "left" if self.club.hand < 0 else "right",
            "estimator": self.estimator,
            "delivery": {name: getattr(self.delivery, name) for name in QUANTITIES},
            "uncertainty": self.uncertainty,
            "covariance": self.covariance.tolist(),
            "launch": self.launch,
            "launch_uncertainty": self.launch_uncertainty,
            "time_s": self.time,
            "frames": list(self.frames),
            "frames_used": self.used,
            "marker_noise_m": self.marker_noise,
            "marker_noise_freedom": self.marker_noise_freedom,
            "misfit": None if math.isnan(self.misfit) else self.misfit,
            "geometry": [each.document() for each in self.geometry],
            "plausible": self.plausible,
            "notes": list(self.notes),
        }

    def __repr__(self) -> str:
        lines = [f"{self.source}: {self.club.name}, {self.estimator}, first touch {units.fixed(self.time, 'ms', 3)}"]
        for name in QUANTITIES:
            unit = units.display_unit(name, units.SI_UNITS[OF_CLUB[name]])
            value, deviation = self.get(name, unit)
            lines.append(f"  {name:<10} {value:10.3f} ± {deviation:.3f} {unit}")
        return "\n".join([*lines, *(f"  {known}" for known in self.geometry), *(f"  * {note}" for note in self.notes)])
