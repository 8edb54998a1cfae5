"""CSV text a row at a time: every row with the line it begins at, whatever is in its cells."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path

from clubface.errors import FileError
from clubface.support.input_files import open_input
from clubface.tables.encodings import NAMES, SAMPLE, as_utf8, encoding_of, unicode_by_bytes
from clubface.tables.file_kind import START, refuse_no_table
from clubface.tables.rows import Reject

LONGEST_LINE = 2_000_000
"""Bytes; a longer line is no row of a table."""
MOST_CELLS = 2000
"""Of a row; the widest exports have some hundred columns."""
DECIMAL_ROWS = 200
"""Rows that tell how numbers are written."""

Row = tuple[list[str], int, str]
"""The cells of a row, the line it begins at, and its text."""


class CsvRows:
    """The rows of a CSV file, with commas, semicolons, tabs or bars between cells.

    Parameters
    ----------
    path
        The file.
    head_lines
        How many lines tell the delimiter; with more than one, a first line such as ``sep=;`` names it.
    delimiter
        The delimiter, where it is known.

    Attributes
    ----------
    delimiter
        Between cells: what most of the first lines have that are not blank.
    blank
        Blank lines passed over so far.
    encoding
        What the text is instead of UTF-8, as far as it is read, as people call it; else None.
    """

    def __init__(self, path: Path, *, head_lines: int = 1, delimiter: str | None = None) -> None:
        self.path = str(path)
        self.blank = 0
        self.encoding: str | None = None
        self._codec = ""
        self._line = 0
        self._file = open_input(path)
        self._size = self._file.seek(0, io.SEEK_END)
        try:
            self._start(path, head_lines, delimiter)
        except BaseException:
            self._file.close()
            raise

    @property
    def notes(self) -> tuple[str, ...]:
        """What a reader of the rows should know, as far as they are read."""
        return (f"the file is not UTF-8: read as {self.encoding}",) if self.encoding else ()

    def _start(self, path: Path, head_lines: int, delimiter: str | None) -> None:
        self._file.seek(0)
        start = self._file.read(START)
        refuse_no_table(path, start)
        unicode, mark = unicode_by_bytes(start)
        self._file.seek(mark)
        if unicode != "utf-8":
            with self._file as file:
                self._file = as_utf8(file, unicode, self.path)
            self._size = self._file.seek(0, 2)
            self._file.seek(0)
            self.encoding = NAMES[unicode]
        first, head = self._first_line()
        named = _separator(head) if head_lines > 1 else None
        if named:
            self._line += 1
            first, head = self._first_line()
        lines = [head, *(self._file.readline(LONGEST_LINE) for _ in range(head_lines - 1))]
        self._file.seek(first)
        self.delimiter = delimiter or named or delimiter_of([line.decode(errors="replace") for line in lines])
        self._raw: list[str] = []
        self._reader = csv.reader(self._decoded(self._line), delimiter=self.delimiter, strict=True)
        self._before = self._line

    def _first_line(self) -> tuple[int, bytes]:
        """Return the next line that is not blank and where it begins."""
        first = self._file.tell()
        head = self._file.readline(LONGEST_LINE)
        while head and not head.strip():
            first = self._file.tell()
            self._line += 1
            head = self._file.readline(LONGEST_LINE)
        return first, head

    def progress(self) -> float:
        """Return which part of the file has been read, 0 to 1."""
        return min(1.0, self._file.tell() / self._size) if self._size else 1.0

    def close(self) -> None:
        """Close the file."""
        self._file.close()

    def _decoded(self, line: int) -> Iterator[str]:
        """Yield the lines as text; what is not UTF-8 is in the encoding that makes words of it."""
        for raw in iter(partial(self._file.readline, LONGEST_LINE), b""):
            line += 1
            if len(raw) >= LONGEST_LINE:
                raise FileError(
                    self.path, line, f"this line is longer than {LONGEST_LINE // 1_000_000} MB: it is no table"
                )
            try:
                text = raw.decode()
            except UnicodeDecodeError:
                text = raw.decode(self._codec or self._decide_codec(raw), errors="replace")
            self._raw.append(text)
            self._check_row(text)
            yield text

    def _decide_codec(self, raw: bytes) -> str:
        """Decide the encoding of a line that is not UTF-8, by it and the next lines, and return it."""
        here = self._file.tell()
        more = self._file.read(SAMPLE)
        self._file.seek(here)
        self._codec = encoding_of(raw + more[: more.rfind(b"\n") + 1])
        self.encoding = NAMES[self._codec]
        return self._codec

    def _check_row(self, text: str) -> None:
        """Refuse a row, as far as it is read, that no table of shots has: its cells would fill the memory."""
        self._cells += text.count(self.delimiter)
        self._length += len(text)
        if self._cells >= MOST_CELLS:
            message = f"the row that begins here has some {self._cells + 1} cells; a table has at most {MOST_CELLS}"
        elif self._length >= LONGEST_LINE:
            message = f"the row that begins here is longer than {LONGEST_LINE // 1_000_000} MB"
        else:
            return
        raise FileError(self.path, self._begins, f"{message}: this is no table of shots")

    def next(self) -> Row | Reject | None:
        """Return the next row that is not blank and the line it begins at; one that is no CSV, all its text."""
        while True:
            self._begins = begins = self._before + self._reader.line_num + 1
            self._raw.clear()
            self._cells = self._length = 0
            try:
                cells = next(self._reader)
            except StopIteration:
                return None
            except csv.Error as error:
                if "new-line character" in str(error):
                    message = "lines end with a carriage return alone; save the file with usual line ends"
                    raise FileError(self.path, begins, message) from None
                return Reject(begins, _explained(str(error)), ["".join(self._raw)])
            if cells and not (len(cells) == 1 and not cells[0].strip("\x00")):  # zeros fill the end of a broken file
                text = self._raw[0] if len(self._raw) == 1 else "".join(self._raw)
                return (
                    Reject(begins, "zero bytes: the file is damaged", [text])
                    if "\x00" in text
                    else (cells, begins, text)
                )
            self.blank += 1


def delimiter_of(lines: Sequence[str]) -> str:
    """Return the delimiter that most lines have, outside quotes, and of such the one most frequent in a line.

    A decimal comma may be in every row, and more than once for each delimiter, but not in the header.
    """
    plain = ["".join(line.split('"')[::2]) for line in lines]
    counts = {each: [line.count(each) for line in plain] for each in ",;\t|"}
    return max(counts, key=lambda each: (sum(map(bool, counts[each])), max(counts[each])))


def _explained(message: str) -> str:
    if "unexpected end of data" in message:
        return "a quoted cell that begins here does not end"
    return f"this is not CSV: {message}"


def _separator(head: bytes) -> str | None:
    """Return the delimiter that a line such as ``sep=,`` names, or None where it is no such line."""
    text = head.decode(errors="replace").strip().strip('"')
    return text[4] if len(text) == 5 and text.lower().startswith("sep=") and text[4] in ",;|" else None
