"""Files as people have them: in other encodings, as workbooks, and under names that say something else."""

from __future__ import annotations

import gzip
import io
import json
import sqlite3
import zipfile

import numpy as np
import pytest

from attached_notes import noted
from clubface import shots as launch_monitor
from clubface.errors import FileError

MPH, YD = 0.44704, 0.9144
GERMAN = "Schläger;Tempo;Höhe\nEisen 7;130,5;17,5\n5er Hölzer;150;12\n"
JAPANESE = "日時,クラブ,ヘッドスピード,飛距離\n2024/05/02,ドライバー,41.2,231\n2024/05/02,7番アイアン,34.1,142\n"
CHINESE = "日期,球杆,球速,距离\n2024/05/02,一号木,61.2,231\n2024/05/02,7号铁,45.1,142\n"
KOREAN = "날짜,클럽,볼 스피드,비거리\n2024/05/02,드라이버,61.2,231\n2024/05/02,7번 아이언,45.1,142\n"
TABLE = [["Club", "Club Speed (mph)", "Ball Speed (mph)", "Carry (yd)"], ["Driver", 100, 147.5, 250.25]]


def mapping(text, unit="km/h"):
    """A mapping of the second column as the speed and of the third or fourth as the carry."""
    heads = text.splitlines()[0].replace(";", ",").split(",")
    club = heads[0 if len(heads) == 3 else 1]
    speed = heads[1 if len(heads) == 3 else 2]
    return f'club = "{club}"\n[columns.speed]\nheading = "{speed}"\nunit = "{unit}"\n'


@pytest.mark.parametrize(
    ("text", "encoding", "name"),
    [
        (GERMAN, "cp1252", "Windows-1252"), (GERMAN, "mac_roman", "Mac Roman"), (JAPANESE, "cp932", "Shift-JIS"),
        (CHINESE, "gbk", "GBK"), (KOREAN, "euc-kr", "EUC-KR"), (GERMAN, "utf-16", "UTF-16"),
        (GERMAN, "utf-16-le", "UTF-16"), (GERMAN, "utf-16-be", "UTF-16"), (JAPANESE, "utf-16-le", "UTF-16"),
        (CHINESE, "utf-16-be", "UTF-16"), (GERMAN, "utf-8", None), (JAPANESE, "utf-8-sig", None),
    ],
)  # fmt: skip
def test_a_session_reads_the_same_in_every_encoding(write, text, encoding, name):
    content = text.encode(encoding)
    shots = launch_monitor.read(write(content), mapping=write(mapping(text), "map.toml"))
    assert shots.clubs.tolist() == [line.replace(";", ",").split(",")[0 if text is GERMAN else 1]
                                    for line in text.splitlines()[1:]]  # fmt: skip
    assert len(shots) == 2
    assert [each["encoding"] for each in noted(shots, "not-utf-8")] == [name] * (name is not None)


def test_an_ascii_beginning_does_not_decide_the_encoding(write):
    rows = "".join(f"Driver,{100 + row % 9},{140 + row % 7}\n" for row in range(500))
    content = ("Club,Club Speed (mph),Ball Speed (mph)\n" + rows + "7番アイアン,80,110\n").encode("cp932")
    shots = launch_monitor.read(write(content))
    assert shots.clubs[-1] == "7番アイアン"


def test_zero_bytes_lose_their_row_and_a_zeroed_end_loses_nothing(write):
    content = b"club,club_speed_mph\nDriver,100\nDri\0ver,101\nDriver,102\n" + b"\0" * 500
    shots = launch_monitor.read(write(content))
    assert shots.rows.tolist() == [2, 4]
    assert [each.line for each in shots.rejected] == [3]


def workbook(sheets):
    """An Excel workbook of some sheets of rows, as bytes."""
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book.remove(book.active)
    for title, rows in sheets.items():
        sheet = book.create_sheet(title)
        for row in rows:
            sheet.append(row)
    file = io.BytesIO()
    book.save(file)
    return file.getvalue()


@pytest.mark.parametrize("name", ["shots.xlsx", "shots.csv", "shots.XLSX"])
def test_a_workbook_is_read_as_the_table_it_holds_under_any_name(write, name):
    shots = launch_monitor.read(write(workbook({"Notes": [["My session"]], "Shots": TABLE}), name))
    assert shots.deliveries["speed"] == pytest.approx([100 * MPH])
    assert shots.launches["carry"] == pytest.approx([250.25 * YD])
    assert (shots.clubs.tolist(), shots.rows.tolist()) == (["Driver"], [2])


def test_a_makers_table_in_a_workbook_has_its_units_row_its_dates_and_its_empty_cells(write):
    import datetime

    rows = [
        ["Session of A. Player"],
        ["Date", "Club", "Club Speed", "Swing Direction", "Dyn. Loft", "Ball Speed", "Carry"],
        [None, None, "[mph]", "[deg]", "[deg]", "[mph]", "[yd]"],
        [datetime.datetime(2026, 5, 1, 10, 0), "Driver", 100, 1.5, 0.1 + 0.2, 147, 250],
        [],
        [datetime.datetime(2026, 5, 1, 10, 1), "Driver", 101, 1.5, 12, 149, None],
    ]
    shots = launch_monitor.read(write(workbook({"Shots": rows}), "shots.xlsx"))
    assert (shots.format, shots.rows.tolist()) == ("trackman", [4, 6])
    np.testing.assert_allclose(shots.launches["ball_speed"], [147 * MPH, 149 * MPH], rtol=1e-14)


def test_sheets_that_are_not_read_are_named(write):
    shots = launch_monitor.read(write(workbook({"May": TABLE, "June": TABLE, "Cover": [["x"]]}), "shots.xlsx"))
    assert noted(shots, "sheet-read") == [{"sheet": "May", "others": ["June"]}]


def test_a_damaged_workbook_is_refused_in_one_line(write):
    content = workbook({"Shots": TABLE})
    for end in range(60, len(content), 997):
        with pytest.raises(FileError) as caught:
            launch_monitor.read(write(content[:end], "shots.xlsx"))
        assert "\n" not in str(caught.value)


def archive(*names):
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as zipped:
        for name in names:
            zipped.writestr(name, "text")
    return file.getvalue()


def database():
    connection = sqlite3.connect(":memory:")
    connection.execute("create table shots (speed)")
    return connection.serialize()


@pytest.mark.parametrize("ending", ["csv", "xlsx", "txt"])
@pytest.mark.parametrize(
    ("content", "kind"),
    [
        (archive("session/shots.csv"), "ZIP archive with session/shots.csv"),
        (gzip.compress(b"speed\n1\n", mtime=0), "gzip"), (b"%PDF-1.7\n1 0 obj\n", "PDF"),
        (b"\n <!DOCTYPE html><html><table>", "web page"),
        (b"\xef\xbb\xbf<html><body>", "web page"), (b"<?xml version='1.0'?><Workbook/>", "XML"),
        (database(), "SQLite"), (json.dumps([{"speed": 1}], indent=1).encode(), "JSON"),
        (b'{"shots": []}', "JSON"), (archive("mimetype", "content.xml"), "OpenDocument"),
        (archive("Index/Document.iwa"), "Numbers"), (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + bytes(600), ".xls"),
        (archive("word/document.xml"), "Word"), (b"PAR1\x15\x04", "Parquet"), (b"\x89PNG\r\n\x1a\n" + bytes(9), "PNG"),
    ],
)  # fmt: skip
def test_files_that_are_no_tables_are_identified_whatever_their_name(write, content, kind, ending):
    with pytest.raises(FileError) as caught:
        launch_monitor.read(write(content, f"shots.{ending}"))
    assert kind in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("ending", ["xlsx", "xls", "ods"])
def test_text_under_the_name_of_a_spreadsheet_is_read_as_text(write, ending):
    shots = launch_monitor.read(write("Club\tClub Speed (mph)\tBall Speed (mph)\nDriver\t100\t147\n", f"a.{ending}"))
    assert shots.deliveries["speed"] == pytest.approx([100 * MPH])


def test_text_under_the_name_of_a_parquet_file_is_named_text(write):
    pytest.importorskip("pyarrow")
    with pytest.raises(FileError, match=r"not a Parquet.*\.csv"):
        launch_monitor.read(write("club_speed_mph\n100\n", "shots.parquet"))
