"""Shows a result in a notebook: its tables and notes as an HTML fragment."""

from __future__ import annotations

import html

from clubface.present.terminal import headings_and_rows, values_of
from clubface.results.result import Result

MOST_ROWS = 60
"""Maximum number of table rows in a notebook."""


def as_fragment(result: Result) -> str:
    """Return a result as HTML for a notebook."""
    parts = [f"<p>{html.escape(each.sentence)}</p>" for each in result.assumptions]
    parts.append(f"<strong>{html.escape(result.title)}</strong>")
    if rows := values_of(result.values):
        parts.append(_table(["", "", ""], [list(each) for each in rows]))
    for each in result.tables:
        if not each.printed or not len(each):
            continue
        if each.title and each.title != result.title:
            parts.append(f"<p>{html.escape(each.title)}</p>")
        if each.layout == "list":
            parts.append(_table(["", "", ""], [list(row) for row in values_of(each.columns)]))
            continue
        heads, rows = headings_and_rows(each)
        parts.append(_table([f"{words} ({unit})" if unit else words for words, unit in heads], rows))
    sentences = dict.fromkeys(each.sentence for each in (*result.summary, *result.notes))
    if sentences:
        parts.append("<ul>" + "".join(f"<li>{html.escape(each)}</li>" for each in sentences) + "</ul>")
    return "\n".join([*parts, *map(as_fragment, result.parts)])


def _table(heads: list[str], rows: list[list[str]]) -> str:
    def line(cells: list[str], tag: str) -> str:
        return f"<tr>{''.join(f'<{tag}>{html.escape(each)}</{tag}>' for each in cells)}</tr>"

    body = "".join(line(each, "td") for each in rows[:MOST_ROWS])
    more = len(rows) - MOST_ROWS
    rest = f"<tr><td colspan={len(heads)}>and {more} more rows</td></tr>" if more > 0 else ""
    return f"<table><thead>{line(heads, 'th')}</thead><tbody>{body}{rest}</tbody></table>"
