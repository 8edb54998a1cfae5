"""Files of monitors in the studio: the same as on the command line, and a sentence for what is none."""

import io
import json
import zipfile
from pathlib import Path

import pytest
from hypothesis import given, settings, strategies as st

pytest.importorskip("starlette")

from clubface.studio.files import LARGEST, MOST_FILES, bare_name
from fuzz_mutations import mutated
from studio_pages import added, client, session

MONITORS = Path(__file__).parents[1] / "data" / "launch_monitors"
TRACKMAN = (MONITORS / "trackman.csv").read_bytes()


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    return client(tmp_path_factory.mktemp("site"))


@pytest.mark.parametrize("name", ["trackman.csv", "foresight-2020.csv", "garmin-de.csv", "square.csv", "rapsodo.csv"])
def test_a_file_gives_what_the_command_gives(studio, clubface_, name, monkeypatch):
    monkeypatch.chdir(MONITORS)
    options = {"unit": ["speed=mph", "length=yd"]} if name == "garmin-de.csv" else {}
    given = [word for each in options.get("unit", []) for word in ("--unit", each)]
    asked = added(studio, (MONITORS / name).read_bytes(), name, **options)
    command = clubface_("monitor", "read", name, *given, "--json").json
    command["provenance"].pop("command", None)
    assert asked.status_code == 201
    mine = asked.json()
    for each in ("kind", "title", "tables", "notes", "values"):
        assert mine[each] == command[each]


def test_shots_come_one_by_one_with_their_flight_paths(studio):
    place = added(studio, TRACKMAN, "trackman.csv").headers["location"]
    shots = studio.get(f"{place}/shots").json()
    assert (shots["schema"], shots["kind"]) == ("clubface-result-1", "shot-list")
    first = shots["tables"]["shots"]["rows"][0]
    assert (first["shot"], first["club"], first["kind"], first["shape"]) == (1, "Driver", "driver", "draw")
    assert first["ball_speed_mps"] == pytest.approx(147.5 * 0.44704, rel=1e-14)
    assert {each["shot"] for each in shots["tables"]["paths"]["rows"]} == {1, 2}
    assert studio.get(f"{place}/summary").json()["kind"] == "session-summary"


def test_units_that_the_file_lacks_are_asked_for(studio):
    content = b"Ball Speed,Launch Angle\n147,12\n"
    refused = added(studio, content)
    assert refused.status_code == 422
    assert refused.json()["where"].startswith("session.csv")
    assert "unit" in refused.json()["what"]
    taken = added(studio, content, unit=["speed=mph", "angle=deg"])
    assert taken.status_code == 201
    assert added(studio, content, unit=["speed"]).json()["allowed"] == "a name and a unit, as in speed=mph"
    assert "did you mean" in added(studio, content, format="trackmen").json()["what"]


def test_the_report_is_that_of_the_command_and_runs_no_script(studio):
    place = added(studio, TRACKMAN, "trackman.csv").headers["location"]
    report = studio.get(f"{place}/report")
    assert report.headers["content-type"].startswith("text/html")
    assert report.headers["content-security-policy"].startswith("sandbox allow-downloads; default-src 'none'")
    assert "<script" not in report.text
    assert "Technical details" in report.text
    saved = studio.get(f"{place}/report?save")
    assert saved.headers["content-disposition"].startswith('attachment; filename="')
    assert saved.text == report.text


def test_sentences_are_in_the_units_that_are_asked_for(studio):
    place = added(studio, session(40), "session.csv").headers["location"]
    golf, metric = (studio.get(f"{place}/golfer", params={"units": each}).json() for each in ("golf", "metric"))
    assert golf["tables"] == metric["tables"]
    of_speed = [next(each for each in every["summary"] if each["code"] == "golfer-speed") for every in (golf, metric)]
    texts, speed = [each["text"] for each in of_speed], of_speed[0]["data"]["speed_mps"]
    assert f"{speed / 0.44704:.0f} mph" in texts[0]
    # A digit more than of mph, since a step of 1 m/s is twice as coarse.
    assert f"{speed:.1f} m/s" in texts[1]
    assert golf == studio.get(f"{place}/golfer").json()
    assert "mph" not in studio.get(f"{place}/report", params={"units": "metric"}).text
    refused = studio.get(f"{place}/golfer", params={"units": "stones"})
    assert refused.status_code == 422
    assert refused.json()["allowed"] is not None


def test_the_golfer_is_that_of_the_command(studio, clubface_, tmp_path):
    path = tmp_path / "session.csv"
    path.write_bytes(session())
    place = added(studio, path.read_bytes()).headers["location"]
    mine = studio.get(f"{place}/golfer").json()
    command = clubface_("golfer", "estimate", str(path), "--json").json
    assert mine["tables"] == command["tables"]
    assert mine["notes"] == command["notes"]
    assert 'club = "driver"' in studio.get(f"{place}/golfer.toml").text


@pytest.mark.parametrize(("asked", "words"), [
    ({"club": "/etc/passwd"}, "club"), ({"club": "mine.toml"}, "club"), ({"like": "../x.toml"}, "like"),
    ({"only": "7i"}, "7i"),
])  # fmt: skip
def test_the_browser_names_no_path(studio, asked, words, tmp_path):
    place = added(studio, session(20)).headers["location"]
    answer = studio.get(f"{place}/golfer", params=asked)
    assert answer.status_code == 422
    assert words in answer.json()["what"]


@pytest.mark.parametrize(
    ("name", "bare"),
    [("../../etc/passwd", "passwd"), ("C:\\shots\\a b.csv", "a b.csv"), ("", "session.csv"), ("..", "session.csv"),
     (".", "session.csv"), ("/", "session.csv"), ("a\x00b\nc.csv", "abc.csv"), ("\u202egnp.csv", "gnp.csv"),
     ("a" * 500 + ".csv", "a" * 96 + ".csv"), ("~root.csv", "~root.csv")],
)  # fmt: skip
def test_names_lose_their_folders(name, bare):
    assert bare_name(name) == bare


def bomb():
    """A workbook whose sheet grows a thousandfold."""
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("[Content_Types].xml", "<Types/>")
        archive.writestr("xl/workbook.xml", "<workbook/>")
        archive.writestr("xl/worksheets/sheet1.xml", b" " * 30_000_000)
    return file.getvalue()


NO_FILES = [
    b"", b"\x00" * 1000, b"PK\x03\x04" + b"x" * 100, bomb(), b"%PDF-1.7\n", b"\xff\xfe", b"a,b\n1,2\n",
    b"<html><script>alert(1)</script></html>", b"PAR1" + b"\x00" * 50, "\u202e\n".encode(),
    b"\x89PNG\r\n\x1a\n" + b"\x00" * 30,
]  # fmt: skip


@pytest.mark.parametrize("name", ["session.csv", "session.xlsx", "session.parquet", "../../x", "club.toml", "a.c3d"])
@pytest.mark.parametrize("content", NO_FILES)
def test_a_file_without_shots_is_answered_with_a_sentence(studio, name, content):
    answer = added(studio, content, name)
    assert answer.status_code == 422
    mistake = answer.json()
    assert set(mistake) == {"where", "what", "allowed"}
    assert 10 < len(mistake["what"]) < 1100
    assert mistake["what"].isprintable()
    assert "/" not in mistake["where"]


def test_a_file_that_is_too_large_is_refused_while_it_comes(studio):
    answer = studio.post("api/files", content=(b"x" * 1_000_000 for _ in range(LARGEST // 1_000_000 + 1)))
    assert answer.status_code == 413
    assert "larger than 20 MB" in answer.json()["what"]


def test_the_oldest_file_makes_room(studio):
    first = added(studio, TRACKMAN).headers["location"]
    for _ in range(MOST_FILES):
        added(studio, TRACKMAN)
    answer = studio.get(f"{first}/shots")
    assert (answer.status_code, answer.json()["allowed"]) == (422, "a file that is still open here; choose it again")


@settings(max_examples=60)
@given(
    seed=st.integers(0, 10**9), name=st.sampled_from(["trackman.csv", "foresight-2020.csv", "gspro.csv", "square.csv"])
)
def test_damaged_files_are_read_or_refused(studio, seed, name):
    from random import Random

    content = mutated((MONITORS / name).read_bytes(), TRACKMAN, Random(seed))
    answer = added(studio, content, name)
    assert answer.status_code in (201, 422)
    if answer.status_code == 201:
        shots = studio.get(answer.headers["location"] + "/shots")
        assert shots.status_code == 200
        json.loads(shots.text, parse_constant=lambda each: pytest.fail(each))
