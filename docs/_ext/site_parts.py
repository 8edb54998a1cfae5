"""What the whole site has and the documentation alone has not: a picture that computes, and the studio.

``make site`` builds it next to the pages, in the folder ``studio``, and says so by the tag ``site``.
"""

from __future__ import annotations

from html import escape
from urllib.parse import quote

from docutils import nodes
from docutils.parsers.rst import Directive
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

STUDIO = "studio/"
SHOT = {"club": "driver", "speed": "105mph", "attack": "2deg", "loft": "13deg", "path": "5deg", "face": "1.5deg"}
"""The shot with which the live picture begins."""
LIVE = """<figure class="live-shot">
<iframe src="{studio}live.html{shot}" title="A drive that follows its sliders" loading="lazy"></iframe>
<figcaption>Computed in this page: move a slider, or press on the face.
<a href="{studio}index.html{shot}">The studio</a> has the other clubs, all models, and everything else.</figcaption>
</figure>
<script>
  addEventListener("message", ({{ source, data }}) => {{
    const frame = document.querySelector(".live-shot iframe");
    if (source === frame.contentWindow && data?.clubfaceHeight > 0) frame.style.height = data.clubfaceHeight + "px";
  }});
</script>
"""


class LiveShot(SphinxDirective):
    """A drive that follows its sliders; nothing where the documentation is built alone."""

    def run(self) -> list[nodes.Node]:
        """Return the frame of the picture."""
        if not self.env.app.tags.has("site"):
            return []
        shot = "#scene=shot&" + "&".join(f"{name}={quote(value)}" for name, value in SHOT.items())
        return [nodes.raw("", LIVE.format(studio=STUDIO, shot=escape(shot)), format="html")]


class OpenStudio(SphinxDirective):
    """A link to the studio of the site, with the words of the content; nothing without the site."""

    has_content = True

    def run(self) -> list[nodes.Node]:
        """Return the link as a paragraph."""
        if not self.env.app.tags.has("site"):
            return []
        words = escape(" ".join(self.content))
        return [nodes.raw("", f'<p><a href="{STUDIO}index.html">{words}</a></p>', format="html")]


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    directives: dict[str, type[Directive]] = {"live-shot": LiveShot, "open-studio": OpenStudio}
    for name, directive in directives.items():
        app.add_directive(name, directive)
    return {"parallel_read_safe": True}
