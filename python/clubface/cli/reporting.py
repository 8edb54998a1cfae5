"""``--report``: what a command prints, its picture and the data behind it, and its origin, as one file."""

from __future__ import annotations

import io
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import redirect_stdout
from typing import Any

from clubface.cli import options, output


def told_conditions(texts: Mapping[str, Any]) -> dict[str, str]:
    """Return the air, wind and ground that were given, as they were typed, by name."""
    return {name: str(texts[name]) for name in (*options.AIR, *options.GROUND) if texts.get(name) is not None}


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
    """
    from clubface.plots.style import svg
    from clubface.reports.blocks import Block, Data, Heading, Paragraph, Picture
    from clubface.reports.document import file_name, write_document
    from clubface.reports.origin import origin

    data = Data(file_name(title), list(columns), list(zip(*columns.values(), strict=True)))
    blocks: list[Block] = [Heading(1, title), Paragraph(tuple(words))]
    if picture is not None:
        shows, figure = picture
        blocks.append(Picture(shows, svg(figure), data))
    with output.repeated_in(blocks), redirect_stdout(io.StringIO()):
        show()
    blocks += origin(launches, given=given)
    write_document(blocks, target)


def more_or_less(value: float, unit: str, words: Sequence[str], digits: int = 1) -> str:
    """Return a difference in words: "3.2 yd farther" or "3.2 yd shorter", by two words for more and less."""
    return f"{abs(value):.{digits}f} {unit} {words[0] if value > 0.0 else words[1]}"
