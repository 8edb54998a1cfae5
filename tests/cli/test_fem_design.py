"""``clubface fem design``: tables, a head that other commands read, a picture, and mistakes in one line."""

import pytest

from clubface import fem
from command_line import assert_mistake
from fem_meshes import HEAD as OWN_HEAD, coarse_walls, gmsh_2
from fem_runs import coarse

pytest.importorskip("typer")
pytest.importorskip("scipy")

HEAD = """name = "few shells"
kind = "driver"
elements = [12, 6, 8]
shape = {loft = "9.8 deg", bulge = "305 mm", roll = "305 mm", width = "116 mm", depth = "104 mm", crown = "29 mm", \
sole = "27 mm", rounding = "6 mm"}
thickness = {face_centre = "3.0 mm", face_edge = "2.4 mm", crown = "0.8 mm", sole = "1.0 mm", skirt = "0.8 mm"}
target = {mass = "204 g"}

[[trims]]
name = "sole"
x = "-60 mm"
y = "-26 mm"
z = "0 mm"
most = "80 g"
"""
STUDY = """title = "A faster face"
head = "./head.toml"
objective = "ball_speed"
designs = 3

[variables.thickness]
face_centre = ["2.4 mm", "3.6 mm"]

[delivery]
speed = "100 mph"
loft = "12 deg"
"""


@pytest.fixture
def files(tmp_path, monkeypatch):
    (tmp_path / "head.toml").write_text(HEAD)
    (tmp_path / "study.toml").write_text(STUDY)
    # Tables and files are the matter here, not the ball.
    monkeypatch.setattr("clubface.design.shells.study.ball_of", lambda *_: coarse("modern"))
    return tmp_path


def test_the_best_head_is_printed_drawn_and_written(clubface_, files):
    best, picture = files / "best.toml", files / "search.svg"
    ran = clubface_("fem", "design", str(files / "study.toml"), "-o", str(best), "--plot", str(picture))
    assert ran.status == 0
    assert "A faster face" in ran.out
    assert "face centre" in ran.out
    assert "3 designs were checked with 6 runs" in " ".join(ran.out.split())
    assert f"wrote {best}" in ran.err
    assert picture.read_text().startswith("<?xml")
    shown = clubface_("fem", "head", str(best), "--json").json["tables"]["head"]["rows"][0]
    assert shown["mass_g"] == pytest.approx(204.0, abs=1e-3)
    assert fem.head(str(best)).name == "few shells"


def test_a_document_has_everything(clubface_, files):
    report = files / "report.md"
    document = clubface_("fem", "design", str(files / "study.toml"), "--json", "--report", str(report)).json
    best = {each["quantity"]: each for each in document["tables"]["best"]["rows"]}["ball_speed"]
    text = report.read_text()
    assert "25 degC, 1013.2 hPa, 50% humidity" in text  # the air of the carries
    after, before = (f"{best[which] / 0.44704:.2f}" for which in ("best", "start"))
    assert f"The mean ball speed of the best head is {after} mph instead of {before} mph." in text
    assert "Designs evaluated by finite elements" in text
    assert "Computed by clubface" in text
    assert document["values"]["objective"] == "ball_speed"
    assert [each["kind"] for each in document["tables"]["designs"]["rows"]] == ["start", "neighbour", "proposal"]
    assert best["best"] > best["start"]
    verdicts = {each["quantity"]: each["verdict"] for each in document["tables"]["limits"]["rows"]}
    assert verdicts["characteristic_time"] in ("kept", "binds")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[variables.thickness]", "[variables.wall]", "study.toml:6: "),
        ('"2.4 mm", "3.6 mm"', '"2.4 mm", "2.6 mm"', "bounds that include"),
        ("head.toml", "study.toml", "kind"),
        ("designs = 3", "designs = 1", "designs is 1"),
    ],
)
def test_mistakes_are_reported_in_one_line(clubface_, files, old, new, message):
    path = files / "study.toml"
    path.write_text(STUDY.replace(old, new))
    assert_mistake(clubface_("fem", "design", str(path)), message)


def test_resume_needs_a_file_other_than_that_of_the_head(clubface_, files):
    study, head = str(files / "study.toml"), files / "head.toml"
    assert_mistake(clubface_("fem", "design", study, "--resume"), "--output is missing")
    before = head.read_bytes()
    assert_mistake(clubface_("fem", "design", study, "-o", str(head)), "file other than")
    assert head.read_bytes() == before


def test_the_best_head_of_a_mesh_is_read_from_another_folder(clubface_, files):
    (files / "head.msh").write_text(gmsh_2(coarse_walls()))
    (files / "head.toml").write_text(OWN_HEAD)
    (files / "study.toml").write_text(STUDY.replace("face_centre", "face"))
    (files / "designs").mkdir()
    best = files / "designs" / "best.toml"
    ran = clubface_("fem", "design", str(files / "study.toml"), "-o", str(best), "--json")
    assert ran.status == 0, ran.err
    assert 'file = "../head.msh"' in best.read_text()
    shown = clubface_("fem", "head", str(best), "--json").json["tables"]["head"]["rows"][0]
    mass = next(each for each in ran.json["tables"]["best"]["rows"] if each["quantity"] == "mass")
    assert shown["mass_g"] == pytest.approx(mass["best"], rel=1e-9)
    # The models that take the head as rigid know from the file how its face gives.
    shot = clubface_("shot", str(best), "--speed", "100 mph", "--loft", "12 deg", "--json")
    assert shot.status == 0, shot.err
    assert "characteristic_time" in best.read_text()


def test_a_group_that_the_mesh_does_not_have_is_reported_in_one_line(clubface_, files):
    (files / "head.msh").write_text(gmsh_2(coarse_walls()))
    (files / "head.toml").write_text(OWN_HEAD)
    (files / "study.toml").write_text(STUDY.replace("face_centre", "hosel"))
    assert_mistake(clubface_("fem", "design", str(files / "study.toml")), "unknown group to vary 'hosel'")
