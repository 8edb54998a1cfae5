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

    def rows(self, table=None):
        """The rows of a table of the JSON document, the first unless named."""
        tables = self.json["tables"]
        return tables[table or next(iter(tables))]["rows"]

    @property
    def values(self):
        """The single values of the JSON document."""
        return self.json["values"]

    def notes(self, code=None):
        """The data of the notes of the JSON document that have a code, or the codes of all."""
        notes = self.json["notes"]
        return [each["code"] for each in notes] if code is None else [n["data"] for n in notes if n["code"] == code]


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
