"""Writes the mean errors of every model against the tour averages into the table of the README."""

from __future__ import annotations

import re
from pathlib import Path

from clubface.present.terminal import headings_and_rows
from clubface.validation import tour
from clubface.validation.tour import mean_table

README = Path(__file__).parents[2] / "README.md"
ROWS = re.compile(
    r"(?<=^\| model \| ball speed, mph \| launch, deg \| spin, rpm \| carry, yd \|\n)(?:^\|.*\n)+", re.MULTILINE
)


def main() -> None:
    """Compute all tables and rewrite the rows."""
    _, rows = headings_and_rows(mean_table([tour.tour(table=name) for name in tour.TABLES]))
    rows = [row[1:] for row in rows if row[0] == "all"]
    lines = ["| --- | --- | --- | --- | --- |", *(f"| {' | '.join(row)} |" for row in rows)]
    text, count = ROWS.subn("\n".join(lines) + "\n", README.read_text(encoding="utf-8"))
    if not count:
        raise SystemExit("the README has no table of errors")
    README.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
