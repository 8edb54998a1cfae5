"""A disk or an output that takes no more: one line, status 2, no half file, nothing finished lost."""

import os
import subprocess
import sys
from pathlib import Path

import benchmark_findings as findings
import pytest

from clubface.errors import FileError
from clubface.fem import case as cases
from clubface.jobs import store
from clubface.present import report
from clubface.shots.prediction import predict
from command_line import MAIN
from deliveries import HEAD

resource = pytest.importorskip("resource", reason="no files of limited size")

ROWS = HEAD + "".join(f"{i},{90 + i % 30},1,13,{i % 7}\n" for i in range(400))


@pytest.fixture
def full(tmp_path, monkeypatch):
    """A disk with a file of deliveries and one of launches, on which no new file may be longer than 600 bytes."""
    monkeypatch.chdir(tmp_path)
    # Python would keep the first 600 bytes of what it compiles now, and fail on them in every later test.
    monkeypatch.setattr(sys, "dont_write_bytecode", True)
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    Path("in.csv").write_text(ROWS)
    Path("launches.csv").write_text("club,ball_speed_mph,launch_deg,carry_yd\n" + "Driver,150,12,240\n" * 20)
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (600, limits[1]))
    yield
    resource.setrlimit(resource.RLIMIT_FSIZE, limits)


@pytest.mark.parametrize(
    "arguments",
    [
        ("club", "new", "mine", "-o", "mine.toml"),
        ("capture", "template", "-o", "mine.toml"),
        ("monitor", "read", "in.csv", "-o", "shots.csv"),
        ("monitor", "read", "in.csv", "-o", "shots.parquet"),
        ("predict", "in.csv", "--club", "driver", "-o", "out.csv"),
        ("predict", "in.csv", "--club", "driver", "-o", "out.parquet"),
        ("shot", "driver", "--speed", "50 m/s", "--plot", "shot.png"),
        ("shot", "driver", "--speed", "50 m/s", "--plot", "shot.svg"),
        ("shot", "driver", "--speed", "50 m/s", "--plot", "shot.pdf"),
        ("tour", "-o", "tour"),
        ("capture", "synthesize", "-o", "swings", "--count", "1"),
        ("fem", "export", "-o", "deck", "--format", "lsdyna"),
        ("infer", "launches.csv", "--club", "driver", "--samples", "50", "-o", "draws.csv"),
        ("monitor", "summary", "launches.csv", "--plot", "bag.png"),
        ("monitor", "report", "launches.csv", "-o", "report.html"),
        ("infer", "--club", "driver", "--ball-speed", "70 m/s", "--samples", "50", "-o", "draws.csv"),
    ],
    ids=" ".join,
)
def test_a_full_disk_is_one_line_and_leaves_no_half_file(clubface_, full, arguments):
    for library in ("matplotlib", "pyarrow", "ezc3d"):
        pytest.importorskip(library)
    ran = clubface_(*arguments)
    assert ran.status == 2
    lines = [line for line in ran.err.splitlines() if "note:" not in line]
    assert len(lines) == 1
    assert lines[0].startswith("clubface: ")
    assert "cannot be written: " in lines[0]
    left = {path for path in Path().rglob("*") if path.is_file() and ".unfinished" not in str(path)}
    assert left == {Path("in.csv"), Path("launches.csv")}


@pytest.mark.parametrize("command", ["vtu", "findings"])
def test_a_full_disk_ends_shapes_of_finite_elements_and_the_findings_in_one_line(
    clubface_, capsys, full, monkeypatch, command
):
    if command == "vtu":
        pytest.importorskip("meshlane")
        quick = cases.case("paper").replace(settings={"duration": 5e-6, "frames": 2})
        monkeypatch.setattr(cases, "case", lambda _: quick)
        ran = clubface_("fem", "export", "paper", "-o", "shapes")
        status, message = ran.status, ran.err
    else:
        monkeypatch.setattr(findings, "run", lambda *_, **__: {"tour": [1.0] * 400})
        status, message = findings.main(["found", "found.json"]), capsys.readouterr().err
    assert status == 2
    (line,) = message.splitlines()
    assert "cannot be written: " in line
    assert {path for path in Path().rglob("*") if path.is_file()} == {Path("in.csv"), Path("launches.csv")}


def test_a_run_that_met_a_full_disk_goes_on_to_the_same_bytes(monkeypatch, tmp_path):
    """Some of the pieces fit. Each is as long as the others: a limit on the length of files does not show it."""
    monkeypatch.setattr(store, "FLUSH_INTERVAL", 0.0)
    monkeypatch.chdir(tmp_path)
    Path("in.csv").write_text(ROWS)
    sync, left = os.fsync, [20]

    def fills(handle):
        left[0] -= 1
        if left[0] < 0:
            raise OSError(28, os.strerror(28))
        sync(handle)

    for ending in ("csv", "parquet"):
        left[0] = 10**6
        predict("in.csv", club="driver", output=f"whole.{ending}", chunk_rows=10)
        left[0] = 20
        monkeypatch.setattr(os, "fsync", fills)
        with pytest.raises(FileError, match="No space left on device"):
            predict("in.csv", club="driver", output=f"out.{ending}", chunk_rows=10)
        assert not Path(f"out.{ending}").exists()
        left[0] = 10**6
        report = predict("in.csv", club="driver", output=f"out.{ending}", chunk_rows=10, resume=True)
        assert 0 < report.resumed < report.rows == 400
        assert Path(f"out.{ending}").read_bytes() == Path(f"whole.{ending}").read_bytes()


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no /dev/full")
@pytest.mark.parametrize(
    "arguments", [("models", "--json"), ("--help",), ("--version",), ("shot", "driver", "--speed", "50 m/s")]
)
def test_a_standard_output_that_is_full_is_one_line(arguments):
    with open("/dev/full", "w") as full:
        ran = subprocess.run(
            [sys.executable, "-c", MAIN, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    assert ran.returncode == 2
    assert ran.stderr == "clubface: standard output: No space left on device\n"


def test_a_run_of_finite_elements_is_shown_where_the_disk_is_full_and_kept_where_the_output_is(
    clubface_, monkeypatch, tmp_path
):
    def full(*_, **__):
        raise FileError("out/figures.json", None, "cannot be written: No space left on device")

    monkeypatch.setattr(report, "write_json", full)
    quick = cases.case("paper").replace(settings={"duration": 5e-6, "frames": 0})
    monkeypatch.setattr(cases, "case", lambda _: quick)
    ran = clubface_("fem", "run", "paper", "-o", str(tmp_path / "out"))
    assert ran.status == 2
    assert "ball speed" in ran.out or "peak force" in ran.out
    assert ran.err.count("cannot be written: No space left on device") == 1
