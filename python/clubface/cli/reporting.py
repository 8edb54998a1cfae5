"""``--report``: what a command prints, its picture and the data behind it, and its origin, as one file."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import redirect_stdout
from typing import Any

from clubface.cli import app, output
from clubface.support.files import recorded_files, short_names

MOST_BYTES = 2**17
"""Larger descriptions are told by their fingerprint alone, as tables are."""


def write(
    target: str,
    *,
    title: str,
    words: Iterable[str],
    picture: tuple[str, Any] | None,
    columns: Mapping[str, Any],
    show: Callable[[], None],
    launches: Iterable[Any],
    given: Mapping[str, str],
    conditions: Mapping[str, Any] | None = None,
    sources: Iterable[str] = (),
    files: Mapping[str, str] | None = None,
) -> None:
    """Write a report.

    Parameters
    ----------
    title, words
        What it is of, and what came out, in sentences for a reader who knows no options.
    picture
        What it shows, in words, and the figure; or None.
    columns
        The numbers behind it, by headings with units.
    show
        Prints the tables, which the report repeats.
    launches
        Launches that tell club, ball, model and sources.
    given
        What else went in, by name.
    conditions
        Air and wind of the flights, as :func:`clubface.fly` takes them; None where no ball flies.
    sources
        What else was taken from where.
    files
        Texts of descriptions that are not in a file the command reads, by name.
    """
    from clubface.present.document import Block, Data, Heading, Paragraph, Picture, file_name, write_document
    from clubface.present.report import provenance_blocks
    from clubface.present.style import svg
    from clubface.simulation.provenance import provenance_of

    data = Data(file_name(title), list(columns), list(zip(*columns.values(), strict=True)))
    blocks: list[Block] = [Heading(1, title), Paragraph(tuple(words))]
    if picture is not None:
        shows, figure = picture
        blocks.append(Picture(shows, svg(figure), data))
    blocks.append(Heading(2, "All figures"))
    with output.repeated_in(blocks), redirect_stdout(io.StringIO()):
        show()
    blocks += provenance_blocks(provenance_of(launches, {**given, **flown(conditions)}, sources))
    write_document([*blocks, *repeat(files or {})], target)


def named(text: str) -> str:
    """Return words as the name of a file."""
    from clubface.present.document import file_name

    return file_name(text)


def flown(conditions: Mapping[str, Any] | None) -> dict[str, str]:
    """Return the conditions of flight in words, by name; nothing where no ball flies."""
    from clubface.simulation.provenance import flight_conditions

    return {} if conditions is None else flight_conditions(**conditions)


def repeat(files: Mapping[str, str] | None = None) -> list[Any]:
    """Return the end of a report: the command that was typed, the files that it read, and other ``files`` by name."""
    from clubface.present.document import Heading, Listing, Paragraph, Table

    read = [each for each in recorded_files() if not each.shipped]
    names = short_names([each.path for each in read])
    blocks: list[Any] = [Heading(2, "To compute it again"), Listing("The command", app.command())]
    if read:
        rows = [(name, str(each.size), each.sha256) for name, each in zip(names, read, strict=True)]
        blocks += [Paragraph(("It reads these files.",)), Table(("file", "bytes", "SHA-256"), rows)]
    texts = {
        name: each.content.decode("utf-8-sig", errors="replace")
        for name, each in zip(names, read, strict=True)
        if each.content is not None and each.size <= MOST_BYTES and name.lower().endswith(".toml")
    }
    return blocks + [Listing(name, text) for name, text in {**(files or {}), **texts}.items()]


def more_or_less(value: float, unit: str, words: Sequence[str], digits: int = 1) -> str:
    """Return a difference in words: "3.2 yd farther" or "3.2 yd shorter", by two words for more and less."""
    return f"{abs(value):.{digits}f} {unit} {words[0] if value > 0.0 else words[1]}"
