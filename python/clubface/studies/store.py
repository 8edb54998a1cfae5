"""What a study has finished: a store with a part for each chunk that is done."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from clubface.errors import FileError
from clubface.studies.study import StudyFile
from clubface.support.checked_json import read_checked, write_checked
from clubface.support.fingerprint import check_same, fingerprint, fingerprints, first_difference
from clubface.support.folders import prepared_folder
from clubface.support.input_files import InputFile, absolute
from clubface.support.part_store import PARTS, RECORD, PartStore
from clubface.support.whole_file import whole_file

ENDING = ".parquet"
INPUTS = "inputs"
A_FOLDER = 1000
"""Parts of a folder: file systems slow down with very many."""
DAMAGED = "this record of a study is damaged; remove it: clubface study run makes it anew, and keeps the parts that fit"
OTHERWISE = "give another folder with --store, or remove this one"


def store_of(path: Path) -> Path:
    """Return the folder of the store of a study's file, unless another is named."""
    return path.with_name(f"{path.stem}.store")


class StudyStore(PartStore):
    """The store of a study.

    Its ``record`` has besides ``content`` the ``name``, ``count`` and ``chunk`` (tasks in all and in a chunk),
    ``axes``, ``columns``, and ``provenance``, which every part repeats.
    """

    @property
    def count(self) -> int:
        """The tasks of the study."""
        return self.record["count"]

    @property
    def chunks(self) -> int:
        """The chunks of the study."""
        return -(-self.count // self.record["chunk"])

    @property
    def identity(self) -> str:
        """A text that is the same only for the same study in chunks of the same size."""
        return fingerprint([self.record["content"], self.record["chunk"]])[:16]

    def tasks(self, chunk: int) -> range:
        """Return the tasks of a chunk."""
        size = self.record["chunk"]
        return range(chunk * size, min((chunk + 1) * size, self.count))

    def path(self, chunk: int) -> Path:
        """Return the file of a chunk."""
        return self.parts / f"{chunk // A_FOLDER:04d}" / f"{chunk:08d}{ENDING}"

    @property
    def inputs(self) -> Path:
        """The folder of what the study has read, each file under its fingerprint: workers read nothing else."""
        return self.folder / INPUTS

    def keep_input(self, given: InputFile) -> None:
        """Keep a file that the study has read; one too large to be kept is read in its own place."""
        path = self.inputs / given.sha256
        if given.content is not None and not path.exists():
            with whole_file(self.prepare(path)) as file:
                file.write(given.content)

    def input(self, sum_: str) -> bytes | None:
        """Return what was read under a fingerprint, None where it is not kept."""
        with suppress(OSError):
            return (self.inputs / sum_).read_bytes()
        return None

    def files_read(self) -> Iterator[InputFile]:
        """Yield what the study has read, by the names that the files have from its folder; what is not kept is left."""
        for name, sum_ in self.record["provenance"]["files"].items():
            if (content := self.input(sum_)) is not None:
                yield InputFile(name, os.fspath(self.inputs / sum_), len(content), sum_, False, content)

    def present(self) -> bytearray:
        """Return for each chunk whether a part is there (1) or not (0); no part is read."""
        found = bytearray(self.chunks)
        for each in self.files():
            stem = each.name.partition(".")[0]
            if each.name.endswith(ENDING) and stem.isdecimal() and int(stem) < len(found) and each.is_file():
                found[int(stem)] = 1
        return found


def open_store(folder: Path) -> StudyStore:
    """Return the store in a folder."""
    record = read_checked(folder / RECORD, DAMAGED) if (folder / RECORD).is_file() else {}
    if "chunk" not in record:  # no store, or that of another long work
        raise FileError(str(folder), None, "this folder holds no study")
    return StudyStore(folder, record)


def begin(folder: Path, study: StudyFile, describe: Callable[[], dict[str, Any]]) -> StudyStore:
    """Return the store of a study in a folder, which is made unless it is there.

    Parameters
    ----------
    folder
        The folder.
    study
        The study.
    describe
        Called for the rest of the record where there is none yet. The size of a chunk is among it: it is decided once,
        by whoever comes first, since workers on other machines must cut the study into the same chunks.

    Raises
    ------
    FileError
        The store belongs to another study, or the folder is something else.
    """
    content = fingerprints(study.content())
    if not (folder / RECORD).exists():
        if folder.exists() and (not folder.is_dir() or any(each.name not in (PARTS, INPUTS) for each in _seen(folder))):
            raise FileError(str(folder), None, "this is no store of a study; give another folder with --store")
        record = {"content": content, "name": study.name, "count": study.design.count, **describe()}
        prepared_folder(folder)
        try:
            write_checked(folder / RECORD, record, new=True)
        except FileError:
            if not (folder / RECORD).exists():
                raise
    found = open_store(folder)
    check_study(found, study)
    for each in _handed_over(study):
        found.keep_input(each)
    return found


def check_study(store: StudyStore, study: StudyFile) -> None:
    """Refuse a store of another study; of a file that has changed it is said where."""
    before = store.record["provenance"]["files"]
    now = {f"file {name}": sum_ for name, sum_ in study.files().items()}
    contents = {each.sha256: each.content for each in _handed_over(study)}

    def change(name: str) -> str:
        key = name.removeprefix("file ")
        if name not in now or key not in before:
            return "" if name not in {*now, *(f"file {each}" for each in before)} else " (named in one of them alone)"
        return first_difference(store.input(before[key]), contents.get(now[name]))

    check_same(store.folder, fingerprints(study.content()), store.record["content"], OTHERWISE, change)


def arguments_of(store: StudyStore, study: StudyFile) -> tuple[str, str, str, list[tuple[str, str, int]]]:
    """Return what a worker is told: study, store, its identity, and path, fingerprint and size of all inputs."""
    files = [(path, each.sha256, each.size) for path, each in study.inputs.by_path().items()]
    return absolute(study.path), absolute(store.folder), store.identity, files


def _handed_over(study: StudyFile) -> list[InputFile]:
    return [each for each in study.inputs.files if not each.shipped]


def _seen(folder: Path) -> list[Path]:
    return [each for each in folder.iterdir() if not each.name.startswith(".")]
