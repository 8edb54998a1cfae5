"""Remarks on what is doubtful about a captured delivery."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from clubface import units
from clubface.capture.ball_flight import Launched
from clubface.capture.calibration import Registration
from clubface.capture.tracking import Track
from clubface.equipment.clubs import Club
from clubface.errors import ClubfaceError
from clubface.support.checks import without_warnings

NOT_PLAUSIBLE = "not plausible"
"""How the first note begins of a delivery that no shot has."""
FASTEST = 70.0
"""m/s; long drivers' clubheads reach 67 m/s (150 mph)."""
SLOWEST = 0.3
"""m/s; the shortest putt."""
STARTS = (-0.3e-3, 0.75e-3)
"""Seconds from first touch to when the ball seems to start at once: half a contact of 0.4 to 0.5 ms, within 0.5 ms."""
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


def delivery_remarks(
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


def launch_remarks(
    values: Mapping[str, float], club: Club, ball: Any, seen: Launched | None, start: float
) -> list[str]:
    """Return how the flight of the ball contradicts the delivery; then club, mapping or calibration are in doubt."""
    if seen is None:
        return []
    notes = []
    late = seen.start - start
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


def track_remarks(followed: Track, cluster: Registration, first_frame: int) -> list[str]:
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


def fit_remarks(misfit: float, missing: int, freedom: int) -> list[str]:
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
