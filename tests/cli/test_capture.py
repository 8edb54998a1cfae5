"""``clubface capture`` on the command line."""

import math

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


DEG = math.pi / 180
PRINTED = {
    "club speed, mph": ("speed", 0.44704, 2), "attack, deg": ("attack", DEG, 2), "path, deg": ("path", DEG, 2),
    "dynamic loft, deg": ("loft", DEG, 2), "face angle, deg": ("face", DEG, 2), "lie, deg": ("lie", DEG, 2),
    "towards the toe, mm": ("toe", 1e-3, 2), "high, mm": ("high", 1e-3, 2), "closure, deg/s": ("closure", DEG, 0),
    "pitch rate, deg/s": ("pitch_rate", DEG, 0), "lie rate, deg/s": ("lie_rate", DEG, 0),
    "ball speed, mph": ("ball_speed", 0.44704, 2), "launch, deg": ("launch", DEG, 2),
    "azimuth, deg": ("azimuth", DEG, 2),
}  # fmt: skip
"""The lines of one swing: quantity, size of the unit, digits."""


def test_one_swing_is_printed_value_by_value_each_with_its_standard_deviation(clubface_, folder):
    ran = clubface_(*arguments(folder))
    assert ran.status == 0
    found = clubface_(*arguments(folder), "--json").json
    values = found["delivery"] | found["launch"]
    deviations = found["uncertainty"] | found["launch_uncertainty"]
    lines = ran.out.split("─\n")[1].splitlines()
    for line, (label, (name, unit, digits)) in zip(lines, PRINTED.items(), strict=False):
        assert line.startswith(label)
        # Rounded to the digits printed.
        rounded = 0.5001 * 10.0**-digits
        value, deviation = (float(each) for each in line.split()[-2:])
        assert value == pytest.approx(values[name] / unit, abs=rounded), line
        assert deviation == pytest.approx(deviations[name] / unit, abs=rounded), line
    assert len(lines) > len(PRINTED)
    assert f"markers' noise {found['marker_noise_m'] * 1e3:.3f} mm" in ran.out


def test_a_swing_is_read_within_four_standard_deviations(clubface_, folder):
    from clubface.shots.reading import read_shots

    truth = read_shots(folder / "truth.csv").deliveries
    found = clubface_(*arguments(folder), "--json").json
    for name, value in found["delivery"].items():
        assert abs(value - truth[name][0]) < 4 * found["uncertainty"][name], name


def test_the_last_row_of_many_swings_is_the_mean_of_their_standard_deviations(clubface_, folder):
    names = [f"swing-00{number}.c3d" for number in (1, 2, 3)]
    found = clubface_(*arguments(folder, *names), "--json").json["swings"]
    lines = clubface_(*arguments(folder, *names)).out.splitlines()
    shown = [PRINTED[label] for label in (*list(PRINTED)[:5], *list(PRINTED)[6:9])]
    rows = {line.split("  ")[0]: line.split() for line in lines}
    for place, (name, unit, digits) in enumerate(reversed(shown), 1):
        rounded = 0.5001 * 10.0**-digits
        for file, swing in zip(names, found, strict=True):
            assert float(rows[file][-place]) == pytest.approx(swing["delivery"][name] / unit, abs=rounded)
        mean = sum(swing["uncertainty"][name] for swing in found) / len(found)
        assert float(rows["standard deviation"][-place]) == pytest.approx(mean / unit, abs=rounded)


def test_json_holds_everything_in_si(clubface_, folder):
    from clubface.shots.reading import read_shots

    found = clubface_(*arguments(folder), "--json").json
    truth = read_shots(folder / "truth.csv").deliveries
    assert abs(found["delivery"]["loft"] - truth["loft"][0]) < 4 * found["uncertainty"]["loft"]
    assert math.sqrt(found["covariance"][3][3]) == pytest.approx(found["uncertainty"]["loft"])
    assert found["frames"][1] == found["frames"][0] + 1
    assert found["notes"] == []
    linear = clubface_(*arguments(folder), "--estimator", "linear", "--json").json
    assert linear["estimator"] == "linear"
    assert linear["misfit"] is None
    assert linear["uncertainty"]["speed"] > found["uncertainty"]["speed"]


def test_many_swings_make_a_table_and_files(clubface_, folder):
    names = [f"swing-00{number}.c3d" for number in (1, 2, 3)]
    (folder / "swing-002.c3d").write_bytes(b"")
    ran = clubface_(*arguments(folder, *names), "-o", str(folder / "shots.csv"))
    assert ran.status == 0
    assert [line.split()[0] for line in ran.out.splitlines() if line.startswith("swing-")] == [names[0], names[2]]
    assert "swing-002.c3d: the file is empty" in ran.err
    assert (folder / "shots.csv").read_text().count("\n") == 3
    assert (folder / "shots.sd.csv").read_text().count("\n") == 3
    found = clubface_(*arguments(folder, *names), "--json").json
    assert len(found["swings"]) == 2
    assert "empty" in found["rejected"][0]


def test_markers_of_a_file_are_listed(clubface_, folder):
    found = clubface_("capture", "markers", str(folder / "swing-001.c3d"), "--json").json
    assert [each["label"] for each in found["markers"]] == ["HEAD1", "HEAD2", "HEAD3", "HEAD4", "HEAD5", "BALL"]
    assert found["rate_hz"] == 720.0
    ball = found["markers"][-1]
    assert 55 < ball["fastest_mps"] < 85
    printed = clubface_("capture", "markers", str(folder / "swing-001.c3d")).out
    assert "HEAD5" in printed


def test_a_template_is_written_once(clubface_, tmp_path):
    assert "[cluster]" in clubface_("capture", "template").out
    target = str(tmp_path / "map.toml")
    assert clubface_("capture", "template", "-o", target).status == 0
    assert_mistake(clubface_("capture", "template", "-o", target), "exists already; it is left as it is")


def test_a_study_prints_and_draws(clubface_, tmp_path):
    picture = tmp_path / "study.png"
    ran = clubface_("capture", "study", "--count", "4", "--noise", "0 mm", "--plot", str(picture))
    assert ran.status == 0
    assert "closure, deg/s" in ran.out
    assert picture.stat().st_size > 10_000
    found = clubface_("capture", "study", "--count", "4", "--noise", "0 mm", "--json").json
    assert found["estimators"]["smoother"]["worst"]["loft"] < 0.05
    assert found["swings"] == 4


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
    assert_mistake(ran, "no marker BALL here; the file has: HEAD1")
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


def test_bare_swings_are_read_and_what_was_assumed_is_told(clubface_, bare):
    shown = clubface_("capture", "markers", str(bare / "swing-001.c3d"), "--json").json
    assert shown["rate_hz"] == 360.0
    assert [each["label"] for each in shown["markers"]] == ["HEAD1", "HEAD3", "HEAD4"]
    ran = clubface_(*arguments(bare))
    assert ran.status == 0
    assert "face angle at address: assumed, 0.0 ± 2.0 deg" in ran.out
    assert "ball: assumed: where the clubhead loses speed" in ran.out
    many = clubface_(*arguments(bare, "swing-001.c3d", "swing-002.c3d"))
    assert many.out.count("face angle at address: assumed, 0.0 ± 2.0 deg") == 1
    found = clubface_(*arguments(bare), "--json").json["geometry"]
    assert {"what": "lie at address", "how": "assumed", "values": [0.0], "deviations": [2.0], "unit": "deg"} in found


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


def test_a_template_names_the_markers_of_a_file(clubface_, folder):
    ran = clubface_("capture", "template", str(folder / "swing-001.c3d"))
    assert 'HEAD5 = "seen"\nBALL = "seen"\n' in ran.out


def test_without_matplotlib_the_table_is_written_all_the_same(clubface_, folder, monkeypatch):
    from clubface.cli import capture

    monkeypatch.setattr(capture, "find_spec", lambda name: None)
    ran = clubface_(*arguments(folder), "-o", str(folder / "shots.csv"))
    assert ran.status == 0
    assert "no picture is written beside the table" in ran.err
    assert not list(folder.glob("*.pdf"))
