"""Run a page from top to bottom, and check what it shows: outputs of code, and figures in its sentences and tables.

``python docs/run.py PAGE FOLDER`` leaves the files that the page makes in FOLDER and fails where the page shows
anything else than it gives. ``--update`` writes outputs and figures into the page, and its pictures into docs/figures.
``python docs/run.py --uncovered`` lists the figures with units that no command and no source stands behind.

Blocks of Python and of ``shell`` run in one folder. A block marked ``text`` that follows one is its output; three dots
in it stand for anything. Figures in sentences are checked by a comment below them, which no reader of the page sees::

    With it the drive has 9% more spin.

    <!-- figures
    drive = clubface shot driver --speed "108 mph" --loft "13 deg" --model area,standard
    has #% more spin = 100 * (drive("backspin", model="area") / drive("backspin", model="standard") - 1)
    -->

A line with a name on its left defines that name, by a command of clubface or by an expression of Python. All other
lines quote the page, with ``#`` for every figure, and give the values: as many digits as the page has must agree. A
quotation without ``#`` is a claim, and its expression must be true. ``given`` stands for what was chosen and
``published`` for what the page or its source states. An indented line continues the one above. ``result(quantity,
unit, column=value)`` reads the value of a command's JSON document in the row that the columns single out;
``stored(file)`` reads what a long computation wrote, or the text of a source whose constants are quoted,
``script(file)`` imports a script of the repository, ``module(name)`` any other module, and
``processor_time(command)`` [s] is what a command or a function costs.

What takes long stands in ``<!-- figures study COMMIT``: `make study` checks it, and ``--update --study`` computes it
and writes the commit of the sources that did.
"""

from __future__ import annotations

import argparse
import contextlib
import doctest
import importlib.util
import io
import json
import math
import os
import re
import shlex
import shutil
import subprocess
import sys
import tomllib
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np

ROOT = Path(__file__).parent.parent
FIGURES = ROOT / "docs" / "figures"
BLOCK = re.compile(
    r"^```(?P<language>python|shell)\n(?P<code>.*?)^```\n(?:\n```text\n(?P<shown>.*?)^```\n)?"
    r"|^<!-- figures(?P<study> study)?(?: (?P<commit>[0-9a-f]+(?:-dirty)?))?\n(?P<figures>.*?)^-->$",
    re.DOTALL | re.MULTILINE,
)
PICTURE = re.compile(r"figures/([\w-]+\.(?:svg|png))")
HIDDEN = re.compile(
    r"^(```+|:::+).*?^\1 *$|^<!--.*?-->|\$\$.*?\$\$|`(?:[^`\n]|\n(?!\n))*`|\]\([^)\s]*\)", re.DOTALL | re.MULTILINE
)
"""What is no sentence: blocks, comments, formulas, code, and addresses of links."""
NUMBER = r"[−+-]?\d+(?:[ ,\N{NARROW NO-BREAK SPACE}]\d{3}(?!\d))*(?:\.\d+)?(?:e-?\d+)?"
UNITS = (
    "mph|rpm|deg|degrees?|yd|yards?|feet|mm|cm|kN|MPa|GPa|N|g|kg|µs|μs|us|ns|ms|s|seconds?|minutes?|hours?|m/s|J|m|"
    "(?:micro|milli|nano)seconds?|per cent|MB|newtons|kilonewtons"
)
FIGURE = re.compile(rf"(?<![\w.])(?:{NUMBER}(?: ?(?:to|–|and|or|/) ?))*{NUMBER}(?:\s?[%°]|[ \n](?:{UNITS})(?![\w/]))")
"""Numbers that a unit follows."""
WIDTH = "100"
"""Columns of the terminal of the shell blocks."""
GIVEN = object()


class Ran(NamedTuple):
    """A block of code that was run, or a quotation of the page whose figures were computed.

    Attributes
    ----------
    line
        Of its first line in the page.
    shown
        The output or the quotation as the page shows it; None where it shows no output.
    printed
        What the page ought to show.
    span
        Place of ``shown`` in the page.
    """

    line: int
    shown: str | None
    printed: str
    span: tuple[int, int]

    @property
    def agrees(self) -> bool:
        """Whether the page shows what was printed, spaces and line breaks apart."""
        flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
        return self.shown is None or doctest.OutputChecker().check_output(self.shown, self.printed, flags)


class Entry(NamedTuple):
    """A line of a comment of figures: a name or a quotation on the left, a command or an expression on the right."""

    left: str
    right: str

    @property
    def defines(self) -> bool:
        """Whether the left side is a name."""
        return self.left.isidentifier()

    def place(self, text: str, start: int, end: int) -> re.Match[str]:
        """Return where a part of the page holds the quotation; its groups are the figures."""
        words = re.escape(self.left).replace(r"\ ", r"\s+").replace(r"\#", f"({NUMBER})")
        pattern = re.compile(rf"(?<![\w.]){words}(?!\w)")
        matches = list(pattern.finditer(text, start, end))
        if len(matches) != 1:
            raise AssertionError(f"“{self.left}” stands {len(matches)} times above the comment that checks it")
        return matches[0]


class Document:
    """The JSON document that a command printed."""

    def __init__(self, document: dict[str, Any]):
        self.document = document

    def __call__(self, quantity: str, unit: str | None = None, /, table: str | None = None, **row: object) -> Any:
        """Return a single value, or that of the one row of a table whose columns have the given values.

        Parameters
        ----------
        quantity
            Name of the value or column, with or without its unit.
        unit
            Unit that the value is returned in, instead of that of the document.
        table
            Name of the table, where several have such a column.
        """
        if not row and table is None:
            for key, value in self.document["values"].items():
                if key == quantity or key.startswith(f"{quantity}_"):
                    return _converted(value, key.removeprefix(f"{quantity}_"), unit)
        cells = [
            (each[key], column.get("unit") or each.get("unit"))
            for name, content in self.document["tables"].items()
            if table in (None, name)
            for key, column in content["columns"].items()
            if quantity in (key, column.get("quantity"), key.rpartition("_")[0])
            for each in content["rows"]
            if all(str(each.get(label)) == str(value) for label, value in row.items())
        ]
        if len(cells) != 1:
            raise AssertionError(f"{len(cells)} cells of the document are {quantity} with {row}")
        return _converted(*cells[0], unit)


def _converted(value: Any, unit: str | None, wanted: str | None) -> Any:
    from clubface import units

    return value if unit is None or wanted is None else float(units.from_si(units.to_si(value, unit), wanted))


def entries(comment: str) -> list[Entry]:
    """Return the entries of a comment of figures."""
    lines = re.sub(r"\n[ \t]+", " ", comment).splitlines()
    parts = [line.partition(" = ") for line in lines if line.strip()]
    for left, equals, right in parts:
        if not equals or not right.strip():
            raise AssertionError(f"“{left}” needs “ = ” and what it equals")
    return [Entry(left.strip(), right.strip()) for left, _, right in parts]


def run(page: Path, folder: Path, *, study: bool = False) -> Iterator[Ran]:
    """Run the blocks of a page in ``folder`` one after the other, those in Python in one namespace.

    ``study`` computes the figures that take long, too.
    """
    import clubface

    text = page.read_text(encoding="utf-8")
    sentences = _sentences(text)
    names: dict[str, Any] = {"__name__": "__main__"}
    helpers = {"clubface": clubface, "np": np, "math": math, "given": GIVEN, "published": GIVEN}
    helpers |= {"stored": stored, "script": script, "module": importlib.import_module, "processor_time": processor_time}
    start = 0
    with contextlib.chdir(folder):
        for block in BLOCK.finditer(text):
            kind = "figures" if block["figures"] is not None else "code"
            line = text.count("\n", 0, block.start(kind)) + 1
            if kind == "code":
                code = block["code"]
                printed = _shell(code) if block["language"] == "shell" else _python(code, names, page, line)
                yield Ran(line, block["shown"], printed, block.span("shown"))
                continue
            if study or not block["study"]:
                for entry in entries(block["figures"]):
                    if entry.defines:
                        helpers[entry.left] = _value(entry.right, {**helpers, **names})
                    else:
                        yield _figures(entry, entry.place(sentences, start, block.start()), {**helpers, **names}, text)
            start = block.end()


def stored(name: str) -> Any:
    """Return a JSON or TOML file of the repository, as a long computation writes it, or the text of another file."""
    read: dict[str, Callable[[str], Any]] = {".json": json.loads, ".toml": tomllib.loads}
    return read.get(Path(name).suffix, str)((ROOT / name).read_text(encoding="utf-8"))


def script(name: str) -> ModuleType:
    """Return a script of the repository as a module, so that a page shows what its functions compute.

    It can import the scripts of its folder, as when it is run.
    """
    specification = importlib.util.spec_from_file_location(Path(name).stem, ROOT / name)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    sys.modules[specification.name] = module
    sys.path.insert(0, str((ROOT / name).parent))
    try:
        specification.loader.exec_module(module)
    finally:
        sys.path.remove(str((ROOT / name).parent))
    return module


def processor_time(work: str | Callable[[], object]) -> float:
    """Return the processor time [s] of a command or a function, with that of the processes that it starts."""
    before = sum(os.times()[:4])
    if callable(work):
        work()
    else:
        _command(work)
    return sum(os.times()[:4]) - before


def _sentences(text: str) -> str:
    """Return the page with everything blanked that is no sentence and no cell of a table."""
    return HIDDEN.sub(lambda part: re.sub(r"[^\n]", "\0", part[0]) if "\n" in part[0] else part[0], text)


def _value(expression: str, names: dict[str, Any]) -> Any:
    if expression.startswith("clubface "):
        return _command(expression)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return eval(f"({expression})", names)
        except Exception as error:
            raise AssertionError(f"{expression}: {error!r}") from error


def _command(line: str) -> Document:
    """Run a command in this process; files of the repository are found from any folder."""
    from clubface.cli.app import run as run_command

    _, *words = shlex.split(line)
    words = [str(ROOT / word) if not Path(word).exists() and (ROOT / word).is_file() else word for word in words]
    out, err = io.StringIO(), io.StringIO()
    with warnings.catch_warnings(), contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        warnings.simplefilter("ignore")
        status = run_command([*words, "--json"])
    if status:
        raise AssertionError(f"exit status {status} of\n{line}\n{err.getvalue()}")
    return Document(json.loads(out.getvalue()))


def _figures(entry: Entry, place: re.Match[str], names: dict[str, Any], text: str) -> Ran:
    """Compute the figures of a quotation."""
    start, end = place.span()
    line = text.count("\n", 0, start) + 1
    value = _value(entry.right, names)
    if value is GIVEN:
        return Ran(line, text[start:end], text[start:end], (start, end))
    if not place.groups():
        if not isinstance(value, (bool, np.bool_)):
            raise AssertionError(f"“{entry.left}” has no figure (#), and {entry.right} is no claim but {value}")
        return Ran(line, text[start:end], text[start:end] if value else f"not so: {entry.right}", (start, end))
    values = list(value) if isinstance(value, (tuple, list)) else [value]
    if len(values) != len(place.groups()):
        raise AssertionError(f"“{entry.left}” has {len(place.groups())} figures, and {entry.right} {len(values)}")
    pieces, last = [], start
    for group, each in enumerate(values, 1):
        pieces += [text[last : place.start(group)], written(each, place[group])]
        last = place.end(group)
    return Ran(line, text[start:end], "".join([*pieces, text[last:end]]), (start, end))


def written(value: float, example: str) -> str:
    """Write a value with the digits, the sign and the separators that a figure of the page has."""
    mantissa, _, exponent = example.partition("e")
    scaled = float(value) / 10.0 ** int(exponent or 0)
    decimals = len(mantissa.partition(".")[2])
    number = f"{scaled:{'+' if mantissa.startswith('+') else ''}.{decimals}f}"
    if not any(digit in number for digit in "123456789"):
        number = number.replace("-", "")
    separator = re.search(r"(?<=\d)[ ,\N{NARROW NO-BREAK SPACE}](?=\d{3})", mantissa)
    if separator:
        whole, point, rest = number.partition(".")
        number = f"{int(whole):,}".replace(",", separator[0]) + point + rest
    if "−" in example:
        number = number.replace("-", "−")
    return f"{number}e{exponent}" if exponent else number


def uncovered(page: Path) -> list[tuple[int, str]]:
    """Return line and text of the figures with units that no code, no command and no source stands behind."""
    text = page.read_text(encoding="utf-8")
    sentences = _sentences(text)
    visible = list(HIDDEN.sub(lambda part: re.sub(r"[^\n]", "\0", part[0]), text))
    start = 0
    for block in BLOCK.finditer(text):
        if block["figures"] is not None:
            for entry in entries(block["figures"]):
                if not entry.defines:
                    place = entry.place(sentences, start, block.start())
                    visible[place.start() : place.end()] = "\0" * (place.end() - place.start())
            start = block.end()
    return [(text.count("\n", 0, match.start()) + 1, match[0]) for match in FIGURE.finditer("".join(visible))]


def _shell(code: str) -> str:
    """Return what commands print on both streams; a command that fails stops the page."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    environment = {**os.environ, "PATH": path, "COLUMNS": WIDTH, "OPENBLAS_NUM_THREADS": "1"}
    ran = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", code],
        env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
    )  # fmt: skip
    if ran.returncode != 0:
        raise AssertionError(f"exit status {ran.returncode} of\n{code}\n{ran.stdout}")
    return ran.stdout


def _python(code: str, names: dict[str, Any], page: Path, line: int) -> str:
    """Return what a block prints; a warning is an error, since a reader would stumble over it."""
    out = io.StringIO()
    with warnings.catch_warnings(), contextlib.redirect_stdout(out):
        warnings.simplefilter("error")
        exec(compile("\n" * (line - 1) + code, str(page), "exec"), names)
    return out.getvalue()


def update(page: Path, folder: Path, *, study: bool = False) -> None:
    """Write outputs and figures into the page, and the pictures it shows and makes into docs/figures."""
    import matplotlib as mpl

    # The same picture is then the same file.
    os.environ["SOURCE_DATE_EPOCH"] = "0"
    mpl.use("agg")
    mpl.rcParams["svg.hashsalt"] = "clubface"
    text = page.read_text(encoding="utf-8")
    edits = []
    for each in run(page, folder, study=study):
        if each.shown is not None and "..." not in each.shown:
            lines = "\n".join(line.rstrip() for line in each.printed.splitlines())
            edits.append((*each.span, f"{lines}\n" if each.shown.endswith("\n") or not each.shown else lines))
    if study:
        edits += [
            (block.start(), block.start("figures"), f"<!-- figures study {commit()}\n")
            for block in BLOCK.finditer(text)
            if block["study"]
        ]
    for start, end, new in sorted(edits, reverse=True):
        text = text[:start] + new + text[end:]
    page.write_text(text, encoding="utf-8")
    for name in PICTURE.findall(text):
        if (folder / name).exists():
            shutil.copyfile(folder / name, FIGURES / name)


def commit() -> str:
    """Return the commit of the sources, marked ``-dirty`` where the code that computes differs from it."""

    def git(*words: str) -> str:
        return subprocess.run(["git", *words], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True).stdout.strip()

    code = git("status", "--porcelain", "--untracked-files=no", "--", "crates", "python", "studies", "examples")
    return git("rev-parse", "--short=8", "HEAD") + ("-dirty" if code else "")


def stamp(results: Path) -> None:
    """Write the commit of the sources into a JSON file that a long computation has just written."""
    text = results.read_text(encoding="utf-8")
    indent = re.search(r"^{\n( *)", text)
    document = {"commit": commit(), **{key: value for key, value in json.loads(text).items() if key != "commit"}}
    results.write_text(json.dumps(document, indent=len(indent[1]) if indent else None) + "\n", encoding="utf-8")


def main() -> int:
    """Run a page; return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=Path, nargs="?")
    parser.add_argument("folder", type=Path, nargs="?")
    parser.add_argument("--update", action="store_true", help="write outputs, figures and pictures into the page")
    parser.add_argument("--study", action="store_true", help="compute the figures that take long, too")
    parser.add_argument("--uncovered", action="store_true", help="list the figures with units that nothing checks")
    parser.add_argument("--stamp", type=Path, metavar="JSON", help="write the commit of the sources into results")
    given = parser.parse_args()
    if given.stamp:
        stamp(given.stamp)
        return 0
    if given.uncovered:
        pages = [given.page] if given.page else [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
        for page in pages:
            for line, figure in uncovered(page):
                print(f"{page}:{line}: {figure!r}")
        return 0
    if given.folder is None:
        parser.error("name a page and a new folder")
    given.folder.mkdir(parents=True, exist_ok=True)
    if any(given.folder.iterdir()):
        parser.error(f"{given.folder} holds files already; name a new folder")
    if given.update:
        update(given.page.resolve(), given.folder, study=given.study)
        return 0
    wrong = [each for each in run(given.page.resolve(), given.folder, study=given.study) if not each.agrees]
    for each in wrong:
        print(f"{given.page}:{each.line} shows\n{each.shown}\nbut computes\n{each.printed}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
