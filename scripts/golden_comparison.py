"""Compare two recordings of the command line: statuses, texts, and what became of every number."""

from __future__ import annotations

import csv
import difflib
import io
import json
import math
import re
from bisect import bisect_left
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

# --- Numbers ----------------------------------------------------------------------------------------------------------

SAME = 1e-12
"""Relative difference up to which a number under the same key is the same."""
KEPT = 1e-9
"""Relative difference up to which a number occurs elsewhere."""
UNITS = {
    "deg": math.pi / 180, "rpm": math.pi / 30, "mph": 0.44704, "km/h": 1 / 3.6, "yd": 0.9144, "ft": 0.3048,
    "in": 0.0254, "%": 1e-2, "milli": 1e-3, "micro": 1e-6, "kilo": 1e3, "mega": 1e6, "giga": 1e9, "hecto": 1e2,
    "g cm2": 1e-7, "mm2": 1e-6, "cm3": 1e-6, "t/mm3": 1e12, "yd2": 0.9144**2, "mph/deg": 0.44704 / (math.pi / 180),
    "1000 rpm/mm": math.pi / 30 / 1e-3,
}  # fmt: skip
"""Sizes of units in SI: a number that was in one of them may be in SI later, or the other way round."""
FACTORS = {
    factor
    for one in (1.0, *UNITS.values())
    for other in (1.0, *UNITS.values())
    for factor in (one, 1.0 / one, one / other)
}
TIMES = (
    (re.compile(r'("(?:\w+_)?(?:wall|elapsed|seconds_per_shot)(?:_s)?": )[-+.\de]+'), r"\1null"),
    (re.compile(r"(Processor time a shot)(?:[ |]+[\d.]+ [mu]?s)+"), r"\1 TIME"),
    (re.compile(r"(stable one|impacts), [\d.]+ s\b"), r"\1, TIME"),
)
"""Times that a computation took, which differ from one recording to the next, with what they are replaced by."""
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w.]*\d)")


@dataclass(frozen=True)
class Number:
    """A number of a recording.

    Attributes
    ----------
    value
        Its value.
    place
        Key, column or line under which it stands.
    digits
        Size of half a unit in its last digit, by which it may be rounded; 0 for a number that was not rounded.
    """

    value: float
    place: str
    digits: float = 0.0


def number_of(text: str, place: str) -> Number | None:
    """Return the number that a text is, or None."""
    try:
        value = float(text)
    except ValueError:
        return None
    if not math.isfinite(value):
        return None
    mantissa, _, exponent = text.strip().lower().partition("e")
    decimals = len(mantissa.partition(".")[2])
    full = len(re.sub(r"^[-+0.]+|\.", "", mantissa)) >= 12
    return Number(value, place, 0.0 if full else 0.5 * 10.0 ** (int(exponent or 0) - decimals))


class Pool:
    """Numbers in which others are looked up, each of which stands for one other at most."""

    def __init__(self, numbers: Iterable[float]) -> None:
        self.values = sorted(numbers)
        self.used = [False] * len(self.values)

    def take(self, value: float, slack: float) -> bool | None:
        """Use up a number within ``slack``; return None if there are only used ones, and False if there is none."""
        start, some = bisect_left(self.values, value - slack), False
        for place in range(start, len(self.values)):
            if self.values[place] > value + slack:
                break
            some = True
            if not self.used[place]:
                self.used[place] = True
                return True
        return None if some else False


@dataclass
class Kept:
    """What became of the numbers of BEFORE.

    Attributes
    ----------
    same
        How many occur in AFTER as they were.
    converted
        How many occur in another unit.
    refined
        How many were rounded, and occur with more digits.
    fewer
        Those that occur, but not as often.
    lost
        Those that do not occur.
    """

    same: int = 0
    converted: int = 0
    refined: int = 0
    fewer: list[Number] = field(default_factory=list)
    lost: list[Number] = field(default_factory=list)


def keep_numbers(before: Iterable[Number], after: Iterable[Number]) -> Kept:
    """Look up every number of BEFORE in AFTER: as it is, then in other units, then as the rounding of one in AFTER."""
    kept, pool = Kept(), Pool(each.value for each in after)
    waiting = []
    for each in before:
        taken = pool.take(each.value, KEPT * abs(each.value))
        if taken:
            kept.same += 1
        else:
            waiting.append((each, taken is None))
    for each, known in waiting:
        converted = convert(pool, each)
        refined = False if converted else round_off(pool, each)
        if converted:
            kept.converted += 1
        elif refined:
            kept.refined += 1
        elif known or converted is None or refined is None:
            kept.fewer.append(each)
        else:
            kept.lost.append(each)
    return kept


def convert(pool: Pool, each: Number) -> bool | None:
    """Use up a number times a ratio of units, or a temperature in the other scale, with the results of `Pool.take`."""
    if each.value == 0.0 or (each.digits and abs(each.value) < 100 * each.digits):
        return False  # two digits fit anything
    values = (each.value * factor for factor in FACTORS)
    return take_one(pool, ((value, KEPT * abs(value)) for value in (*values, each.value + 273.15, each.value - 273.15)))


def round_off(pool: Pool, each: Number) -> bool | None:
    """Use up a number of which this one is the rounding, in SI or in the unit it was printed in."""
    if not each.digits:
        return False
    sizes = (1.0, *UNITS.values()) if abs(each.value) >= 100 * each.digits else (1.0,)
    return take_one(pool, ((each.value * size, 1.001 * each.digits * size) for size in sizes))


def take_one(pool: Pool, candidates: Iterable[tuple[float, float]]) -> bool | None:
    """Use up the first candidate that is there; return None if all that are there are used, False if there are none."""
    used = False
    for value, slack in candidates:
        taken = pool.take(value, slack)
        if taken:
            return True
        used = used or taken is None
    return None if used else False


# --- Comparison -------------------------------------------------------------------------------------------------------


@dataclass
class Difference:
    """How one output of a run differs.

    Attributes
    ----------
    output
        Stream or file, as in ``1.out`` or ``files/map.csv``.
    kind
        "json", "csv", "text", "status", "missing" or "new".
    changed
        Numbers under the same key that differ, with both values.
    moved
        The same where the number of BEFORE occurs elsewhere in the document, so that it only changed place.
    keys
        Keys or columns that were removed and added.
    kept
        What became of the numbers.
    elsewhere
        How many of the numbers that this output lost stand in another output of the run.
    lines
        Difference of the texts, line by line.
    bad
        Whether a number is lost from a JSON document or from all outputs of the run, a number of a document or table
        changed under its key, a status changed or a file is missing.
    """

    output: str
    kind: str
    changed: list[str] = field(default_factory=list)
    moved: list[str] = field(default_factory=list)
    removed: list[str] = field(default_factory=list)
    added: list[str] = field(default_factory=list)
    texts: list[str] = field(default_factory=list)
    kept: Kept = field(default_factory=Kept)
    elsewhere: int = 0
    lines: list[str] = field(default_factory=list)
    bad: bool = False


def flatten(value: object, place: str = "") -> Iterator[tuple[str, object]]:
    """Yield the leaves of a JSON document with their keys."""
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from flatten(inner, f"{place}.{key}" if place else str(key))
    elif isinstance(value, list):
        for number, inner in enumerate(value):
            yield from flatten(inner, f"{place}[{number}]")
    else:
        yield place, value


def read_json(text: str) -> dict[str, object] | None:
    """Return the leaves of a text that is a JSON document, or one a line; None of any other text."""
    if not text.lstrip().startswith(("{", "[")):
        return None
    try:
        return dict(flatten(json.loads(text)))
    except ValueError:
        pass
    try:
        return dict(flatten([json.loads(line) for line in text.splitlines() if line.strip()]))
    except ValueError:
        return None


def is_number(value: object) -> bool:
    """Whether a leaf is a finite number."""
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def numbers_of(output: str, text: str) -> list[Number]:
    """Return every number of an output."""
    leaves = read_json(text)
    if leaves is not None:
        return [Number(float(value), place) for place, value in leaves.items() if is_number(value)]  # pyright: ignore[reportArgumentType]
    if output.endswith(".csv"):
        cells = read_table(text)[1]
        numbers = (number_of(cell, place) for place, cell in cells.items())
        return [each for each in numbers if each]
    lines = enumerate(text.splitlines(), 1)
    numbers = (number_of(each[0], f"line {line}") for line, row in lines for each in NUMBER.finditer(row))
    return [each for each in numbers if each]


def read_table(text: str) -> tuple[list[str], dict[str, str]]:
    """Return the columns of a CSV file, and each cell by its column and row."""
    rows = list(csv.reader(io.StringIO(text)))
    heads = rows[0] if rows else []
    return heads, {
        f"{heads[place] if place < len(heads) else place}[{number}]": cell
        for number, row in enumerate(rows[1:])
        for place, cell in enumerate(row)
    }


def close(one: object, other: object) -> bool:
    """Whether two leaves are the same."""
    if is_number(one) and is_number(other):
        return math.isclose(one, other, rel_tol=SAME, abs_tol=1e-300)  # pyright: ignore[reportArgumentType]
    return one == other


def compare_leaves(difference: Difference, before: dict[str, object], after: dict[str, object]) -> None:
    """Compare two documents key by key: keys, values under the same key, and texts that went."""
    difference.removed = collapse(key for key in before if key not in after)
    difference.added = collapse(key for key in after if key not in before)
    values = Pool(float(value) for value in after.values() if is_number(value))  # pyright: ignore[reportArgumentType]
    for key in before:
        if key in after and is_number(before[key]) and not close(before[key], after[key]):
            one = float(before[key])  # pyright: ignore[reportArgumentType]
            elsewhere = values.take(one, SAME * abs(one)) is not False
            (difference.moved if elsewhere else difference.changed).append(f"{key}: {before[key]!r} -> {after[key]!r}")
    texts = Counter(value for value in before.values() if isinstance(value, str))
    texts -= Counter(value for value in after.values() if isinstance(value, str))
    difference.texts = list(texts)


def collapse(keys: Iterable[str]) -> list[str]:
    """Return keys with the numbers of their lists left out, each once."""
    return list(dict.fromkeys(re.sub(r"\[\d+\]", "[]", key) for key in keys))


def compare_output(output: str, before: str, after: str, rest: list[Number]) -> Difference | None:
    """Return how an output differs, None if it does not; ``rest`` are the numbers of all outputs of AFTER's run."""
    if before == after:
        return None
    one, other = read_json(before), read_json(after)
    if one is not None and other is not None:
        difference = Difference(output, "json")
        compare_leaves(difference, one, other)
    elif output.endswith(".csv"):
        difference = Difference(output, "csv")
        (heads, cells), (new_heads, new_cells) = read_table(before), read_table(after)
        compare_leaves(difference, numeric(cells), numeric(new_cells))
        difference.removed = [each for each in heads if each not in new_heads]
        difference.added = [each for each in new_heads if each not in heads]
        rows = before.count("\n"), after.count("\n")
        difference.texts += [f"{rows[0]} lines, now {rows[1]}"] if rows[0] != rows[1] else []
    else:
        difference = Difference(output, "text" if one is None else "json that is none now")
    difference.kept = keep_numbers(numbers_of(output, before), numbers_of(output, after))
    difference.elsewhere = len(difference.kept.lost) - len(keep_numbers(difference.kept.lost, rest).lost)
    if difference.kind != "csv" or len(before) < 20_000:
        lines = difflib.unified_diff(before.splitlines(), after.splitlines(), lineterm="", n=1)
        difference.lines = [line for line in lines if not line.startswith(("---", "+++"))]
    lost = len(difference.kept.lost) - (0 if difference.kind == "json" else difference.elsewhere)
    # The data of a report may get more digits under the same heading; other tables may not change.
    difference.bad = lost > 0 or (bool(difference.changed) and ".saved/" not in output)
    return difference


def numeric(cells: dict[str, str]) -> dict[str, object]:
    """Return cells with those that are numbers as numbers."""
    numbers = {place: number_of(cell, place) for place, cell in cells.items()}
    return {place: each.value if each else cells[place] for place, each in numbers.items()}


def compare_run(before: Path, after: Path) -> list[Difference]:
    """Return how the outputs of a run differ."""
    one, other = (read_outputs(each) for each in (before, after))
    statuses = [json.loads(each.pop("commands.json")) for each in (one, other)]
    changes = []
    for old, new in zip(*statuses, strict=False):
        if old != new:
            changes.append(Difference("status", "status", lines=[f"-{old}", f"+{new}"], bad=True))
    if len(statuses[0]) != len(statuses[1]):
        changes.append(Difference("status", "status", lines=["another number of commands"], bad=True))
    rest = [number for output, text in other.items() for number in numbers_of(output, text)] if one != other else []
    for output in sorted(one.keys() | other.keys()):
        if output not in other:
            kept = keep_numbers(numbers_of(output, one[output]), rest)
            # Data inside a report may get another name; a file that was asked for has the name that it was given.
            bad = bool(kept.lost) or ".saved/" not in output
            changes.append(Difference(output, "missing", kept=kept, lines=one[output].splitlines()[:3], bad=bad))
        elif output not in one:
            changes.append(Difference(output, "new", lines=other[output].splitlines()[:3]))
        elif difference := compare_output(output, one[output], other[output], rest):
            changes.append(difference)
    return changes


def read_tree(folder: Path) -> dict[str, bytes]:
    """Return the content of every file in a folder by its path in it."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def read_outputs(folder: Path) -> dict[str, str]:
    """Return the outputs of a run by their names, without the times that computations took."""
    outputs = {}
    for name, content in read_tree(folder).items():
        text = content.decode("utf-8")
        for pattern, replacement in TIMES:
            text = pattern.sub(replacement, text)
        outputs[name] = text
    return outputs


def run_names(folder: Path) -> list[str]:
    """Return the runs of a recording."""
    return sorted(str(path.parent.relative_to(folder)) for path in folder.rglob("commands.json"))


def compare(before: Path, after: Path, report: Path, most: int, only: tuple[str, ...] = ()) -> int:
    """Print a table of all runs and write their differences; return 1 if a number or an output is lost or changed."""
    names, others = ([name for name in run_names(each) if name.startswith(only or "")] for each in (before, after))
    differences = {name: compare_run(before / name, after / name) for name in names if name in others}
    gone, new = [each for each in names if each not in others], [each for each in others if each not in names]
    parts = [f"# Outputs of {before} and {after}\n", summary(differences, gone, new)]
    for name, changes in differences.items():
        if changes:
            parts.append(f"## {name}\n")
            parts += [describe(each, most) for each in changes]
    report.write_text("\n".join(parts), encoding="utf-8")
    print(summary(differences, gone, new))
    print(f"All differences: {report}")
    return int(bool(gone) or any(each.bad for changes in differences.values() for each in changes))


def summary(differences: dict[str, list[Difference]], gone: list[str], new: list[str]) -> str:
    """Return counts, and a table of the runs that differ."""
    different = {name: changes for name, changes in differences.items() if changes}
    every = [each for changes in different.values() for each in changes]
    kept = [each.kept for each in every]
    lines = [
        f"{len(differences)} runs in both: {len(differences) - len(different)} the same to the last byte, "
        f"{sum(not any(each.bad for each in changes) for changes in different.values())} with every number kept, "
        f"{sum(any(each.bad for each in changes) for changes in different.values())} to look at.",
        f"In outputs that differ, {sum(each.same for each in kept)} numbers occur as they were, "
        f"{sum(each.converted for each in kept)} in another unit, {sum(each.refined for each in kept)} with more "
        f"digits, {sum(len(each.fewer) for each in kept)} less often, and {sum(len(each.lost) for each in kept)} are "
        f"lost, {sum(each.elsewhere for each in every)} of them to another output of the run.",
        *([f"Runs that are gone: {', '.join(gone)}"] if gone else []),
        *([f"Runs that are new: {', '.join(new)}"] if new else []),
        "",
    ]
    if different:
        lines += ["| run | outputs that differ | status | changed | moved | converted | refined | fewer | lost | |",
                  "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |"]  # fmt: skip
    for name, changes in sorted(different.items(), key=lambda pair: not any(each.bad for each in pair[1])):
        cells = [
            len(changes),
            sum(each.kind in ("status", "missing") for each in changes),
            sum(len(each.changed) for each in changes),
            sum(len(each.moved) for each in changes),
            sum(each.kept.converted for each in changes),
            sum(each.kept.refined for each in changes),
            sum(len(each.kept.fewer) for each in changes),
            sum(len(each.kept.lost) for each in changes),
        ]
        names = [each.output for each in changes if each.bad]
        bad = ", ".join(names[:3]) + (f" and {len(names) - 3} more" if len(names) > 3 else "")
        lines.append(f"| {name} | {' | '.join(map(str, cells))} | {bad} |")
    return "\n".join(lines) + "\n"


def describe(difference: Difference, most: int) -> str:
    """Return what is different in one output, with at most so many items of each kind."""
    lines = [f"### {difference.output}: {difference.kind}{', to look at' if difference.bad else ''}\n"]
    items = {
        "keys removed": difference.removed, "keys added": difference.added, "texts that went": difference.texts,
        "numbers changed under their key": difference.changed, "numbers that only changed place": difference.moved,
        f"numbers lost, {difference.elsewhere} of them to another output": shown(difference.kept.lost),
        "numbers that occur less often": shown(difference.kept.fewer),
    }  # fmt: skip
    for title, each in items.items():
        if each:
            lines.append(f"* {len(each)} {title}: " + "; ".join(f"`{one}`" for one in each[:most]))
    if difference.lines:
        rest = [f"... {len(difference.lines) - most} more lines"] if len(difference.lines) > most else []
        lines += ["", "````diff", *(line[:240] for line in difference.lines[:most]), *rest, "````"]
    return "\n".join(lines) + "\n"


def shown(numbers: list[Number]) -> list[str]:
    """Return numbers with their places."""
    return [f"{each.place}: {each.value!r}" for each in numbers]
