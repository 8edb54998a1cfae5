"""``clubface evaluate`` on the benchmark shots."""

import hashlib
from pathlib import Path

import pytest

import clubface
from clubface.errors import FileError
from clubface.validation.benchmark_data import FOLDER
from command_line import assert_mistake

pytest.importorskip("typer")
pytest.importorskip("pyarrow")

SHOTS = str(FOLDER / "7-iron.parquet")


def parameters(document):
    """Values by model and name."""
    return {(row["model"], row["parameter"]): row["value"] for row in document["tables"]["parameters"]["rows"]}


def test_the_club_is_taken_from_the_shots_and_tables_are_printed(clubface_):
    ran = clubface_("evaluate", SHOTS, "--models", "standard,slip")
    assert ran.status == 0
    text = " ".join(ran.out.split())
    for words in ("Models compared with 120 measured shots: 7-iron", "Best model", "0.25", "printed 5.12 %"):
        assert words in text


def test_json_has_errors_models_and_the_fingerprint_of_the_shots(clubface_, tmp_path):
    shots = tmp_path / "shots.parquet"
    shots.write_bytes(Path(SHOTS).read_bytes())
    document = clubface_("evaluate", str(shots), "--models", "slip", "--json").json
    assert (document["values"]["club"], document["values"]["shots"]) == ("7-iron", 120)
    errors = document["tables"]["errors"]["rows"]
    assert {row["quantity"] for row in errors} == {"ball_speed", "launch", "azimuth", "backspin", "sidespin"}
    assert parameters(document)["slip", "slip_z"] == 0.0423
    (used,) = document["provenance"]["files"]
    assert used["sha256"] == hashlib.sha256(shots.read_bytes()).hexdigest()


def test_parameters_of_several_files_and_settings_are_used(clubface_, tmp_path):
    import clubface

    for model, values in {"slip": {"slip_y": 0.1}, "standard": {"cor": 0.8}}.items():
        changed = clubface.ParameterSet.builtin(model, "7-iron").replace(**values)
        (tmp_path / f"{model}.toml").write_text(changed.to_toml())
    files = [part for name in ("slip", "standard") for part in ("--parameters", str(tmp_path / f"{name}.toml"))]
    ran = clubface_("evaluate", SHOTS, "--models", "slip,standard,adjusted", *files, "--set", "slip_z=0.2", "--json")
    values = parameters(ran.json)
    assert (values["slip", "slip_y"], values["slip", "slip_z"]) == (0.1, 0.2)
    assert values["standard", "cor"] == 0.8
    assert values["adjusted", "extra_mass"] == pytest.approx(10.1)  # g


def test_noise_is_given_with_units(clubface_):
    ran = clubface_(
        "evaluate", SHOTS, "--models", "slip", "--noise", "launch=0.1 deg", "--delivery-noise", "face=1 deg", "--json"
    )
    noise = {row["quantity"]: row for row in ran.json["tables"]["noise"]["rows"]}
    assert noise["launch"]["deviation"] == pytest.approx(0.1)
    assert noise["face"]["deviation"] == pytest.approx(1.0)
    assert noise["azimuth"]["perfect_mae"] > 0.5


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
    assert (document["values"]["club"], document["values"]["shots"]) == (
        "7-iron",
        1,
    )  # of the other one the clubhead speed is missing
    assert "referred-contact-face" not in {each["code"] for each in document["notes"]}  # no face angle was measured
    document = clubface_("evaluate", trackman, "--only", "driver", "--models", "standard", "--json").json
    assert "referred-contact-face" in {each["code"] for each in document["notes"]}
