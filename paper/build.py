"""The paper about clubface: its numbers, its pictures and its pages.

``python paper/build.py [FOLDER]``, or ``make paper``, computes what the text quotes, in some ten seconds, and writes
paper.pdf into FOLDER, ``out`` unless named; ``--png`` writes every page as a picture, too. FOLDER/paper then holds
everything that Typst needs to set the paper, as for a journal.
"""

from __future__ import annotations

import argparse
import json
import shutil
import sys
from datetime import UTC, datetime
from pathlib import Path

import typst

HERE = Path(__file__).parent
SOURCES = [
    HERE / "paper.typ",
    HERE / "references.bib",
    HERE / "example.py",
    HERE.parent / "docs" / "figures" / "impact.png",
]
sys.path.insert(0, str(HERE))

from paper_pictures import draw_all  # noqa: E402
from text_numbers import all_numbers  # noqa: E402


def prepare(folder: Path) -> None:
    """Write the numbers, the pictures and the sources of the paper into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    numbers = json.dumps(all_numbers(), ensure_ascii=False, indent=1)
    (folder / "numbers.json").write_text(numbers + "\n", encoding="utf-8")
    draw_all(folder)
    for each in SOURCES:
        shutil.copy(each, folder)


def compiler(folder: Path) -> typst.Compiler:
    """Return what sets the paper, from a folder that ``prepare`` has filled.

    Typst brings the fonts along, so that the pages are the same on every machine.
    """
    return typst.Compiler(folder / "paper.typ", root=folder, ignore_system_fonts=True)


def released(folder: Path) -> datetime:
    """Return the date of the release, which the file bears, so that the same sources give the same file."""
    numbers = json.loads((folder / "numbers.json").read_text(encoding="utf-8"))
    return datetime.fromisoformat(numbers["release"]["date"]).replace(tzinfo=UTC)


def main() -> None:
    """Write the paper."""
    parser = argparse.ArgumentParser(description="Write the paper about clubface as PDF.")
    parser.add_argument("folder", type=Path, nargs="?", default=HERE.parent / "out")
    parser.add_argument("--png", action="store_true", help="write every page as a picture, too")
    given = parser.parse_args()
    parts, target = given.folder / "paper", given.folder / "paper.pdf"
    prepare(parts)
    document = compiler(parts)
    document.compile(output=target, timestamp=released(parts))
    if given.png:
        document.compile(output=given.folder / "paper-{p}.png", format="png", ppi=110)
    print(target)


if __name__ == "__main__":
    main()
