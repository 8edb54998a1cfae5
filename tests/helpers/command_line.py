"""Running the command line in tests, in this process or in one of its own."""

import json
import signal
import subprocess
import sys

import pytest

MAIN = "from clubface.cli import main; main()"
PRESS = """
import ctypes, sys
kernel = ctypes.windll.kernel32
kernel.FreeConsole()
kernel.AttachConsole(int(sys.argv[1]))
kernel.SetConsoleCtrlHandler(None, True)
sys.exit(not kernel.GenerateConsoleCtrlEvent(0, 0))
"""


def interruptible(command, **options):
    """Start a process in whose terminal Ctrl-C can be pressed; what it writes is text from pipes."""
    # On Windows Ctrl-C reaches all processes of a terminal: this one gets a terminal of its own.
    own = {"creationflags": getattr(subprocess, "CREATE_NO_WINDOW", 0), "encoding": "utf-8"}
    return subprocess.Popen(command, **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **own, **options})


def press_ctrl_c(child):
    """Press Ctrl-C in the terminal of a process that :func:`interruptible` has started."""
    if sys.platform == "win32":
        subprocess.run([sys.executable, "-c", PRESS, str(child.pid)], check=True)
    else:
        child.send_signal(signal.SIGINT)


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
