"""Notes on what is doubtful about a captured delivery."""

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
"""m/s; long drivers' clubheads reach 67 m/s (150 mph)."""
SLOWEST = 0.3
"""m/s; the shortest putt."""
STARTS = (-0.3e-3, 0.75e-3)
"""Seconds from first touch to when the ball seems to start at once: half a contact of 0.4 to 0.5 ms, within 0.5 ms."""
MIDDLE_OF_CONTACT = 0.2e-3
"""Seconds from first touch to the middle of a contact, when a ball that is hit seems to start."""
SMOOTH = -0.35
"""Correlation of successive steps of the residuals above which they are no white noise; that has -0.5."""
SURE_CORRELATION = 4.0
"""Standard errors of it by which it must exceed that of white noise as well."""
DIRECTION_OFF = units.to_si(6.0, "deg")
"""Largest difference of launch and azimuth from the default model; published models: 1.2 degrees."""
SPEED_OFF = 0.15
ROUGH = 1.5
ASKEW = units.to_si(30.0, "deg")
"""Path beyond which the target line is doubted: golfers swing within some 15 degrees of it."""
VAGUE = 0.1
"""Largest standard deviation of the speed, as a part of it; three markers and assumed places give 0.02."""
TOO_MUCH_LOFT, TOO_MUCH_LIE = units.to_si(25.0, "deg"), units.to_si(45.0, "deg")
"""Largest differences of dynamic loft from the club's, and of the lie from its own."""
OPENING = units.to_si(500.0, "deg/s")
"""Fastest opening of the face: full swings close it with 1000 to 4000 deg/s, short ones with hardly any."""
MOVED = 2e-3
"""Metres; a marker that sits farther from its place on the head is named."""
FEW_FREEDOMS = 30
ROUNDED = 1e-6
"""Metres; residuals below it are the rounding of a file in single precision, and no noise."""


def implausible(values: Mapping[str, float], deviations: Mapping[str, float], club: Club) -> list[Note]:
    """Return a note on the values of a delivery that no shot has, or that are as good as unknown; none without such."""
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
    """Yield notes on implausible values of a delivery; ``assumed`` is by how much the loft is assumed."""
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
    """Yield how the flight of the ball contradicts the delivery; then club, mapping or calibration are in doubt."""
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
    """Yield what had to be corrected in the markers of the clubhead."""

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
    """Yield that the markers were low-pass filtered, as far as their residuals up to frame ``before`` show it."""
    frames = np.arange(len(followed.known)) <= before
    correlation, count = followed.step_correlation(frames)
    noise, _ = followed.noise(frames)
    if noise > ROUNDED and correlation > max(SMOOTH, -0.5 + SURE_CORRELATION / math.sqrt(max(count, 1))):
        yield note("capture-filtered", correlation=correlation)


def fit_notes(misfit: float, missing: int, freedom: int) -> Iterator[Note]:
    """Yield what is doubtful about the path and its noise."""
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
