"""Control characters in cells, headings, names and texts never reach a screen, a report, a table or a picture."""

import base64
import csv
import io
import json
import re
import unicodedata

import pytest

import clubface
from clubface.errors import legible
from clubface.schema import Document, quoted

pytest.importorskip("matplotlib")

BAD = "\x1b[2Jred\x1b[31m\x07\x9b1mC1\u202eesrever\u200b\u2066\u00ad\ufeff\U000e0041"
RAW = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f\u00ad\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff\U000e0041]")


def assert_legible(text):
    result = RAW.search(text)
    assert result is None, f"{unicodedata.name(result[0], hex(ord(result[0])))} in ...{text[: result.end()][-80:]!r}"


def assert_page_is_legible(text):
    assert_legible(text)
    for each in re.findall(r"base64,([A-Za-z0-9+/=]+)", text):
        inside = base64.b64decode(each)
        if not inside.startswith(b"\x89PNG"):
            assert_legible(inside.decode())


def table(rows):
    kept = io.StringIO()
    csv.writer(kept).writerows(rows)
    return kept.getvalue()


@pytest.fixture
def shots(write):
    """A table of shots whose every text is hostile."""
    heads = ["club", "player", f"notes {BAD}", "club_speed_mph", "attack_deg", "loft_deg", "path_deg", "face_deg",
             "ball_speed_mph", "launch_deg", "azimuth_deg", "backspin_rpm", "sidespin_rpm",
             f"flex{BAD} [mph]"]  # fmt: skip
    rows = [
        [f"Driver{BAD}" if row == 9 else "Driver", f"Ann{BAD}", BAD, 100 + row * row % 7, row * row % 5 - 1, 13,
         row * row % 3, 1, 145 + row % 4, 12 + row % 2, row % 3, 2600, 100 * (row % 3), 1]
        for row in range(12)
    ]  # fmt: skip
    rows.append(["Driver", BAD, BAD, BAD, 0, 13, 0, 0, BAD, 12, 0, 2600, 0, 1])
    return str(write(table([heads, *rows])))


COMMANDS = {
    "monitor read": ("monitor", "read", "SHOTS", "-o", "OUT.csv", "--rejects", "OUT2.csv"),
    "monitor report": ("monitor", "report", "SHOTS", "-o", "OUT.html"),
    "monitor report, text": ("monitor", "report", "SHOTS", "-o", "OUT.md"),
    "monitor summary": ("monitor", "summary", "SHOTS"),
    "predict": ("predict", "SHOTS", "--club", "driver", "--where", "club == 'Driver'", "-o", "OUT.csv"),
    "predict, as JSON": (
        "predict",
        "SHOTS",
        "--club",
        "driver",
        "--where",
        "club == 'Driver'",
        "-o",
        "OUT.csv",
        "--json",
    ),
    "evaluate": (
        "evaluate",
        "SHOTS",
        "--club",
        "driver",
        "--where",
        "club == 'Driver'",
        "--models",
        "slip,standard",
        "-o",
        "FOLDER",
    ),
    "infer": ("infer", "SHOTS", "--club", "driver", "--where", "club == 'Driver'", "--samples", "20", "-o", "OUT.csv"),
    "golfer": (
        "golfer",
        "estimate",
        "SHOTS",
        "--club",
        "driver",
        "--where",
        "club == 'Driver'",
        "--report",
        "OUT.html",
    ),
    "shot": ("shot", "CLUB", "--speed", "100 mph", "--report", "OUT.html"),
    "compare": ("compare", "CLUB", "3-wood", "--speed", "100 mph", "--report", "OUT.html", "-o", "OUT.csv"),
    "clubs": ("clubs", "CLUB"),
    "clubs, as JSON": ("clubs", "CLUB", "--json"),
    "club check": ("club", "check", "CLUB"),
    "map": ("map", "CLUB", "--speed", "100 mph", "--grid", "5x5", "--plot", "OUT.svg"),
    "dispersion": ("dispersion", "GOLFER", "--count", "64", "--no-shares", "--report", "OUT.html", "--plot", "OUT.svg"),
    "golfer show": ("golfer", "show", "GOLFER", "--report", "OUT.html"),
    "best-loft": ("best-loft", "--speed", "90 mph", "--club", "CLUB", "--report", "OUT.html"),
}


@pytest.mark.parametrize("name", COMMANDS)
def test_hostile_characters_come_out_as_escapes(name, shots, tmp_path, clubface_):
    club = clubface.club("driver").replace(description=f"mine {BAD}", sources={"mass": f"weighed {BAD}"})
    (tmp_path / "club.toml").write_text(club.to_toml())
    (tmp_path / "golfer.toml").write_text(
        f'title = "Anna"\nclub = "club.toml"\n[mean]\nspeed = "100 mph"\nloft = "12 deg"\n[spread]\nface = "2 deg"\n'
        f"[sources]\nmean.speed = {quoted(BAD)}\n"
    )
    paths = {"SHOTS": shots, "CLUB": str(tmp_path / "club.toml"), "GOLFER": str(tmp_path / "golfer.toml"),
             "FOLDER": str(tmp_path / "report"), "OUT": str(tmp_path / "out")}  # fmt: skip
    words = list(COMMANDS[name])
    for word, path in paths.items():
        words = [each.replace(word, path) for each in words]
    ran = clubface_(*words)
    assert ran.status == 0, ran.err
    assert_legible(ran.out)
    assert_legible(ran.err)
    written = [*tmp_path.glob("out*"), *(tmp_path / "report").glob("*")]
    assert written or not any("OUT" in each or each == "FOLDER" for each in COMMANDS[name])
    for path in written:
        if path.suffix != ".png":
            assert_page_is_legible(path.read_text(encoding="utf-8"))
    if "--json" in words:
        json.loads(ran.out)


def test_a_title_with_control_characters_is_drawn_with_escapes(tmp_path):
    from matplotlib.figure import Figure

    from clubface import plots

    figure = Figure()
    figure.suptitle(BAD)
    plots.save(figure, tmp_path / "a.svg")
    assert_legible((tmp_path / "a.svg").read_text())


def test_letters_of_all_languages_and_spaces_between_thousands_stay_as_they_are():
    for text in ("Jürgen, 7 アイアン, 木杆, Ελένη, 3\u202f045 m, 3\u00a0045, º, µ, ➜", "é", "e\u0301"):
        assert legible(text) == text
    assert legible("a\nb\tc", "\n") == "a\nb\\tc"
    assert legible("caf\udce9") == "caf\\xe9"


def test_a_text_that_is_written_as_toml_reads_back_as_the_same():
    for text in (BAD, "a\nb\t\"c\" \\ 'd'", "Jürgen \u00a0 x"):
        assert Document(f"x = {quoted(text)}").data["x"] == text
        assert_legible(quoted(text))
