"""File access: inputs are read once and recorded, outputs are written completely or not at all; built-in data files.

All user files (clubs, balls, heads, meshes, parameters, golfers, mappings, shots, studies, recordings) are opened here
and nowhere else. An active :class:`InputRecord` keeps the content that was read: editing a file meanwhile has no
effect, and the inputs of a result are known exactly. A worker receives the files that its command has read, and reads
no others.

An output is written under another name and renamed once it is complete on disk.
"""

from __future__ import annotations

import hashlib
import io
import os
import stat
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from contextvars import ContextVar
from functools import wraps
from pathlib import Path
from typing import BinaryIO, NamedTuple, ParamSpec, TextIO, TypeVar

from clubface.errors import LINES, FileError, legible
from clubface.support.checks import check_choice


def prepared_folder(folder: str | os.PathLike[str]) -> Path:
    """Create the folder; report a failure before any work is done."""
    path = Path(folder)
    try:
        path.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        raise FileError(str(path), None, "this is a file; give the name of a folder") from None
    if not os.access(path, os.W_OK):
        raise FileError(str(path), None, "this folder cannot be written to")
    return path


DATA = Path(__file__).parent.parent / "data"


def builtin_names(folder: str) -> tuple[str, ...]:
    """List the names of the built-in descriptions in ``data/<folder>``, in alphabetical order."""
    return tuple(sorted(path.stem for path in (DATA / folder).glob("*.toml")))


def builtin_path(what: str, name: object, folder: str, known: Iterable[str] | None = None) -> Path:
    """Return the file of the built-in description ``name`` in ``data/<folder>``; ``what`` describes it in errors."""
    names = tuple(known or builtin_names(folder))
    check_choice(what, name, names)
    return DATA / folder / f"{name}.toml"


def is_path(name: object) -> bool:
    """Return whether a value is a path, as opposed to a built-in name."""
    return isinstance(name, os.PathLike) or (
        isinstance(name, str) and (name.endswith(".toml") or "/" in name or os.sep in name)
    )


def resolve_name(name: str, folder: Path) -> str | Path:
    """Return a built-in name unchanged, and a path from a file relative to the folder of that file."""
    return folder / name if is_path(name) else name


def path_of(what: str, name: str | os.PathLike[str], folder: str) -> str | os.PathLike[str]:
    """Return a path unchanged, or the path of the built-in description ``name`` in ``data/<folder>``."""
    return name if is_path(name) else builtin_path(what, name, folder)


P = ParamSpec("P")
R = TypeVar("R")
LARGEST_KEPT = 32_000_000
"""Maximum size of a file whose content is kept [bytes]. Larger files, such as a table of a million shots, are read in
blocks, and refused if they change meanwhile."""
MOST_KEPT = 256_000_000
"""Maximum total size of the contents kept by a computation [bytes]; further files are treated like large ones."""
PIECE = 1_000_000
"""Size of the blocks in which files are read [bytes]."""
CHANGED = "this file was changed while it was read; start again"
NOT_A_FILE = "a pipe cannot be read twice, and a device has no end; save it as a file first"


class InputFile(NamedTuple):
    """A file that was read.

    Attributes
    ----------
    path
        Path as requested: as typed, or relative to the folder of the file that names it.
    place
        Path with symbolic links resolved: the same for all paths to one file.
    size
        Size [bytes].
    sha256
        SHA-256 of its content.
    shipped
        Whether it belongs to the package, so that the version identifies its content.
    content
        Its bytes; None if the file is larger than ``LARGEST_KEPT``, or was read after ``MOST_KEPT`` bytes had been
        kept.
    """

    path: str
    place: str
    size: int
    sha256: str
    shipped: bool
    content: bytes | None


class InputRecord:
    """The files that a computation reads, each with the content of the first read.

    While it is active, :func:`read_input` and :func:`open_input` return the content that it holds, and add new files to
    it. A record made while another is active shares its files and adds to both.

    Parameters
    ----------
    given
        Files by requested path. The record is then closed: nothing else is read, except files of the package.
    """

    def __init__(self, given: Mapping[str, InputFile] | None = None) -> None:
        self._files = dict(given or {})
        self._closed = given is not None
        self._around = None if self._closed else _ACTIVE.get()
        self._lock = threading.RLock()

    @property
    def files(self) -> tuple[InputFile, ...]:
        """The files in the order of reading, each once, even if it was opened under several names."""
        result: dict[str, InputFile] = {}
        with self._lock:
            for each in self._files.values():
                result.setdefault(each.place, each)
        return tuple(result.values())

    def add(self, files: Iterable[InputFile]) -> None:
        """Add files that were read earlier."""
        with self._lock:
            for each in files:
                self._files.setdefault(absolute(each.path), each)

    def by_path(self) -> dict[str, InputFile]:
        """Return the files by the requested path, without those that come with the package."""
        with self._lock:
            return {path: each for path, each in self._files.items() if not each.shipped}

    def close(self) -> None:
        """Close the record: further reads raise an error, so that results depend only on the files loaded so far."""
        self._closed = True

    @contextmanager
    def active(self) -> Iterator[InputRecord]:
        """Record all reads within the block, on this thread and on threads that inherit its context."""
        before = _ACTIVE.set(self)
        try:
            yield self
        finally:
            _ACTIVE.reset(before)

    def file(self, path: str, most: int) -> InputFile:
        """Return a file as it was first read; ``most`` is the largest size allowed [bytes]."""
        key = absolute(path)
        with self._lock:
            if (result := self._files.get(key)) is None:
                if self._closed and not _is_shipped(place_of(path)):
                    raise FileError(path, None, "this file was not there, or not named, when the computation began")
                result = _load(path, most) if self._around is None else self._around.file(path, most)
                if sum(len(each.content or b"") for each in self._files.values()) > MOST_KEPT:
                    result = result._replace(content=None)
                same = next((each for each in self._files.values() if each.place == result.place), None)
                self._files[key] = result if same is None else same._replace(path=path)
        return result._replace(path=path)


_ACTIVE: ContextVar[InputRecord | None] = ContextVar("input_record", default=None)


def recorded(compute: Callable[P, R]) -> Callable[P, R]:
    """Make a computation read each file only once, no matter how often it is requested.

    Within another recorded computation, it adds to that record.
    """

    @wraps(compute)
    def wrapped(*args: P.args, **options: P.kwargs) -> R:
        if _ACTIVE.get() is not None:
            return compute(*args, **options)
        with InputRecord().active():
            return compute(*args, **options)

    return wrapped


def count_as_read(files: Iterable[InputFile]) -> None:
    """Record files that an earlier run has read, because the running computation uses its results."""
    if (record := _ACTIVE.get()) is not None:
        record.add(files)


def recorded_files() -> tuple[InputFile, ...]:
    """Return the files that the running computation has read so far; empty if nothing is recorded."""
    record = _ACTIVE.get()
    return () if record is None else record.files


def input_file(path: str | os.PathLike[str], *, most: int | None = None) -> InputFile:
    """Return a file with its fingerprint; within a recorded computation, as it was when first read.

    Parameters
    ----------
    path
        The file.
    most
        Maximum size [bytes]. Default: unlimited.

    Raises
    ------
    FileError
        The file does not exist, is not a regular file, is too large, or cannot be read.
    """
    name = os.fspath(path)
    record = _ACTIVE.get()
    limit = most if most is not None else 2**63
    result = _load(name, limit) if record is None else record.file(name, limit)
    if result.size > limit:
        raise _too_large(name, limit)
    return result


def read_input(path: str | os.PathLike[str], *, most: int | None = None) -> bytes:
    """Return the bytes of a file; see :func:`input_file`."""
    result = input_file(path, most=most)
    if result.content is not None:
        return result.content
    with open_input(path) as file:
        return file.read()


def open_input(path: str | os.PathLike[str]) -> BinaryIO:
    """Open a file for reading; see :func:`input_file`. A large file that changes while it is read is refused."""
    result = input_file(path)
    if result.content is not None:
        return io.BytesIO(result.content)
    raw = _Unchanging(result.path)
    if _checksum(raw) != result.sha256:
        raise FileError(result.path, None, CHANGED)
    raw.seek(0)
    return io.BufferedReader(raw, PIECE)


@contextmanager
def as_local_file(path: str | os.PathLike[str]) -> Iterator[str]:
    """Yield the path of a local file with the bytes of :func:`read_input`, for libraries that open files themselves."""
    content = read_input(path)
    with tempfile.TemporaryDirectory(prefix="clubface-") as folder:
        name = os.path.join(folder, os.path.basename(path))
        Path(name).write_bytes(content)
        yield name


def short_names(paths: Sequence[str]) -> list[str]:
    """Return file names without folders, except for the parts needed to tell files of the same name apart.

    ``a/anna.toml``, ``b/anna.toml`` and ``a/my.toml`` give ``a/anna.toml``, ``b/anna.toml`` and ``my.toml``.
    """
    parts = [Path(each).parts for each in paths]
    names = []
    for each in parts:
        others = [other for other in parts if other != each]
        length = 1
        while length < len(each) and any(other[-length:] == each[-length:] for other in others):
            length += 1
        names.append("/".join(each[-length:]))
    return names


def file_stem(name: str) -> str:
    """Return ``name`` with characters that file names cannot contain replaced by hyphens."""
    kept = "".join(letter if letter.isalnum() or letter in "-_ ." else "-" for letter in name).strip(" .")
    return kept[:100] or "case"


def absolute(path: str | os.PathLike[str]) -> str:
    """Return an absolute path; symbolic links in it are kept."""
    return os.fspath(Path.cwd() / path)


def same_file(one: str | os.PathLike[str], other: str | os.PathLike[str]) -> bool:
    """Return whether two paths lead to the same file, whether or not it exists."""
    return place_of(one) == place_of(other)


def place_of(path: str | os.PathLike[str]) -> str:
    """Return the path of a file, existing or not, with symbolic links resolved."""
    try:
        return os.path.realpath(path)
    except (OSError, ValueError):  # not a valid file name
        return absolute(path)


def _is_shipped(place: str) -> bool:
    return place.startswith(_SHIPPED)


_SHIPPED = os.path.join(os.path.realpath(DATA), "")


def _load(name: str, most: int) -> InputFile:
    """Read a regular file; anything else raises FileError, so that reading never blocks."""
    with _Unchanging(name) as file:
        if file.size > most:
            raise _too_large(name, most)
        content = None
        try:
            if file.size > LARGEST_KEPT:
                sum_ = _checksum(file)
            else:
                content = _read_whole(file, min(most, LARGEST_KEPT))
                sum_ = hashlib.sha256(content).hexdigest()
        except OSError as error:
            raise unreadable(name, error) from None
    place = place_of(name)
    size = file.size if content is None else len(content)
    return InputFile(name, place, size, sum_, _is_shipped(place), content)


def unreadable(name: str, error: Exception) -> FileError:
    """Return the error for a file that cannot be read."""
    reason = getattr(error, "strerror", None) or str(error)
    if os.path.isdir(name):  # which Windows calls a lack of rights
        reason = "this is a folder"
    elif "\0" in name:
        reason = "a file name cannot contain the character \\u0000"
    return FileError(name, None, f"cannot be read: {reason}")


def _too_large(name: str, most: int) -> FileError:
    return FileError(name, None, f"this file is larger than {most // 1000} kB; it cannot be the right one")


def _read_whole(file: _Unchanging, most: int) -> bytes:
    """Return the bytes of a file; raise FileError for endless ones, such as some device files."""
    result = file.read(min(file.size, most) + 1)  # in one call, so that only one copy is in memory
    while len(result) <= most and (piece := file.read(PIECE)):
        result += piece
    if len(result) > most:
        raise _too_large(str(file.name), most)
    return result


def _checksum(file: _Unchanging) -> str:
    made = hashlib.sha256()
    while piece := file.read(PIECE):
        made.update(piece)
    return made.hexdigest()


class _Unchanging(io.FileIO):
    """A file that must not change between opening and the end of reading."""

    def __init__(self, path: str) -> None:
        self._path = path
        try:
            super().__init__(path, "rb", opener=_open_without_waiting)
            state = os.fstat(self.fileno())
        except (OSError, ValueError) as error:
            raise unreadable(path, error) from None
        if not stat.S_ISREG(state.st_mode):
            self.close()
            raise FileError(path, None, f"cannot be read: {NOT_A_FILE}")
        self.size = state.st_size
        self._state = (state.st_size, state.st_mtime_ns)

    def readinto(self, buffer: bytearray | memoryview, /) -> int | None:  # pyright: ignore[reportIncompatibleMethodOverride]
        """Read on."""
        return self._checked(super().readinto(buffer))

    def read(self, size: int | None = -1, /) -> bytes:
        """Read on."""
        return self._checked(super().read(-1 if size is None else size)) or b""

    def readall(self) -> bytes:
        """Read to the end."""
        return self._checked(super().readall()) or b""

    def _checked(self, result: R) -> R:
        """Return the data read, after checking that the file has not changed."""
        state = os.fstat(self.fileno())
        if (state.st_size, state.st_mtime_ns) != self._state:
            raise FileError(self._path, None, CHANGED)
        return result


def _open_without_waiting(path: str, flags: int) -> int:
    """Open a file without blocking, as opening a pipe without a writer would."""
    return os.open(path, flags | getattr(os, "O_NONBLOCK", 0))


def given_files(files: Iterable[tuple[str, str, int]], contents: Path) -> dict[str, InputFile]:
    """Return a closed record of files, given path, fingerprint and size of each and the folder of their contents.

    A file whose content is missing is read from its path, if it is unchanged.

    Raises
    ------
    FileError
        A stored content is damaged.
    """
    result = {}
    for path, sum_, size in files:
        content = None
        if (kept := contents / sum_).exists():
            content = _load(str(kept), LARGEST_KEPT).content
            if content is None or hashlib.sha256(content).hexdigest() != sum_:
                raise FileError(str(kept), None, "this copy of an input is damaged; remove it and start again")
        result[path] = InputFile(path, os.path.realpath(path), size, sum_, False, content)
    return result


Name = str | os.PathLike[str]


def unwritable(path: Name, error: OSError) -> FileError:
    """Return the error for a file that cannot be written."""
    if isinstance(error, FileExistsError):
        return FileError(os.fspath(path), None, "this file exists already; it is left as it is")
    hint = "; close it in other programs" if getattr(error, "winerror", None) in IN_USE else ""
    return FileError(os.fspath(path), None, f"cannot be written: {error.strerror or error}{hint}")


IN_USE = (5, 32)
"""How Windows refuses to replace a file that another program has opened: access denied, sharing violation."""
PATIENCE = 2.0 if sys.platform == "win32" else 0.0
"""Time [s] that such a program has to close it: those of this package read a file and close it at once."""


def _replaced(fresh: Path, target: Path) -> None:
    """Give a file the name of another."""
    ends = time.monotonic() + PATIENCE
    while True:
        try:
            return os.replace(fresh, target)
        except PermissionError:
            if time.monotonic() >= ends:
                raise
        time.sleep(0.01)


@contextmanager
def whole_file(path: Name, *, folder: Path | None = None, new: bool = False) -> Iterator[BinaryIO]:
    """Open a file for writing that replaces ``path`` when the block ends and all data are on disk.

    If the block raises an error, or the disk is full, the previous file remains. Libraries that need a path can use the
    ``name`` of the file yielded.

    Parameters
    ----------
    path
        Final path. Links are followed; devices and pipes raise FileError.
    folder
        Folder for the temporary file, on the same disk. Default: the folder of ``path``.
    new
        Whether an existing file is an error.

    Raises
    ------
    FileError
        The file cannot be written, or is an input of the computation that writes it.
    """
    target = Path(os.path.realpath(path))
    if os.fspath(target) in {each.place for each in recorded_files()}:
        raise FileError(os.fspath(path), None, "this is an input of the command; give another file")
    try:
        mode = _mode_of(target, new)
        fresh = (folder or target.parent) / f".{target.stem[:100]}-{os.urandom(6).hex()}{target.suffix}"
        file = open(fresh, "x+b")  # noqa: SIM115, it is closed below
    except OSError as error:
        raise unwritable(path, error) from None
    try:
        with file:
            yield file
            file.flush()
            if mode is not None and os.name != "nt":  # which has no rights but to write, or else nothing is replaced
                os.chmod(fresh, mode)
            os.fsync(file.fileno())
        if new:
            os.link(fresh, target)
            os.unlink(fresh)
        else:
            _replaced(fresh, target)
        synced(target.parent)
    except BaseException as error:
        with suppress(OSError):
            os.unlink(fresh)
        if isinstance(error, OSError):
            raise unwritable(path, error) from None
        raise


@contextmanager
def whole_text(path: Name) -> Iterator[TextIO]:
    """Open a UTF-8 text file; line endings are written unchanged. See :func:`whole_file`."""
    with whole_file(path) as file:
        text = io.TextIOWrapper(file, encoding="utf-8", newline="", write_through=True)
        yield text
        text.detach()


def write_text(path: Name, text: str, *, encoding: str = "utf-8", new: bool = False) -> Path:
    """Write a text file completely or not at all; return its path. Control characters are escaped."""
    with whole_file(path, new=new) as file:
        file.write(legible(text, LINES).encode(encoding))
    return Path(path)


def synced(folder: Path) -> None:
    """Flush a folder's entries to disk, if the system can."""
    with suppress(OSError):
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def _mode_of(target: Path, new: bool) -> int | None:
    """Return the permissions of an existing file, or None; raise FileError for anything but a regular file."""
    try:
        result = target.stat()
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(result.st_mode):
        raise FileError(str(target), None, "this is a folder; give the name of a file")
    if not stat.S_ISREG(result.st_mode):
        raise FileError(str(target), None, "this is a device or a pipe; give the name of a file")
    if new:
        raise FileExistsError
    return stat.S_IMODE(result.st_mode)
