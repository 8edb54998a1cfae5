"""Tables read a chunk at a time, every row with the line at which it begins: CSV in any encoding, Excel, Parquet.

The kind of a file is decided by its content, not by its name. Unicode is recognised by its byte order mark or its zero
bytes; any other encoding is the one in which the bytes form words. Only this module needs openpyxl.
"""

from __future__ import annotations

import codecs
import csv
import datetime
import io
import re
import tempfile
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from itertools import islice
from pathlib import Path
from typing import Any, BinaryIO

from clubface.errors import FileError, shortened
from clubface.results.notes import Note, note
from clubface.shots.tables.cells import Chunk, Reject, decimals_of, doubt, ragged_reason
from clubface.shots.tables.file_kind import START, is_workbook, refuse_no_table
from clubface.shots.tables.headings import shot_words
from clubface.shots.tables.parquet import ENDINGS, ParquetReader
from clubface.shots.tables.writer import csv_lines
from clubface.support.checks import without_foreign_warnings
from clubface.support.files import open_input

SAMPLE = 1 << 18
"""Number of bytes used to find the encoding of text that is not UTF-8."""
IN_MEMORY = 1 << 25
"""Maximum size of transcoded text held in memory [bytes]; more goes to a temporary file."""
NAMES = {
    "cp1252": "Windows-1252", "mac_roman": "Mac Roman", "cp932": "Shift-JIS", "gb18030": "GBK", "big5": "Big5",
    "cp949": "EUC-KR", "utf-16-le": "UTF-16", "utf-16-be": "UTF-16", "utf-32-le": "UTF-32", "utf-32-be": "UTF-32",
}  # fmt: skip
"""Encodings read besides UTF-8, with their common names."""
FALLBACK = "cp1252"

_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
_LATIN = re.compile("[ÄÖÜäöüßÀÂÇÈÉÊËÎÏÔŒÙÛàâçèéêëîïôœùûÁÍÑÓÚáíñóúÅÆØåæøÃÕãõìò°º²’‘“”–—½\xa0]")
_EVERYDAY: Mapping[str, re.Pattern[str]] = {
    "cp932": re.compile(
        "[ぁ-んァ-ヶー・番号球速度距離飛打出角回転数初高左右日時間名合計平均率最大総曲幅入射方向横縦残地点℃°]"
    ),
    "gb18030": re.compile(
        "[球杆速度距离角铁木号日期时间总飞行高左右旋转击打出面路径效率侧后倒平均最大落点偏差向程挖起推发°]"
    ),
    "big5": re.compile(
        "[球桿速度距離角鐵木號日期時間總飛行高左右旋轉擊打出面路徑效率側後倒平均最大落點偏差向程挖起推發°]"
    ),
    "cp949": re.compile(
        "[볼클럽스피드거리각도비캐리발사런치스핀량축방향아이언드라버우웨지번시간날짜총최고높좌회전수백사이헤팩터샷°]"
    ),
    "cp1252": _LATIN,
    "mac_roman": _LATIN,
}
"""Characters typical of tables of golf shots, by encoding; a wrong encoding gives other characters. Of several that fit
equally well the first counts, as two-byte characters do not form everyday words by accident."""
LARGEST_CHUNK = 64_000_000
"""Number of characters after which a chunk ends early, so that long rows do not fill the memory."""


def unicode_by_bytes(start: bytes) -> tuple[str, int]:
    """Return the Unicode encoding of a text from its first bytes, and the length of its byte order mark.

    Text without a mark is UTF-16 if many even or odd bytes are zero, as for digits and commas, and few of the others;
    otherwise it is provisionally UTF-8.
    """
    for mark, encoding in _MARKS:
        if start.startswith(mark):
            return encoding, len(mark)
    pairs = len(start) // 2
    zeros = [start[0::2].count(0), start[1::2].count(0)]
    for place, encoding in ((1, "utf-16-le"), (0, "utf-16-be")):
        if pairs > 3 and zeros[place] > 0.1 * pairs and zeros[1 - place] < 0.25 * zeros[place]:
            return encoding, 0
    return "utf-8", 0


def as_utf8(file: BinaryIO, encoding: str, path: str) -> BinaryIO:
    """Return a file with the remaining text of another, in UTF-8."""
    decoder = codecs.getincrementaldecoder(encoding)()
    text = tempfile.SpooledTemporaryFile(IN_MEMORY)  # noqa: SIM115 - it is returned open
    try:
        while chunk := file.read(SAMPLE):
            text.write(decoder.decode(chunk).encode())
        text.write(decoder.decode(b"", True).encode())
    except (UnicodeError, OSError) as error:
        text.close()
        what = "is damaged" if isinstance(error, UnicodeError) else f"cannot be read: {error.strerror}"
        raise FileError(path, None, f"this {NAMES[encoding]} text {what}; save it as CSV UTF-8") from None
    text.seek(0)
    return text  # pyright: ignore[reportReturnType]


def encoding_of(text: bytes) -> str:
    """Return the encoding, other than UTF-8, in which a text has most characters typical of tables of shots.

    It must decode the whole text, and half of the non-ASCII characters must be typical; else it is Windows-1252.
    """
    scores = {name: _score(text, name) for name in _EVERYDAY}
    best = max(scores, key=lambda name: scores[name])
    return best if scores[best] >= 0.5 else FALLBACK


def _score(text: bytes, encoding: str) -> float:
    """Return the share of non-ASCII characters that are typical; -1 if the text cannot be decoded."""
    try:
        beyond = re.sub(r"[\x00-\x7f]+", "", text.decode(encoding))
    except UnicodeDecodeError:
        return -1.0
    return len(_EVERYDAY[encoding].findall(beyond)) / max(len(beyond), 1)


LONGEST_LINE = 2_000_000
"""Maximum length of a line [bytes]."""
MOST_CELLS = 2000
"""Maximum number of cells in a row; the widest exports have some hundred columns."""
DECIMAL_ROWS = 200
"""Number of rows inspected to find out how numbers are written."""

Row = tuple[list[str], int, str]
"""The cells of a row, the line it begins at, and its text."""


class CsvRows:
    """The rows of a CSV file, with commas, semicolons, tabs or bars between cells.

    The default delimiter is the one in most of the first ``head_lines`` non-blank lines; a first line such as ``sep=;``
    can also set it. ``blank`` counts the blank lines skipped so far, and ``encoding`` is the common name of an encoding
    other than UTF-8, if one has been found so far.
    """

    def __init__(self, path: Path, *, head_lines: int = 1, delimiter: str | None = None) -> None:
        self.path = str(path)
        self.blank = 0
        self.encoding: str | None = None
        self._codec = ""
        self._line = 0
        self._file = open_input(path)
        try:
            self._start(path, head_lines, delimiter)
        except BaseException:
            self._file.close()
            raise

    @property
    def notes(self) -> tuple[Note, ...]:
        """Notes on the rows read so far."""
        return (note("not-utf-8", encoding=self.encoding),) if self.encoding else ()

    def _start(self, path: Path, head_lines: int, delimiter: str | None) -> None:
        start = self._file.read(START)
        refuse_no_table(path, start)
        unicode, mark = unicode_by_bytes(start)
        self._file.seek(mark)
        if unicode != "utf-8":
            with self._file as file:
                self._file = as_utf8(file, unicode, self.path)
            self.encoding, mark = NAMES[unicode], 0
        self._size = self._file.seek(0, io.SEEK_END)
        self._file.seek(mark)
        first, head = self._first_line()
        only = head.decode(errors="replace").strip().strip('"').lower()
        named = only[4] if head_lines > 1 and re.fullmatch("sep=[,;|]", only) else None
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
        """Return the next line that is not blank, and its line number."""
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
        """Yield the lines as text, in UTF-8 or the encoding found for the file."""
        for raw in iter(partial(self._file.readline, LONGEST_LINE), b""):
            line += 1
            if len(raw) >= LONGEST_LINE:
                message = f"this line is longer than {LONGEST_LINE // 1_000_000} MB: it is not a table"
                raise FileError(self.path, line, message)
            try:
                text = raw.decode()
            except UnicodeDecodeError:
                text = raw.decode(self._codec or self._decide_codec(raw), errors="replace")
            self._raw.append(text)
            self._check_row(text)
            yield text

    def _decide_codec(self, raw: bytes) -> str:
        """Find the encoding from a line that is not UTF-8 and the next ones, and return it."""
        here = self._file.tell()
        more = self._file.read(SAMPLE)
        self._file.seek(here)
        self._codec = encoding_of(raw + more[: more.rfind(b"\n") + 1])
        self.encoding = NAMES[self._codec]
        return self._codec

    def _check_row(self, text: str) -> None:
        """Raise an error for a row too large for a table of shots, before its cells fill the memory."""
        self._cells += text.count(self.delimiter)
        self._length += len(text)
        if self._cells >= MOST_CELLS:
            message = f"the row that begins here has some {self._cells + 1} cells; a table has at most {MOST_CELLS}"
        elif self._length >= LONGEST_LINE:
            message = f"the row that begins here is longer than {LONGEST_LINE // 1_000_000} MB"
        else:
            return
        raise FileError(self.path, self._begins, f"{message}: this is not a table of shots")

    def next(self) -> Row | Reject | None:
        """Return the next row that is not blank, with line and text; for invalid CSV, a reject with all its text."""
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
                is_open = "unexpected end of data" in str(error)
                reason = "a quoted cell that begins here does not end" if is_open else f"this is not CSV: {error}"
                return Reject(begins, reason, ["".join(self._raw)])
            if cells and not (len(cells) == 1 and not cells[0].strip("\x00")):  # a broken file may end in zeros
                text = self._raw[0] if len(self._raw) == 1 else "".join(self._raw)
                if "\x00" in text:
                    return Reject(begins, "zero bytes: the file is damaged", [text])
                return cells, begins, text
            self.blank += 1


def delimiter_of(lines: Sequence[str]) -> str:
    """Return the delimiter in most lines, outside quotes; among equals, the most frequent one in a line.

    Decimal commas may be more frequent than the delimiter in every row, but not in the header.
    """
    plain = ["".join(line.split('"')[::2]) for line in lines]
    counts = {each: [line.count(each) for line in plain] for each in ",;\t|"}
    return max(counts, key=lambda each: (sum(map(bool, counts[each])), max(counts[each])))


LARGEST, LARGEST_PART = 1_000_000_000, 100_000_000
"""Maximum unpacked size of a workbook [bytes], and of each part except sheets, which are read row by row."""
SEARCHED = 200
"""Number of rows within which the table of a sheet must begin."""


class WorkbookRows:
    """The rows of the first sheet with a table, with numbers as text with a decimal point. See :class:`CsvRows`."""

    delimiter = ","
    encoding: str | None = None

    def __init__(self, path: Path) -> None:
        self.path = str(path)
        self.blank = 0
        try:
            from openpyxl import load_workbook
        except ImportError:
            message = 'an Excel workbook needs openpyxl, pip install "clubface[excel]"; or save the sheet as CSV'
            raise FileError(self.path, None, message) from None
        self._file = open_input(path)
        try:
            with zipfile.ZipFile(self._file) as archive:
                sizes = {each.filename: each.file_size for each in archive.infolist()}
            parts = [size for name, size in sizes.items() if not name.startswith("xl/worksheets/")]
            if sum(sizes.values()) > LARGEST or max(parts) > LARGEST_PART:
                message = f"this workbook has {sum(sizes.values()) // 1_000_000} MB unpacked; save the sheet as CSV"
                raise FileError(self.path, None, message)
            with without_foreign_warnings():  # on styles and extensions that openpyxl ignores
                self._book: Any = load_workbook(self._file, read_only=True, data_only=True)
        except Exception as error:  # openpyxl passes on any error of its XML and ZIP readers
            self._file.close()
            raise self._damaged(error) from None
        try:
            sheets = [each for each in self._book.worksheets if self._has_table(each)]
            if not sheets:
                raise FileError(self.path, None, "no sheet of this workbook has a table, with names above numbers")
            self._rows = self._cells(sheets[0])
            self._count = max(sheets[0].max_row or 1, 1)
        except BaseException:
            self.close()
            raise
        sheet, *others = (shortened(each.title, 40) for each in sheets)
        self.notes: tuple[Note, ...] = (note("sheet-read", sheet=sheet, others=others),) if others else ()
        self._line = 0

    def next(self) -> Row | Reject | None:
        """Return the next row that is not blank, with its number and its cells as a CSV line."""
        for cells in self._rows:
            self._line += 1
            if any(cells):
                return cells, self._line, csv_lines([cells], self.delimiter).decode()
            self.blank += 1
        return None

    def progress(self) -> float:
        """Return the share of the sheet that has been read, 0 to 1."""
        return min(1.0, self._line / self._count)

    def close(self) -> None:
        """Close the workbook."""
        self._book.close()
        self._file.close()

    def _has_table(self, sheet: Any) -> bool:
        """Return whether a sheet begins with a row of two names or more and a number below it."""
        named = False
        for cells in islice(self._cells(sheet), SEARCHED):
            words = sum(any(map(str.isalpha, each)) for each in cells)
            if named and any(map(str.isdigit, "".join(cells))):
                return True
            named |= words >= 2
        return False

    def _cells(self, sheet: Any) -> Iterator[list[str]]:
        """Yield the rows of a sheet, padded to its widest named row so far, without empty cells beyond."""
        width = 0
        try:
            sheet.reset_dimensions()  # programs write wrong dimensions
            for row in sheet.iter_rows(values_only=True):
                cells = [_text(each) for each in row]
                while cells and not cells[-1]:
                    cells.pop()
                if len(cells) > MOST_CELLS:
                    message = f"a row has {len(cells)} cells; a table has at most {MOST_CELLS}"
                    raise FileError(self.path, None, message)
                width = max(width, len(cells))
                yield cells + [""] * (width - len(cells))
        except FileError:
            raise
        except Exception as error:  # as above, since sheets are read row by row
            raise self._damaged(error) from None

    def _damaged(self, error: Exception) -> FileError:
        if isinstance(error, FileError):
            return error
        reason = (str(error).splitlines() or [type(error).__name__])[0]
        return FileError(self.path, None, f"this Excel workbook cannot be read: {shortened(reason, 80)}")


def _text(value: object) -> str:
    """Return the value of a cell as CSV text."""
    match value:
        case None:
            return ""
        case bool():
            return str(value).upper()
        case float():
            return f"{value:.15g}"  # 0.1 + 0.2 as Excel shows it
        case datetime.datetime():
            return str(value.replace(microsecond=0))
        case _:
            return str(value)


RowSource = CsvRows | WorkbookRows
"""The rows of a file, one after the other."""


def open_rows(path: Path, *, head_lines: int = 1, delimiter: str | None = None) -> RowSource:
    """Open the rows of a file; the options, as for :class:`CsvRows`, apply to text."""
    return WorkbookRows(path) if is_workbook(path) else CsvRows(path, head_lines=head_lines, delimiter=delimiter)


class CsvReader:
    """A CSV file, with commas, semicolons, tabs or bars between cells, or a workbook, read in chunks of rows."""

    counts = "line"

    def __init__(self, path: Path) -> None:
        self.path = str(path)
        self._rows = open_rows(path)
        self.delimiter = self._rows.delimiter
        try:
            row = self._rows.next()
            if row is None:
                raise FileError(self.path, 1, "the file is empty: its first row must name the columns")
            if isinstance(row, Reject):
                raise FileError(self.path, row.line, row.reason)
            self.headings = row[0]
            self.header_line: int | None = row[1]
            self._seen = [*islice(iter(self._rows.next, None), DECIMAL_ROWS)]
            quantities = [*map(shot_words().quantity, self.headings)]
            rows = (row[0] for row in self._seen if not isinstance(row, Reject))
            cells = (each for row in rows for each in zip(row, quantities, strict=False))
            self.decimal_comma, self._doubtful = decimals_of(cells, self.delimiter)
        except BaseException:
            self._rows.close()
            raise

    @property
    def blank(self) -> int:
        """Number of blank lines skipped so far."""
        return self._rows.blank

    @property
    def notes(self) -> tuple[Note, ...]:
        """Notes on the file, as far as it has been read."""
        return (*self._rows.notes, *([doubt(self._doubtful)] if self._doubtful else []))

    def chunks(self, rows: int, skip: int) -> Iterator[Chunk]:
        """Yield chunks of ``rows`` rows, after skipping the first ``skip``."""
        width = len(self.headings)
        passed = 0
        at_end = False
        while not at_end:
            kept: list[list[str]] = []
            lines: list[int] = []
            written: list[str] = []
            ragged: list[Reject] = []
            size = 0
            for _ in range(rows if passed >= skip else min(rows, skip - passed)):
                row = self._seen.pop(0) if self._seen else self._rows.next()
                if row is None:
                    at_end = True
                    break
                if isinstance(row, Reject):
                    ragged.append(row._replace(cells=[*row.cells, *[""] * width][:width]))
                    continue
                cells, line, text = row
                size += len(text)
                if len(cells) == width:
                    kept.append(cells)
                    lines.append(line)
                    written.append(text)
                else:
                    ragged.append(Reject(line, ragged_reason(cells, width), [*cells, *[""] * width][:width]))
                if size > LARGEST_CHUNK:
                    break
            count = len(kept) + len(ragged)
            if passed >= skip and count:
                columns = list(zip(*kept, strict=True)) or [()] * width
                yield Chunk(lines, columns, ragged, self.decimal_comma, written)
            passed += count

    def progress(self) -> float:
        """Return the share of the file that has been read, 0 to 1."""
        return self._rows.progress()

    @property
    def types(self) -> list[None]:
        """Arrow types of the columns; None for text."""
        return [None] * len(self.headings)

    def close(self) -> None:
        """Close the file."""
        self._rows.close()


Reader = CsvReader | ParquetReader
"""A table read in chunks."""


def open_table(path: Path) -> Reader:
    """Open a table, Parquet by its ending, else CSV or a workbook."""
    if path.suffix.lower() in ENDINGS:
        return ParquetReader(path)
    return CsvReader(path)
