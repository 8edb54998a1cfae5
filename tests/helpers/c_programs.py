"""Compiling and running programs against the installed C library."""

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "crates" / "clubface-c" / "examples"
OCTAVE = ROOT / "tests" / "helpers" / "octave"
STRICT = ("-Wall", "-Wextra", "-Wpedantic", "-Werror")


def ran(*command, **options):
    """What a command printed on its output; its messages if it fails."""
    result = subprocess.run([str(each) for each in command], capture_output=True, text=True, timeout=600, **options)
    assert result.returncode == 0, f"{' '.join(map(str, command))}\n{result.stdout}{result.stderr}"
    return result.stdout


def prototypes(header):
    """The functions that a header declares: what each returns, and the types of its arguments."""
    code = re.sub(r"//[^\n]*|/\*.*?\*/|^#[^\n]*", "", header, flags=re.DOTALL | re.MULTILINE)
    declared = {}
    for returned, name, arguments in re.findall(r"([\w ]+?[ *]+)(\w+)\(([^()]*)\);", code):
        types = [re.sub(r"\s*\w+$", "", each.strip()) for each in arguments.split(",")]
        declared[name] = (tidy(returned), [] if arguments.strip() == "void" else [tidy(each) for each in types])
    return declared


def tidy(type_):
    """A type of C with single spaces, its star apart."""
    return " ".join(type_.replace("*", " * ").split())
