"""Studies of finite elements that sweep keys of the files of ball and head, and keep histories."""

from dataclasses import replace

import numpy as np
import pytest

from clubface import fem, studies
from clubface.errors import FileError, InputError
from clubface.fem.case import case
from clubface.fem.heads.read import from_toml
from clubface.studies.study import read_study
from clubface.support.files import builtin_path
from fem_runs import write_case

pytest.importorskip("pyarrow")

ENERGY = 'energy = "c10*(I1-3) + c20*(I1-3)^2"\nc10 = "5 MPa"\nc20 = "0.2 MPa"\n'
RIVLIN = 'law = "mooney-rivlin"\nc10 = "4 MPa"\nc01 = "1 MPa"\n'


def study_of(folder, sweep, table='case = "./case.toml"', of_study=""):
    path = folder / "study.toml"
    path.write_text(f'[study]\nkind = "fem"\nchunk = 2\n{of_study}\n[fem]\n{table}\n[sweep]\n{sweep}\n')
    return path


def computed(folder, sweep, table='case = "./case.toml"'):
    study = read_study(study_of(folder, sweep, table))
    return study, study.task.run(range(study.design.count))


def changed(chosen, place, **changes):
    """A case with keys of a piece of the ball changed."""
    pieces = list(chosen.ball.pieces)
    pieces[place] = replace(pieces[place], **changes)
    return chosen.replace(ball=replace(chosen.ball, pieces=tuple(pieces)))


def test_constants_of_a_material_are_swept(tmp_path):
    path = write_case(tmp_path, duration=900)
    _, result = computed(tmp_path, 'core.c10 = ["3 MPa", "4 MPa"]\ncover.poisson = [0.3, 0.4]')
    assert not result.failed
    chosen = case(path)
    core, cover = (piece.material for piece in chosen.ball.pieces)
    assert result.columns["peak_force"][3] == chosen.run().peak_force
    # A file that says youngs keeps it where its poisson changes.
    soft = replace(core, constants={"c10": 3e6, "c01": 1e6})
    other = fem.Material.linear("350 MPa", 0.3, cover.density)
    one = changed(changed(chosen, 0, material=soft), 1, material=other).run()
    assert result.columns["peak_force"][0] == pytest.approx(one.peak_force, rel=1e-9)
    assert result.columns["peak_force"][0] != result.columns["peak_force"][2]


def test_constants_of_an_energy_are_swept(tmp_path):
    path = write_case(tmp_path, duration=900, old=RIVLIN, new=ENERGY)
    study, result = computed(tmp_path, 'core.c20 = { from = "0 MPa", to = "0.2 MPa", count = 2 }')
    assert [each.unit for each in study.design.axes] == ["Pa"]
    assert result.columns["peak_force"][1] == case(path).run().peak_force
    assert result.columns["peak_force"][0] < result.columns["peak_force"][1]


def test_the_mesh_of_a_ball_is_swept(tmp_path):
    path = write_case(tmp_path, duration=900)
    _, result = computed(tmp_path, "cube = [4, 6]\ncover.layers = [1, 2]\nball.element = ['full']")
    assert not result.failed
    finer = case(path)
    finer = finer.replace(ball=replace(finer.ball, cube=6, element="full"))
    assert result.columns["peak_force"][3] == changed(finer, 1, layers=2).run().peak_force


def test_walls_and_metal_of_a_head_are_swept(tmp_path):
    head = from_toml(builtin_path("head", "paper", "fem_heads"))
    head = replace(head, elements=(14, 8, 10), thickness={**head.thickness, "face_centre": 3.1e-3})
    (tmp_path / "head.toml").write_text(fem.heads.head_text(head))
    path = write_case(tmp_path, duration=900, old='kind = "plane"', new='kind = "meshed"\nclub = "./head.toml"')
    path.write_text(path.read_text().replace('angle = "11.5 deg"', 'loft = "11.5 deg"'))
    _, result = computed(tmp_path, 'face_centre = ["2.8 mm"]\nmetal.youngs = ["110 GPa"]\ncore.c10 = ["3 MPa"]')
    assert not result.failed, result.failed
    chosen = case(path)
    thin = replace(head, thickness={**head.thickness, "face_centre": 2.8e-3}, metal=replace(head.metal, youngs=110e9))
    soft = replace(chosen.ball.pieces[0].material, constants={"c10": 3e6, "c01": 1e6})
    one = changed(chosen.replace(club=fem.head(thin)), 0, material=soft).run()
    # The file holds lengths to 0.1 um.
    assert result.columns["peak_force"][0] == pytest.approx(one.peak_force, rel=1e-6)
    assert abs(one.peak_force / chosen.run().peak_force - 1.0) > 1e-3


@pytest.mark.parametrize(
    ("sweep", "message"),
    [
        ('core.c11 = ["1 MPa"]', "unknown input"),
        ('core.c10 = ["1 mm"]', "c10"),
        ("core.layers = [1.5]", "whole number"),
        ("core.layers = [100]", "whole number from 1 to 48"),
        ('ball.element = ["half"]', "one-point"),
        ("cube = [4]\nball.cube = [6]", "swept twice"),
    ],
)
def test_a_mistake_in_a_swept_key_is_named(tmp_path, sweep, message):
    write_case(tmp_path, duration=900)
    with pytest.raises(FileError, match=message):
        _ = read_study(study_of(tmp_path, sweep)).task


def test_a_swept_value_that_the_file_may_not_hold_leaves_that_task_without_a_result(tmp_path):
    write_case(tmp_path, duration=900)
    _, result = computed(tmp_path, "core.poisson = [0.49, 0.5]\ncube = [4, 5]")
    assert [index for index, _ in result.failed] == [1, 2, 3]
    messages = [message for _, message in result.failed]
    # With the file and the line of the key.
    assert all(word in messages[0] for word in ("ball.toml", "cube", "even"))
    assert "poisson of core is 0.5" in messages[1]


def test_balls_by_name_each_take_the_swept_keys(tmp_path):
    write_case(tmp_path, duration=900)
    (tmp_path / "other.toml").write_text((tmp_path / "ball.toml").read_text().replace("4 MPa", "6 MPa"))
    study, result = computed(tmp_path, 'ball = ["./ball.toml", "./other.toml"]\ncore.c01 = ["1 MPa", "2 MPa"]')
    assert study.design.count == 4
    assert len({*result.columns["peak_force"].tolist()}) == 4
    assert np.all(np.diff(result.columns["peak_force"]) > 0.0)  # the stiffer, the larger


TABLE = 'case = "./case.toml"\nhistories = ["contact", "energy", "motion"]'


def test_histories_are_kept_and_read_by_one_call(tmp_path, in_this_process):
    path = write_case(tmp_path, duration=900)
    study = study_of(tmp_path, 'core.c10 = ["3 MPa", "4 MPa", "5 MPa"]', TABLE)
    with pytest.raises(FileError):
        studies.histories(study, "contact")
    studies.run(study, workers=1)
    contact = studies.histories(study, "contact")
    assert {*contact["task"].tolist()} == {0.0, 1.0, 2.0}
    one = case(path).run()
    own = {name: column[contact["task"] == 1] for name, column in contact.items()}
    assert own.pop("task").size == one.steps
    assert all(np.array_equal(own[name], one.contact[name]) for name in one.contact)
    motion = studies.histories(study, "motion", tasks=[1])
    assert np.array_equal(motion["spin_toe"], one.motion["spin"][:, 2])
    energy = studies.histories(study, "energy", tasks=[1])
    assert np.array_equal(energy["strain"], one.energy["strain"])
    for name, tasks in (("stress", None), ("contact", [3])):
        with pytest.raises(InputError):
            studies.histories(study, name, tasks=tasks)


def test_a_lost_history_is_computed_again(tmp_path, in_this_process):
    write_case(tmp_path, duration=900)
    study = study_of(tmp_path, 'core.c10 = ["3 MPa", "4 MPa", "5 MPa"]', TABLE)
    studies.run(study, workers=1)
    before = studies.histories(study, "energy")
    files = sorted((tmp_path / "study.store" / "histories" / "energy").rglob("*.parquet"))
    files[0].unlink()
    files[1].write_bytes(files[1].read_bytes()[:-20])
    outcome = studies.run(study, workers=1)
    assert outcome.computed == 2
    again = studies.histories(study, "energy")
    assert all(np.array_equal(again[name], before[name]) for name in before)


def test_a_study_without_histories_says_so(tmp_path, in_this_process):
    write_case(tmp_path, duration=900)
    study = study_of(tmp_path, 'core.c10 = ["3 MPa"]')
    studies.run(study, workers=1)
    assert not (tmp_path / "study.store" / "histories").exists()
    with pytest.raises(InputError, match="histories"):
        studies.histories(study, "contact")
