"""What is built for other machines: whose a wheel is, how results are counted, and which are on record."""

import io
import json
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


@pytest.fixture
def foreign(monkeypatch):
    """The folder of the script on the search path, as when it runs."""
    monkeypatch.syspath_prepend(str(ROOT / "scripts" / "foreign"))
    yield
    for name in ("debian_root", "record", "rust_tests", "targets", "wheel_trial", "windows_python", "wine"):
        sys.modules.pop(name, None)


@pytest.mark.parametrize(
    ("platform", "triple"),
    [
        ("manylinux_2_17_x86_64.manylinux2014_x86_64", "x86_64-unknown-linux-gnu"),
        ("manylinux_2_17_aarch64.manylinux2014_aarch64", "aarch64-unknown-linux-gnu"),
        ("musllinux_1_2_x86_64", "x86_64-unknown-linux-musl"),
        ("musllinux_1_2_aarch64", "aarch64-unknown-linux-musl"),
        ("win_amd64", "x86_64-pc-windows-gnu"),
        ("macosx_10_12_x86_64", "x86_64-apple-darwin"),
        ("macosx_11_0_arm64", "aarch64-apple-darwin"),
    ],
)
def test_a_wheel_belongs_to_one_machine(foreign, platform, triple):
    from targets import TARGETS

    assert [each.triple for each in TARGETS.values() if each.takes(f"clubface-0.2.0-cp311-abi3-{platform}.whl")] == [
        triple
    ]


def test_an_archive_of_python_for_windows_that_is_another_one_is_not_unpacked(foreign, tmp_path, monkeypatch):
    import windows_python

    monkeypatch.setattr(windows_python.urllib.request, "urlopen", lambda address: io.BytesIO(b"another"))
    with pytest.raises(SystemExit, match="SHA-256"):
        windows_python.windows_python(tmp_path, "3.11")
    assert not list(tmp_path.iterdir())


def test_a_result_takes_the_place_of_an_earlier_one_of_the_same_kind(foreign, tmp_path):
    from record import record
    from targets import TARGETS

    path = tmp_path / "runs.json"
    arm, x86 = TARGETS["aarch64-unknown-linux-gnu"], TARGETS["x86_64-unknown-linux-musl"]
    for target, what, passed in ((x86, "tests", 1), (arm, "tests", 2), (arm, "wheel", 3), (arm, "tests", 4)):
        record(target, what, "native", {"passed": passed}, path)
    stored = json.loads(path.read_text(encoding="utf-8"))
    assert [(each["target"], each["what"], each["passed"]) for each in stored] == [
        (arm.triple, "tests", 4),
        (arm.triple, "wheel", 3),
        (x86.triple, "tests", 1),
    ]


def test_a_test_program_that_stops_without_a_result_counts_as_a_failure(foreign, monkeypatch):
    import rust_tests
    from targets import TARGETS, Runner

    line = "test result: ok. 3 passed; 0 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.01s"
    target, runner = TARGETS["aarch64-unknown-linux-gnu"], Runner((), "qemu-user")
    monkeypatch.setattr(rust_tests, "EMULATED", ("--test golden",))
    for status, failed in ((0, 0), (139, 1)):
        command = [sys.executable, "-c", f"print({line!r}); raise SystemExit({status})"]
        monkeypatch.setattr(rust_tests, "cargo", lambda target, command=command: command)
        results = rust_tests.run_tests(target, runner)
        assert (results["passed"], results["failed"], results["skipped"]) == (3, failed, 1)
