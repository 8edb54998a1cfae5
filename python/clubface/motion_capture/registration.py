"""Where the markers sit on the club: as the mapping says, or from points of the face seen together with them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from clubface import units
from clubface.equipment.clubs import Club
from clubface.equipment.face import face_point, nearest
from clubface.errors import FileError
from clubface.motion_capture.attitude import face_axes
from clubface.motion_capture.geometry import Known
from clubface.motion_capture.mapping_file import MarkerMap
from clubface.motion_capture.recording import Recording
from clubface.motion_capture.rigid_body import FEWEST, degrees_of_freedom, fit_poses, pose_information, visible
from clubface.motion_capture.rotations import Array, skew
from clubface.motion_capture.tracking import check_scale

MISPLACED = 3e-3
"""Metres; face points that fit the face so badly are wrongly named or placed."""


class Registration(NamedTuple):
    """The cluster on the club.

    Attributes
    ----------
    names
        The markers.
    shape
        Their places from the CG, in club axes with z towards the toe [m], shape (markers, 3).
    covariance
        Of the place and turn of the club against the cluster [m, rad], in club axes about the CG, shape (6, 6).
    misfit
        Root mean square of what is left between the face points and the face [m]; NaN without any.
    notes
        What a reader should know.
    geometry
        How it is known.
    """

    names: tuple[str, ...]
    shape: Array
    covariance: Array
    misfit: float
    notes: tuple[str, ...] = ()
    geometry: tuple[Known, ...] = ()


def given_positions(mapping: MarkerMap, club: Club) -> Registration:
    """Return the cluster whose positions the mapping gives."""
    names = tuple(mapping.cluster)
    shape = np.array([mapping.cluster[name] for name in names], dtype=np.float64) + np.array(club.cg)
    covariance = np.linalg.inv(pose_information(shape, np.eye(3)[None], np.ones((1, len(shape))))[0])
    told = Known.of("markers from the face centre", "given", "mm", deviations=[mapping.position_deviation])
    return Registration(names, shape, covariance * mapping.position_deviation**2, float("nan"), geometry=(told,))


def calibrated(mapping: MarkerMap, club: Club, recording: Recording, turn: Array) -> Registration:
    """Return the cluster as it is seen together with the points of the face.

    In every frame that shows all points of the face, their attitude and position turn the cluster into club axes. The
    mean over these frames is the cluster. The noise of the markers averages out over the frames; errors in the places
    of the face points do not.

    Parameters
    ----------
    mapping, club
        Which marker is what, and the club.
    recording
        The calibration trial.
    turn
        Rotation from the laboratory to the world, mirrored for a left-hander, shape (3, 3).

    Raises
    ------
    FileError
        Markers are missing or never seen together, or the points do not fit the face.
    """
    local = _face_points(mapping, club)
    faces = recording.markers(mapping.face) @ turn.T
    cluster = recording.markers(mapping.cluster) @ turn.T
    whole = np.all(visible(faces), axis=-1)
    if not whole.any():
        raise FileError(
            recording.path, None, f"no frame shows all points of the face at once: {', '.join(mapping.face)}"
        )
    check_scale(local, faces[whole], recording.path)
    poses = fit_poses(local, faces[whole])
    if not np.isfinite(poses.position).all():
        raise FileError(recording.path, None, f"the points of the face lie on a line: {', '.join(mapping.face)}")
    freedom = int(degrees_of_freedom(poses.residuals).sum())
    misfit = float(np.sqrt((poses.residuals**2).sum() / freedom))
    if misfit > MISPLACED:
        worst = list(mapping.face)[int(np.argmax(np.linalg.norm(poses.residuals.mean(0), axis=-1)))]
        raise FileError(
            recording.path, None,
            f"the points of the face miss their places by {units.fixed(misfit, 'mm', 1)}, most of all {worst}: is this"
            f" the calibration of {club.name}, and are toe, high and standoff those of the markers?",
        )  # fmt: skip
    arms = cluster[whole] - poses.position[:, None]
    turned = np.einsum("kij,kmi->kmj", poses.rotation, arms)
    counts = visible(turned).sum(0)
    names = tuple(name for name, count in zip(mapping.cluster, counts, strict=True) if count)
    absent = [name for name in mapping.cluster if name not in names]
    if len(names) < FEWEST:
        raise FileError(recording.path, None, f"no frame shows the face together with: {', '.join(absent)}")
    shape = np.nanmean(turned[:, counts > 0], axis=0)
    # The face points' own frame scatters by noise; what their places are wrong by is the same in every frame.
    noise = mapping.noise if mapping.noise is not None else _scatter(turned)
    frames = float(whole.sum())
    face_part = np.linalg.inv(pose_information(local, np.eye(3)[None], np.ones((1, len(local))))[0])
    shape_part = np.linalg.inv(pose_information(shape, np.eye(3)[None], np.ones((1, len(shape))))[0])
    covariance = (
        face_part * (noise**2 / frames + mapping.position_deviation**2)
        + shape_part * noise**2 / counts[counts > 0].min()
    )
    about_cg = np.eye(6)
    about_cg[:3, 3:] = skew(np.array(club.cg))
    notes = (f"{', '.join(absent)} not seen in the calibration: left out",) if absent else ()
    told = (
        Known.of("markers from the face", "measured", "mm", deviations=[misfit]),
        Known.of("points of the face", "given", "mm", deviations=[mapping.position_deviation]),
    )
    return Registration(names, shape + np.array(club.cg), about_cg @ covariance @ about_cg.T, misfit, notes, told)


def _face_points(mapping: MarkerMap, club: Club) -> Array:
    """Return the places of the face's calibration points from the face centre, in club axes [m]."""
    found = []
    for name, point in mapping.face.items():
        if abs(point.toe) > 0.5 * club.face_width or abs(point.high) > 0.5 * club.face_height:
            raise FileError(mapping.path, None, f"[face] {name} lies outside the face of {club.name}")
        touched = face_point(point.toe, point.high, club.bulge, club.roll)
        found.append(touched + point.standoff * nearest(touched, club.bulge, club.roll)[1])
    return np.array(found) @ face_axes(club.loft).T


def _scatter(turned: Array) -> float:
    """Return the noise of a marker [m] from how the cluster scatters in the frame of the face points.

    It holds the noise of that frame as well, and so is not too small.
    """
    often = visible(turned).sum(0) > 1
    return float(np.sqrt(np.mean(np.nanvar(turned[:, often], axis=0, ddof=1)))) if often.any() else 0.0
