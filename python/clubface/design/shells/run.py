"""The complete search for the best shell head: one search per choice of metals, the best head, and the result."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from clubface import units
from clubface.design.optimisation.advice import is_at_an_end
from clubface.design.shells.engine import Engine, FastModel
from clubface.design.shells.families import Head, MetalChoice
from clubface.design.shells.study import QUANTITIES, ShellStudy, design_quantity, read
from clubface.design.shells.trust_region import Goal, SearchResult, Step, trust_region_search
from clubface.errors import MeshWarning, RangeWarning, RunError, TargetWarning
from clubface.fem.heads.read import from_text, head_text
from clubface.jobs.store import store_for
from clubface.quantities import format_value
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.result import Described, Provenance, Result
from clubface.results.table import Column, Table, column, row_names, text
from clubface.simulation.provenance import flight_conditions
from clubface.support.arrays import Floats
from clubface.support.checks import without_warnings
from clubface.support.files import recorded

SYMBOLS = {"start": "s", "neighbour": "^", "proposal": "o"}


def broken(limits: Mapping[str, tuple[float, float]], values: Mapping[str, float]) -> str:
    """Return a description of the violated limits and the values that violate them."""
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
    """The search for the best head with one choice of metals."""

    metal: MetalChoice
    goal: Goal
    result: SearchResult

    @property
    def start(self) -> Step:
        """The starting head."""
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
    """The result of a shell head study.

    Attributes
    ----------
    study, searches
        The study, and one search per choice of metals.
    chosen
        The search that found the best head.
    head
        The best head as in its file, with the yield stress of its metals.
    runs
        Number of finite element runs that judged the designs.
    """

    study: ShellStudy
    searches: tuple[Search, ...]
    chosen: Search
    head: Head
    runs: int

    def best_value(self, name: str) -> float:
        """Return the best head's value of a variable, as in its file [SI]."""
        return self.study.family.value(self.head, name)

    def to_result(self) -> Result:
        """Return the best head, its limits and all designs as a result."""
        several = len(self.searches) > 1
        tables = [_best_table(self)]
        if any(each.goal.limits for each in self.searches):
            tables.append(_limits_table(self))
        tables += [_metals_table(self, printed=several), _designs_table(self)]
        provenance = Provenance(
            inputs={"runs of finite elements": str(self.runs), **flight_conditions()},
            sources=tuple(f"Metal {each.name}: {each.source}" for each in self.study.metals if each.source),
            descriptions={"the-best-head.toml": head_text(self.head)},
        )
        return Result(
            kind="shell-design", title=self.study.title, tables=tuple(tables),
            values=(
                text("objective", [self.study.objective], printed=False),
                text("metal", [self.chosen.metal.name], printed=False), text("runs", [self.runs], printed=False),
            ),
            summary=tuple(_summary(self)), notes=tuple(_notes(self)), provenance=provenance,
            draw=lambda: [search_picture(self)],
        )  # fmt: skip


@recorded
def improve(
    study: ShellStudy | str | os.PathLike[str],
    *,
    output: str | Path | None = None,
    resume: bool = False,
    workers: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Improved:
    """Find the best head of a study: a fast model proposes heads, finite elements evaluate them.

    Parameters
    ----------
    study
        Variables, objective and limits, or the file with them.
    output
        TOML file for the best head. Finished runs are kept in a folder next to it until the study ends.
    resume
        As for :func:`clubface.optimise`.
    workers
        Number of runs at a time; default one per core.
    progress
        Called with the number of designs evaluated and the maximum.

    Raises
    ------
    RunError
        The starting head cannot be run, or no head within the limits was found.
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
        searches = tuple(_search(study, engine, fast, progress, *each) for each in enumerate(study.choices))
        chosen = searches[0]
        for each in searches[1:]:
            if each.within and (not chosen.within or each.goal.better(each.best.values, chosen.best.values)):
                chosen = each
        if not chosen.within:
            lacks = broken(chosen.goal.limits, chosen.best.values)
            advice = "give limits or bounds that a head can meet, or allow more designs"
            raise RunError(
                f"no head within all limits was found; the best, of {chosen.metal.name}, has {lacks}; {advice}"
            )
        head = study.family.finish(_round_trip_head(study, np.array(chosen.best.place), chosen.metal), chosen.metal)
        if output is not None:
            # Models with rigid heads need this line to know how springy the face is.
            time = chosen.best.values["characteristic_time"]
            text = head_text(head, characteristic_time=time, folder=Path(output).parent)
            kept.write_result(Path(output), lambda file: file.write(text.encode()))
            kept.remove()
        return Improved(study=study, searches=searches, chosen=chosen, head=head, runs=engine.runs)


def _round_trip_head(study: ShellStudy, place: Floats, metal: MetalChoice) -> Head:
    """Return the head at a place after a round trip through its file, so that the head evaluated is the one written."""
    made = from_text(head_text(study.at(place, metal)))
    assert isinstance(made, Head)
    return made


def _search(
    study: ShellStudy,
    engine: Engine,
    fast: FastModel,
    progress: Callable[[int, int], object] | None,
    number: int,
    metal: MetalChoice,
) -> Search:
    goal, whole = study.goal(metal), study.designs * len(study.choices)
    count = progress and (lambda done, _: progress(number * study.designs + done, whole))
    try:
        result = trust_region_search(
            lambda place: fast(study.at(place, metal)),
            lambda places: engine([_round_trip_head(study, place, metal) for place in places]),
            study.start(), goal, radius=study.radius, most=study.designs, neighbours=study.neighbours, progress=count,
        )  # fmt: skip
    except RunError as error:
        raise RunError(
            f"{study.head.name} of {metal.name}: {error}; try a thicker face, or a slower hardest impact"
        ) from error
    return Search(metal=metal, goal=goal, result=result)


def ordered(names: Iterable[str]) -> list[str]:
    """Return names of quantities in the order of ``QUANTITIES``."""
    places = list(QUANTITIES)
    return sorted(dict.fromkeys(names), key=lambda name: places.index(name.partition(".")[0]))


def _best_table(improved: Improved) -> Table:
    """Return variables and quantities of the starting and the best head."""
    start, best = improved.chosen.start.values, improved.chosen.best.values
    rows = [(name, improved.study.start_value(name), improved.best_value(name)) for name in improved.study.bounds]
    rows += [(name, start[name], best[name]) for name in ordered(best)]
    kinds = [design_quantity(name) for name, _, _ in rows]
    columns = (
        *row_names("quantity", [name for name, _, _ in rows], [each.label for each in kinds]),
        Column("start", [value for _, value, _ in rows], kinds), Column("best", [value for _, _, value in rows], kinds),
    )  # fmt: skip
    return Table("best", columns)


def _limits_table(improved: Improved) -> Table:
    """Return every limit with the values of the starting and the best head, and the verdict."""
    rows = [(search, name) for search in improved.searches for name in search.goal.limits]
    ends = [search.goal.limits[name] for search, name in rows]
    kinds = [design_quantity(name) for _, name in rows]
    best = [search.best.values[name] for search, name in rows]
    columns = (
        text("metal", [search.metal.name for search, _ in rows], printed=False),
        *row_names("quantity", [name for _, name in rows], [each.label for each in kinds]),
        Column("least", [least or None for least, _ in ends], kinds),
        Column("most", [most if most < math.inf else None for _, most in ends], kinds),
        Column("start", [search.start.values[name] for search, name in rows], kinds), Column("best", best, kinds),
        text("verdict", [verdict(value, *each) for value, each in zip(best, ends, strict=True)]),
    )  # fmt: skip
    shown = [place for place, (search, _) in enumerate(rows) if search is improved.chosen]
    return Table("limits", columns, "Limits", shown_rows=shown)


def verdict(value: float, least: float, most: float) -> str:
    """Return "broken", "kept" or, within half a percent of the limit, "binds"."""
    if not least <= value <= most:
        return "broken"
    return "binds" if value >= 0.995 * most or value <= 1.005 * least else "kept"


def _metals_table(improved: Improved, *, printed: bool) -> Table:
    """Return the best head for each choice of metals."""
    sources = [dict.fromkeys(each.source for each in search.metal.metals.values() if each.source)
               for search in improved.searches]  # fmt: skip
    objective = design_quantity(improved.study.objective)
    columns = (
        text("metal", [each.metal.name for each in improved.searches]),
        column("yield_stress", [_least_yield(improved.study, each) for each in improved.searches], "Pa", unit="MPa",
               digits=0),
        Column(objective.name, [each.best.values[objective.name] for each in improved.searches], objective),
        text("within", [each.within for each in improved.searches], label="within limits"),
        text("designs", [len(each.result.steps) for each in improved.searches]),
        text("ended", [each.result.ended for each in improved.searches], printed=False),
        text("source", ["; ".join(each) for each in sources]),
    )  # fmt: skip
    return Table("metals", columns, "Best head by metal", printed=printed)


def _least_yield(study: ShellStudy, search: Search) -> float | None:
    """Return the lowest yield stress in the face; None if none is given."""
    metals = [study.family.metal(part.name, search.metal)[1] for part in study.family.start.parts if part.face]
    return min((each.yield_stress for each in metals if each.yield_stress is not None), default=None)


def _designs_table(improved: Improved) -> Table:
    """Return every design evaluated: predicted and computed quantities, and whether it was accepted."""
    objective = improved.study.objective
    steps = [(search, place, step) for search in improved.searches for place, step in enumerate(search.result.steps, 1)]
    beyond = [search.goal.violation(step.values) for search, _, step in steps]

    def values(key: str, name: str) -> list[float | None]:
        return [(getattr(step, key) or {}).get(name) for _, _, step in steps]

    known = ordered(name for _, _, step in steps for name in step.values)
    other = [(key, name) for key in ("values", "promised") for name in known if name != objective]
    columns = (
        text("metal", [search.metal.name for search, _, _ in steps], printed=False),
        text("design", [place for _, place, _ in steps], label=""),
        text("kind", [step.kind for _, _, step in steps], label=""),
        Column(f"promised_{objective}", values("promised", objective), design_quantity(objective), "predicted"),
        Column(f"found_{objective}", values("values", objective), design_quantity(objective), "computed"),
        column("beyond_limits", [each if 0.0 < each < math.inf else None for each in beyond], "1", unit="%", digits=2),
        text("verdict", ["accepted" if step.accepted else "refused" if step.kind == "proposal" else ""
                         for _, _, step in steps], label=""),
        text("accepted", [step.accepted for _, _, step in steps], printed=False),
        text("radius", [step.radius for _, _, step in steps], printed=False),
        *(text(name.replace(".", "_"), [step.place[row] for _, _, step in steps], printed=False)
          for row, name in enumerate(improved.study.bounds)),
        *(Column(f"{'found' if key == 'values' else key}_{name}", values(key, name), design_quantity(name),
                 printed=False) for key, name in other),
    )  # fmt: skip
    metal = f" of {improved.chosen.metal.name}" if len(improved.searches) > 1 else ""
    return Table(
        "designs", columns, f"Designs{metal} evaluated by finite elements",
        shown_rows=[row for row, (search, _, _) in enumerate(steps) if search is improved.chosen],
    )  # fmt: skip


def _summary(improved: Improved) -> Iterator[Note]:
    start, best = improved.chosen.start.values, improved.chosen.best.values
    for shown in dict.fromkeys((improved.study.objective, "characteristic_time", "stress", "mass")):
        for name in (each for each in ordered(best) if each.partition(".")[0] == shown):
            kind = design_quantity(name)
            before, after = (units.fixed(each[name], kind.golf.unit, kind.golf.digits) for each in (start, best))
            if before != after:
                yield note("shells-change", meaning=kind.label, before=before, after=after)


def _notes(improved: Improved) -> Iterator[Note]:
    designs = sum(len(each.result.steps) for each in improved.searches)
    yield note("shells-effort", designs=designs, runs=improved.runs, reason=improved.chosen.result.ended)
    if ends := [
        design_quantity(name).label for name, limits in improved.study.bounds.items()
        if is_at_an_end(improved.best_value(name), limits)
    ]:  # fmt: skip
        yield note("shells-at-an-end", names=ends)
    if improved.study.hardest is not None:
        yield note("shells-stress")
    if improved.study.rules and improved.study.family.start.volume is None:
        yield note("shells-open")


def search_picture(improved: Improved) -> Picture:
    """Return the objective of every design, predicted and computed, and its values relative to the limits."""
    return Picture(
        "search", "All designs evaluated by finite elements", [[_objective_panel(improved), _shares_panel(improved)]],
        height=4.2, legend=True,
    )  # fmt: skip


def _objective_panel(improved: Improved) -> Panel:
    steps, objective = improved.chosen.result.steps, improved.study.objective
    numbers, values = np.arange(1, len(steps) + 1), np.array([step.values[objective] for step in steps])
    last = np.maximum.accumulate([row if step.accepted else 0 for row, step in enumerate(steps)])
    marks = [Mark("line", np.repeat(numbers, 2)[1:], np.repeat(values[last], 2)[:-1], label="best so far")]
    within = np.array([improved.chosen.goal.violation(step.values) == 0.0 for step in steps])
    for kind, symbol in SYMBOLS.items():
        for kept in (True, False):
            rows = [row for row, step in enumerate(steps) if step.kind == kind and within[row] == kept]
            if rows:
                label = f"{kind}{'' if kept else ', beyond limits'}"
                marks.append(Mark("points", numbers[rows], values[rows], symbol=symbol, hollow=not kept, label=label))
    promised = {row + 1: step.promised[objective] for row, step in enumerate(steps) if step.promised is not None}
    if promised:
        label = "predicted by the fast model"
        marks.append(Mark("points", list(promised), list(promised.values()), symbol="x", style=1, label=label))
    return Panel(marks, axis(label="design"), Axis(design_quantity(objective)))


def _shares_panel(improved: Improved) -> Panel:
    steps, limits = improved.chosen.result.steps, improved.chosen.goal.limits
    marks = [Mark("rule", y=1.0, style=-2, size=1.0)]
    for style, (name, (least, most)) in enumerate(limits.items()):
        shares = [step.values[name] / (most if most < math.inf else least) for step in steps]
        marks.append(Mark("line", np.arange(1, len(steps) + 1), shares, style=style, label=design_quantity(name).label))
    share = axis("share", "share of the limit", like="1", unit="%")
    return Panel(marks, axis(label="design"), share)
