"""Check of the built pages: they load nothing from a network, and every link within them leads somewhere."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from sphinx.application import Sphinx
from sphinx.util import logging

logger = logging.getLogger(__name__)

LOADED = re.compile(r"""(?:@import\s+|url\(\s*)["']?((?:https?:)?//[^"')\s]+)""")
"""What a style sheet loads from a network."""


class _Page(HTMLParser):
    """What a page loads, where its links lead, and the places in it that links can name."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.loads: list[str] = []
        self.links: list[str] = []
        self.places: set[str] = set()
        self._style = False
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._style = tag == "style"
        for name, value in attrs:
            if value is None:
                continue
            if name == "id" or (tag == "a" and name == "name"):
                self.places.add(value)
            elif name == "style":
                self.loads += LOADED.findall(value)
            elif name == "srcset":
                self.loads += [each.split()[0] for each in value.split(",") if each.strip()]
            elif name in ("href", "xlink:href", "src", "data", "poster"):
                (self.links if tag in ("a", "area") else self.loads).append(value)

    def handle_data(self, data: str) -> None:
        if self._style:
            self.loads += LOADED.findall(data)


def problems(folder: Path) -> Iterator[str]:
    """Yield what is wrong with the pages of a folder, each in one sentence that names the page.

    :param folder: folder of web pages and style sheets, with those below it
    """
    pages = {path: _Page(path) for path in sorted(folder.resolve().glob("**/*.html"))}
    for path, page in pages.items():
        name = path.relative_to(folder.resolve())
        for address in page.loads + page.links:
            parts = urlsplit(address)
            if parts.scheme or parts.netloc:
                if address in page.loads and parts.scheme != "data":
                    yield f"{name} loads {address} from a network; ship it with the pages"
                continue
            target = (path.parent / unquote(parts.path)).resolve() if parts.path else path
            if not target.is_file():
                yield f"{name} names {address}, which does not exist"
            elif "=" in parts.fragment:  # what the page shows, as in links of the studio
                continue
            elif parts.fragment and target in pages and unquote(parts.fragment) not in pages[target].places:
                yield f"{name} links to {address}, a place that {target.name} does not have"
    for path in sorted(folder.glob("**/*.css")):
        for address in LOADED.findall(path.read_text(encoding="utf-8")):
            yield f"{path.relative_to(folder)} loads {address} from a network; ship it with the pages"


def check(app: Sphinx, error: Exception | None) -> None:
    """Warn of every problem once the pages are written, so that a build with -W fails."""
    if error is None and app.builder.name == "html":
        for problem in problems(app.outdir):
            logger.warning(problem)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the check."""
    app.connect("build-finished", check)
    return {"parallel_read_safe": True}
