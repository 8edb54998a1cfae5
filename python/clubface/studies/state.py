"""How far a study is."""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from clubface.errors import FileError
from clubface.studies.chunks import checked_part
from clubface.studies.store import StudyStore, check_study, open_store, store_of
from clubface.studies.study import read_study
from clubface.support.input_files import count_as_read

SHOWN = 20
"""Chunks that are told by their number."""


@dataclass(frozen=True, kw_only=True)
class Status:
    """How far a study is.

    Attributes
    ----------
    name
        Of the study.
    store
        The folder of its store.
    tasks, chunks, chunk
        Tasks and chunks in all, and tasks of a chunk.
    done
        Chunks whose part is there, and whole where that was checked.
    missing, damaged
        The first chunks without a part, and with a damaged one.
    size
        Bytes of all parts.
    """

    name: str
    store: str
    tasks: int
    chunks: int
    chunk: int
    done: int
    missing: tuple[int, ...]
    damaged: tuple[int, ...]
    size: int


def opened(which: str | os.PathLike[str], store: str | os.PathLike[str] | None = None) -> StudyStore:
    """Return the store of a study that is named by its file or by the folder of the store itself.

    Raises
    ------
    FileError
        There is none, or it belongs to another study.
    """
    path = Path(which)
    if path.is_dir():
        found = open_store(path)
        count_as_read(found.files_read())
        return found
    study = read_study(path)
    folder = Path(store) if store is not None else store_of(path)
    if not folder.exists():
        raise FileError(str(folder), None, f"nothing of this study is done yet; clubface study run {path} begins it")
    found = open_store(folder)
    check_study(found, study)
    return found


def status(
    which: str | os.PathLike[str],
    *,
    store: str | os.PathLike[str] | None = None,
    check: bool = False,
    progress: Callable[[int, int], object] | None = None,
) -> Status:
    """Return how far a study is.

    Parameters
    ----------
    which
        The file of the study, or the folder of its store.
    store
        The folder of the store of a file, unless it is the usual one.
    check
        Whether to read every part, and tell the damaged ones.
    progress
        Called with the chunks looked at and the chunks in all.
    """
    found = opened(which, store)
    there = found.present()
    damaged = []
    for chunk in range(found.chunks) if check else ():
        try:
            if there[chunk]:
                checked_part(found, chunk)
        except FileError:
            damaged.append(chunk)
        except FileNotFoundError:
            there[chunk] = 0
        if progress is not None:
            progress(chunk + 1, found.chunks)
    missing = [chunk for chunk in range(found.chunks) if not there[chunk]]
    return Status(
        name=found.record["name"], store=str(found.folder), tasks=found.count, chunks=found.chunks,
        chunk=found.record["chunk"], done=found.chunks - len(missing) - len(damaged),
        missing=tuple(missing[:SHOWN]), damaged=tuple(damaged[:SHOWN]), size=found.size(),
    )  # fmt: skip
