"""What several tests need."""

from __future__ import annotations

import os
import pickle
import shutil
import signal

import pytest
from hypothesis import HealthCheck, settings

from c_programs import ROOT, ran

# Before NumPy is loaded, as the command line does: on a busy machine OpenBLAS's threads wait for each other over
# matrices of a few rows, and motion capture takes ten times as long.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

# Of a test of JAX nearly all is its compiler, which takes a quarter longer where it optimises what runs once. Processes
# that tests start inherit it.
os.environ.setdefault("JAX_DISABLE_MOST_OPTIMIZATIONS", "1")

# A test run started in the background inherits an ignored interrupt, and passes that on to the commands it starts: then
# Ctrl-C would reach nobody. The handler of an interactive run is what the tests of interruption mean.
signal.signal(signal.SIGINT, signal.default_int_handler)

# An example takes as long as the machine is busy, and the first one loads the core: time is no property of the code.
# A folder that all examples of a test share is no mistake: each writes its files anew. A test that gives a list of its
# own would have the check of time back. Every run draws examples of its own; `make fuzz` draws as many as one wants.
settings.register_profile(
    "clubface",
    deadline=None,
    max_examples=50,
    suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture],
)
settings.load_profile("clubface")


@pytest.fixture
def clubface_(capsys, monkeypatch):
    """Run a command line in this process."""
    pytest.importorskip("typer")
    pytest.importorskip("rich")
    from clubface.cli.app import run
    from command_line import Ran

    monkeypatch.setenv("COLUMNS", "120")

    def ran(*arguments):
        status = run(arguments)
        captured = capsys.readouterr()
        return Ran(status, captured.out, captured.err)

    return ran


@pytest.fixture(scope="session", autouse=True)
def same_pictures_are_drawn_once():
    """A picture in two reports, as HTML and as Markdown, is the same text: to draw it takes most of their time."""
    from clubface.present import report

    draw, drawn = report.picture_blocks, {}

    def picture_blocks(result, units=None):
        key = pickle.dumps((result.pictures(), units))
        if key not in drawn:
            drawn[key] = list(draw(result, units))
        return drawn[key]

    report.picture_blocks = picture_blocks
    yield
    report.picture_blocks = draw


@pytest.fixture
def without_pictures(monkeypatch):
    """Reports are written without pictures, where a test is about their words."""
    monkeypatch.setattr("clubface.present.report.picture_blocks", lambda result, units=None: ())


@pytest.fixture
def new_process(monkeypatch):
    """Warnings that are given once in a process are given again."""
    monkeypatch.setattr("clubface.support.checks._given", {})


@pytest.fixture
def write(tmp_path):
    """Write a file of deliveries; return its path."""

    def writer(content, name="shots.csv"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    return writer


@pytest.fixture(scope="session")
def install(tmp_path_factory):
    """The folder that `make libclubface` installs into, and then somebody moves.

    The library is what `make test` has just linked the tests of Rust with. Elsewhere it is built by
    `cargo build --release --package clubface-c`, and named by `CLUBFACE_LIBRARY=target/release`.
    """
    built = os.environ.get("CLUBFACE_LIBRARY")
    if built is None:
        pytest.skip("libclubface is not tested: CLUBFACE_LIBRARY does not name a folder with it; make test does")
    for tool in ("cc", "rustc"):
        if shutil.which(tool) is None:
            pytest.skip(f"libclubface is not tested: that needs {tool}")
    folder = tmp_path_factory.mktemp("install")
    ran(ROOT / "scripts" / "install-libclubface.sh", folder / "first", built)
    return (folder / "first").rename(folder / "moved")
