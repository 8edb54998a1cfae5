"""The mapping: which marker is what, and where the target is."""

from __future__ import annotations

import os
from typing import Self

from clubface.motion_capture.mapping_file import from_document, to_toml
from clubface.motion_capture.markers import Markers
from clubface.support.strict_toml import Document


class MarkerMap(Markers):
    """The markers of a laboratory; its attributes are those of :class:`Markers`."""

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Self:
        """Read a mapping file; ``template`` shows its form. Every error names file and line."""
        return from_document(cls, Document.read(path))

    @classmethod
    def from_text(cls, text: str, path: str = "<mapping>") -> Self:
        """Read the text of a mapping file; ``path`` names it in errors."""
        return from_document(cls, Document(text, path))

    def to_toml(self) -> str:
        """Return the text of a mapping file that reads back as this mapping, lengths to 1 nm."""
        return to_toml(self)


def marker_map(which: str | os.PathLike[str] | MarkerMap) -> MarkerMap:
    """Return the mapping that is given as the path of its file, or as a :class:`MarkerMap` itself."""
    return which if isinstance(which, MarkerMap) else MarkerMap.read(which)
