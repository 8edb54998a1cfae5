"""Notes on doubtful aspects of a captured delivery."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from clubface import units
from clubface.capture.ball_flight import Launched
from clubface.capture.calibration import Registration
from clubface.capture.tracking import Track
from clubface.equipment.clubs import Club
from clubface.errors import ClubfaceError
from clubface.results.notes import Note, note
from clubface.support.checks import without_warnings

FASTEST = 70.0
"""Highest plausible clubhead speed [m/s]; long drivers reach 67 m/s (150 mph)."""
SLOWEST = 0.3
"""Lowest plausible clubhead speed [m/s]: the shortest putt."""
STARTS = (-0.3e-3, 0.75e-3)
"""Plausible times from first touch to the apparent start of the ball [s]: half a contact of 0.4 to 0.5 ms, to within
0.5 ms."""
MIDDLE_OF_CONTACT = 0.2e-3
"""Time from first touch to mid-contact [s], at which a ball appears to start."""
SMOOTH = -0.35
"""Correlation of successive residual steps above which the residuals are not white noise, which has -0.5."""
SURE_CORRELATION = 4.0
"""Number of standard errors by which the correlation must also exceed that of white noise."""
DIRECTION_OFF = units.to_si(6.0, "deg")
"""Largest difference of launch and azimuth from the default model [rad]; published models differ by 1.2 degrees."""
SPEED_OFF = 0.15
ROUGH = 1.5
ASKEW = units.to_si(30.0, "deg")
"""Path above which the target line is doubtful [rad]; golfers swing within about 15 degrees of it."""
VAGUE = 0.1
"""Largest relative standard deviation of speed; three markers with assumed positions give 0.02."""
TOO_MUCH_LOFT, TOO_MUCH_LIE = units.to_si(25.0, "deg"), units.to_si(45.0, "deg")
"""Largest differences of dynamic loft from the club's, and of lie from the club's [rad]."""
OPENING = units.to_si(500.0, "deg/s")
"""Fastest plausible opening of the face [rad/s]; full swings close it at 1000 to 4000 deg/s, short ones hardly."""
MOVED = 2e-3
"""Displacement on the head above which a marker is named [m]."""
FEW_FREEDOMS = 30
ROUNDED = 1e-6
"""Residual below which only single-precision rounding remains, and no noise [m]."""


def implausible(values: Mapping[str, float], deviations: Mapping[str, float], club: Club) -> list[Note]:
    """Return a note if values of a delivery are physically impossible or practically unknown, else an empty list."""
    off = {
        "speed": not SLOWEST < values["speed"] < FASTEST or deviations["speed"] > VAGUE * values["speed"],
        "path": abs(values["path"]) > ASKEW,
        "loft": abs(values["loft"] - club.loft) > TOO_MUCH_LOFT,
        "lie": abs(values["lie"]) > TOO_MUCH_LIE,
    }
    doubted = {name: [values[name], deviations[name]] for name, bad in off.items() if bad}
    return [note("capture-not-plausible", values=doubted)] if doubted else []


def delivery_notes(
    values: Mapping[str, float], deviations: Mapping[str, float], club: Club, *, assumed: float = 0.0
) -> Iterator[Note]:
    """Yield notes on implausible values of a delivery; ``assumed`` is the assumed part of the loft's deviation."""
    toe, high = values["toe"], values["high"]
    if abs(toe) > 0.5 * club.face_width or abs(high) > 0.5 * club.face_height:
        face = {"face_width": club.face_width, "face_height": club.face_height}
        yield note("capture-off-face", toe=toe, high=high, club=club.name, **face)
    if not SLOWEST < values["speed"] < FASTEST:
        yield note("capture-speed", speed=values["speed"])
    if deviations["speed"] > VAGUE * values["speed"]:
        yield note("capture-speed-uncertain", values={"speed": [values["speed"], deviations["speed"]]})
    if abs(values["loft"] - club.loft) > TOO_MUCH_LOFT:
        yield note("capture-loft", loft=values["loft"], static_loft=club.loft, club=club.name)
    if abs(values["lie"]) > TOO_MUCH_LIE:
        yield note("capture-lie", lie=values["lie"])
    if abs(values["path"]) > ASKEW:
        yield note("capture-path", path=values["path"])
    if values["closure"] < -OPENING - 3.0 * deviations["closure"]:
        yield note("capture-face-opens", closure=values["closure"])
    if math.sqrt(max(deviations["loft"] ** 2 - assumed**2, 0.0)) > units.to_si(2.0, "deg"):
        yield note("capture-loft-uncertain")


def launch_notes(
    values: Mapping[str, float], club: Club, ball: Any, seen: Launched | None, start: float
) -> Iterator[Note]:
    """Yield notes on contradictions between ball flight and delivery, which cast doubt on club, map or calibration."""
    if seen is None:
        return
    late = seen.start - start
    if late <= STARTS[0]:
        yield note("capture-ball-start", late_time=late)
    elif late >= STARTS[1]:
        yield note("capture-ball-starts-late", late_time=late, times=late / MIDDLE_OF_CONTACT)
    from clubface.simulation.impact import impact

    try:
        with without_warnings():
            expected = impact(club, dict(values), ball=ball)
    except ClubfaceError:
        return
    speed, launch, azimuth = directions(seen.velocity)
    spread = math.sqrt(float(np.max(np.diag(seen.covariance)))) / max(speed, 1e-9)
    off = max(abs(launch - float(expected.launch)), abs(azimuth - float(expected.azimuth)))
    if off > DIRECTION_OFF + 3.0 * spread or abs(speed / float(expected.ball_speed) - 1.0) > SPEED_OFF + 3.0 * spread:
        flight = {"ball_speed": speed, "launch": launch, "azimuth": azimuth}
        computed = {name: float(getattr(expected, name)) for name in flight}
        yield note("capture-flight-contradicts", seen=flight, expected=computed, club=club.name)


def track_notes(followed: Track, cluster: Registration, first_frame: int) -> Iterator[Note]:
    """Yield notes on corrections to the clubhead's markers."""

    def counted(frames: Sequence[int]) -> list[int]:
        return [each + first_frame for each in frames]

    for markers, frames in followed.exchanged.items():
        yield note("capture-markers-exchanged", markers=list(markers), frames=counted(frames))
    for marker, frames in followed.stray.items():
        yield note("capture-marker-strays", marker=marker, frames=counted(frames))
    if followed.lost:
        yield note("capture-markers-do-not-fit", frames=counted(followed.lost))
    for place, marker in enumerate(cluster.names):
        if not followed.seen[:, place].any():
            yield note("capture-marker-not-seen", marker=marker)
    moved = np.linalg.norm(followed.shape - cluster.shape, axis=-1)
    if moved.max() > MOVED:
        marker = cluster.names[int(moved.argmax())]
        yield note("capture-marker-moved", marker=marker, marker_displacement=float(moved.max()))


def filter_notes(followed: Track, before: int) -> Iterator[Note]:
    """Yield a note if the residuals up to frame ``before`` show that the markers were low-pass filtered."""
    frames = np.arange(len(followed.known)) <= before
    correlation, count = followed.step_correlation(frames)
    noise, _ = followed.noise(frames)
    if noise > ROUNDED and correlation > max(SMOOTH, -0.5 + SURE_CORRELATION / math.sqrt(max(count, 1))):
        yield note("capture-filtered", correlation=correlation)


def fit_notes(misfit: float, missing: int, freedom: int) -> Iterator[Note]:
    """Yield notes on doubts about the path and its noise."""
    if missing > 1:
        yield note("capture-path-extended", missing=missing)
    if misfit > ROUGH:
        yield note("capture-path-misfit", misfit=misfit)
    if 0 < freedom < FEW_FREEDOMS:
        yield note("capture-few-degrees-of-freedom", freedom=freedom)


def directions(velocity: Any) -> tuple[float, float, float]:
    """Return speed [m/s], launch angle and azimuth [rad] of a velocity in world axes."""
    x, y, z = (float(each) for each in velocity)
    return math.sqrt(x * x + y * y + z * z), math.atan2(y, math.hypot(x, z)), math.atan2(z, x)
