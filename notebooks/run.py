"""Run notebooks in a kernel of their own, and compare what they print with what they hold.

``python notebooks/run.py`` runs all of them and fails where a cell prints something else than its stored output;
``--update`` stores what they print and draw. Names of notebooks choose some. Pictures are drawn anew by ``--update``
alone, and compared by nobody: numbers are.
"""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import nbformat
from nbclient import NotebookClient

FOLDER = Path(__file__).parent
ALL = tuple(sorted(FOLDER.glob("*.ipynb")))
TIME_LIMIT = 300
"""Seconds a cell may take, also on a busy machine."""
NUMBER = re.compile(r"[-+−]?\d+(?:\.\d+)?")
TOLERANCE = 1e-3
"""Relative difference of a printed number, beside one unit of its last digit: other processors round otherwise."""


class Differs(NamedTuple):
    """A cell that prints something else than it holds.

    Attributes
    ----------
    cell
        Its number among the cells of code, from 1.
    stored, printed
        What it holds, and what it gave.
    """

    cell: int
    stored: str
    printed: str


def executed(path: Path) -> nbformat.NotebookNode:
    """Run a notebook from top to bottom and return it; an error in a cell stops it."""
    notebook = nbformat.read(path, as_version=4)
    # One thread for linear algebra and one date for every picture: the same notebook is then the same file.
    os.environ.update(OPENBLAS_NUM_THREADS="1", SOURCE_DATE_EPOCH="0", PYDEVD_DISABLE_FILE_VALIDATION="1")
    client = NotebookClient(
        notebook, timeout=TIME_LIMIT, kernel_name="python3", record_timing=False,
        resources={"metadata": {"path": str(path.parent)}},
    )  # fmt: skip
    client.execute()
    return _without_traces(notebook)


def _without_traces(notebook: nbformat.NotebookNode) -> nbformat.NotebookNode:
    """Take out what differs from one machine to another: versions, times, and the words that stand for a picture."""
    notebook.metadata = {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }
    for cell in notebook.cells:
        cell.metadata = {}
        for output in cell.get("outputs", ()):
            output.get("metadata", {}).clear()
            if "image/png" in output.get("data", {}):
                output.data.pop("text/plain", None)
    return notebook


def texts(cell: nbformat.NotebookNode) -> str:
    """Return what a cell prints and shows as text."""
    parts = [
        output.get("text", "") if output.output_type == "stream" else output.get("data", {}).get("text/plain", "")
        for output in cell.get("outputs", ())
    ]
    return "".join(parts)


def pictures(notebook: nbformat.NotebookNode) -> list[str]:
    """Return the pictures of a notebook, each a PNG in base 64."""
    outputs: Iterator[Any] = (output for cell in notebook.cells for output in cell.get("outputs", ()))
    return [output.data["image/png"] for output in outputs if "image/png" in output.get("data", {})]


def agree(stored: str, printed: str) -> bool:
    """Return whether two texts have the same words and, to rounding, the same numbers."""
    if NUMBER.sub("#", stored).split() != NUMBER.sub("#", printed).split():
        return False
    return all(map(_near, NUMBER.findall(stored), NUMBER.findall(printed)))


def _near(one: str, other: str) -> bool:
    unit = 10.0 ** -len(one.partition(".")[2])
    a, b = (float(each.replace("−", "-")) for each in (one, other))
    return abs(a - b) <= 1.001 * unit + TOLERANCE * abs(a)


def differences(stored: nbformat.NotebookNode, ran: nbformat.NotebookNode) -> list[Differs]:
    """Return the cells of code that print something else than they hold, or draw more or fewer pictures."""
    differences = []
    pairs = ((a, b) for a, b in zip(stored.cells, ran.cells, strict=True) if a.cell_type == "code")
    for number, (a, b) in enumerate(pairs, 1):
        one, other = texts(a), texts(b)
        drawn = [sum("image/png" in output.get("data", {}) for output in cell.outputs) for cell in (a, b)]
        if not agree(one, other) or drawn[0] != drawn[1]:
            differences.append(Differs(number, f"{one}({drawn[0]} pictures)", f"{other}({drawn[1]} pictures)"))
    return differences


def main() -> int:
    """Run notebooks; return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("notebooks", type=Path, nargs="*", default=list(ALL))
    parser.add_argument("--update", action="store_true", help="store what the notebooks print and draw")
    given = parser.parse_args()
    status = 0
    for path in given.notebooks:
        ran = executed(path)
        if given.update:
            nbformat.write(ran, path)
            continue
        for each in differences(nbformat.read(path, as_version=4), ran):
            print(f"{path.name}, cell {each.cell} holds\n{each.stored}\nbut prints\n{each.printed}")
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
