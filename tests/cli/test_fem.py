"""``clubface fem`` and the finite elements as one more model."""

import json
import re
import sys
import time

import numpy as np
import pytest

import clubface
from clubface import fem
from clubface.errors import InputError, UnknownNameError
from command_line import MAIN, assert_mistake, interruptible, press_ctrl_c
from fem_runs import write_case

pytest.importorskip("typer")


@pytest.fixture
def paper_like(tmp_path):
    """A variation of Roh and Lee's case with a coarse ball."""
    path = write_case(tmp_path, duration=1000, old='kind = "plane"', new='kind = "rigid"\nclub = "driver"')
    path.write_text(path.read_text().replace("angle =", "loft ="))
    return path


def test_the_reference_case_is_a_result(clubface_, tmp_path):
    write_case(tmp_path)
    ran = clubface_("fem", "reference", "--ball", str(tmp_path / "ball.toml"), "--json")
    (row,) = ran.rows("reference")
    assert row["solver"] == "clubface"
    expected = fem.reference(ball=tmp_path / "ball.toml")
    assert row["normal_velocity_mps"] == expected.normal_velocity
    assert row["peak_force_kN"] == pytest.approx(1e-3 * expected.peak_force)
    assert ran.notes("cost-of-run")[0]["elements"] == 256
    assert "normal velocity" in clubface_("fem", "reference", "--ball", str(tmp_path / "ball.toml")).out


def test_the_reference_case_on_finer_meshes_says_by_how_much_they_differ(clubface_, tmp_path):
    write_case(tmp_path)
    ran = clubface_("fem", "reference", "--ball", str(tmp_path / "ball.toml"), "--meshes", "2", "--json")
    coarse, fine = ran.rows("meshes")
    assert coarse["elements"] == 256 < fine["elements"]
    (spread,) = ran.notes("mesh-spread")
    assert (spread["coarse"], spread["fine"]) == (coarse["elements"], fine["elements"])
    assert spread["spin_over_meshes"] == pytest.approx(abs(fine["backspin_rpm"] / coarse["backspin_rpm"] - 1.0))
    assert spread["speed_over_meshes"] == pytest.approx(abs(fine["ball_speed_mps"] / coarse["ball_speed_mps"] - 1.0))
    (bounds,) = ran.notes("error-bounds")
    (cost,) = ran.notes("cost-of-run")
    assert 0.01 * cost["energy_error_pct"] < bounds["spin_over_meshes"]


def test_a_shot_by_finite_elements_says_what_bounds_its_error(clubface_, tmp_path):
    report = tmp_path / "shot.html"
    arguments = ("shot", "7-iron", "--speed", "80 mph", "--loft", "25 deg", "--model")
    (bounds,) = clubface_(*arguments, "rings,fem", "--report", str(report), "--json").notes("error-bounds")
    assert bounds["spin_over_meshes"] > bounds["speed_over_meshes"] > 0.0
    assert f"{bounds['elements']} elements" in report.read_text()
    assert clubface_(*arguments, "rings", "--json").notes("error-bounds") == []


def test_paper_has_the_published_figures_and_draws(clubface_, paper_like, tmp_path):
    pytest.importorskip("matplotlib")
    ran = clubface_("fem", "paper", "--case", str(paper_like), "--json", "-o", str(tmp_path / "out"))
    published, *own = ran.rows("paper")
    assert [row["source"] for row in own] == ["penalty", "augmented-lagrange"]
    assert (published["section_spin_rpm"], published["rolling_spin_rpm"]) == pytest.approx((2047.0, 2298.0))
    assert set(own[0]) == set(published)
    for figure in ("paper", "models", "patch", "section", "sweep"):
        assert (tmp_path / "out" / f"{figure}.png").stat().st_size > 10_000
    rows = (tmp_path / "out" / "sweep.csv").read_text().splitlines()
    assert len(rows) == 2 + 7 * 5
    shown = clubface_("fem", "paper", "--case", str(paper_like)).out
    assert all(each in shown for each in ("2047", "2298", "augmented-lagrange"))


def test_a_run_writes_figures_histories_and_pictures(clubface_, tmp_path):
    pytest.importorskip("matplotlib")
    path, out = write_case(tmp_path, duration=700), tmp_path / "out"
    ran = clubface_("fem", "run", str(path), "-o", str(out), "--frames", "6", "--animate", "--json")
    assert ran.status == 0
    written = {"figures.json", "contact.csv", "motion.csv", "energy.csv", "materials.csv"}
    drawn = {"impact.png", "patch.png", "section.png", "impact.gif"}
    assert {each.name for each in out.iterdir()} == written | drawn
    figures = json.loads((out / "figures.json").read_text())
    assert figures["values"]["peak_force_kN"] == ran.values["peak_force_kN"]
    assert figures["provenance"]["inputs"]["ball"] == "soft"
    assert figures["provenance"]["inputs"]["duration"] == "700 us"
    assert float(figures["provenance"]["inputs"]["speed"]) == 35.0
    whole = {row["value of"]: row["value"] for row in ran.rows("materials") if row["piece"] == "whole ball"}
    assert whole["mass"] == pytest.approx(46.0)
    assert whole["core_density"] > 1000.0
    contact = np.genfromtxt(out / "contact.csv", delimiter=",", names=True)
    assert contact["normal_kN"].max() == pytest.approx(figures["values"]["peak_force_kN"])
    assert [row["normal_kN"] for row in ran.rows("contact")] == pytest.approx(contact["normal_kN"])
    from PIL import Image

    with Image.open(out / "impact.gif") as picture:
        assert picture.n_frames in (5, 6)  # pyright: ignore[reportAttributeAccessIssue]


def test_a_sweep_is_a_table_and_a_picture(clubface_, paper_like, tmp_path):
    pytest.importorskip("matplotlib")
    arguments = ("fem", "sweep", "--case", str(paper_like), "--speed", "30:40:10", "--loft", "9", "-o", str(tmp_path))
    assert [row["speed_mps"] for row in clubface_(*arguments, "--json").rows()] == [30.0, 40.0]
    assert (tmp_path / "sweep.png").exists()
    assert clubface_(*arguments).out.splitlines()[-1].split()[0] == "40.0"


@pytest.mark.parametrize(("form", "ending"), [("lsdyna", "mine.k"), ("vtu", "mine.pvd")])
def test_an_export_names_the_file_to_open(clubface_, tmp_path, form, ending):
    pytest.importorskip("meshlane")
    ran = clubface_("fem", "export", str(write_case(tmp_path)), "--format", form, "-o", str(tmp_path / "out"))
    assert ran.status == 0
    assert ran.err.startswith(f"clubface: wrote {tmp_path / 'out' / ending}\n")
    # The shapes are of a run that is shorter than the contact.
    assert ("still on the face" in ran.err) == (form == "vtu")
    assert (tmp_path / "out" / ending).exists()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("run", "papr"), ("case of finite elements", "did you mean paper or")),
        (("reference", "--ball", "papr"), ("unknown ball", "did you mean paper?")),
        (("reference", "--refine", "9"), ("refine is 9",)),
        (("reference", "--friction", "-1"), ("friction is -1.0",)),
        (("export", "--format", "stl"), ("lsdyna, vtu",)),
        (("run", "paper", "--animate"), ("--output",)),
        (("run", "paper", "--frames", "-1"), ("frames is -1",)),
        (("run", "paper", "-o", __file__), ("this is a file",)),
        (("run", "paper", "-o", "/proc/nowhere"), ("/proc/nowhere",)),
        (("sweep", "--speed", "30:60"), ("--speed", "first:last:step")),
        (("sweep", "--speed", "400", "--loft", "9"), ("speed", "at most 150 m/s")),
        (("sweep", "--speed", "40", "--loft", "9", "--workers", "0"), ("workers is 0",)),
    ],
)
def test_a_mistake_is_one_line(clubface_, arguments, words):
    assert_mistake(clubface_("fem", *arguments), *words)


def test_a_run_whose_elements_fail_ends_with_the_element_and_what_it_has(clubface_, tmp_path):
    pytest.importorskip("matplotlib")
    path, out = write_case(tmp_path, duration=700, old='speed = "35', new='speed = "150'), tmp_path / "out"
    # Shorter steps would save them.
    path.write_text(path.read_text().replace("[run]", "[run]\nsafety = 0.9"))
    ran = clubface_("fem", "run", str(path), "-o", str(out))
    assert ran.status == 2
    message = ran.err.splitlines()[-1]
    assert "clubface: element " in message
    assert " of c" in message  # core or cover
    assert " times its original volume" in message or " was turned inside out " in message
    assert " us: the time step is too long (choose a smaller `safety`)" in message
    contact = np.genfromtxt(out / "contact.csv", delimiter=",", names=True)
    assert contact["normal_kN"].max() > 0.0
    assert np.isfinite(contact["normal_kN"]).all()
    figures = json.loads((out / "figures.json").read_text())
    assert message.removeprefix("clubface: ") == figures["values"]["stopped"]
    # The energy balance is that of an earlier time than the error.
    (cost,) = (each["data"] for each in figures["notes"] if each["code"] == "cost-of-failed-run")
    last = np.genfromtxt(out / "energy.csv", delimiter=",", names=True)["time_s"][-1]
    assert cost["last_time_s"] == pytest.approx(last)
    assert last < 1e-6 * float(re.search(r" at (\d+) us:", message)[1])


def test_ctrl_c_keeps_what_was_computed(tmp_path):
    pytest.importorskip("matplotlib")
    # Longer than any test waits.
    path = write_case(tmp_path, duration=100_000, old="./ball.toml", new="reference")
    command = [sys.executable, "-c", MAIN, "fem", "run", str(path), "--frames", "5000", "-o"]
    for patience in (1.0, 4.0, 12.0):  # until the run itself has begun, however busy the machine
        out = tmp_path / f"out-{patience:.0f}"
        with interruptible([*command, str(out)]) as child:
            started = time.monotonic()
            while not out.exists() and child.poll() is None and time.monotonic() - started < 30:
                time.sleep(0.02)
            time.sleep(patience)
            press_ctrl_c(child)
            _, message = child.communicate()
        assert child.returncode == 130
        assert message.splitlines()[-1].startswith("clubface: interrupted")
        if (out / "figures.json").exists():
            break
    assert message.splitlines()[-1].startswith("clubface: interrupted at ")
    assert "by request" in json.loads((out / "figures.json").read_text())["values"]["stopped"]
    for name in ("contact.csv", "motion.csv", "energy.csv"):
        table = np.genfromtxt(out / name, delimiter=",", skip_header=1)
        assert np.isfinite(table).all()


@pytest.mark.parametrize("patience", [0.3, 0.45, 0.6])
def test_ctrl_c_while_a_head_is_meshed_is_one_line(patience):
    command = [sys.executable, "-c", MAIN, "fem", "head", "paper"]
    with interruptible(command) as child:
        time.sleep(patience)
        press_ctrl_c(child)
        _, message = child.communicate()
    # Whenever it comes, it must not break what the core is making; the words may still be those of Python.
    assert "panicked" not in message, message
    assert "PanicException" not in message, message


def test_the_model_gives_the_launch_of_its_own_run():
    launch = clubface.impact("driver", speed="108 mph", toe="5 mm", model="fem", parameters={"friction": 0.3})
    how = fem.Settings(until_separation=True)
    result = fem.strike("driver", speed="108 mph", toe="5 mm", friction=0.3, settings=how)
    assert launch.ball_speed == result.launch.ball_speed
    assert launch.peak_force == result.peak_force
    assert launch.ball.name == "modern"
    assert launch.provenance["parameters"]["values"] == {"friction": 0.3}


def test_a_shot_by_two_models_and_its_picture(clubface_, tmp_path):
    pytest.importorskip("matplotlib")
    arguments = ("shot", "driver", "--speed", "48 m/s", "--model", "standard,fem", "--json")
    rows = clubface_(*arguments, "--plot", str(tmp_path / "shot.png")).rows()
    assert [row["model"] for row in rows] == ["standard", "fem"]
    assert list(rows[0]) == list(rows[1])
    assert rows[1]["ball_speed_mps"] == pytest.approx(rows[0]["ball_speed_mps"], rel=0.05)
    assert (tmp_path / "shot.png").exists()


def test_options_without_meaning_for_finite_elements_are_refused():
    shot = {"speed": 48.0}
    with pytest.raises(InputError, match="contact model"):
        clubface.history("driver", shot, model="fem")
    with pytest.raises(InputError, match="derivatives"):
        clubface.sensitivity("driver", shot, model="fem")
    with pytest.raises(InputError, match="accuracy"):
        clubface.impact("driver", shot, model="fem", accuracy=1e-6)
    with pytest.raises(UnknownNameError, match="unknown ball"):
        clubface.impact("driver", shot, model="fem", ball="publishd")
    with pytest.raises(InputError, match="distance, modern, "):
        clubface.impact("driver", shot, model="fem", ball="conforming")
    result = clubface.impact("driver", speed=[4800.0], model="fem", on_error="nan")
    assert np.isnan(result.ball_speed).all()
    assert result.problems[0].parameter == "speed"
