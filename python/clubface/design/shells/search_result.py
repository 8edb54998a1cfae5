"""A search for a head of shells as a result: start and best head, limits, metals, designs, and the picture."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

import numpy as np

from clubface import units
from clubface.design.optimisation.advice import is_at_an_end
from clubface.design.shells.study import QUANTITIES, design_quantity
from clubface.results.notes import Note, note
from clubface.results.pictures import Axis, Mark, Panel, Picture, axis
from clubface.results.provenance import Provenance
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, text
from clubface.simulation.provenance import flight_conditions

if TYPE_CHECKING:
    from clubface.design.shells.run import Improved, Search
    from clubface.design.shells.study import ShellStudy
    from clubface.design.shells.trust_region import Step

SYMBOLS = {"start": "s", "neighbour": "^", "proposal": "o"}


def search_result(improved: Improved) -> Result:
    """Return the outcome of a study of a head of shells as a result."""
    several = len(improved.searches) > 1
    tables = [_best_table(improved)]
    if any(each.goal.limits for each in improved.searches):
        tables.append(_limits_table(improved))
    tables += [_metals_table(improved, printed=several), _designs_table(improved)]
    provenance = Provenance(
        inputs={"runs of finite elements": str(improved.runs), **flight_conditions()},
        sources=tuple(f"Metal {each.name}: {each.source}" for each in improved.study.metals if each.source),
        descriptions={"the-best-head.toml": improved.study.family.text(improved.head)},
    )
    return Result(
        kind="shell-design", title=improved.study.title, tables=tuple(tables),
        values=(
            text("objective", [improved.study.objective], printed=False),
            text("metal", [improved.chosen.metal.name], printed=False), text("runs", [improved.runs], printed=False),
        ),
        summary=tuple(_summary(improved)), notes=tuple(_notes(improved)), provenance=provenance,
        draw=lambda: [search_picture(improved)],
    )  # fmt: skip


def ordered(names: Iterable[str]) -> list[str]:
    """Return names of quantities in the order of ``QUANTITIES``."""
    places = list(QUANTITIES)
    return sorted(dict.fromkeys(names), key=lambda name: places.index(name.partition(".")[0]))


def _best_table(improved: Improved) -> Table:
    """Return variables and quantities of the head to start from and of the best one."""
    start, best = improved.chosen.start.values, improved.chosen.best.values
    rows = [(name, improved.study.start_value(name), improved.best_value(name)) for name in improved.study.bounds]
    rows += [(name, start[name], best[name]) for name in ordered(best)]
    kinds = [design_quantity(name) for name, _, _ in rows]
    columns = (
        text("quantity", [name for name, _, _ in rows], printed=False),
        text("what", [each.label for each in kinds], in_files=False),
        Column("start", [value for _, value, _ in rows], kinds), Column("best", [value for _, _, value in rows], kinds),
    )  # fmt: skip
    return Table("best", columns)


def _limits_table(improved: Improved) -> Table:
    """Return every limit with what start and best have of it, and the verdict."""
    rows = [(search, name) for search in improved.searches for name in search.goal.limits]
    ends = [search.goal.limits[name] for search, name in rows]
    kinds = [design_quantity(name) for _, name in rows]
    best = [search.best.values[name] for search, name in rows]
    columns = (
        text("metal", [search.metal.name for search, _ in rows], printed=False),
        text("quantity", [name for _, name in rows], printed=False),
        text("what", [each.label for each in kinds], in_files=False),
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
    """Return the best head of every metal."""
    objective = design_quantity(improved.study.objective)
    columns = (
        text("metal", [each.metal.name for each in improved.searches]),
        column(
            "yield_stress",
            [_least_yield(improved.study, each) for each in improved.searches],
            "Pa",
            unit="MPa",
            digits=0,
        ),
        Column(objective.name, [each.best.values[objective.name] for each in improved.searches], objective),
        text("within", [each.within for each in improved.searches], label="within limits"),
        text("designs", [len(each.result.steps) for each in improved.searches]),
        text("ended", [each.result.ended for each in improved.searches], printed=False),
        text("source", [_sources(each) for each in improved.searches]),
    )
    return Table("metals", columns, "The best head of each metal", printed=printed)


def _least_yield(study: ShellStudy, search: Search) -> float | None:
    """Return the least yield stress of the face; None where none is given."""
    metals = [study.family.metal(part.name, search.metal)[1] for part in study.family.start.parts if part.face]
    return min((each.yield_stress for each in metals if each.yield_stress is not None), default=None)


def _sources(search: Search) -> str:
    metals = search.metal.metals.values()
    return "; ".join(dict.fromkeys(each.source for each in metals if each.source))


def _designs_table(improved: Improved) -> Table:
    """Return every design that the engine judged: what was promised, what was found, and what became of it."""
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
        Column(f"promised_{objective}", values("promised", objective), design_quantity(objective), "promised"),
        Column(f"found_{objective}", values("values", objective), design_quantity(objective), "found"),
        column("beyond_limits", [each if 0.0 < each < math.inf else None for each in beyond], "1", unit="%", digits=2),
        text("verdict", [_verdict_of(step) for _, _, step in steps], label=""),
        text("accepted", [step.accepted for _, _, step in steps], printed=False),
        text("radius", [step.radius for _, _, step in steps], printed=False),
        *(text(name.replace(".", "_"), [step.place[row] for _, _, step in steps], printed=False)
          for row, name in enumerate(improved.study.bounds)),
        *(Column(f"{'found' if key == 'values' else key}_{name}", values(key, name), design_quantity(name),
                 printed=False) for key, name in other),
    )  # fmt: skip
    metal = f" of {improved.chosen.metal.name}" if len(improved.searches) > 1 else ""
    return Table(
        "designs", columns, f"Designs{metal} that finite elements judged",
        shown_rows=[row for row, (search, _, _) in enumerate(steps) if search is improved.chosen],
    )  # fmt: skip


def _verdict_of(step: Step) -> str:
    if step.accepted:
        return "accepted"
    return "refused" if step.kind == "proposal" else ""


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
    """Return the objective of every design, promised and found, and what it has of each limit."""
    return Picture(
        "search", "Every design that finite elements judged", [[_objective_panel(improved), _shares_panel(improved)]],
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
        label = "promised by the fast model"
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
