"""Recognising files by their first bytes, whatever their name: a table, a workbook, or something else."""

from __future__ import annotations

import re
import zipfile
from pathlib import Path

from clubface.errors import FileError, shortened
from clubface.support.files import open_input

START = 4096
"""Number of bytes read to recognise a file."""
_WORKBOOK, _SAVE = "save the sheet as .xlsx or CSV", "export the shots as CSV"
_SIGNATURES: tuple[tuple[bytes, str], ...] = (
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", f"an Excel workbook of the old kind (.xls); {_WORKBOOK}"),
    (b"\x09\x08", f"an Excel workbook of the old kind (.xls); {_WORKBOOK}"),
    (b"\x1f\x8b", "compressed by gzip; unpack it first"),
    (b"BZh91AY&SY", "compressed by bzip2; unpack it first"),
    (b"\xfd7zXZ\x00", "compressed by xz; unpack it first"),
    (b"\x28\xb5\x2f\xfd", "compressed by zstd; unpack it first"),
    (b"7z\xbc\xaf\x27\x1c", "a 7-Zip archive; unpack it first"),
    (b"Rar!\x1a\x07", "a RAR archive; unpack it first"),
    (b"%PDF", f"a PDF document; {_SAVE}"),
    (b"{\\rtf", f"an RTF document; {_SAVE}"),
    (b"SQLite format 3\x00", f"an SQLite database; {_SAVE}"),
    (b"\x89PNG\r\n", f"a PNG picture; {_SAVE}"),
    (b"\xff\xd8\xff", f"a JPEG picture; {_SAVE}"),
    (b"GIF8", f"a GIF picture; {_SAVE}"),
    (b"\x89HDF\r\n", f"an HDF5 file; {_SAVE}"),
    (b"\x93NUMPY", f"an array of NumPy; {_SAVE}"),
    (b"MATLAB 5.0", f"a file of MATLAB; {_SAVE}"),
    (b"ARROW1", "an Arrow file; save it as Parquet or CSV"),
    (b"PAR1", "a Parquet file; its name must end in .parquet"),
)
_MARKUP = (
    (re.compile(rb"<(!doctype\s+html|html|head|body|table|div|meta)\b", re.IGNORECASE), f"a web page (HTML); {_SAVE}"),
    (re.compile(rb"<\?xml|<[a-z]+[:\s>]", re.IGNORECASE), f"an XML file; {_SAVE}"),
    (re.compile(rb"\{\s*[\"}]|\[\s*[{\[\"\n]"), f"a JSON file; {_SAVE}"),
)
_ARCHIVED = (
    (re.compile(r"Index/Document\.iwa|Index\.zip"), "a Numbers spreadsheet; export it as Excel (.xlsx) or CSV"),
    (re.compile(r"content\.xml"), f"an OpenDocument file (.ods); {_WORKBOOK}"),
    (re.compile(r"xl/workbook\.bin"), f"a binary Excel workbook (.xlsb); {_WORKBOOK}"),
    (re.compile(r"word/document\.xml"), f"a Word document; {_SAVE}"),
)
_SPREADSHEETS = {".xls": _WORKBOOK, ".ods": _WORKBOOK, ".numbers": "export it as Excel (.xlsx) or CSV"}


def is_workbook(path: Path) -> bool:
    """Return whether a file is an Excel workbook (.xlsx), by its content."""
    try:
        with open_input(path) as file:
            return file.read(4) == b"PK\x03\x04" and "xl/workbook.xml" in _archived(path)
    except FileError:
        return False


def refuse_no_table(path: Path, start: bytes) -> None:
    """Raise an error, with advice, if the first bytes show that a file is not a text table."""
    if start.startswith(b"PK\x03\x04"):
        names = _archived(path)
        kind = next((text for pattern, text in _ARCHIVED if any(map(pattern.fullmatch, names))), None)
        held = ", ".join(shortened(each, 40) for each in names[:3]) + ", ..." * (len(names) > 3)
        _refuse(path, kind or f"a ZIP archive{f' with {held}' if held else ''}; unpack it first")
    for signature, kind in _SIGNATURES:
        if start.startswith(signature):
            _refuse(path, kind)
    text = start.removeprefix(b"\xef\xbb\xbf").lstrip()
    for pattern, kind in _MARKUP:
        if pattern.match(text):
            _refuse(path, kind)
    if b"\x00" in start and (advice := _SPREADSHEETS.get(path.suffix.lower())):
        raise FileError(str(path), None, f"this is a spreadsheet; {advice}")


def _archived(path: Path) -> list[str]:
    """Return the names of the files in a ZIP archive; empty if it is damaged."""
    try:
        with open_input(path) as file, zipfile.ZipFile(file) as archive:
            return archive.namelist()
    except (zipfile.BadZipFile, OSError, ValueError, NotImplementedError):
        return []


def _refuse(path: Path, kind: str) -> None:
    raise FileError(str(path), None, f"this is not a table but {kind}")
