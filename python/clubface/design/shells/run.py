"""A search for the best head of shells from start to end: for every metal a search, then the best head of all."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from clubface.design.shells.engine import Engine, FastModel
from clubface.design.shells.families import Head
from clubface.design.shells.goal import Goal
from clubface.design.shells.metals import MetalChoice
from clubface.design.shells.study import ShellStudy, design_quantity, read
from clubface.design.shells.trust_region import SearchResult, Step, trust_region_search
from clubface.errors import MeshWarning, RangeWarning, RunError, TargetWarning
from clubface.fem.heads.read import from_text
from clubface.jobs.store import store_for
from clubface.quantities import format_value
from clubface.results.result import Described, Result
from clubface.support.checks import without_warnings
from clubface.support.files import recorded


def broken(limits: Mapping[str, tuple[float, float]], values: Mapping[str, float]) -> str:
    """Return the broken limits with the values that break them, in words."""
    parts = []
    for name, (least, most) in limits.items():
        value, quantity = values[name], design_quantity(name)
        if not least <= value <= most:
            limit, beyond = (most, "above") if value > most else (least, "below")
            shown = (format_value(each, quantity) for each in (value, limit))
            parts.append(f"{quantity.label} {f' {beyond} '.join(shown)}")
    return ", ".join(parts)


@dataclass(frozen=True, kw_only=True)
class Search:
    """The search for the best head of one choice of metals: the choice, its goal, and what was found."""

    metal: MetalChoice
    goal: Goal
    result: SearchResult

    @property
    def start(self) -> Step:
        """The head to start from."""
        return self.result.steps[0]

    @property
    def best(self) -> Step:
        """The best head."""
        return self.result.steps[self.result.best]

    @property
    def within(self) -> bool:
        """Whether the best head is within all limits."""
        return self.goal.violation(self.best.values) == 0.0


@dataclass(frozen=True, kw_only=True)
class Improved(Described):
    """What a study found.

    Attributes
    ----------
    study
        The study.
    searches
        One for every choice of metals.
    chosen
        The search with the best head.
    head
        The best head, as in its file: of metals with their yield stress.
    runs
        Number of finite element runs that judged the designs.
    """

    study: ShellStudy
    searches: tuple[Search, ...]
    chosen: Search
    head: Head
    runs: int

    def best_value(self, name: str) -> float:
        """Return a variable of the best head as its file has it [SI]."""
        return self.study.family.value(self.head, name)

    def to_result(self) -> Result:
        """Return the best head, its limits and all designs as a result."""
        from clubface.design.shells.search_result import search_result

        return search_result(self)


@recorded
def improve(
    study: ShellStudy | str | os.PathLike[str],
    *,
    output: str | Path | None = None,
    resume: bool = False,
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Improved:
    """Find the best head of a study: a fast model proposes heads, finite elements judge them.

    Parameters
    ----------
    study
        What may change, what is best, and within which limits; or its file.
    output
        The TOML file to which the best head is written. Next to it, in a folder, every run is kept that has finished,
        until the study ends.
    resume
        Whether an interrupted run of another study is an error; otherwise it is started over. An interrupted run of the
        same study goes on in either case.
    workers
        Number of runs at a time; if left out, one for each core.
    progress
        Called with the number of designs that were judged and the most that will be.

    Raises
    ------
    RunError
        The head to start from cannot be run, or no head within the limits was found.
    """
    if not isinstance(study, ShellStudy):
        study = read(study)
    with (
        without_warnings(TargetWarning),
        without_warnings(RangeWarning),
        without_warnings(MeshWarning),
        store_for(output, {"study": study, **study.family.files()}, resume=resume) as kept,
    ):
        engine, fast = Engine(study, kept, workers), FastModel(study)
        searches = tuple(
            _search(study, metal, engine, fast, progress, number) for number, metal in enumerate(study.choices)
        )
        chosen = searches[0]
        for each in searches[1:]:
            if each.within and (not chosen.within or each.goal.better(each.best.values, chosen.best.values)):
                chosen = each
        if not chosen.within:
            lacks = broken(chosen.goal.limits, chosen.best.values)
            advice = "give limits or bounds that some head can keep, or allow more designs"
            raise RunError(
                f"no head within all limits was found; the best, of {chosen.metal.name}, has {lacks}; {advice}"
            )
        head = study.family.finish(design_of(study, chosen.best, chosen.metal), chosen.metal)
        if output is not None:
            # The models that take the head as rigid learn from this line how its face gives.
            time = chosen.best.values["characteristic_time"]
            text = study.family.text(head, characteristic_time=time, folder=Path(output).parent)
            kept.write_result(Path(output), lambda file: file.write(text.encode()))
            kept.remove()
        return Improved(study=study, searches=searches, chosen=chosen, head=head, runs=engine.runs)


def design_of(study: ShellStudy, step: Step, metal: MetalChoice) -> Head:
    """Return the head that was judged in a step, of metals that stay elastic."""
    return as_written(study, study.at(np.array(step.place), metal))


def as_written(study: ShellStudy, design: Head) -> Head:
    """Return a head as its file has it, so that what is judged is what is written."""
    made = from_text(study.family.text(design))
    assert isinstance(made, Head)
    return made


def _search(
    study: ShellStudy, metal: MetalChoice, engine: Engine, fast: FastModel, progress: Any, number: int
) -> Search:
    goal, whole = study.goal(metal), study.designs * len(study.choices)

    def count(done: int, _: int) -> None:
        if progress is not None:
            progress(number * study.designs + done, whole)

    try:
        result = trust_region_search(
            lambda place: fast(study.at(place, metal)),
            lambda places: engine([as_written(study, study.at(place, metal)) for place in places]),
            study.start(), goal, radius=study.radius, most=study.designs, neighbours=study.neighbours, progress=count,
        )  # fmt: skip
    except RunError as error:
        raise RunError(
            f"{study.head.name} of {metal.name}: {error}; try a thicker face, or a slower hardest blow"
        ) from error
    return Search(metal=metal, goal=goal, result=result)
