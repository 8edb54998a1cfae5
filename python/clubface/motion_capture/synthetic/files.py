"""A folder of synthetic swings: C3D files, the mapping file, the calibration and the truth."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from clubface.equipment.clubs import Club, club as club_of
from clubface.motion_capture.mapping_file import MarkerMap
from clubface.motion_capture.recording import Recording, write_c3d
from clubface.motion_capture.synthetic.bare import bare_map, record_bare
from clubface.motion_capture.synthetic.golfer import random_swing
from clubface.motion_capture.synthetic.laboratory import BALL, CLUSTERS, FACE, Cameras, kind_of
from clubface.motion_capture.synthetic.synthetic_swing import LAUNCH, SyntheticSwing
from clubface.recorded.shots import RecordedShots
from clubface.simulation.delivery import OF_CLUB
from clubface.support.checks import MOST_SEED, check_count
from clubface.support.folders import prepared_folder
from clubface.support.whole_file import write_text

MOST = 100_000
BARE_RATE = 360.0
"""Hz; of cameras that follow a whole golfer."""
MAPPING, CALIBRATION, TRUTH = "markers.toml", "calibration.c3d", "truth.csv"


def positions_map(club: Club, cameras: Cameras) -> MarkerMap:
    """Return the mapping that gives the positions of the cluster."""
    return MarkerMap(
        cluster=dict(CLUSTERS[kind_of(club)]),
        accuracy=0.0,
        ball=BALL,
        target=cameras.target,
        up=cameras.up,
        club=club.name,
    )


def calibration_map(club: Club, cameras: Cameras) -> MarkerMap:
    """Return the mapping that has the cluster placed by a calibration file."""
    kind = kind_of(club)
    return MarkerMap(
        cluster=dict.fromkeys(CLUSTERS[kind]), face=dict(FACE[kind]), calibration=CALIBRATION, accuracy=0.0,
        ball=BALL,
        target=cameras.target, up=cameras.up, club=club.name,
    )  # fmt: skip


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
    """Write ``count`` swings of one club and everything that is needed to read them.

    The files are ``swing-001.c3d`` and so on; ``calibration.c3d`` of the head with markers on its face;
    ``markers.toml``; and ``truth.csv`` with the exact delivery of each swing and its launch, which ``read_shots``
    reads.

    Parameters
    ----------
    folder
        Made if it does not exist.
    count
        Number of swings.
    club, hand
        The club, and the hand of the player.
    cameras
        The laboratory; 720 Hz and no noise if left out.
    seed
        The same seed gives the same files.
    progress
        Called with the number of swings written and the number of swings.

    Returns
    -------
    list
        The files, those of the swings first.
    """
    check_swings(count, seed)
    seen, head = cameras or Cameras(), _head(club, hand)
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
    """Write ``count`` swings as most archives hold them: three markers on the head, no ball, an address before.

    What a reader has to assume is drawn at random for every swing, as widely as :class:`Assumed` says. The parameters
    and files are those of :func:`synthesize`, without a calibration; cameras have 360 Hz and no noise if left out.
    """
    check_swings(count, seed)
    seen, head = cameras or Cameras(rate=BARE_RATE), _head(club, hand)
    target = prepared_folder(folder)

    def record(swing: SyntheticSwing, random: np.random.Generator) -> Recording:
        return record_bare(swing, seen, random).recording

    files = _write_swings(target, count, head, record, seed, progress)
    write_text(target / MAPPING, bare_map(head, seen).to_toml())
    return [*files, target / MAPPING, target / TRUTH]


def _head(club: str | Club, hand: str | None) -> Club:
    """Return the club, in the hand that was asked for."""
    head = club_of(club)
    return head if hand is None else head.replace(hand=hand)


def _write_swings(
    target: Path,
    count: int,
    head: Club,
    record: Callable[[SyntheticSwing, np.random.Generator], Recording],
    seed: int,
    progress: Callable[[int, int], object] | None,
) -> list[Path]:
    """Write recordings of random swings, and their truth; return the files of the recordings."""
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
    """Refuse a number of swings, or a seed of theirs, that is no whole number within limits."""
    check_count("count", count, 1, MOST)
    check_count("seed", seed, 0, MOST_SEED)


def truth(swings: Sequence[SyntheticSwing], source: str = "synthetic") -> RecordedShots:
    """Return the exact deliveries of swings and the launches they were given, in one table."""
    count = len(swings)
    sides = ["left" if each.club.hand < 0 else "right" for each in swings]
    return RecordedShots(
        deliveries={name: np.array([each.truth[name] for each in swings]) for name in OF_CLUB},
        launches={name: np.array([each.launch[name] for each in swings]) for name in LAUNCH},
        clubs=np.array([each.club.name for each in swings], dtype=object),
        hand=np.array(sides, dtype=object),
        rows=np.arange(1, count + 1),
        source=source,
        format="synthetic",
        speed_at="cg",
        face_at="face",
    )
