"""A report as one file, HTML or Markdown, which needs no other: pictures and data are inside."""

from __future__ import annotations

import base64
import html
import os
import re
from collections.abc import Sequence
from pathlib import Path

from clubface.errors import InputError
from clubface.reports.blocks import Block, Bullets, Data, Heading, Paragraph, Table
from clubface.support.whole_file import write_text

ENDINGS = (".html", ".md")
_STYLE = (
    "body{font:17px/1.55 Georgia,serif;max-width:46em;margin:2em auto;padding:0 1em;color:#222}"
    "h1,h2,h3,table{font-family:system-ui,sans-serif}h1,h2,h3{line-height:1.2}"
    "h2{border-bottom:2px solid #0072B2;margin-top:2em}"
    "img{max-width:100%}figure{margin:1.5em 0}figcaption,.save{font:14px system-ui,sans-serif;color:#555}"
    ".wide{overflow-x:auto}table{border-collapse:collapse;font-size:14px}"
    "th,td{padding:.25em .7em;border-bottom:1px solid #ddd;text-align:right;vertical-align:top}"
    "th:first-child,td:first-child{text-align:left}thead th{border-bottom:2px solid #0072B2}"
    "@media print{.save{display:none}body{margin:0;max-width:none}figure,table{break-inside:avoid}}"
)


def write_document(blocks: Sequence[Block], path: str | os.PathLike[str]) -> Path:
    """Write a report to one file, HTML or Markdown by its ending; return its path."""
    target = check_ending(path)
    return write_text(target, as_html(blocks) if target.suffix.lower() == ".html" else as_markdown(blocks))


def check_ending(path: str | os.PathLike[str], *, name: str = "output") -> Path:
    """Refuse a report of another kind, before any work; errors call it ``name``."""
    target = Path(path)
    if target.suffix.lower() not in ENDINGS:
        raise InputError(name, str(path), f"a file whose name ends in {' or '.join(ENDINGS)}")
    return target


def as_html(blocks: Sequence[Block]) -> str:
    """Return a report as one HTML document without scripts."""
    title = next((html.escape(each.text) for each in blocks if isinstance(each, Heading)), "Report")
    head = (
        '<meta charset="utf-8"><meta name="viewport" content="width=device-width">'
        f"<title>{title}</title><style>{_STYLE}</style>"
    )
    body = "\n".join(_html(each) for each in blocks)
    return f'<!doctype html>\n<html lang="en"><head>{head}</head>\n<body>\n{body}\n</body></html>\n'


def as_markdown(blocks: Sequence[Block]) -> str:
    """Return a report as Markdown, its pictures as data in it."""
    return "\n\n".join(_markdown(each) for each in blocks) + "\n"


def _html(block: Block) -> str:
    if isinstance(block, Heading):
        return f"<h{block.level}>{html.escape(block.text)}</h{block.level}>"
    if isinstance(block, Paragraph):
        return f"<p>{html.escape(' '.join(block.texts))}</p>"
    if isinstance(block, Bullets):
        return "<ul>" + "".join(f"<li>{html.escape(text)}</li>" for text in block.texts) + "</ul>"
    if isinstance(block, Table):
        head = "".join(f"<th>{html.escape(text)}</th>" for text in block.headings)
        rows = "".join(f"<tr>{''.join(f'<td>{html.escape(cell)}</td>' for cell in row)}</tr>" for row in block.rows)
        table = f'<div class="wide"><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>'
        return table + _saved([] if block.data is None else [_link_to_csv(block.data)])
    name = block.data.name if block.data is not None else file_name(block.shows)
    source = _in_the_page(block.svg, "image/svg+xml")
    links = [_link(source, f"{name}.svg", "the picture (SVG)")]
    if block.data is not None:
        links.append(_link_to_csv(block.data))
    shows = html.escape(block.shows)
    return f'<figure><img alt="{shows}" src="{source}"><figcaption>{shows}</figcaption>{_saved(links)}</figure>'


def _markdown(block: Block) -> str:
    if isinstance(block, Heading):
        return f"{'#' * block.level} {_plain(block.text)}"
    if isinstance(block, Paragraph):
        return _plain(" ".join(block.texts))
    if isinstance(block, Bullets):
        return "\n".join(f"* {_plain(text)}" for text in block.texts)
    if isinstance(block, Table):
        lines = [block.headings, ["---", *["---:"] * (len(block.headings) - 1)], *block.rows]
        return "\n".join("| " + " | ".join(_cell(text) for text in line) + " |" for line in lines)
    return f"![{_plain(block.shows)}]({_in_the_page(block.svg, 'image/svg+xml')})"


def file_name(text: str) -> str:
    """Return words as the name of a file: small letters, digits and hyphens."""
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")[:60] or "picture"


def _plain(text: str) -> str:
    return text.replace("<", "&lt;")


def _cell(text: str) -> str:
    return _plain(text).replace("|", "\\|").replace("\n", " ")


def _in_the_page(text: str, kind: str) -> str:
    return f"data:{kind};base64,{base64.b64encode(text.encode()).decode()}"


def _link(address: str, name: str, what: str) -> str:
    return f'<a download="{html.escape(name)}" href="{address}">{what}</a>'


def _link_to_csv(data: Data) -> str:
    return _link(_in_the_page(data.as_csv(), "text/csv"), f"{data.name}.csv", "the data (CSV)")


def _saved(links: Sequence[str]) -> str:
    return f'<p class="save">Save {" or ".join(links)}</p>' if links else ""
