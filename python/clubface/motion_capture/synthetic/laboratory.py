"""What cameras would see of a synthetic swing: markers in frames, with noise and gaps, in laboratory axes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from clubface.equipment.clubs import Club
from clubface.equipment.face import face_point, nearest
from clubface.errors import InputError
from clubface.motion_capture.attitude import delivered, face_axes
from clubface.motion_capture.laboratory import axis
from clubface.motion_capture.markers import FacePoint, Point
from clubface.motion_capture.recording import Recording
from clubface.motion_capture.rotations import Array
from clubface.motion_capture.synthetic.synthetic_swing import MIRROR, SyntheticSwing

CLUSTERS: Mapping[str, Mapping[str, Point]] = {
    "wood": {
        "HEAD1": (-0.025, 0.032, -0.020), "HEAD2": (-0.030, 0.034, 0.025), "HEAD3": (-0.075, 0.028, 0.000),
        "HEAD4": (-0.035, 0.008, 0.052), "HEAD5": (-0.012, 0.040, -0.048),
    },
    "iron": {
        "HEAD1": (-0.022, 0.018, 0.030), "HEAD2": (-0.012, -0.014, -0.012), "HEAD3": (-0.018, 0.026, -0.028),
        "HEAD4": (-0.006, 0.075, -0.052), "HEAD5": (0.012, 0.048, -0.044),
    },
}  # fmt: skip
"""Markers on the crown and skirt of a wood, on back and hosel of an iron: from the face centre [m], club axes."""
FACE: Mapping[str, Mapping[str, FacePoint]] = {
    "wood": {
        "FACE_CENTRE": FacePoint(0.0, 0.0, 0.002), "FACE_TOE": FacePoint(0.03, 0.0, 0.002),
        "FACE_HEEL": FacePoint(-0.03, 0.0, 0.002), "FACE_TOP": FacePoint(0.0, 0.018, 0.002),
    },
    "iron": {
        "FACE_CENTRE": FacePoint(0.0, 0.0, 0.002), "FACE_TOE": FacePoint(0.022, 0.0, 0.002),
        "FACE_HEEL": FacePoint(-0.022, 0.0, 0.002), "FACE_TOP": FacePoint(0.0, 0.014, 0.002),
    },
}  # fmt: skip
BALL = "BALL"


@dataclass(frozen=True, kw_only=True)
class Cameras:
    """The cameras of a laboratory.

    Attributes
    ----------
    rate
        Frames a second [Hz].
    noise
        Standard deviation of a marker along each axis [m]; white and independent.
    before, after
        Time recorded before and after impact [s].
    gaps
        Fraction of the time during which a marker of the head is not seen, in gaps of a few frames.
    gap
        Mean length of a gap, in frames.
    target, up
        Axes of the laboratory that point to the target and up.
    origin
        Position of the world's origin in the laboratory [m], in the axes of the laboratory.
    calibration_frames
        Number of frames in which the head is held still with markers on its face.
    """

    rate: float = 720.0
    noise: float = 0.0
    before: float = 0.25
    after: float = 0.03
    gaps: float = 0.0
    gap: float = 4.0
    target: str = "+y"
    up: str = "+z"
    origin: Point = field(default=(0.35, -0.2, 0.01))
    calibration_frames: int = 200

    def __post_init__(self) -> None:
        checks = {
            "rate": (60.0 <= self.rate <= 1e5, "from 60 to 100000 Hz"),
            "noise": (0.0 <= self.noise <= 0.01, "from 0 to 10 mm"),
            "gaps": (0.0 <= self.gaps <= 0.5, "from 0 to 0.5"),
            "gap": (self.gap >= 1.0, "1 frame or more"),
            "calibration_frames": (self.calibration_frames >= 1, "1 or more"),
        }
        for name, (fine, allowed) in checks.items():
            if not fine:
                raise InputError(name, getattr(self, name), allowed)

    def record(self, swing: SyntheticSwing, seed: int | np.random.Generator, *, path: str = "<synthetic>") -> Recording:
        """Return the recording of a swing; impact falls at random between two frames."""
        return self.record_from(swing, seed, path=path)[0]

    def record_from(
        self, swing: SyntheticSwing, seed: int | np.random.Generator, *, path: str = "<synthetic>"
    ) -> tuple[Recording, float]:
        """Return the recording of a swing, and the time of its first frame [s] if first touch is at zero."""
        random = np.random.default_rng(seed)
        first = -np.ceil(self.before * self.rate) - random.uniform()
        times = (first + np.arange(int((self.before + self.after) * self.rate) + 2)) / self.rate
        cluster = CLUSTERS[kind_of(swing.club)]
        head = swing.points(list(cluster.values()), times)
        seen = self.measured(np.concatenate([head, swing.ball_centre(times)[:, None]], 1), random)
        hidden = self._gaps(random, len(times), len(cluster))
        seen[:, : len(cluster)][hidden] = np.nan
        return Recording(labels=(*cluster, BALL), positions=seen, rate=self.rate, path=path), float(times[0])

    def calibrate(self, club: Club, seed: int | np.random.Generator, *, path: str = "<calibration>") -> Recording:
        """Return a recording of the head held still at address, with markers on its face."""
        random = np.random.default_rng(seed)
        kind = kind_of(club)
        face = face_axes(club.loft)
        points = [
            face @ (touched + point.standoff * nearest(touched, club.bulge, club.roll)[1])
            for point in FACE[kind].values()
            for touched in [face_point(point.toe, point.high, club.bulge, club.roll)]
        ]
        local = np.array([*CLUSTERS[kind].values(), *points])
        held = local @ delivered(club.loft + 0.03, -0.2, 0.05, club.loft).T + np.array([-0.02, 0.04, 0.01])
        still = np.broadcast_to(held * (MIRROR if club.hand < 0 else 1.0), (self.calibration_frames, *held.shape))
        labels = (*CLUSTERS[kind], *FACE[kind])
        return Recording(labels=labels, positions=self.measured(still, random), rate=self.rate, path=path)

    def measured(self, world: Array, random: np.random.Generator) -> Array:
        """Return world positions as the laboratory measures them."""
        target, up = axis(self.target), axis(self.up)
        turn = np.stack([target, up, np.cross(target, up)])
        return world @ turn + np.array(self.origin) + self.noise * random.normal(size=world.shape)

    def _gaps(self, random: np.random.Generator, frames: int, markers: int) -> Array:
        """Return which markers are hidden in which frames: gaps of random lengths at random places."""
        starts = random.uniform(size=(frames, markers)) < self.gaps / self.gap
        lengths = random.geometric(1.0 / self.gap, size=(frames, markers))
        hidden = np.zeros((frames, markers), dtype=bool)
        for frame, marker in zip(*np.nonzero(starts), strict=True):
            hidden[frame : frame + lengths[frame, marker], marker] = True
        return hidden


def kind_of(club: Club) -> str:
    """Return "iron" or "wood", for clusters and points of the face."""
    return "iron" if club.kind == "iron" else "wood"
