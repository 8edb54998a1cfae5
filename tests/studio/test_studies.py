"""Studies in the studio: those of the folder that was named, and no others."""

import pytest

pytest.importorskip("starlette")
pytest.importorskip("pyarrow")

from clubface import studies
from studio_pages import client
from study_files import shots, squares


@pytest.fixture(scope="module")
def studio(tmp_path_factory):
    folder = tmp_path_factory.mktemp("studies")
    studies.run(shots(folder), workers=1)
    studies.run(squares(folder, count=20), workers=1)
    studies.run(squares(tmp_path_factory.mktemp("elsewhere"), count=20), workers=1)
    (folder / "empty").mkdir()
    (folder / "damaged.store").mkdir()
    (folder / "damaged.store" / "record.json").write_text("{")
    return client(tmp_path_factory.mktemp("site"), studies=folder)


def test_the_studies_of_the_folder_are_listed_with_how_far_they_are(studio):
    rows = studio.get("api/studies").json()["tables"]["studies"]["rows"]
    assert [(each["store"], each["tasks"], each["chunks"], each["done"]) for each in rows] == [
        ("shots.store", 24, 5, 5), ("squares.store", 20, 2, 2)
    ]  # fmt: skip


def test_a_study_gives_what_the_command_gives(studio, clubface_, tmp_path):
    path = shots(tmp_path)
    studies.run(path, workers=1)
    summary = studio.get("api/studies/shots.store/summary").json()
    command = clubface_("study", "summary", str(tmp_path / "shots.store"), "--json").json
    assert summary["tables"] == command["tables"]
    assert summary["kind"] == "study-summary"
    assert studio.get("api/studies/shots.store").json()["kind"] == "study-status"
    report = studio.get("api/studies/shots.store/report")
    assert "<svg" in report.text or "<img" in report.text
    assert report.headers["content-security-policy"].startswith("sandbox")


OTHERS = ["nothing", "empty", "damaged.store", "..", "%2e%2e", "..%2felsewhere0%2fsquares.store", "%2fetc", "~"]


@pytest.mark.parametrize("name", [*OTHERS, "shots.toml", "%00"])
def test_no_other_folder_is_opened(studio, name):
    answer = studio.get(f"api/studies/{name}/summary")
    assert answer.status_code in (404, 422)
    assert answer.json()["what"]


def test_without_a_folder_the_answer_says_how_to_name_one(tmp_path):
    studio = client(tmp_path)
    assert studio.get("api/studies").json()["tables"]["studies"]["rows"] == []
    assert "clubface studio --studies FOLDER" in studio.get("api/studies/x/summary").json()["what"]
