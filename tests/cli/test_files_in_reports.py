"""A report shows the files that were read and no other, whatever their texts say."""

import hashlib
import os
import re

import pytest

import clubface

pytest.importorskip("matplotlib")

SECRET = 'mass = "the plan that no customer may see"\n'
SPEED = ("--speed", "105 mph")
COMMANDS = {
    "shot": ("shot", "mine.toml", *SPEED),
    "dispersion": ("dispersion", "anna.toml", "--count", "64", "--no-shares"),
    "monitor report": ("monitor", "report", "shots.csv"),
}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "at").mkdir()
    quoted = "../private.toml private.toml \"../private.toml\" '../private.toml'"
    mine = clubface.club("driver").replace(name='mine "../private.toml"', description=quoted)
    (tmp_path / "at" / "mine.toml").write_text(mine.to_toml() + '\n# "../private.toml"\n')
    (tmp_path / "private.toml").write_text(SECRET)
    (tmp_path / "at" / "private.toml").write_text(SECRET)
    (tmp_path / "at" / "anna.toml").write_text(
        'title = "Anna \'../private.toml\'"  # "private.toml"\nclub = "mine.toml"\n'
        '[mean]\nspeed = "100 mph"\nloft = "12 deg"\n[spread]\nface = "2 deg"\n'
    )
    (tmp_path / "at" / "shots.csv").write_text(
        'club,ball_speed_mph,launch_deg,backspin_rpm\nDriver,150,12,2600\nDriver,152,13,2500\n"../private.toml",151,12,2600\n'
    )
    monkeypatch.chdir(tmp_path / "at")
    return tmp_path


@pytest.mark.usefixtures("without_pictures")
@pytest.mark.parametrize("name", COMMANDS)
def test_a_text_that_quotes_a_file_does_not_bring_it_into_a_report(name, folder, clubface_):
    option = "-o" if name.startswith("monitor") else "--report"
    ran = clubface_(*COMMANDS[name], option, str(folder / "report.html"))
    assert ran.status == 0, ran.err
    page = (folder / "report.html").read_text()
    assert "no customer may see" not in page
    assert hashlib.sha256(SECRET.encode()).hexdigest() not in page


def test_the_club_of_a_golfer_lies_in_the_folder_of_the_golfer_and_is_in_the_report(folder, clubface_, monkeypatch):
    monkeypatch.chdir(folder)
    report = folder / "report.html"
    ran = clubface_("dispersion", "at/anna.toml", "--count", "64", "--no-shares", "--report", str(report))
    assert ran.status == 0, ran.err
    sums = {hashlib.sha256((folder / "at" / name).read_bytes()).hexdigest() for name in ("anna.toml", "mine.toml")}
    assert set(re.findall(r"\b[0-9a-f]{64}\b", report.read_text())) == sums


def test_an_optimisation_reports_the_golfer_in_its_folder_and_not_another_of_the_name(tmp_path, clubface_, monkeypatch):
    (tmp_path / "sub").mkdir()
    anna = 'title = "Anna"\n[mean]\nspeed = "100 mph"\nloft = "12 deg"\n[spread]\nface = "2 deg"\n'
    (tmp_path / "anna.toml").write_text(anna.replace("100", "70"))
    (tmp_path / "sub" / "anna.toml").write_text(anna)
    (tmp_path / "sub" / "fit.toml").write_text(
        'title = "Which"\ngolfer = "anna.toml"\nobjective = "carry"\nshots = 64\n[fit]\nclubs = ["driver", "3-wood"]\n'
    )
    monkeypatch.chdir(tmp_path)
    ran = clubface_("optimise", "sub/fit.toml", "--report", "report.html")
    assert ran.status == 0, ran.err
    page = (tmp_path / "report.html").read_text()
    assert hashlib.sha256(anna.encode()).hexdigest() in page
    assert hashlib.sha256((tmp_path / "anna.toml").read_bytes()).hexdigest() not in page


def test_an_output_is_no_file_that_was_read(folder, clubface_):
    before = (folder / "at" / "mine.toml").read_bytes()
    ran = clubface_("dispersion", "anna.toml", "--count", "64", "--no-flight", "--report", "mine.toml")
    assert ran.status == 2
    if os.name == "nt":
        return  # links need rights there
    (folder / "at" / "mine.html").symlink_to("mine.toml")
    ran = clubface_("dispersion", "anna.toml", "--count", "64", "--no-shares", "--report", "mine.html")
    assert ran.status == 2
    assert "mine.html" in ran.err
    assert (folder / "at" / "mine.toml").read_bytes() == before
