"""A report as one self-contained file, HTML or Markdown, with its pictures and data inside."""

from __future__ import annotations

import base64
import csv
import html
import io
import os
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from clubface.errors import LINES, InputError, legible
from clubface.present.terminal import column_blocks
from clubface.support.files import write_text


class Data(NamedTuple):
    """The numbers behind a picture or table, which a reader can save as CSV."""

    name: str  # of the file, without extension
    headings: Sequence[str]  # with units: "carry (yd)"
    rows: Sequence[Sequence[Any]]  # numbers, texts, or None for unknown values

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
    """Running text, one sentence per entry."""

    texts: Sequence[str]


class Bullets(NamedTuple):
    """A list of sentences."""

    texts: Sequence[str]


class TextTable(NamedTuple):
    """A table of texts; ``data`` holds its numbers, or None."""

    headings: Sequence[str]
    rows: Sequence[Sequence[str]]
    data: Data | None = None


class DocumentPicture(NamedTuple):
    """A picture: its caption, the text of its SVG, and the numbers it draws, or None.

    ``narrow`` draws the version for phones and returns the text of its SVG; Markdown does not use it.
    """

    shows: str
    svg: str
    data: Data | None = None
    narrow: Callable[[], str] | None = None


class Listing(NamedTuple):
    """The text of an input file, which a reader can save under its ``name``."""

    name: str
    text: str


class PageBreak(NamedTuple):
    """The next piece begins a page when printed."""


class Appendix(NamedTuple):
    """Technical details: collapsed until the reader opens them; in Markdown, an appendix."""

    title: str
    blocks: Sequence[Block]


Block = Heading | Paragraph | Bullets | TextTable | DocumentPicture | Listing | PageBreak | Appendix


ENDINGS = (".html", ".md")
_STYLE = (
    "body{font:17px/1.55 Georgia,serif;max-width:46em;margin:2em auto;padding:0 1em;color:#222}"
    "h1,h2,h3,h4,table{font-family:system-ui,sans-serif}h1,h2,h3,h4{line-height:1.2}"
    "h2{border-bottom:2px solid #0072B2;margin-top:2em}"
    "img{max-width:100%}figure{margin:1.5em 0}figcaption,.save{font:14px system-ui,sans-serif;color:#555}"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:14px}"
    "th,td{padding:.25em .7em;border-bottom:1px solid #ddd;text-align:right;vertical-align:top}"
    "th:first-child,td:first-child,.text{text-align:left}thead th{border-bottom:2px solid #0072B2}"
    "td{white-space:nowrap}td.text{white-space:normal;overflow-wrap:anywhere;min-width:7.5em}.paper{display:none}"
    "pre{font-size:13px;white-space:pre-wrap;overflow-wrap:anywhere;border-left:3px solid #ddd;padding-left:.8em}"
    "a{color:#005a8f;overflow-wrap:anywhere}"
    "summary{font:bold 1.5em/1.2 system-ui,sans-serif;cursor:pointer;border-bottom:2px solid #0072B2;margin:2em 0 1em}"
    # Pictures are dark on white: invert them, but keep the hues.
    "@media screen and (prefers-color-scheme:dark){:root{color-scheme:dark;background:#121613}body{color:#e9efea}"
    "a{color:#79c0ff}figcaption,.save{color:#a7b3ab}th,td{border-color:#343d37}pre{border-color:#343d37}"
    "h2,summary,thead th{border-color:#79c0ff}img{filter:invert(.92) hue-rotate(180deg)}}"
    "@media screen and (min-width:1800px){body{zoom:1.4}}@media screen and (min-width:3000px){body{zoom:1.8}}"
    "@page{margin:13mm 18mm}"
    "@media print{.save{display:none}body{margin:0;max-width:none;font-size:11pt;padding:0}"
    ".sheets{font-size:9.5pt;line-height:1.35}.sheets img{max-height:6.4cm}"
    "a{color:inherit;text-decoration:none}h1{font-size:20pt}h2{font-size:14pt}h3{font-size:11pt}"
    "h4{font-size:10pt}h3,h4,p,ul{margin:.5em 0}"
    ".wide{overflow:visible}.screen{display:none}.paper{display:block;margin-bottom:1em}"
    ".sheets img.tall,img.tall{max-height:21cm}"
    "table{font-size:var(--print,9pt)}th,td{padding:.2em .4em}td.text{min-width:0}figure,tr{break-inside:avoid}"
    "thead{display:table-header-group}h1,h2,h3,h4,p:has(+ul){break-after:avoid}p,li{orphans:3;widows:3}"
    ".page{break-before:page}h2{margin:.8em 0 .4em}.page+h2,.page+h3,h1{margin-top:0}figure{margin:.6em 0}"
    "details{break-before:page}details:not([open]){display:none}}"
)
PRINTED = 9.0
"""Font size of a printed table [pt]."""
SMALLEST = 6.0
"""Smallest font size [pt] before a table is split into parts."""
PAPER = 480.0
"""Width between the margins of an A4 page, with some spare [pt]."""
LETTER, GAP = 0.66, 0.8
"""Width of a digit in the widest common font, and of the space around a cell, relative to the font size."""
NUMBER = 24
"""Longest cell that counts as a number; columns with longer cells are aligned to the left."""
_ADDRESS = re.compile(
    r"(?P<url>https?://[^\s<>()\"]+)|doi:? ?(?P<doi>10\.\d{4,9}/[^\s<>()\",;]+)"
    r"|(?P<page>\b(?:[a-z0-9-]+\.)+(?:com|org|net|edu|gov|io|ca|uk)/[^\s<>()\",;:]+)"
)
"""Addresses in a text: a URL, a DOI, or a page without https."""


def write_document(blocks: Sequence[Block], path: str | os.PathLike[str]) -> Path:
    """Write a report to one file, HTML or Markdown by its ending; return its path."""
    target = Path(path)
    if target.suffix.lower() not in ENDINGS:
        raise InputError("output", str(path), f"a file whose name ends in {' or '.join(ENDINGS)}")
    return write_text(target, as_html(blocks) if target.suffix.lower() == ".html" else as_markdown(blocks))


def as_html(blocks: Sequence[Block]) -> str:
    """Return a report as one HTML document without scripts."""
    title = next((html.escape(each.text) for each in blocks if isinstance(each, Heading)), "Report")
    head = (
        '<meta charset="utf-8"><meta name="viewport" content="width=device-width">'
        f"<title>{title}</title><style>{_STYLE}</style>"
    )
    body = "\n".join(_html(each) for each in blocks)
    kind = ' class="sheets"' if any(isinstance(each, PageBreak) for each in blocks) else ""
    return f'<!doctype html>\n<html lang="en"><head>{head}</head>\n<body><main{kind}>\n{body}\n</main></body></html>\n'


def as_markdown(blocks: Sequence[Block]) -> str:
    """Return a report as Markdown, with its pictures embedded as data."""
    return "\n\n".join(filter(None, map(_markdown, blocks))) + "\n"


def _html(block: Block) -> str:
    if isinstance(block, PageBreak):
        return '<div class="page"></div>'
    if isinstance(block, Appendix):
        inside = "\n".join(map(_html, block.blocks))
        return f"<details><summary>{html.escape(block.title)}</summary>\n{inside}\n</details>"
    if isinstance(block, Heading):
        return f"<h{block.level}>{html.escape(block.text)}</h{block.level}>"
    if isinstance(block, Paragraph):
        return f"<p>{_link_addresses(' '.join(block.texts))}</p>"
    if isinstance(block, Bullets):
        return "<ul>" + "".join(f"<li>{_link_addresses(text)}</li>" for text in block.texts) + "</ul>"
    if isinstance(block, Listing):
        source = _data_address(block.text, "text/plain")
        saved = _save_links([_link(source, block.name, "the file")])
        return f"<h3>{html.escape(block.name)}</h3><pre>{html.escape(block.text)}</pre>{saved}"
    if isinstance(block, TextTable):
        shown = _html_table(block) if block.rows else ""  # a table without printed rows is only saved
        return shown + _save_links([] if block.data is None else [_link_to_csv(block.data)])
    name = block.data.name if block.data is not None else file_name(block.shows)
    source = _data_address(block.svg, "image/svg+xml")
    links = [_link(source, f"{name}.svg", "the picture (SVG)")]
    if block.data is not None:
        links.append(_link_to_csv(block.data))
    shows = html.escape(block.shows)
    tall = ' class="tall"' if _is_tall(block.svg) else ""
    image = f'<img{tall} alt="{shows}" src="{source}">'
    if block.narrow is not None:
        narrow = _data_address(block.narrow(), "image/svg+xml")
        image = f'<picture><source media="screen and (max-width:600px)" srcset="{narrow}">{image}</picture>'
    return f"<figure>{image}<figcaption>{shows}</figcaption>{_save_links(links)}</figure>"


def _is_tall(svg: str) -> bool:
    """Return whether a picture is nearly as high as it is wide, so that it needs a page when printed."""
    size = re.search(r'width="([\d.]+)pt" height="([\d.]+)pt"', svg)
    return size is not None and float(size[2]) > 0.9 * float(size[1])


def _html_table(table: TextTable) -> str:
    """Return a table that scrolls on a screen; on paper it is shrunk to fit the page, or split into parts.

    Numbers are never broken. Every part repeats the first column.
    """
    texts = [any(len(row[place]) > NUMBER for row in table.rows) for place in range(len(table.headings))]
    widths = [_width(table, place, text=text) for place, text in enumerate(texts)]
    parts = column_blocks(widths, 0.0, PAPER / SMALLEST)

    def rows_of(places: Sequence[int]) -> str:
        def row(cells: Sequence[str], tag: str) -> str:
            kinds = (' class="text"' * texts[place] for place in places)
            inside = (
                f"<{tag}{kind}>{html.escape(cells[place])}</{tag[:2]}>"
                for kind, place in zip(kinds, places, strict=True)
            )
            return f"<tr>{''.join(inside)}</tr>"

        head = row(table.headings, 'th scope="col"')
        return f"<thead>{head}</thead><tbody>{''.join(row(each, 'td') for each in table.rows)}</tbody>"

    def sized(places: Sequence[int]) -> str:
        size = min(PRINTED, PAPER / sum(widths[place] for place in places))
        style = "" if size == PRINTED else f' style="--print:{size:.1f}pt"'
        return f"<table{style}>{rows_of(places)}</table>"

    whole = range(len(widths))
    if len(parts) == 1:
        return f'<div class="wide">{sized(whole)}</div>'
    paper = "".join(f'<div class="paper" aria-hidden="true">{sized(places)}</div>' for places in parts)
    return f'<div class="wide screen"><table>{rows_of(whole)}</table></div>{paper}'


def _width(table: TextTable, place: int, *, text: bool) -> float:
    """Return the minimum width of a column, relative to the font size; words may be broken, numbers may not."""
    letters = max(map(len, table.headings[place].split()), default=1)
    cells = max((len(row[place]) for row in table.rows), default=1)
    return LETTER * max(letters, min(cells, NUMBER) if text else cells) + GAP


def _markdown(block: Block) -> str:
    if isinstance(block, PageBreak):
        return ""
    if isinstance(block, Appendix):
        return "\n\n".join([f"## {_plain(block.title)}", *filter(None, map(_markdown, block.blocks))])
    if isinstance(block, Heading):
        return f"{'#' * block.level} {_plain(block.text)}"
    if isinstance(block, Paragraph):
        return _plain(" ".join(block.texts))
    if isinstance(block, Bullets):
        return "\n".join(f"* {_plain(text)}" for text in block.texts)
    if isinstance(block, Listing):
        fence = "`" * max(3, 1 + max(map(len, re.findall("`+", block.text)), default=0))
        return f"### {_plain(block.name)}\n\n{fence}\n{block.text.rstrip()}\n{fence}"
    if isinstance(block, TextTable):
        lines = [block.headings, ["---", *["---:"] * (len(block.headings) - 1)], *block.rows]
        return "\n".join("| " + " | ".join(_cell(text) for text in line) + " |" for line in lines)
    return f"![{_plain(block.shows)}]({_data_address(block.svg, 'image/svg+xml')})"


def file_name(text: str) -> str:
    """Return text as a file name: lower-case letters, digits and hyphens."""
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")[:60] or "picture"


def _plain(text: str) -> str:
    """Return text as one line that Markdown shows literally, without tags, links or pictures in it."""
    one = " ".join(text.split())
    return re.sub(r"[\\`\[\]]", r"\\\g<0>", one.replace("&", "&amp;").replace("<", "&lt;"))


def _cell(text: str) -> str:
    return _plain(text).replace("|", "\\|")


def _link_addresses(text: str) -> str:
    """Return text as HTML, with addresses as links and commands in backticks as code."""
    result, end = [], 0
    for each in _ADDRESS.finditer(text):
        words = each[0].rstrip(".,;:")
        address = each["url"] or (f"https://doi.org/{each['doi']}" if each["doi"] else f"https://{each['page']}")
        result += [html.escape(text[end : each.start()]), f'<a href="{html.escape(address.rstrip(".,;:"))}">']
        result.append(f"{html.escape(words)}</a>")
        end = each.start() + len(words)
    return re.sub("`([^`<]+)`", r"<code>\1</code>", "".join(result) + html.escape(text[end:]))


def _data_address(text: str, kind: str) -> str:
    return f"data:{kind};base64,{base64.b64encode(legible(text, LINES).encode()).decode()}"


def _link(address: str, name: str, what: str) -> str:
    file = html.escape(name)
    return f'<a download="{file}" href="{address}" aria-label="Save {what} as {file}">{what}</a>'


def _link_to_csv(data: Data) -> str:
    return _link(_data_address(data.as_csv(), "text/csv"), f"{data.name}.csv", "the data (CSV)")


def _save_links(links: Sequence[str]) -> str:
    return f'<p class="save">Save {" or ".join(links)}</p>' if links else ""
