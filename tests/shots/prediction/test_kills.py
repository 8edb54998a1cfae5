"""A small version of ``make kills``: a run killed at random moments ends with the bytes of an undisturbed one."""

import random
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).parents[3] / "studies"))

import kills


@pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")
def test_a_run_killed_at_random_moments_ends_with_the_same_bytes():
    assert kills.study([kills.SMALL], 2) == []


@pytest.mark.filterwarnings("ignore::clubface.errors.RuleWarning")
def test_other_bytes_are_seen(tmp_path):
    folder = kills.prepared(tmp_path / "run")
    whole = {"out.csv": b"other", "out.rejects.csv": b"other"}
    (message,) = kills.disturbed(kills.SMALL, folder, whole, 0.0, random.Random(1), 0)
    assert "the last run is not as the undisturbed one" in message


def test_the_program_of_the_findings_starts():
    # Without arguments it prints its usage: every name that it replaces is there.
    child = subprocess.run([sys.executable, "-c", kills.FINDINGS], capture_output=True, text=True)
    assert child.returncode == 2
    assert child.stderr.startswith("usage: ")
