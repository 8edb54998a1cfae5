"""Calibration: marker positions on the club, given, or derived from face points, the address, or the swing itself.

At address the head rests on the ground behind the ball with its built loft and lie. That the player aims the face at
the target and holds the shaft as designed is assumed; the standard deviations of these assumptions enter every delivery
that depends on them. At impact the head loses the momentum that the ball gains, and the ball leaves nearly along the
face normal, so loft and face angle follow from the direction in which the head is slowed. The impact gives no
information on the lie, which is taken as the club's; that is good to a few degrees, and speed, attack angle, path and
rates hardly depend on it.

Once the attitude is roughly known at one instant, the rest is a small least-squares problem for the six coordinates of
the club relative to its markers, with one row per known quantity.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from clubface import units
from clubface.capture.estimators import ROUGHNESS
from clubface.capture.geometry import Known, off_face, usual_place
from clubface.capture.impact_detection import DetectedImpact, detect_impact, last_before
from clubface.capture.impact_frame import Extrapolation
from clubface.capture.markers import MarkerMap
from clubface.capture.recording import Recording, runs
from clubface.capture.rotations import (
    FEWEST,
    Array,
    angles,
    degrees_of_freedom,
    delivered,
    exponential,
    fit_poses,
    shape_covariance,
    skew,
    visible,
)
from clubface.capture.tracking import Track, check_scale, check_seen, track
from clubface.equipment.balls import Ball
from clubface.equipment.clubs import Club
from clubface.errors import ClubfaceError, FileError
from clubface.results.notes import Note, note
from clubface.support.checks import without_warnings

MISPLACED = 3e-3
"""Misfit above which face points are considered misnamed or misplaced [m]."""


class Registration(NamedTuple):
    """Registration of the marker cluster on the club."""

    names: tuple[str, ...]  # of the markers
    shape: Array  # marker positions from the CG, in club axes with z towards the toe [m], shape (markers, 3)
    # Of the club's position and rotation relative to the cluster [m, rad], in club axes about the CG, shape (6, 6).
    covariance: Array
    misfit: float  # root mean square residual of the face points [m]; NaN without any
    notes: tuple[Note, ...] = ()
    geometry: tuple[Known, ...] = ()  # how the registration is known


def given_positions(mapping: MarkerMap, club: Club) -> Registration:
    """Return the registration for marker positions given in the mapping."""
    names = tuple(mapping.cluster)
    shape = np.array([mapping.cluster[name] for name in names], dtype=np.float64) + np.array(club.cg)
    covariance = shape_covariance(shape) * mapping.position_deviation**2
    parts = Known("markers from the face centre", "given", "toe", deviations=[mapping.position_deviation])
    return Registration(names, shape, covariance, float("nan"), geometry=(parts,))


def calibrated(mapping: MarkerMap, club: Club, recording: Recording, turn: Array) -> Registration:
    """Return the registration from a trial that shows the cluster together with face points.

    In every frame that shows all face points, their pose transforms the cluster into club axes; the result is the mean
    over these frames. Marker noise averages out over the frames, errors in the positions of face points do not.
    ``turn`` is the rotation from laboratory to world axes, mirrored for a left-hander, shape (3, 3). Raises FileError
    if markers are missing or never seen together, or if the face points do not fit the face.
    """
    local = _face_points(mapping, club)
    faces = recording.markers(mapping.face) @ turn.T
    cluster = recording.markers(mapping.cluster) @ turn.T
    whole = np.all(visible(faces), axis=-1)
    if not whole.any():
        raise recording.error(f"no frame shows all face points at once: {', '.join(mapping.face)}")
    check_scale(local, faces[whole], recording.path)
    poses = fit_poses(local, faces[whole])
    if not np.isfinite(poses.position).all():
        raise recording.error(f"the face points lie on a line: {', '.join(mapping.face)}")
    freedom = int(degrees_of_freedom(poses.residuals).sum())
    misfit = float(np.sqrt((poses.residuals**2).sum() / freedom))
    if misfit > MISPLACED:
        worst = list(mapping.face)[int(np.argmax(np.linalg.norm(poses.residuals.mean(0), axis=-1)))]
        raise recording.error(
            f"the face points miss their positions by {units.fixed(misfit, 'mm', 1)}, most of all {worst}; check that"
            f" this is the calibration of {club.name}, and that toe, high and standoff are those of the markers"
        )
    arms = cluster[whole] - poses.position[:, None]
    turned = np.einsum("kij,kmi->kmj", poses.rotation, arms)
    counts = visible(turned).sum(0)
    names = tuple(name for name, count in zip(mapping.cluster, counts, strict=True) if count)
    absent = [name for name in mapping.cluster if name not in names]
    if len(names) < FEWEST:
        raise recording.error(f"no frame shows the face together with: {', '.join(absent)}")
    shape = np.nanmean(turned[:, counts > 0], axis=0)
    # The face points' frame scatters with noise; errors in their positions are the same in every frame.
    noise = mapping.noise if mapping.noise is not None else _scatter(turned)
    covariance = shape_covariance(local) * (noise**2 / float(whole.sum()) + mapping.position_deviation**2)
    covariance += shape_covariance(shape) * noise**2 / counts[counts > 0].min()
    about_cg = np.eye(6)
    about_cg[:3, 3:] = skew(np.array(club.cg))
    notes = (note("capture-markers-not-calibrated", markers=absent),) if absent else ()
    parts = (
        Known("markers from the face", "measured", "toe", deviations=[misfit]),
        Known("face points", "given", "toe", deviations=[mapping.position_deviation]),
    )
    return Registration(names, shape + np.array(club.cg), about_cg @ covariance @ about_cg.T, misfit, notes, parts)


def _face_points(mapping: MarkerMap, club: Club) -> Array:
    """Return the positions of the face points from the face centre, in club axes [m]."""
    for name, point in mapping.face.items():
        if abs(point.toe) > 0.5 * club.face_width or abs(point.high) > 0.5 * club.face_height:
            raise FileError(mapping.path, None, f"[face] {name} lies outside the face of {club.name}")
    return np.array([off_face(club, *point) for point in mapping.face.values()])


def _scatter(turned: Array) -> float:
    """Estimate the noise of a marker [m] from the scatter of the cluster relative to the face points.

    The estimate includes the noise of the face points, so it is not too small.
    """
    often = visible(turned).sum(0) > 1
    return float(np.sqrt(np.mean(np.nanvar(turned[:, often], axis=0, ddof=1)))) if often.any() else 0.0


ROUNDS = 8
"""Number of Gauss-Newton iterations; two suffice if given positions and attitude agree within a few degrees."""
STEP = 1e-6
"""Step of the central differences [m, rad], and minimum standard deviation of a given position [m]."""
ODD = 4.0
"""Sum of squares per row above which the known quantities contradict each other."""


class Attitude(NamedTuple):
    """Loft, face angle and lie of the club at one instant [rad], for a right-hander, and their covariance."""

    values: Array
    covariance: Array


def placed(markers: Array, attitude: Attitude, mapping: MarkerMap, club: Club, height: float | None) -> Registration:
    """Return the registration from marker positions and the club's attitude at one instant.

    ``markers`` are their positions [m], in world axes for a right-hander, shape (markers, 3); ``height`` is that of the
    ground in world axes [m] if the sole rests on it, else None.
    """
    names = tuple(mapping.cluster)
    cg = np.array(club.cg)
    assumed = delivered(attitude.values[0], attitude.values[1], attitude.values[2], club.loft)
    mean, spread = usual_place(club.kind, mapping.assumed)
    known = [place for place, name in enumerate(names) if mapping.cluster[name] is not None]
    given = np.array([mapping.cluster[names[place]] for place in known]).reshape(-1, 3)
    root = np.linalg.inv(np.linalg.cholesky(attitude.covariance))
    seen = (markers - markers.mean(0)) @ assumed
    start = seen + (mean if not known else given.mean(0) - seen[known].mean(0)) + cg
    origin = markers.mean(0) - assumed @ start.mean(0)
    nominal = 0.5 * club.face_height * np.cos(club.loft)

    def moved(x: Array) -> Array:
        """Return the markers in club axes if the club is displaced by ``x`` from its initial estimate."""
        return (start - x[:3]) @ exponential(x[3:])

    def rows(x: Array) -> Array:
        """Return the residual of each known quantity in standard deviations."""
        turned = assumed @ exponential(x[3:])
        off = [root @ (np.array(angles(turned, club.loft)) - attitude.values)]
        shape = moved(x) - cg
        if known:
            off.append(np.ravel(shape[known] - given) / max(mapping.position_deviation, STEP))
        else:
            off.append((shape.mean(0) - mean) / spread)
        if height is not None:
            centre = origin + assumed @ x[:3] + turned @ cg
            off.append(np.array([(centre[1] - height - nominal) / mapping.assumed.sole]))
        return np.concatenate(off)

    x, covariance = least_squares(rows, np.zeros(6))
    degrees = np.sqrt(np.diag(attitude.covariance))
    parts = []
    if known:
        words = f"{len(known)} marker{'s' * (len(known) > 1)} from the face centre"
        parts.append(Known(words, "given", "toe", deviations=[mapping.position_deviation]))
    else:
        parts.append(
            Known("mean of the markers from the face centre", "assumed", "toe", mean.tolist(), spread.tolist())
        )
    if height is not None:
        parts.append(
            Known("height of the face centre over the ground", "assumed", "toe", [nominal], [mapping.assumed.sole])
        )
    shape = moved(x)
    notes = _disagreement(
        rows(x), len(known), np.array(angles(assumed @ exponential(x[3:]), club.loft)), attitude, degrees
    )
    return Registration(names, shape, covariance, float("nan"), notes, tuple(parts))


def least_squares(rows: Callable[[Array], Array], start: Array) -> tuple[Array, Array]:
    """Minimise the sum of squares of ``rows`` by Gauss-Newton; return the solution and its covariance."""
    x = start
    inverse = np.eye(len(x))
    for _ in range(ROUNDS):
        steps = STEP * np.eye(len(x))
        jacobian = np.stack([(rows(x + step) - rows(x - step)) / (2.0 * STEP) for step in steps], 1)
        inverse = np.linalg.inv(jacobian.T @ jacobian)
        x = x - inverse @ jacobian.T @ rows(x)
    return x, inverse


def _disagreement(off: Array, known: int, values: Array, attitude: Attitude, deviations: Array) -> tuple[Note, ...]:
    """Return a note if given positions contradict the assumed attitude."""
    if known < FEWEST or float(off @ off) <= ODD * len(off):
        return ()
    worst = int(np.argmax(np.abs(values - attitude.values) / deviations))
    angle = ("loft", "face", "lie")[worst]
    measured, expected = ({angle: float(each[worst])} for each in (values, attitude.values))
    return (note("capture-attitude-contradicted", measured=measured, assumed=expected),)


STILL = 0.08
"""Speed over ``WINDOW`` below which a head counts as at rest [m/s]; waggles are ten times faster."""
WINDOW = 0.05
"""Time over which speed is measured [s], so that 1 mm of marker noise amounts to 0.03 m/s."""
SHORTEST = 0.1
"""Minimum duration of an address [s]: longer than the pause at the top of the swing."""
LOW = 0.15
"""Maximum height of a resting head above its lowest position [m], which excludes the shoulder."""


def from_address(mapping: MarkerMap, club: Club, recording: Recording, turn: Array) -> Registration:
    """Return the registration from the address, in a separate trial or in the swing.

    ``turn`` is the rotation from laboratory to world axes, mirrored for a left-hander, shape (3, 3). Raises FileError
    if the head is never at rest, or a marker is not seen at address.
    """
    assumed = mapping.assumed
    seen = recording.markers(mapping.cluster) @ turn.T
    first, last = _address_frames(mapping, recording, seen)
    markers = _mean_markers(seen[first : last + 1], tuple(mapping.cluster), recording, first)
    attitude = Attitude(np.array([club.loft, 0.0, 0.0]), np.diag([assumed.loft, assumed.face, assumed.lie]) ** 2)
    result = placed(markers, attitude, mapping, club, mapping.ground)
    parts = (
        Known("loft at address", "assumed", "face", [club.loft], [assumed.loft]),
        Known("face angle at address", "assumed", "face", [0.0], [assumed.face]),
        Known("lie at address", "assumed", "face", [0.0], [assumed.lie]),
    )
    frames = {"first_frame": first + recording.first_frame, "last_frame": last + recording.first_frame}
    of_file = mapping.calibration is not None
    address = note("capture-address-of-file" if of_file else "capture-address", **frames, file=str(recording.path))
    return result._replace(geometry=(*parts, *result.geometry), notes=(address, *result.notes))


def _address_frames(mapping: MarkerMap, recording: Recording, seen: Array) -> tuple[int, int]:
    """Return the first and last frame of the address, counted from 0."""
    count = len(seen)
    if mapping.frames is not None:
        first, last = (each - recording.first_frame for each in mapping.frames)
        if first < 0 or last >= count:
            available = f"{recording.first_frame} to {recording.first_frame + count - 1}"
            raise recording.error(
                f"frames of the address are {list(mapping.frames)}, but the file has frames {available}; correct"
                f" frames under [calibration] of {mapping.path}"
            )
        return first, last
    middle = np.where(visible(seen)[..., None], seen, np.nan).mean(1)  # NaN where a marker is hidden
    step = max(round(WINDOW * recording.rate), 1)
    speed = np.full(count, np.nan)
    if count > step:
        speed[: count - step] = np.linalg.norm(middle[step:] - middle[:-step], axis=-1) * recording.rate / step
    low = middle[:, 1] < np.nanmin(middle[:, 1], initial=np.inf) + LOW
    with np.errstate(invalid="ignore"):
        still = runs((speed < STILL) & low)
    rests = [(first, last + step) for first, last in still if last + step - first >= SHORTEST * recording.rate]
    if not rests:
        slowest = "" if np.isnan(speed).all() else f"; it is never slower than {np.nanmin(speed):.2f} m/s"
        raise recording.error(
            f"no address: the clubhead never rests near the ground for {units.fixed(SHORTEST, 'ms', 0)}{slowest}."
            f" Under [calibration] of {mapping.path}, give the frames of the address, or a file that shows it, or"
            ' by = "swing"'
        )
    return rests[-1]


def _mean_markers(seen: Array, names: tuple[str, ...], recording: Recording, first: int) -> Array:
    """Return the mean marker positions over the frames that show all of them."""
    whole = seen[np.all(visible(seen), axis=-1)]
    if len(whole) < 1 or len(names) < FEWEST:
        hidden = [name for name, each in zip(names, np.any(visible(seen), axis=0).tolist(), strict=True) if not each]
        words = f"{', '.join(hidden)} not seen" if hidden else "no frame shows all markers of the cluster"
        raise recording.error(
            f"address from frame {first + recording.first_frame}: {words}; remove the marker from [cluster], or give"
            " other frames under [calibration]"
        )
    mean = whole.mean(0)
    if not np.isfinite(fit_poses(mean - mean.mean(0), mean[None]).position).all():
        raise recording.error(f"the markers of the cluster lie on a line: {', '.join(names)}")
    return mean


DRAWS = 800
"""Number of random draws of the unknowns; about a hundred agree with a usual impact, which gives spreads to 7%."""
FEWEST_AGREEING = 30
"""Minimum number of draws that agree with a usual impact."""
USUAL_LOFT = {"wood": units.to_si(3.0, "deg"), "hybrid": 0.0, "iron": units.to_si(-7.0, "deg")}
"""Usual delivered loft minus the club's [rad]: drivers are hit upwards, irons with the hands ahead."""
TURNED = units.to_si(8.0, "deg")
"""Standard deviation of the head's rotation from its static attitude at impact, about each axis [rad]."""
SWING_ROUNDS = 5
"""Iterations of the search for the face that sends the ball in its direction; each leaves at most 20% error."""
STEEP = 1.3
"""Limit for loft and face angle in the search [rad]."""
SHARE = 0.85
"""Change of the ball's direction per change of the face's direction: 0.75 to 0.9 in published models."""


def from_swing(mapping: MarkerMap, club: Club, ball: Ball, recording: Recording, turn: Array) -> Registration:
    """Return the registration from the impact of a swing; raise FileError if the impact cannot be read.

    ``turn`` is the rotation from laboratory to world axes, mirrored for a left-hander, shape (3, 3).
    """
    where = recording.path
    followed = followed_alone(mapping, recording, turn)
    noise = mapping.noise
    if noise is None:
        noise, _ = followed.noise(np.arange(len(followed.known)) <= last_before(recording.times, followed, where))
    mean, spread = _mean_position(mapping, club)
    cg = -mean - np.array(club.cg)
    arm = float(np.linalg.norm(np.hypot(spread, TURNED * np.linalg.norm(cg))) / np.sqrt(3.0))
    cg = delivered(club.loft, 0.0, 0.0, club.loft) @ cg
    how = Extrapolation(max(noise, 1e-6), "smoother", ROUGHNESS, where)
    detected = detect_impact(recording.times, followed, how, arm=arm, cg=cg)
    attitude = _attitude(detected, mapping, club, ball, where)
    markers = detected.position + followed.shape @ detected.rotation.T
    result = placed(markers, attitude, mapping, club, None)
    deviations = np.sqrt(np.diag(attitude.covariance))
    parts = (
        Known("loft and face angle at impact, from the head's loss of speed and usual values", "assumed", "face",
                 attitude.values[:2].tolist(), deviations[:2].tolist()),
        Known("lie at impact", "assumed", "face", [0.0], deviations[2:].tolist()),
    )  # fmt: skip
    return result._replace(geometry=(*parts, *result.geometry))


def followed_alone(mapping: MarkerMap, recording: Recording, turn: Array) -> Track:
    """Return the head's track from its markers alone, with their mean as the origin."""
    names = tuple(mapping.cluster)
    seen = recording.markers(names) @ turn.T
    check_seen(seen, names, recording.path)
    whole = np.flatnonzero(np.all(visible(seen), axis=-1))
    if not len(whole):
        counts = visible(seen).sum(0).tolist()
        hidden = ", ".join(name for name, count in zip(names, counts, strict=True) if not count)
        reason = f"{hidden} never seen" if hidden else "no frame shows all of them at once"
        raise recording.error(f"markers of the cluster: {reason}; remove markers that are not seen from [cluster]")
    first = seen[whole[len(whole) // 2]]
    return track(first - first.mean(0), seen, names, recording.path)


def _attitude(detected: DetectedImpact, mapping: MarkerMap, club: Club, ball: Ball, where: str) -> Attitude:
    """Return loft, face angle and lie at first touch from how the head is slowed, and their covariance."""
    from clubface.simulation.impact import impact

    random = np.random.default_rng(0)
    assumed = mapping.assumed
    mean, spread = _mean_position(mapping, club)
    change = random.multivariate_normal(detected.later - detected.velocity, detected.covariance, DRAWS, method="eigh")
    # From the mean of the markers to the CG, in club axes.
    arm = -(mean + spread * random.normal(size=(DRAWS, 3))) - np.array(club.cg)
    toe, high = (deviation * random.normal(size=DRAWS).clip(-2.0, 2.0) for deviation in (assumed.toe, assumed.high))
    lie = assumed.delivered_lie * random.normal(size=DRAWS)
    sideways = assumed.impulse * random.normal(size=(2, DRAWS))
    velocity = detected.velocity
    speed = float(np.linalg.norm(velocity))
    given = {
        "speed": speed, "attack": float(np.arcsin(velocity[1] / speed)),
        "path": float(np.arctan2(velocity[2], velocity[0])), "lie": lie, "toe": toe, "high": high,
        "lie_rate": -detected.spin[0], "closure": detected.spin[1], "pitch_rate": detected.spin[2],
    }  # fmt: skip
    loft, face = np.full(DRAWS, club.loft), np.zeros(DRAWS)
    try:
        for _ in range(SWING_ROUNDS):
            turned = delivered(float(np.nanmedian(loft)), float(np.nanmedian(face)), 0.0, club.loft)
            pushed = -(change - np.cross(detected.spin, arm @ turned.T))
            launch = np.arctan2(pushed[:, 1], np.hypot(pushed[:, 0], pushed[:, 2]))
            azimuth = np.arctan2(pushed[:, 2], pushed[:, 0])
            with without_warnings():
                made = impact(
                    club.replace(hand="right"), {**given, "loft": loft, "face": face}, ball=ball, on_error="nan"
                )
            loft = (loft + (launch + sideways[0] - made.launch) / SHARE).clip(-STEEP, STEEP)
            face = (face + (azimuth + sideways[1] - made.azimuth) / SHARE).clip(-STEEP, STEEP)
    except ClubfaceError:
        raise FileError(where, None, _describe_failure(club)) from None
    drawn = np.stack([loft, face, lie])
    drawn = drawn[:, np.isfinite(drawn).all(0)]
    usual = np.array([club.loft + USUAL_LOFT[club.kind], 0.0])[:, None]
    allowed = np.array([assumed.delivered_loft, assumed.delivered_face])[:, None]
    weights = np.exp(-0.5 * (((drawn[:2] - usual) / allowed) ** 2).sum(0))
    if (weights > 0.1).sum() < FEWEST_AGREEING:
        raise FileError(where, None, _describe_failure(club))
    mean = np.average(drawn, axis=1, weights=weights)
    return Attitude(np.array([mean[0], mean[1], 0.0]), np.cov(drawn, aweights=weights))


def _mean_position(mapping: MarkerMap, club: Club) -> tuple[Array, Array]:
    """Return the mean marker position from the face centre [m], and its standard deviations."""
    given = [place for place in mapping.cluster.values() if place is not None]
    if len(given) < len(mapping.cluster):
        return usual_place(club.kind, mapping.assumed)
    return np.mean(given, 0), np.full(3, mapping.position_deviation / np.sqrt(len(given)))


def _describe_failure(club: Club) -> str:
    return (
        f"the head is slowed as if the ball went where no usual impact of {club.name} sends it; check the club, the"
        " directions of target and up, and the positions under [cluster]. If they are right, give"
        ' by = "address" in place of "swing"'
    )
