"""``clubface identify`` from files."""

from __future__ import annotations

import hashlib
import os
import sys
import time
from glob import glob
from pathlib import Path

import pytest

import clubface
from clubface.errors import ClubfaceError
from command_line import MAIN, assert_mistake, interruptible, press_ctrl_c
from synthetic_shots import recorded

pytest.importorskip("typer")

FAST = ("--population", "12", "--generations", "4", "--refined", "2", "--folds", "3", "--bootstrap", "5")


def parameters(document):
    """The rows of all parameters by name."""
    return {row["parameter"]: row for row in document["tables"]["parameters"]["rows"]}


@pytest.fixture
def drives(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    recorded(20, "slip", noise=1.0).write("drives.csv")
    return "drives.csv"


def test_shots_become_parameters_as_table_json_and_file(clubface_, drives):
    ran = clubface_("identify", drives, "--club", "driver", "--model", "slip", *FAST, "-o", "fit.toml")
    assert ran.status == 0
    assert "Parameters of slip from 20 shots with driver" in ran.out
    again = clubface_("identify", drives, "--club", "driver", "--model", "slip", *FAST, "--json").json
    assert again["values"]["model"] == "slip"
    assert again["values"]["cost"] < again["values"]["cost_holdout"]
    (used,) = again["provenance"]["files"]
    assert used["sha256"] == hashlib.sha256(Path(drives).read_bytes()).hexdigest()
    written = clubface.ParameterSet.from_toml("fit.toml")
    assert used["sha256"] in written.source
    result = clubface.identify(
        clubface.read_shots(drives), club="driver", model="slip", population=12, generations=4, refined=2, folds=3,
        bootstrap=5,
    )  # fmt: skip
    rows = parameters(again)
    assert {name: row["value"] for name, row in rows.items()} == dict(result.parameters.values) == dict(written.values)
    assert {name: (rows[name]["low"], rows[name]["high"]) for name in result.free} == result.intervals
    assert again["values"]["cost_holdout"] == result.cost_holdout
    # Nothing is left beside the files asked for.
    assert sorted(os.listdir()) == ["drives.csv", "fit.toml"]
    used = clubface_("shot", "driver", "--speed", "113 mph", "--model", "slip", "--parameters", "fit.toml", "--json")
    assert used.status == 0


def test_the_fit_is_drawn(clubface_, drives):
    pytest.importorskip("matplotlib")
    ran = clubface_("identify", drives, "--club", "driver", "--model", "slip", *FAST, "--plot", "fit.PNG")
    assert ran.status == 0
    with open("fit.PNG", "rb") as file:
        assert file.read(4) == b"\x89PNG"


def test_what_is_kept_has_a_name_that_every_system_takes(clubface_, drives, monkeypatch):
    """Windows takes none of these signs, and hides what follows a colon."""
    Path("own.toml").write_text(clubface.Club.template('my "<9|8>*?": 1/2'), encoding="utf-8")
    names = []

    def stopped(*_, checkpoint, **__):
        names.append(checkpoint)
        raise ClubfaceError("that is all")

    monkeypatch.setattr("clubface.inference.identification.run.identify", stopped)
    assert_mistake(clubface_("identify", drives, "--club", "own.toml", "--model", "slip"), "that is all")
    assert names[0].startswith("drives-my ")
    assert not set('<>:"/\\|?*') & set(names[0])


def test_options_reach_the_fit(clubface_, drives):
    ran = clubface_(
        "identify", drives, "--club", "driver", "--model", "slip", *FAST, "--free", "cor,slip_y",
        "--set", "slip_z=0.01", "--bounds", "cor=0.7:0.9", "--cost", "robust", "--noise", "backspin=80 rpm",
        "--no-profiles", "--seed", "7", "--quantity", "ball_speed,backspin", "--json",
    ).json  # fmt: skip
    rows = parameters(ran)
    assert [name for name, row in rows.items() if row["identified"]] == ["cor", "slip_y"]
    assert rows["slip_z"]["value"] == 0.01
    assert (rows["cor"]["bound_low"], rows["cor"]["bound_high"]) == (0.7, 0.9)
    assert ran["values"]["cost_kind"] == "robust"
    deviations = ran["tables"]["deviations"]["rows"]
    assert [row["quantity"] for row in deviations] == ["ball_speed", "backspin"]
    assert deviations[1]["noise"] == pytest.approx(80.0)
    assert ran["provenance"]["inputs"]["seed"] == "7"
    assert "profiles" not in ran["tables"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("missing.csv",), ("missing.csv", "No such file")),
        (("drives.csv", "--club", "7-iron"), ("7-iron", "dynamic loft")),
        (("drives.csv", "--model", "slipp"), ("slipp", "slip")),
        (("drives.csv", "--model", "slip", "--free", "friction"), ("friction", "slip_y")),
        (("drives.csv", "--model", "slip", "--bounds", "slip_y=0.1"), ("--bounds", "name=low:high")),
        (("drives.csv", "--model", "slip", "--tie", "slip_z=cor"), ("slip_z", "cor")),
        (("drives.csv", "--model", "slip", "--cost", "mean"), ("mean", "published")),
        (("drives.csv", "--model", "slip", "-o", "fit.json"), ("--output", ".toml")),
        (("drives.csv", "--model", "slip", "--plot", "fit.doc"), ("--plot", "fit.doc", ".png, .svg, .pdf")),
        (("drives.csv", "--model", "slip", "-o", "none/fit.toml"), ("--output", "none/fit.toml", "folder that exists")),
        (("drives.csv", "--model", "slip", "--plot", "none/a.png"), ("--plot", "none/a.png", "folder that exists")),
        (
            ("drives.csv", "--model", "slip", "--checkpoint", "drives.csv"),
            ("drives.csv", "not a record of unfinished work", "another name"),
        ),
        (
            ("drives.csv", "--club", "own.toml", "-o", "./own.toml"),
            ("--output", "a file other than the inputs"),
        ),
        (("drives.csv", "--model", "fem"), ("fem", "volumetric")),
        (("swing.c3d",), ("swing.c3d", "clubface capture read")),
        (("empty.csv",), ("empty.csv",)),
        (("header.csv",), ("header.csv", "no shots")),
        (("words.csv",), ("words.csv",)),
    ],
)
def test_a_mistake_is_one_message(clubface_, drives, arguments, words):
    open("empty.csv", "w").close()
    with open("own.toml", "w") as file:
        file.write(clubface.Club.template())
    with open("header.csv", "w") as file:
        file.write("club_speed_mph,ball_speed_mph\n")
    with open("words.csv", "w") as file:
        file.write("club_speed_mph,ball_speed_mph\nfast,very fast\n")
    club = () if "--club" in arguments else ("--club", "driver")
    model = () if "--model" in arguments else ("--model", "standard")
    before = {each.name: each.read_bytes() for each in Path().iterdir()}
    assert_mistake(clubface_("identify", *arguments, *club, *model, *FAST), *words)
    assert {each.name: each.read_bytes() for each in Path().iterdir()} == before


def test_ctrl_c_keeps_what_is_finished_and_resume_goes_on(clubface_, drives):
    arguments = ("identify", drives, "--club", "driver", "--model", "area", "--population", "40", "--generations",
                 "120", "--refined", "1", "--folds", "0", "--bootstrap", "0", "--no-profiles")  # fmt: skip
    kept = "drives-driver-area.checkpoint"
    with interruptible([sys.executable, "-c", MAIN, *arguments]) as process:
        deadline = time.monotonic() + 60.0
        while not glob(f"{kept}/values.jsonl") and time.monotonic() < deadline:
            time.sleep(0.02)
        press_ctrl_c(process)
        out, err = process.communicate(timeout=30)
    assert process.returncode == 130
    assert out == ""
    assert f"kept in {kept}" in err
    assert "Traceback" not in err
    resumed = clubface_(*arguments, "--resume", "--json").json
    whole = clubface_(*arguments, "--json").json
    del resumed["values"]["wall_time_s"], whole["values"]["wall_time_s"]
    assert resumed == whole
    assert not os.path.exists(kept)
