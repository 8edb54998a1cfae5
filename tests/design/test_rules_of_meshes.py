"""What is known of a meshed head beside the rules, and what reports say of its face."""

import json
from dataclasses import replace

import numpy as np
import pytest

import clubface
from clubface import fem
from clubface.design.optimisation.study import design_study
from clubface.design.rules import check_rules
from clubface.fem.heads import MeshHead
from fem_meshes import GROUPS, HEAD, coarse_walls, write_walls
from fem_runs import coarse_head

pytestmark = pytest.mark.filterwarnings("ignore::clubface.errors.MeshWarning")
FACE = {"loft": "11.5 deg", "bulge": "305 mm", "roll": "305 mm"}


@pytest.fixture
def own(tmp_path, write):
    write_walls(tmp_path, coarse_walls())
    return write(HEAD.replace("head.msh", "abaqus.inp"), "own.toml")


def verdicts(head, **size):
    return {each.rule.name: each for each in check_rules(head, **size)}


def test_an_unmeasured_face_is_not_called_conforming(own, clubface_):
    assert verdicts(own)["characteristic_time"].words == "not measured"
    assert verdicts(clubface.club("driver").replace(characteristic_time=0.0))["characteristic_time"].conforms is None
    printed = clubface_("club", "check", str(own)).out
    row = next(line for line in printed.splitlines() if line.startswith("characteristic time of the face"))
    assert "not measured" in row
    assert "--measure" in printed
    document = json.loads(clubface_("club", "check", str(own), "--json").out)
    result = {each["quantity"]: each for each in document["tables"]["rules"]["rows"]}
    assert result["characteristic_time"]["value"] is None
    own.write_text(own.read_text().replace("unit =", 'characteristic_time = "270 us"\nunit ='))
    with pytest.warns(clubface.errors.RuleWarning):
        assert verdicts(clubface.club(own))["characteristic_time"].words == "does not conform"


def test_volume_and_dimensions_of_a_closed_mesh_are_those_of_its_outside():
    head = coarse_head()
    inner, outer = replace(head, thickness=0.0 * head.thickness), head
    assert inner.volume is not None
    assert outer.volume is not None
    a, b, c, d = (head.nodes[head.quads[:, corner]] for corner in range(4))
    area = 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1)
    assert outer.volume - inner.volume == pytest.approx(0.5 * area @ head.thickness, rel=1e-12)
    low, high = head.nodes.min(axis=0), head.nodes.max(axis=0)
    assert np.all(np.array(head.size) > high - low)
    result = verdicts(head.as_club())
    assert result["volume"].value == outer.volume
    assert result["heel_to_toe"].value == head.size[2]
    assert verdicts(head.as_club(), volume="480 cc")["volume"].words == "does not conform"


def test_a_box_of_shells_has_the_volume_of_the_box(tmp_path):
    box = np.array([[x, y, z] for x in (0, -80) for y in (-25, 25) for z in (-50, 50)], float)
    sides = {"face": [0, 2, 3, 1], "back": [4, 5, 7, 6], "top": [2, 6, 7, 3], "low": [0, 1, 5, 4],
             "left": [0, 4, 6, 2], "right": [1, 3, 7, 5]}  # fmt: skip
    head = replace(
        coarse_head(), nodes=box * 1e-3, quads=np.array(list(sides.values())), thickness=np.full(6, 2e-3),
        added=np.zeros(8), parts=tuple(fem.heads.Part(name, 1, fem.heads.Metal(), name == "face") for name in sides),
    )  # fmt: skip
    assert head.volume == pytest.approx(400e-6 + 0.5 * 2e-3 * 2 * (0.08 * 0.1 + 0.05 * 0.1 + 0.08 * 0.05))


def test_of_an_open_mesh_the_volume_cannot_be_checked(tmp_path):
    walls = coarse_walls()
    parts = {**walls.parts, "crown": walls.parts["crown"][1:]}
    path = write_walls(tmp_path, walls._replace(parts=parts))
    result = verdicts(MeshHead(name="open", file=path, groups=GROUPS, **FACE).mesh().as_club())
    assert result["volume"].conforms is None
    assert "not closed" in result["volume"].words
    assert result["heel_to_toe"].conforms


@pytest.mark.parametrize("command", ["shot", "compare"])
def test_a_report_says_that_the_face_of_a_mesh_was_taken_as_rigid(own, clubface_, tmp_path, command):
    pytest.importorskip("matplotlib")
    more = {"shot": (), "compare": ("driver",)}[command]
    report = tmp_path / "report.md"
    arguments = (command, str(own), *more, "--speed", "100 mph", "--report", str(report))
    ran = clubface_(*arguments)
    assert ran.status == 0, ran.err
    assert "treats the face of own head as rigid" in report.read_text()
    own.write_text(own.read_text().replace("unit =", 'characteristic_time = "230 us"\nunit ='))
    assert clubface_(*arguments).status == 0
    assert "as rigid: its file" not in report.read_text()


def test_an_optimum_of_a_meshed_head_is_held_against_the_volume_and_size_of_its_mesh(own, write):
    head = fem.head(own)
    study = f"""\
title = "Mass inside a mesh"
club = "{own.name}"
golfer = "handicap-10-driver"
objective = "carry"
[variables]
mass_distribution = "free"
[head]
size = ["115 mm", "62 mm", "124 mm"]
centre = ["-55 mm", "-1 mm", "3 mm"]
volume = "450 cm3"
discretionary_mass = "30 g"
[rules]
conform = false
"""
    result = design_study(write(study, "study.toml"))
    values = {each.rule.name: each.value for each in result.rule_values(result.club)}
    assert (values["volume"], values["heel_to_toe"]) == (head.volume, head.size[2])
