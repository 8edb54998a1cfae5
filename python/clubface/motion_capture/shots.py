"""Many recordings to one table of shots."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Unpack

import numpy as np

from clubface.equipment.clubs import Club
from clubface.errors import FileError, InputError
from clubface.motion_capture.captured import CapturedDelivery
from clubface.motion_capture.mapping_file import MarkerMap
from clubface.motion_capture.recording import read_c3d
from clubface.motion_capture.reduction import QUANTITIES
from clubface.motion_capture.setup import Options, prepare
from clubface.motion_capture.swing import capture
from clubface.recorded.shots import RecordedShots, RejectedRow

LAUNCHES = ("ball_speed", "launch", "azimuth")


@dataclass(frozen=True, kw_only=True, eq=False)
class CapturedSwings:
    """The deliveries of many recordings.

    Attributes
    ----------
    captured
        The deliveries that could be read, in the order of the files.
    places
        The place of each of them among the files, from 1.
    rejected
        The files that gave no delivery: their places and the reasons.
    interrupted
        Whether Ctrl-C ended the reading before the last file.
    """

    captured: tuple[CapturedDelivery, ...]
    places: tuple[int, ...]
    rejected: tuple[RejectedRow, ...]
    interrupted: bool = False

    def __len__(self) -> int:
        return len(self.captured)

    @property
    def shots(self) -> RecordedShots:
        """The table of deliveries and launches."""
        return self._table("c3d", [_values(each) for each in self.captured], [each.launch for each in self.captured])

    @property
    def uncertainty(self) -> RecordedShots:
        """A table like ``shots`` that holds the standard deviations."""
        deviations = [each.uncertainty for each in self.captured]
        return self._table("c3d standard deviations", deviations, [each.launch_uncertainty for each in self.captured])

    def write(self, path: str | os.PathLike[str]) -> list[Path]:
        """Write the shots to a CSV or Parquet file, and their standard deviations beside it: ``shots.sd.csv``."""
        target = Path(path)
        beside = target.with_name(f"{target.stem}.sd{target.suffix}")
        self.shots.write(target)
        self.uncertainty.write(beside)
        return [target, beside]

    def _table(self, kind: str, deliveries: list[dict[str, float]], launches: list[dict[str, float]]) -> RecordedShots:
        if not self.captured:
            raise InputError("swings", "none", "at least one swing that could be read")
        seen = [name for name in LAUNCHES if any(name in each for each in launches)]
        return RecordedShots(
            deliveries={name: np.array([each[name] for each in deliveries]) for name in QUANTITIES},
            launches={name: np.array([each.get(name, np.nan) for each in launches]) for name in seen},
            clubs=np.array([each.club.name for each in self.captured], dtype=object),
            hand=np.array(["left" if each.club.hand < 0 else "right" for each in self.captured], dtype=object),
            rows=np.array(self.places, dtype=np.int64),
            source=os.path.commonpath([Path(each.source).parent for each in self.captured]) or ".",
            format=kind,
            speed_at="cg",
            face_at="face",
            rejected=self.rejected,
            notes=tuple(f"{Path(each.source).name}: {note}" for each in self.captured for note in each.notes),
        )


def read_swings(
    paths: Iterable[str | os.PathLike[str]],
    mapping: str | os.PathLike[str] | MarkerMap,
    club: str | os.PathLike[str] | Club,
    *,
    progress: Callable[[int, int], object] | None = None,
    **options: Unpack[Options],
) -> CapturedSwings:
    """Read the deliveries of many C3D files of one session: same club, markers and calibration.

    A file that cannot be used is listed with its reason and does not stop the others. Ctrl-C ends the reading and keeps
    what was read until then.

    Parameters
    ----------
    paths
        The files.
    mapping, club, **options
        As for :func:`read_swing`.
    progress
        Called with the number of files done and the number of files.
    """
    files = [os.fspath(path) for path in paths]
    setup = prepare(mapping, club, **options)
    captured: list[CapturedDelivery] = []
    places: list[int] = []
    rejected: list[RejectedRow] = []
    interrupted = False
    try:
        for place, path in enumerate(files, 1):
            try:
                captured.append(capture(read_c3d(path, unit=setup.mapping.unit), setup))
                places.append(place)
            except FileError as error:
                rejected.append(RejectedRow(place, str(error)))
            if progress is not None:
                progress(place, len(files))
    except KeyboardInterrupt:
        interrupted = True
    return CapturedSwings(
        captured=tuple(captured[: len(places)]), places=tuple(places), rejected=tuple(rejected), interrupted=interrupted
    )


def _values(found: CapturedDelivery) -> dict[str, float]:
    return {name: getattr(found.delivery, name) for name in QUANTITIES}
