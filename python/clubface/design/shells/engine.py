"""What finite elements find of a design: characteristic time, ball speed and carry, stress of the face."""

from __future__ import annotations

import math
from collections.abc import Sequence
from statistics import fmean
from typing import Any

from clubface.design.shells.rigid import on_face, rigid_values
from clubface.design.shells.study import ShellStudy
from clubface.errors import RunError
from clubface.fem import head_tests
from clubface.fem.core import Progress
from clubface.fem.heads.driver import DriverHead
from clubface.fem.heads.shells import ShellHead
from clubface.fem.run import strike
from clubface.fem.settings import Settings
from clubface.fem.side_by_side import side_by_side
from clubface.fem.stress import INTERVAL
from clubface.support.fingerprint import fingerprint
from clubface.support.resuming import Store

SHAPES = round(Settings.duration / INTERVAL) + 1
"""Times at which the stress of the hardest blow is looked at: as often as ``fem head --blow`` does."""

Task = tuple[str, int]


class Engine:
    """Judges designs by finite elements, several runs at a time, and keeps each run that has finished.

    Attributes
    ----------
    runs
        Number of runs that judgements took, with those that were found in the store.
    """

    def __init__(self, study: ShellStudy, kept: Store | None, workers: int | None) -> None:
        self._study, self._kept, self._workers = study, kept, workers
        self._known: dict[str, dict[str, float]] = {} if kept is None else {key: kept[key] for key in kept}
        self.runs = 0

    def __call__(self, designs: Sequence[DriverHead]) -> list[dict[str, float]]:
        """Return the quantities of designs [SI]; all are NaN where a run failed."""
        study = self._study
        tasks: list[Task] = [("time", 0), *(("shot", place) for place in range(len(study.delivery.points)))]
        if study.hardest is not None:
            tasks += [("blow", place) for place in range(len(study.hardest.points))]
        heads = [design.mesh() for design in designs]
        names = [fingerprint(design) for design in designs]
        keys = {
            (number, task): f"{names[number]} {task[0]} {task[1]}" for number in range(len(heads)) for task in tasks
        }
        todo = [point for point, key in keys.items() if key not in self._known]
        self.runs += len(keys)

        def run(point: tuple[int, Task], going: Progress, threads: int) -> dict[str, float]:
            return self._run(heads[point[0]], point[1], going, threads)

        side_by_side(todo, run, lambda point, found: self._keep(keys[point], found), workers=self._workers)
        return [
            _together(head, [self._known[keys[number, task]] for task in tasks]) for number, head in enumerate(heads)
        ]

    def _keep(self, key: str, found: dict[str, float]) -> None:
        self._known[key] = found
        if self._kept is not None:
            self._kept.keep(key, found)
            # A run is worth more than the time of a write.
            self._kept.flush()

    def _run(self, head: ShellHead, task: Task, going: Progress, threads: int) -> dict[str, float]:
        """Return what one run finds; empty if it failed."""
        study, (kind, place) = self._study, task
        try:
            if kind == "time":
                return {"characteristic_time": head_tests.characteristic_time(head, threads=threads, progress=going)}
            blow = study.delivery if kind == "shot" else study.hardest
            assert blow is not None
            frames = {"frames": SHAPES, "fields": True} if kind == "blow" else {}
            settings = Settings(until_separation=True, threads=threads, **frames)
            found = strike(
                head, which=study.ball, settings=settings, progress=going, **blow.at(blow.points[place])
            )  # fmt: skip
        except RunError:
            return {}
        if found.interrupted:
            raise KeyboardInterrupt
        if found.stopped is not None:
            return {}
        if kind == "blow":
            return {"stress": face_stress(found, head)}
        launch = found.launch
        assert launch is not None
        return {"ball_speed": float(launch.get("ball_speed")), "carry": found.flown()["carry"]}


def face_stress(found: Any, head: ShellHead) -> float:
    """Return the greatest stress of von Mises in the face [Pa], on either side, over the shapes that a run kept."""
    return float(found.head_fields.von_mises[:, on_face(head)].max())


def _together(head: ShellHead, runs: list[dict[str, float]]) -> dict[str, float]:
    """Return all quantities: means of the shots, the greatest stress of the blows."""
    collected: dict[str, list[float]] = {}
    for found in runs:
        for name, value in found.items():
            collected.setdefault(name, []).append(value)
    values = {name: max(each) if name == "stress" else fmean(each) for name, each in collected.items()}
    values |= rigid_values(head)
    return values if all(runs) else dict.fromkeys(values, math.nan)
