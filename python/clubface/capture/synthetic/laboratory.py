"""Simulated laboratory recordings of synthetic swings, complete or bare, and folders of their files.

Cameras see markers frame by frame, with noise and gaps, in laboratory axes. Bare recordings have three markers on the
head and no ball, with address and swing in one file, like most archives. Everything unmeasured is then drawn at random,
as widely as a reader has to assume: face angle at address, shaft lean, marker positions.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from clubface.capture.geometry import Assumed, off_face, usual_place
from clubface.capture.markers import FacePoint, MarkerMap, Point
from clubface.capture.recording import Recording, write_c3d
from clubface.capture.rotations import Array, delivered, exponential, logarithm, mirror
from clubface.capture.setup import axes, axis
from clubface.capture.synthetic.synthetic_swing import LAUNCH, SyntheticSwing, club_of_hand, random_swing
from clubface.equipment.clubs import Club
from clubface.errors import InputError
from clubface.shots.recorded import RecordedShots
from clubface.simulation.inputs import OF_CLUB
from clubface.support.checks import MOST_SEED, check_count
from clubface.support.files import prepared_folder, write_text

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
"""Markers on crown and skirt of a wood, or back and hosel of an iron: from the face centre [m], club axes."""
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
        Frames per second [Hz].
    noise
        Standard deviation of a marker along each axis [m]; white and independent.
    before, after
        Time recorded before and after impact [s].
    gaps
        Fraction of time for which a marker on the head is hidden, in gaps of a few frames.
    gap
        Mean length of a gap [frames].
    target, up
        Laboratory axes that point to the target and up.
    origin
        Position of the world's origin [m], in laboratory axes.
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
    origin: Point = (0.35, -0.2, 0.01)
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
        """Record a swing; impact falls at a random time between two frames."""
        return self.record_from(swing, seed, path=path)[0]

    def record_from(
        self, swing: SyntheticSwing, seed: int | np.random.Generator, *, path: str = "<synthetic>"
    ) -> tuple[Recording, float]:
        """Record a swing; return the recording and the time of its first frame [s], with first touch at zero."""
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
        """Record the head held still at address, with markers on its face."""
        random = np.random.default_rng(seed)
        kind = kind_of(club)
        points = [off_face(club, *point) for point in FACE[kind].values()]
        local = np.array([*CLUSTERS[kind].values(), *points])
        held = local @ delivered(club.loft + 0.03, -0.2, 0.05, club.loft).T + np.array([-0.02, 0.04, 0.01])
        still = np.broadcast_to(held * mirror(club.hand), (self.calibration_frames, *held.shape))
        labels = (*CLUSTERS[kind], *FACE[kind])
        return Recording(labels=labels, positions=self.measured(still, random), rate=self.rate, path=path)

    def measured(self, world: Array, random: np.random.Generator) -> Array:
        """Return world positions as measured in the laboratory."""
        turn = axes(axis(self.target), axis(self.up))
        return world @ turn + np.array(self.origin) + self.noise * random.normal(size=world.shape)

    def _gaps(self, random: np.random.Generator, frames: int, markers: int) -> Array:
        """Return which markers are hidden in which frames, in random gaps."""
        starts = random.uniform(size=(frames, markers)) < self.gaps / self.gap
        lengths = random.geometric(1.0 / self.gap, size=(frames, markers))
        hidden = np.zeros((frames, markers), dtype=bool)
        for frame, marker in zip(*np.nonzero(starts), strict=True):
            hidden[frame : frame + lengths[frame, marker], marker] = True
        return hidden


def kind_of(club: Club) -> str:
    """Return "iron" or "wood", the keys of ``CLUSTERS`` and ``FACE``."""
    return "iron" if club.kind == "iron" else "wood"


MARKERS: Mapping[str, tuple[str, ...]] = {"wood": ("HEAD1", "HEAD3", "HEAD4"), "iron": ("HEAD1", "HEAD2", "HEAD3")}
"""Three of the markers that form a triangle with unequal sides."""
REST, BACKSWING = 0.6, 0.9
"""Time at address, and time from there to the start of the synthetic swing, behind the player [s]."""
TOP = 0.8
"""Rise of the backswing path above a straight line [m]."""
GAP = (0.015, 0.005)
"""Mean and standard deviation of the gap between face and ball at address [m]."""
SIDEWAYS = 0.008
"""Standard deviation of the ball's position along the face at address [m]."""
FARTHEST = 2.0
"""Standard deviations at which impact points are clipped, so that every impact is on the face."""


@dataclass(frozen=True, kw_only=True, eq=False)
class BareSwing:
    """A bare recording, and the truth that its reader does not know.

    Attributes
    ----------
    recording
        Recording of three markers on the head, from address to follow-through.
    cluster
        Marker positions from the face centre [m], club axes.
    angles
        Loft, face angle and lie at address [rad], for a right-hander.
    first
        Time of the first frame [s], with first touch at zero.
    """

    recording: Recording
    cluster: Mapping[str, Point]
    angles: Array
    first: float


def record_bare(
    swing: SyntheticSwing, cameras: Cameras, seed: int | np.random.Generator, *, assumed: Assumed | None = None
) -> BareSwing:
    """Record a swing including its address with three markers on the head.

    The same seed gives the same recording. ``assumed`` gives the distributions of the unmeasured quantities.
    """
    random, spread = np.random.default_rng(seed), assumed or Assumed()
    cluster = _cluster(swing.club, random, spread)
    held_at = np.array([swing.club.loft, 0.0, 0.0]) + random.normal(size=3) * [spread.loft, spread.face, spread.lie]
    first = -np.ceil(cameras.before * cameras.rate) - random.uniform()
    early = int((REST + BACKSWING) * cameras.rate)
    times = (first - early + np.arange(early + int((cameras.before + cameras.after) * cameras.rate) + 2)) / cameras.rate
    position, attitude = swing.head(times)
    begin = first / cameras.rate
    cg, held = _address(swing, held_at, random, spread)
    part = np.clip((times[:early] - begin) / BACKSWING + 1.0, 0.0, 1.0)
    part = part**3 * (10.0 - 15.0 * part + 6.0 * part**2)
    whole, turned = swing.head(np.array([begin]))
    position[:early] = cg + part[:, None] * (whole[0] - cg) + np.outer(4.0 * TOP * part * (1.0 - part), [0.0, 1.0, 0.0])
    attitude[:early] = exponential(part[:, None] * logarithm(turned[0] @ held.T)) @ held
    local = np.array(list(cluster.values())) + np.array(swing.club.cg)
    seen = (position[:, None] + np.einsum("kij,mj->kmi", attitude, local)) * swing.mirror
    recording = Recording(
        labels=tuple(cluster), positions=cameras.measured(seen, random), rate=cameras.rate, path="<synthetic>"
    )
    return BareSwing(recording=recording, cluster=cluster, angles=held_at, first=float(times[0]))


def asked_at_random(seed: int | np.random.Generator) -> dict[str, float]:
    """Draw face angle, lie and impact point of a swing [SI], as widely as a reader has to assume."""
    random, wide = np.random.default_rng(seed), Assumed()
    deviations = {"face": wide.delivered_face, "lie": wide.delivered_lie, "toe": wide.toe, "high": wide.high}
    return {name: each * float(np.clip(random.normal(), -FARTHEST, FARTHEST)) for name, each in deviations.items()}


def bare_map(
    club: Club, cameras: Cameras, by: str = "address", cluster: Mapping[str, Point] | None = None
) -> MarkerMap:
    """Return the marker map, by "address" or "swing", for reading bare recordings of a club.

    ``cluster`` gives marker positions if the reader has measured them.
    """
    names = MARKERS[kind_of(club)]
    return MarkerMap(
        cluster=cluster or dict.fromkeys(names),
        by=by,
        ground=float(axis(cameras.up) @ np.array(cameras.origin)) if by == "address" else None,
        target=cameras.target, up=cameras.up, club=club.name,
    )  # fmt: skip


def _cluster(club: Club, random: np.random.Generator, assumed: Assumed) -> dict[str, Point]:
    """Return three markers about a mean position drawn from the reader's assumption."""
    kind = kind_of(club)
    names, usual = MARKERS[kind], [CLUSTERS[kind][name] for name in MARKERS[kind]]
    mean, spread = usual_place(club.kind, assumed)
    places = np.array(usual) - np.mean(usual, 0) + mean + spread * random.normal(size=3)
    return {name: (float(x), float(y), float(z)) for name, (x, y, z) in zip(names, places, strict=True)}


def _address(
    swing: SyntheticSwing, angles: Array, random: np.random.Generator, assumed: Assumed
) -> tuple[Array, Array]:
    """Return CG position and attitude of the head at rest behind the ball, for a right-hander."""
    club = swing.club
    attitude = delivered(angles[0], angles[1], angles[2], club.loft)
    height = 0.5 * club.face_height * np.cos(club.loft) + assumed.sole * random.normal()
    back = swing.ball.radius + abs(GAP[0] + GAP[1] * random.normal())
    centre = np.array([swing.rest[0] - back, height, swing.rest[2] + SIDEWAYS * random.normal()])
    return centre - attitude @ np.array(club.cg), attitude


MOST = 100_000
BARE_RATE = 360.0
"""Frame rate of cameras that capture a whole golfer [Hz]."""
MAPPING, CALIBRATION, TRUTH = "markers.toml", "calibration.c3d", "truth.csv"


def positions_map(club: Club, cameras: Cameras) -> MarkerMap:
    """Return the marker map that gives the cluster's positions."""
    cluster, target, up = dict(CLUSTERS[kind_of(club)]), cameras.target, cameras.up
    return MarkerMap(cluster=cluster, accuracy=0.0, ball=BALL, target=target, up=up, club=club.name)


def calibration_map(club: Club, cameras: Cameras) -> MarkerMap:
    """Return the marker map that locates the cluster by a calibration file."""
    kind = kind_of(club)
    by_file = {"cluster": dict.fromkeys(CLUSTERS[kind]), "face": dict(FACE[kind]), "calibration": CALIBRATION}
    return replace(positions_map(club, cameras), **by_file)


def synthesize(
    folder: str | os.PathLike[str],
    count: int = 10,
    *,
    club: str | Club = "driver",
    hand: str | None = None,
    cameras: Cameras | None = None,
    seed: int = 1,
    progress: Callable[[int, int], object] | None = None,
) -> list[Path]:
    """Write ``count`` swings of one club and everything needed to read them; return the files, swings first.

    The files are ``swing-001.c3d`` and so on; ``calibration.c3d``, with markers on the face; ``markers.toml``; and
    ``truth.csv`` with the exact delivery and launch of each swing, for ``read_shots``.

    Parameters
    ----------
    folder
        Folder, created if missing.
    count
        Number of swings.
    club, hand
        The club, and the player's hand.
    cameras
        Cameras of the laboratory; default 720 Hz and no noise.
    seed
        The same seed gives the same files.
    progress
        Called with the number of swings written and the total.
    """
    check_swings(count, seed)
    seen, head = cameras or Cameras(), club_of_hand(club, hand)
    target = prepared_folder(folder)
    files = _write_swings(target, count, head, seen.record, seed, progress)
    write_c3d(seen.calibrate(head, np.random.default_rng([seed, 0])), target / CALIBRATION)
    write_text(target / MAPPING, calibration_map(head, seen).to_toml())
    return [*files, target / CALIBRATION, target / MAPPING, target / TRUTH]


def synthesize_bare(
    folder: str | os.PathLike[str],
    count: int = 10,
    *,
    club: str | Club = "driver",
    hand: str | None = None,
    cameras: Cameras | None = None,
    seed: int = 1,
    progress: Callable[[int, int], object] | None = None,
) -> list[Path]:
    """Write ``count`` bare swings, as in most archives: three markers on the head, no ball, an address at the start.

    Quantities that a reader has to assume are drawn at random for each swing, as widely as :class:`Assumed` says.
    Parameters and files are those of :func:`synthesize`, without a calibration; cameras default to 360 Hz, no noise.
    """
    check_swings(count, seed)
    seen, head = cameras or Cameras(rate=BARE_RATE), club_of_hand(club, hand)
    target = prepared_folder(folder)

    def record(swing: SyntheticSwing, random: np.random.Generator) -> Recording:
        return record_bare(swing, seen, random).recording

    files = _write_swings(target, count, head, record, seed, progress)
    write_text(target / MAPPING, bare_map(head, seen).to_toml())
    return [*files, target / MAPPING, target / TRUTH]


def _write_swings(
    target: Path,
    count: int,
    head: Club,
    record: Callable[[SyntheticSwing, np.random.Generator], Recording],
    seed: int,
    progress: Callable[[int, int], object] | None,
) -> list[Path]:
    """Write recordings of random swings and their truth; return the recordings' files."""
    swings, files = [], []
    for number in range(1, count + 1):
        swings.append(random_swing(np.random.default_rng([seed, number, 0]), club=head))
        files.append(target / f"swing-{number:03d}.c3d")
        write_c3d(record(swings[-1], np.random.default_rng([seed, number, 1])), files[-1])
        if progress is not None:
            progress(number, count)
    truth(swings, str(target)).write(target / TRUTH)
    return files


def check_swings(count: object, seed: object) -> None:
    """Raise InputError unless number of swings and seed are whole numbers within limits."""
    check_count("count", count, 1, MOST)
    check_count("seed", seed, 0, MOST_SEED)


def truth(swings: Sequence[SyntheticSwing], source: str = "synthetic") -> RecordedShots:
    """Return the exact deliveries and launches of swings as one table."""
    sides = ["left" if each.club.hand < 0 else "right" for each in swings]
    return RecordedShots(
        deliveries={name: np.array([each.truth[name] for each in swings]) for name in OF_CLUB},
        launches={name: np.array([each.launch[name] for each in swings]) for name in LAUNCH},
        clubs=np.array([each.club.name for each in swings], dtype=object),
        hand=np.array(sides, dtype=object),
        rows=np.arange(1, len(swings) + 1),
        source=source,
        format="synthetic",
        speed_at="cg",
        face_at="face",
    )
