"""What a result was computed from: inputs, equipment and models, files with fingerprints, versions, sources."""

from __future__ import annotations

import platform
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

from clubface.support.files import InputFile, recorded_files, short_names
from clubface.support.version import __version__


class FileUsed(NamedTuple):
    """A file that went into a result: its name without the folder where that is enough, and its fingerprint."""

    name: str
    bytes: int
    sha256: str
    text: str | None = None


class Computation(NamedTuple):
    """With what launches were computed."""

    club: str
    ball: str
    model: str
    parameters: str
    hand: str = "right"


@dataclass(frozen=True)
class Provenance:
    """What a result was computed from.

    Attributes
    ----------
    inputs
        Values that went in, as people write them, by name.
    computations
        Clubs, balls, models and parameter sets.
    sources
        Where values come from, a work or file each.
    caveats
        What the sources say against relying on them.
    files
        The files that were read, those that came with the package left out.
    descriptions
        Texts of files with which the result can be computed again, by name.
    """

    inputs: Mapping[str, str] = field(default_factory=dict)
    computations: tuple[Computation, ...] = ()
    sources: tuple[str, ...] = ()
    caveats: tuple[str, ...] = ()
    files: tuple[FileUsed, ...] = ()
    descriptions: Mapping[str, str] = field(default_factory=dict)
    versions: Mapping[str, str] = field(default_factory=lambda: versions())

    def with_files(self) -> Provenance:
        """Return it with the files that the running computation has read so far."""
        return replace(self, files=used_files())

    def __add__(self, other: Provenance) -> Provenance:
        return Provenance(
            {**self.inputs, **other.inputs},
            _once(self.computations + other.computations),
            _once(self.sources + other.sources),
            _once(self.caveats + other.caveats),
            _once(self.files + other.files),
            {**self.descriptions, **other.descriptions},
        )

    def to_dict(self) -> dict[str, Any]:
        """Return it as JSON has it."""
        return {
            "versions": dict(self.versions),
            "inputs": dict(self.inputs),
            "computed_with": [each._asdict() for each in self.computations],
            "sources": list(self.sources),
            "caveats": list(self.caveats),
            "files": [{"name": each.name, "bytes": each.bytes, "sha256": each.sha256} for each in self.files],
        }


MOST_BYTES = 2**17
"""Larger descriptions are named by their fingerprint alone, as tables are."""


def used_files(read: Iterable[InputFile] | None = None) -> tuple[FileUsed, ...]:
    """Return the files that the running computation has read, with the texts of descriptions in TOML."""
    own = [each for each in (recorded_files() if read is None else read) if not each.shipped]
    used = []
    for name, each in zip(short_names([file.path for file in own]), own, strict=True):
        kept = each.content is not None and each.size <= MOST_BYTES and name.lower().endswith(".toml")
        content = each.content.decode("utf-8-sig", errors="replace") if kept and each.content is not None else None
        used.append(FileUsed(name, each.size, each.sha256, content))
    return tuple(used)


def versions() -> dict[str, str]:
    """Return the versions of what computes."""
    import numpy as np

    return {"clubface": __version__, "python": platform.python_version(), "numpy": np.__version__}


def _once(items: tuple[Any, ...]) -> tuple[Any, ...]:
    return tuple(dict.fromkeys(items))
