"""``clubface evaluate`` on the benchmark shots."""

from pathlib import Path

import pytest

import clubface
from clubface.errors import FileError
from clubface.validation.benchmark_data import FOLDER
from command_line import assert_mistake

pytest.importorskip("typer")
pytest.importorskip("pyarrow")

SHOTS = str(FOLDER / "7-iron.parquet")


def test_the_club_is_taken_from_the_shots_and_tables_are_printed(clubface_):
    ran = clubface_("evaluate", SHOTS, "--models", "standard,slip")
    assert ran.status == 0
    text = " ".join(ran.out.split())
    for words in ("Mean absolute error, 120 shots", "As published for the 7-iron", "Best model", "0.25", "5.12%*"):
        assert words in text


def test_json_holds_errors_models_and_notes(clubface_):
    document = clubface_("evaluate", SHOTS, "--models", "slip", "--json").json
    assert (document["club"], document["shots"]) == ("7-iron", 120)
    assert set(document["errors"]) == {"ball_speed", "launch", "azimuth", "backspin", "sidespin"}
    assert document["models"]["slip"]["parameters"]["values"]["slip_z"] == 0.0423


def test_parameters_of_several_files_and_settings_are_used(clubface_, tmp_path):
    import clubface

    for model, values in {"slip": {"slip_y": 0.1}, "standard": {"cor": 0.8}}.items():
        changed = clubface.ParameterSet.builtin(model, "7-iron").replace(**values)
        (tmp_path / f"{model}.toml").write_text(changed.to_toml())
    files = [part for name in ("slip", "standard") for part in ("--parameters", str(tmp_path / f"{name}.toml"))]
    ran = clubface_("evaluate", SHOTS, "--models", "slip,standard,adjusted", *files, "--set", "slip_z=0.2", "--json")
    values = {name: each["parameters"]["values"] for name, each in ran.json["models"].items()}
    assert (values["slip"]["slip_y"], values["slip"]["slip_z"]) == (0.1, 0.2)
    assert values["standard"]["cor"] == 0.8
    assert values["adjusted"]["extra_mass"] == 0.0101


def test_noise_is_given_with_units(clubface_):
    ran = clubface_(
        "evaluate", SHOTS, "--models", "slip", "--noise", "launch=0.1 deg", "--delivery-noise", "face=1 deg", "--json"
    )
    noise = ran.json["noise"]
    assert noise["monitor"]["launch"] == pytest.approx(0.1 * 3.141592653589793 / 180)
    assert noise["perfect_model_mae"]["azimuth"] > 0.5 * 3.141592653589793 / 180


def test_the_report_is_written(clubface_, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.setattr(
        "clubface.inference.evaluation.Evaluation.write", lambda result, folder: [f"{folder}: {len(result.shots)}"]
    )
    ran = clubface_("evaluate", SHOTS, "--models", "slip", "-o", str(tmp_path / "out"))
    assert ran.err == f"clubface: wrote {tmp_path / 'out'}: 120\n"
    assert (tmp_path / "out").is_dir()


def test_the_report_does_not_take_the_place_of_the_shots(clubface_, write):
    path = write("club,club_speed_mph,loft_deg,ball_speed_mph\ndriver,100,12,148\n", "evaluation.csv")
    before = path.read_text()
    assert_mistake(clubface_("evaluate", str(path), "-o", str(path.parent)), "would overwrite this file")
    assert path.read_text() == before
    with pytest.raises(FileError, match="would overwrite"):
        clubface.evaluate(path, models=["slip"]).write(path.parent)


def test_shots_of_another_club_are_refused_unless_a_note_is_enough(clubface_):
    assert_mistake(clubface_("evaluate", SHOTS, "--club", "driver"), "the shots name 7-iron, not driver")
    ran = clubface_("evaluate", SHOTS, "--club", "driver", "--models", "slip", "--mismatch", "note")
    assert "the shots name 7-iron, not driver: is this the right club?" in ran.out


def test_mistakes_are_one_message(clubface_, write):
    assert_mistake(clubface_("evaluate", SHOTS, "--models", "slipp"), "did you mean slip")
    assert_mistake(clubface_("evaluate", SHOTS, "--noise", "launch"), "--noise", "name=value")
    assert_mistake(clubface_("evaluate", SHOTS, "--only", "driver"), "7-iron (120)")
    assert_mistake(clubface_("evaluate", "missing.csv"), "missing.csv")
    no_launch = write("club_speed_mph\n100\n")
    assert_mistake(clubface_("evaluate", str(no_launch), "--club", "driver"), "measured launch")
    assert_mistake(clubface_("evaluate", str(no_launch)), "the shots name none")


def test_a_launch_monitors_file_is_read_as_it_is(clubface_):
    trackman = str(Path(__file__).parents[1] / "data" / "launch_monitors" / "trackman.csv")
    assert_mistake(
        clubface_("evaluate", trackman),
        "--only is missing; give one of the several clubs that were hit: Driver (1), 7 Iron (2)",
    )
    document = clubface_("evaluate", trackman, "--only", "7 iron", "--models", "standard", "--json").json
    assert (document["club"], document["shots"]) == ("7-iron", 1)  # of the other one the clubhead speed is missing
    assert not any("referred to" in note for note in document["notes"])  # no face angle was measured
    document = clubface_("evaluate", trackman, "--only", "driver", "--models", "standard", "--json").json
    assert any("referred to the face centre of driver" in note for note in document["notes"])
