"""Running the command line in tests, in this process or in one of its own."""

import json
import subprocess
import sys

import pytest

MAIN = "from clubface.cli import main; main()"


class Ran:
    """What one command line did."""

    def __init__(self, status, out, err):
        self.status, self.out, self.err = status, out, err

    @property
    def json(self):
        return json.loads(self.out, parse_constant=lambda name: pytest.fail(f"{name} is not JSON"))


def process(*arguments, **options):
    """Run a command line in a process of its own."""
    return subprocess.run(
        [sys.executable, "-c", MAIN, *arguments], capture_output=True, text=True, timeout=50, **options
    )


def assert_mistake(ran, *words):
    """One message on the error stream, nothing on the other, status 2."""
    assert ran.status == 2
    assert ran.out == ""
    messages = [line for line in ran.err.splitlines() if not line.startswith("clubface: note:")]
    assert len(messages) == 1
    assert messages[0].startswith("clubface: ")
    for word in words:
        assert word in messages[0]
