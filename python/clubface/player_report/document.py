"""The report as one file, Markdown or HTML, with its pictures inside."""

from __future__ import annotations

import base64
import html
import os
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from clubface.errors import InputError
from clubface.player_report import words
from clubface.player_report.figures_of_club import ClubFigures, figures_of
from clubface.recorded.shots import RecordedShots
from clubface.support.whole_file import write_text

ENDINGS = (".html", ".md")
CLUBLESS = "a club without a name"
_STYLE = (
    "body{font:17px/1.55 Georgia,serif;max-width:44em;margin:2em auto;padding:0 1em;color:#222}"
    "h1,h2,h3{font-family:system-ui,sans-serif;line-height:1.2}h2{border-bottom:2px solid #0072B2;margin-top:2em}"
    "img{max-width:100%}footer{color:#666;font-size:14px;margin-top:3em}"
)


class Block(NamedTuple):
    """A piece of the report: its kind ("h1", "h2", "h3", "p", "ul", "img"), its texts, and the content of a picture."""

    kind: str
    texts: tuple[str, ...]
    picture: bytes = b""


def blocks(clubs: list[ClubFigures], shots: RecordedShots) -> Iterator[Block]:
    """Yield the pieces of the report on shots, of which ``clubs`` holds the figures club by club."""
    yield Block("h1", ("Your shots, and what they say",))
    names = [f"{each.title} ({len(each.shots)})" for each in clubs]
    yield Block(
        "p", (f"This report is about {words.counted(len(shots))} of {Path(shots.source).name}: {', '.join(names)}.",)
    )
    for each in clubs:
        yield Block("h2", (each.title[:1].upper() + each.title[1:],))
        yield Block("p", tuple(words.measured(each)))
        yield Block("img", (f"{each.title}: where the shots go, and face, path and start line",), _picture(each))
        for title, texts in (
            ("Where the ball starts, and why", tuple(words.line(each))),
            ("Where you strike it", tuple(words.strike(each))),
        ):
            if texts:
                yield Block("h3", (title,))
                yield Block("p", texts)
        if changes := tuple(words.what_if(each)):
            yield Block("h3", ("What would change your average shot",))
            yield Block("p", ("Each of these alone, with all else as it is:",))
            yield Block("ul", changes)
        if doubts := tuple(words.doubt(each)):
            yield Block("h3", ("How sure we are",))
            yield Block("p", doubts)
    if shots.notes:
        yield Block("h2", ("Notes on the file",))
        yield Block("ul", tuple(f"{note[:1].upper()}{note[1:]}." for note in dict.fromkeys(shots.notes)))


def write_report(shots: RecordedShots, path: str | os.PathLike[str]) -> Path:
    """Write the report of a player's shots to one file, Markdown or HTML by its ending; return its path."""
    target = Path(path)
    if target.suffix.lower() not in ENDINGS:
        raise InputError("output", str(path), f"a file whose name ends in {' or '.join(ENDINGS)}")
    if not len(shots):
        raise InputError("shots", shots.source, "at least one shot")
    found = list(blocks(figures_by_club(shots), shots))
    text = as_html(found) if target.suffix.lower() == ".html" else as_markdown(found)
    return write_text(target, text)


def as_markdown(of: list[Block]) -> str:
    """Return the report as Markdown, the pictures as data in it."""
    parts = []
    for each in (block._replace(texts=tuple(text.replace("<", "&lt;") for text in block.texts)) for block in of):
        if each.kind == "img":
            parts.append(f"![{each.texts[0]}]({_data(each.picture)})")
        elif each.kind == "ul":
            parts.append("\n".join(f"* {text}" for text in each.texts))
        else:
            parts.append("#" * int(each.kind[1]) + " " + each.texts[0] if each.kind[0] == "h" else " ".join(each.texts))
    return "\n\n".join(parts) + "\n"


def as_html(of: list[Block]) -> str:
    """Return the report as one HTML document, the pictures in it."""
    body = []
    for each in of:
        texts = [html.escape(text) for text in each.texts]
        if each.kind == "img":
            body.append(f'<p><img alt="{texts[0]}" src="{_data(each.picture)}"></p>')
        elif each.kind == "ul":
            body.append("<ul>" + "".join(f"<li>{text}</li>" for text in texts) + "</ul>")
        else:
            body.append(f"<{each.kind}>{' '.join(texts)}</{each.kind}>")
    title = html.escape(of[0].texts[0])
    head = (
        '<meta charset="utf-8"><meta name="viewport" content="width=device-width">'
        f"<title>{title}</title><style>{_STYLE}</style>"
    )
    return f'<!doctype html>\n<html lang="en"><head>{head}</head>\n<body>\n' + "\n".join(body) + "\n</body></html>\n"


def figures_by_club(shots: RecordedShots) -> list[ClubFigures]:
    """Return the figures of each club of each player; what two players hit is no one's typical shot."""
    found = []
    for player, places in shots.by_player():
        of = shots.select(places)
        names = [""] if of.clubs is None else dict.fromkeys(of.clubs)
        for name in names:
            theirs = of if of.clubs is None else of.select(of.clubs == name)
            found.append(replace(figures_of(theirs, str(name) or CLUBLESS), player=player))
    return found


def _picture(of: ClubFigures) -> bytes:
    from clubface.player_report.picture import club_picture, png

    return png(club_picture(of))


def _data(picture: bytes) -> str:
    return f"data:image/png;base64,{base64.b64encode(picture).decode()}"
