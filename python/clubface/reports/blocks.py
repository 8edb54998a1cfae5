"""The pieces that a report is made of."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from typing import Any, NamedTuple


class Data(NamedTuple):
    """Numbers behind a picture or table, which a reader can save as CSV.

    Attributes
    ----------
    name
        Name of the file, without an ending.
    headings
        One a column, with its unit: "carry (yd)".
    rows
        Numbers, texts, or None for what is not known.
    """

    name: str
    headings: Sequence[str]
    rows: Sequence[Sequence[Any]]

    def as_csv(self) -> str:
        """Return the data as the text of a CSV file, numbers with all their digits."""
        kept = io.StringIO()
        writer = csv.writer(kept, lineterminator="\n")
        writer.writerow(self.headings)
        writer.writerows(["" if cell is None or cell != cell else cell for cell in row] for row in self.rows)
        return kept.getvalue()


class Heading(NamedTuple):
    """A heading; the one of level 1 is the title of the report."""

    level: int
    text: str


class Paragraph(NamedTuple):
    """Running text, a sentence an entry."""

    texts: Sequence[str]


class Bullets(NamedTuple):
    """A list of sentences."""

    texts: Sequence[str]


class Table(NamedTuple):
    """A table of texts; ``data`` has its numbers, or None."""

    headings: Sequence[str]
    rows: Sequence[Sequence[str]]
    data: Data | None = None


class Picture(NamedTuple):
    """A picture: what it shows, in words, the text of its SVG, and the numbers it draws, or None."""

    shows: str
    svg: str
    data: Data | None = None


class Listing(NamedTuple):
    """The text of a file that went in, which a reader can save under its ``name``."""

    name: str
    text: str


Block = Heading | Paragraph | Bullets | Table | Picture | Listing
