"""Captured deliveries with their uncertainty, and remarks on what is doubtful about them.

A captured delivery: its values, their uncertainty, and what was noticed while reading it.

Checks of a captured delivery: remarks on what is doubtful about it.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from statistics import NormalDist
from typing import Any, NamedTuple

import numpy as np

from clubface import units
from clubface.capture.ball_flight import Launched
from clubface.capture.calibration import Registration
from clubface.capture.captured_result import captured_result
from clubface.capture.geometry import Known
from clubface.capture.reduction import QUANTITIES
from clubface.capture.rotations import Array
from clubface.capture.tracking import Track
from clubface.equipment.clubs import Club
from clubface.errors import ClubfaceError, InputError
from clubface.results.result import Described, Result
from clubface.simulation.inputs import OF_CLUB, Delivery
from clubface.support.checks import MOST_SEED, check_choice, check_count, without_warnings
from clubface.support.processes import check_request

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
class CapturedDelivery(Described):
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

    def to_result(self) -> Result:
        """Return it as a result."""
        return captured_result([self])

    def __repr__(self) -> str:
        return str(self.to_result())


FASTEST = 70.0
"""m/s; long drivers' clubheads reach 67 m/s (150 mph)."""
SLOWEST = 0.3
"""m/s; of the shortest putt."""
STARTS = (-0.3e-3, 0.75e-3)
"""Seconds from first touch to when the ball seems to start at once: half a contact of 0.4 to 0.5 ms, within 0.5 ms."""
DIRECTION_OFF = units.to_si(6.0, "deg")
"""By which launch and azimuth may differ from those of the default model; published models: 1.2 degrees."""
SPEED_OFF = 0.15
ROUGH = 1.5
ASKEW = units.to_si(30.0, "deg")
"""Path beyond which the target line is doubted: golfers swing within some 15 degrees of it."""
VAGUE = 0.1
"""Part of the speed by which it is uncertain at most; three markers and assumed places give 0.02."""
TOO_MUCH_LOFT, TOO_MUCH_LIE = units.to_si(25.0, "deg"), units.to_si(45.0, "deg")
"""By how much dynamic loft differs from the club's, and the lie from its own, at most."""
OPENING = units.to_si(500.0, "deg/s")
"""Full swings close the face with 1000 to 4000 deg/s; short ones with hardly any."""
MOVED = 2e-3
"""Metres."""
FEW_FREEDOMS = 30


def implausible(values: Mapping[str, float], deviations: Mapping[str, float], club: Club) -> list[str]:
    """Return the values of a delivery that no shot has, or that are as good as unknown, with their names."""
    off = {
        "speed": not SLOWEST < values["speed"] < FASTEST or deviations["speed"] > VAGUE * values["speed"],
        "path": abs(values["path"]) > ASKEW,
        "loft": abs(values["loft"] - club.loft) > TOO_MUCH_LOFT,
        "lie": abs(values["lie"]) > TOO_MUCH_LIE,
    }
    shown = {"speed": ("m/s", 1), "path": ("deg", 0), "loft": ("deg", 0), "lie": ("deg", 0)}
    return [
        f"{name} {units.fixed(values[name], *shown[name])} ± {units.fixed(deviations[name], *shown[name])}"
        for name, bad in off.items()
        if bad
    ]


def of_delivery(
    values: Mapping[str, float], deviations: Mapping[str, float], club: Club, *, assumed: float = 0.0
) -> list[str]:
    """Return remarks on implausible values of a delivery; ``assumed`` is by how much the loft is assumed."""
    notes = []
    toe, high = values["toe"], values["high"]
    if abs(toe) > 0.5 * club.face_width or abs(high) > 0.5 * club.face_height:
        size = " x ".join(f"{units.from_si(each, 'mm'):.0f}" for each in (club.face_width, club.face_height)) + " mm"
        notes.append(
            f"the impact lies {units.fixed(toe, 'mm', 1)} towards the toe and {units.fixed(high, 'mm', 1)} high,"
            f" outside the face of {club.name} ({size}): a wrong club, mapping or calibration"
        )
    if not SLOWEST < values["speed"] < FASTEST:
        notes.append(f"a clubhead of {values['speed']:.3g} m/s: the unit of length or the frame rate may be wrong")
    if deviations["speed"] > VAGUE * values["speed"]:
        notes.append(
            f"the speed is hardly known, {values['speed']:.3g} ± {deviations['speed']:.2g} m/s: too few frames before"
            " impact show the clubhead, or markers stray there; take out of [cluster] what strays, or cut the recording"
        )
    if abs(values["loft"] - club.loft) > TOO_MUCH_LOFT:
        notes.append(
            f"the dynamic loft of {units.fixed(values['loft'], 'deg', 1)} is far from the"
            f" {units.fixed(club.loft, 'deg', 1)} of {club.name}: a wrong club, mapping or calibration"
        )
    if abs(values["lie"]) > TOO_MUCH_LIE:
        notes.append(
            f"the lie of {units.fixed(values['lie'], 'deg', 0)} is no club's: the axis that points up may be wrong"
        )
    if abs(values["path"]) > ASKEW:
        notes.append(
            f"the club goes {units.fixed(values['path'], 'deg', 0)} to the right of the target: the axis that points to"
            " the target may be wrong (target under [laboratory], or --target)"
        )
    if values["closure"] < -OPENING - 3.0 * deviations["closure"]:
        notes.append(
            f"the face opens through impact, with {units.fixed(-values['closure'], 'deg/s', 0)}: the hand of the club"
            " may be wrong (--hand)"
        )
    if math.sqrt(max(deviations["loft"] ** 2 - assumed**2, 0.0)) > units.to_si(2.0, "deg"):
        notes.append(
            "the dynamic loft is not known to 2 deg: too few markers, too near together, or gaps before impact"
        )
    return notes


def of_launch(values: Mapping[str, float], club: Club, ball: Any, seen: Launched | None, touch: float) -> list[str]:
    """Return how the flight of the ball contradicts the delivery; then club, mapping or calibration are in doubt."""
    if seen is None:
        return []
    notes = []
    late = seen.start - touch
    if not STARTS[0] < late < STARTS[1]:
        notes.append(
            f"the ball starts {units.fixed(late, 'ms', 2)} after the face touches it, not the 0.2 ms of a real impact:"
            " a wrong club, mapping or calibration"
        )
    from clubface.simulation.impact import impact

    try:
        with without_warnings():
            expected = impact(club, dict(values), ball=ball)
    except ClubfaceError:
        return notes
    speed, launch, azimuth = directions(seen.velocity)
    spread = math.sqrt(float(np.max(np.diag(seen.covariance)))) / max(speed, 1e-9)
    off = max(abs(launch - float(expected.launch)), abs(azimuth - float(expected.azimuth)))
    if off > DIRECTION_OFF + 3.0 * spread or abs(speed / float(expected.ball_speed) - 1.0) > SPEED_OFF + 3.0 * spread:
        notes.append(
            f"the ball flies off with {_flight(speed, launch, azimuth)}, where this delivery of {club.name} gives"
            f" {_flight(*(float(getattr(expected, name)) for name in ('ball_speed', 'launch', 'azimuth')))}: a wrong"
            " club, mapping or calibration"
        )
    return notes


def of_track(followed: Track, cluster: Registration, first_frame: int) -> list[str]:
    """Return what had to be corrected in the markers of the clubhead."""
    notes = [
        f"{words} in {frames_in_words(frames, first_frame)}: put right" for words, frames in followed.exchanged.items()
    ]
    notes += [
        f"{name} strays in {frames_in_words(frames, first_frame)}: left out there"
        for name, frames in followed.stray.items()
    ]
    if followed.lost:
        notes.append(
            f"the markers of the clubhead do not fit in {frames_in_words(followed.lost, first_frame)}: left out"
        )
    for place, name in enumerate(cluster.names):
        if not followed.seen[:, place].any():
            notes.append(f"{name} is never seen")
    moved = np.linalg.norm(followed.shape - cluster.shape, axis=-1)
    if moved.max() > MOVED:
        name = cluster.names[int(moved.argmax())]
        notes.append(
            f"{name} sits {units.fixed(moved.max(), 'mm', 1)} from its place by the mapping or calibration: has it"
            " moved?"
        )
    return notes


def of_fit(misfit: float, missing: int, freedom: int) -> list[str]:
    """Return what is doubtful about the path and its noise."""
    notes = []
    if missing > 1:
        notes.append(f"the last {missing} frames before impact do not show the clubhead's pose: extended across them")
    if misfit > ROUGH:
        notes.append(
            f"the path departs from the estimator's by {misfit:.1f} times the variance expected: its uncertainty is too"
            " small (a larger roughness, or the given marker noise, may be needed)"
        )
    if 0 < freedom < FEW_FREEDOMS:
        notes.append(f"the noise of the markers is estimated from {freedom} degrees of freedom only")
    return notes


def directions(velocity: Any) -> tuple[float, float, float]:
    """Return speed [m/s], launch angle and azimuth [rad] of a velocity in world axes."""
    x, y, z = (float(each) for each in velocity)
    return math.sqrt(x * x + y * y + z * z), math.atan2(y, math.hypot(x, z)), math.atan2(z, x)


def _flight(speed: float, launch: float, azimuth: float) -> str:
    return f"{speed:.1f} m/s, {units.fixed(launch, 'deg', 1)} up and {units.fixed(azimuth, 'deg', 1)} right"


def frames_in_words(frames: list[int], first_frame: int) -> str:
    """Write frames as ranges, the first few of them."""
    runs: list[list[int]] = []
    for frame in (each + first_frame for each in frames):
        if runs and frame == runs[-1][1] + 1:
            runs[-1][1] = frame
        else:
            runs.append([frame, frame])
    written = [str(a) if a == b else f"{a}-{b}" for a, b in runs[:4]]
    more = f" and {len(runs) - 4} more" if len(runs) > 4 else ""
    return f"{'frame' if len(frames) == 1 else 'frames'} {', '.join(written)}{more}"
