"""The file of a meshed head is a club for every model: its mesh for finite elements, what it weighs for the others."""

import re

import numpy as np
import pytest

import clubface
from clubface import fem
from clubface.errors import FileError, InputError
from clubface.fem import head_tests
from clubface.support.files import builtin_path
from fem_runs import coarse

SHOT = {"speed": "100 mph", "toe": "8 mm"}


@pytest.fixture
def file(tmp_path):
    """Roh and Lee's head of few shells."""
    path = tmp_path / "head.toml"
    text = builtin_path("head", "paper", "fem_heads").read_text().replace("[36, 12, 25]", "[14, 8, 10]")
    # So coarse a mesh misses its targets a little.
    path.write_text(re.sub(r"\n(cg_z|cg_above|izz) = .*", "", text))
    return path


@pytest.mark.parametrize("model", ["response", "standard", "volumetric", "rings"])
@pytest.mark.filterwarnings("ignore::clubface.errors.RangeWarning")
def test_a_reduced_model_takes_the_rigid_head_of_the_mesh(file, model):
    launch = clubface.impact(file, SHOT, model=model)
    rigid = clubface.impact(fem.head(file).club, SHOT, model=model)
    assert (launch.ball_speed, launch.sidespin) == (rigid.ball_speed, rigid.sidespin)
    assert launch.club.mass == pytest.approx(0.21, rel=1e-6)


def test_finite_elements_take_the_mesh_by_every_way_that_leads_to_it(file):
    how = fem.Settings(until_separation=True)
    mesh = fem.strike(fem.head(file), SHOT, settings=how)
    launch = clubface.impact(file, SHOT, model="fem")
    for result in (
        launch,
        fem.strike(file, SHOT, settings=how).launch,
        fem.strike(launch.club, SHOT, settings=how).launch,
    ):
        assert (result.ball_speed, result.backspin) == (mesh.launch.ball_speed, mesh.launch.backspin)
    rigid = clubface.impact(fem.head(file).club, SHOT, model="fem")
    # A face of 1.8 mm of titanium springs: some per cent of ball speed.
    assert launch.ball_speed > 1.01 * rigid.ball_speed
    assert head_tests.restitution(file, ball=coarse("modern")) == head_tests.restitution(
        fem.head(file), ball=coarse("modern")
    )


def test_a_left_handed_mesh_is_the_mirror_image(file):
    club = clubface.club(file)
    right, left = (clubface.impact(club.replace(hand=hand), SHOT, model="fem") for hand in ("right", "left"))
    assert (left.ball_speed, left.sidespin, left.azimuth) == (right.ball_speed, -right.sidespin, -right.azimuth)
    assert right.sidespin != 0.0


def test_a_shot_cannot_change_the_mass_of_its_mesh_and_replacing_it_makes_a_rigid_club(file):
    with pytest.raises(InputError, match="club_mass"):
        clubface.impact(file, SHOT, model="fem", club_mass="200 g")
    assert np.isfinite(clubface.impact(file, SHOT, model="response", club_mass="200 g").ball_speed)
    lighter = clubface.club(file).replace(mass="200 g")
    assert not hasattr(lighter, "head")
    assert clubface.impact(lighter, SHOT, model="fem").ball_speed > 0.0


def test_a_file_gives_the_rigid_head_what_a_mesh_lacks(file):
    text = file.read_text()
    file.write_text('characteristic_time = "250 us"\nhand = "left"\n' + text)
    club = clubface.club(file)
    assert (club.characteristic_time, club.hand) == (250e-6, -1)
    faster = clubface.impact(club, SHOT).ball_speed / clubface.impact(fem.head(file).club, SHOT).ball_speed
    # 250 us are worth 0.03 to 0.05 of restitution, and so 2 to 3% of ball speed.
    assert 1.01 < faster < 1.04
    file.write_text('characteristic_time = "250 mm"\n' + text)
    with pytest.raises(FileError, match=r"head\.toml:1: characteristic_time"):
        clubface.club(file)


def test_shot_predicts_by_every_model_from_one_file_and_notes_the_rigid_face(clubface_, file):
    ran = clubface_("shot", str(file), "--speed", "100 mph", "--model", "response,fem", "--json")
    assert [row["model"] for row in ran.rows()] == ["response", "fem"]
    assert ran.rows()[1]["ball_speed_mps"] == clubface.impact(file, speed="100 mph", model="fem").ball_speed
    assert f"clubface fem head {file} --measure" in ran.err
    assert "face of Roh and Lee head of shells as rigid" in ran.err
    file.write_text('characteristic_time = "250 us"\n' + file.read_text())
    assert "rigid" not in clubface_("shot", str(file), "--speed", "105 mph").err


def test_finite_elements_alone_have_no_note_on_a_rigid_face(clubface_, file):
    assert "rigid" not in clubface_("shot", str(file), "--speed", "100 mph", "--model", "fem", "--json").err


def test_a_head_is_measured_where_and_with_what_is_asked(clubface_, file):
    asked = ("--toe", "15 mm", "--safety", "0.3", "--ball", "distance")
    measured = clubface_("fem", "head", str(file), "--measure", *asked, "--json").rows()[0]
    made = fem.head(file)
    assert measured["restitution"] == head_tests.restitution(made, toe="15 mm", ball="distance", safety=0.3)
    time = head_tests.characteristic_time(made, toe="15 mm", safety=0.3)
    assert measured["characteristic_time_us"] == pytest.approx(1e6 * time, rel=1e-12)
    assert "--measure" in clubface_("fem", "head", str(file), "--toe", "15 mm").err


def test_derivatives_by_the_cg_say_that_the_delivery_is_held(clubface_):
    shot = ("sensitivity", "driver", "--speed", "105 mph", "--model", "slip")
    assert "dynamic loft, face angle and lie are held" in " ".join(clubface_(*shot).out.split())
    assert "held" not in clubface_(*shot, "--by", "toe").out


def test_a_head_with_a_target_for_its_cg_notes_that_the_delivery_is_held(clubface_, file):
    assert "held" not in clubface_("fem", "head", str(file)).out
    file.write_text(file.read_text().replace("[target]\n", '[target]\ncg_z = "1 mm"\n'))
    assert "dynamic loft, face angle and lie are held" in " ".join(clubface_("fem", "head", str(file)).out.split())
