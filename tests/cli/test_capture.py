"""``clubface capture`` on the command line."""

import math
from pathlib import Path

import pytest

pytest.importorskip("ezc3d")

from command_line import assert_mistake


@pytest.fixture
def folder(clubface_, tmp_path):
    ran = clubface_("capture", "synthesize", "-o", str(tmp_path / "swings"), "--count", "3", "--noise", "0.2 mm")
    assert ran.status == 0
    assert "wrote 3 swings, calibration.c3d, markers.toml, truth.csv" in ran.err
    return tmp_path / "swings"


def arguments(folder, *files):
    paths = [str(folder / name) for name in files or ("swing-001.c3d",)]
    return ["capture", "read", *paths, "--markers", str(folder / "markers.toml"), "--club", "driver"]


def rows_of(document, name, **wanted):
    return [row for row in document["tables"][name]["rows"] if all(row[key] == value for key, value in wanted.items())]


def test_one_swing_is_printed_value_by_value_each_with_its_standard_deviation(clubface_, folder):
    ran = clubface_(*arguments(folder))
    assert ran.status == 0
    document = clubface_(*arguments(folder), "--json").json
    values, deviations = document["tables"]["deliveries"]["rows"]
    (line,) = [each for each in ran.out.splitlines() if each.startswith("dynamic loft, deg")]
    # Rounded to the digits printed.
    assert [float(each) for each in line.split()[-2:]] == pytest.approx([values["loft_deg"], deviations["loft_deg"]],
                                                                        abs=0.00501)  # fmt: skip
    assert len(values) == 2 + 11 + 3
    (swing,) = rows_of(document, "swings")
    assert f"{swing['marker_noise_mm']:.3f} mm" in ran.out


def test_a_swing_is_read_within_four_standard_deviations(clubface_, folder):
    from clubface.shots.reading import read_shots

    truth = read_shots(folder / "truth.csv").deliveries
    values, deviations = clubface_(*arguments(folder), "--json").json["tables"]["deliveries"]["rows"]
    sizes = {"mps": 1.0, "deg": math.pi / 180, "mm": 1e-3, "degps": math.pi / 180}
    for key, deviation in deviations.items():
        name, _, unit = key.rpartition("_")
        if name in truth:
            assert abs(values[key] - truth[name][0] / sizes[unit]) < 4 * deviation, name


def test_json_holds_covariance_frames_and_estimator(clubface_, folder):
    document = clubface_(*arguments(folder), "--json").json
    _, deviations = rows_of(document, "deliveries")
    (loft,) = rows_of(document, "covariances", quantity="loft")
    assert math.degrees(math.sqrt(loft["loft"])) == pytest.approx(deviations["loft_deg"])
    (swing,) = rows_of(document, "swings")
    assert swing["frame_after"] == swing["frame_before"] + 1
    assert document["notes"] == []
    linear = clubface_(*arguments(folder), "--estimator", "linear", "--json").json
    (swing,) = rows_of(linear, "swings")
    assert (swing["estimator"], swing["misfit"]) == ("linear", None)
    assert rows_of(linear, "deliveries")[1]["speed_mps"] > deviations["speed_mps"]


def test_many_swings_make_a_table_and_files(clubface_, folder, monkeypatch):
    names = [f"swing-00{number}.c3d" for number in (1, 2, 3)]
    (folder / "swing-002.c3d").write_bytes(b"")
    monkeypatch.chdir(folder)  # a long path would be wrapped in the table
    ran = clubface_(*arguments(Path(), *names), "-o", str(folder / "shots.csv"))
    assert ran.status == 0
    assert names[0] in ran.out
    assert names[2] in ran.out
    assert "swing-002.c3d: the file is empty" in ran.err
    assert (folder / "shots.csv").read_text().count("\n") == 3
    assert (folder / "shots.sd.csv").read_text().count("\n") == 3
    result = clubface_(*arguments(folder, *names), "--json").json
    assert len(rows_of(result, "swings")) == 2
    (rejected,) = rows_of(result, "rejected")
    assert rejected["line"] == 2
    assert "empty" in rejected["reason"]


def test_markers_of_a_file_are_listed(clubface_, folder):
    result = clubface_("capture", "markers", str(folder / "swing-001.c3d"), "--json").json
    *head, ball = rows_of(result, "markers")
    assert [each["marker"] for each in (*head, ball)] == ["HEAD1", "HEAD2", "HEAD3", "HEAD4", "HEAD5", "BALL"]
    assert result["values"]["rate_hz"] == 720.0
    assert 55 < ball["fastest_speed_mps"] < 85
    printed = clubface_("capture", "markers", str(folder / "swing-001.c3d")).out
    assert "HEAD5" in printed


def test_a_template_names_the_markers_of_a_file_and_is_written_once(clubface_, folder, tmp_path):
    assert "[cluster]" in clubface_("capture", "template").out
    assert 'HEAD5 = "seen"\nBALL = "seen"\n' in clubface_("capture", "template", str(folder / "swing-001.c3d")).out
    target = str(tmp_path / "map.toml")
    assert clubface_("capture", "template", "-o", target).status == 0
    assert_mistake(clubface_("capture", "template", "-o", target), "exists already; it is left as it is")


def test_a_study_prints_and_draws(clubface_, tmp_path):
    picture = tmp_path / "study.png"
    ran = clubface_("capture", "study", "--count", "4", "--noise", "0 mm", "--plot", str(picture))
    assert ran.status == 0
    assert "closure rate" in ran.out
    assert picture.stat().st_size > 10_000
    result = clubface_("capture", "study", "--count", "4", "--noise", "0 mm", "--json").json
    (loft,) = rows_of(result, "errors", quantity="dynamic loft", estimator="smoother")
    assert (loft["unit"], loft["worst"]) == ("deg", pytest.approx(0.0, abs=0.05))
    assert result["values"]["swings"] == 4


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (["--estimator", "spline"], ["unknown estimator 'spline'", "smoother"]),
        (["--club", "7-iron"], ["club is '7-iron'", "driver"]),
        (["--units", "deg"], ["units"]),
        (["--target", "north"], ["target", "+x"]),
        (["--noise", "0.3"], ["noise", "mm"]),
        (["--markers", "absent.toml"], ["absent.toml", "cannot be read"]),
    ],
)
def test_a_mistake_is_one_message(clubface_, folder, change, words):
    assert_mistake(clubface_(*arguments(folder), *change), *words)


def test_files_without_a_swing_end_with_status_two(clubface_, folder):
    ran = clubface_(*arguments(folder, "calibration.c3d"))
    assert_mistake(ran, "no marker BALL; it has: HEAD1")
    assert_mistake(clubface_("capture", "synthesize", "-o", str(folder), "--gaps", "0.9"), "gaps", "0.5")
    assert_mistake(clubface_("capture", "synthesize", "-o", str(folder), "--count", "0"), "count")


def test_ctrl_c_keeps_the_swings_that_were_read(clubface_, folder, monkeypatch):
    from clubface.capture import swing

    real, calls = swing.capture, []

    def stopped(recording, setup):
        calls.append(recording)
        if len(calls) == 3:
            raise KeyboardInterrupt
        return real(recording, setup)

    monkeypatch.setattr(swing, "capture", stopped)
    names = [f"swing-00{number}.c3d" for number in (1, 2, 3)]
    ran = clubface_(*arguments(folder, *names), "-o", str(folder / "shots.csv"))
    assert ran.status == 130
    assert "interrupted: 2 of 3 swings read" in ran.err
    assert (folder / "shots.csv").read_text().count("\n") == 3


@pytest.fixture
def bare(clubface_, tmp_path):
    target = tmp_path / "bare"
    ran = clubface_("capture", "synthesize", "-o", str(target), "--bare", "--count", "2", "--noise", "0.3 mm")
    assert ran.status == 0
    assert "wrote 2 swings, markers.toml, truth.csv" in ran.err
    return target


def test_bare_swings_are_read_and_what_was_assumed_is_listed(clubface_, bare):
    shown = clubface_("capture", "markers", str(bare / "swing-001.c3d"), "--json").json
    assert shown["values"]["rate_hz"] == 360.0
    assert [each["marker"] for each in rows_of(shown, "markers")] == ["HEAD1", "HEAD3", "HEAD4"]
    ran = clubface_(*arguments(bare))
    assert ran.status == 0
    assert "assumed: where the clubhead loses speed" in ran.out
    many = clubface_(*arguments(bare, "swing-001.c3d", "swing-002.c3d"))
    assert many.out.count("face angle at address") == 1
    (lie,) = rows_of(clubface_(*arguments(bare), "--json").json, "geometry", quantity="lie at address")
    assert (lie["known"], lie["value"], lie["unit"]) == ("assumed", 0.0, "deg")
    assert lie["deviation"] == pytest.approx(2.0)


def test_a_table_gets_its_pictures_beside_it_and_a_printed_delivery_none(clubface_, folder):
    assert clubface_(*arguments(folder)).status == 0
    assert not list(folder.glob("*.pdf"))
    names = [f"swing-00{number}.c3d" for number in (1, 2, 3)]
    ran = clubface_(*arguments(folder, *names), "-o", str(folder / "shots.csv"))
    assert "shots.csv" in ran.err
    pages = (folder / "shots.pdf").read_bytes()
    assert pages.count(b"/Type /Page ") == 3
    clubface_(*arguments(folder, *names), "-o", str(folder / "shots.csv"))
    assert (folder / "shots.pdf").read_bytes() == pages
    picture = folder / "swing.png"
    assert clubface_(*arguments(folder), "--plot", str(picture)).status == 0
    assert picture.stat().st_size > 20_000
    assert_mistake(clubface_(*arguments(folder, *names), "--plot", str(picture)), "--plot", "several swings", ".pdf")


def test_without_matplotlib_the_table_is_written_all_the_same(clubface_, folder, monkeypatch):
    from clubface.cli import capture

    monkeypatch.setattr(capture, "find_spec", lambda name: None)
    ran = clubface_(*arguments(folder), "-o", str(folder / "shots.csv"))
    assert ran.status == 0
    assert "no picture is written next to the table" in ran.err
    assert not list(folder.glob("*.pdf"))
