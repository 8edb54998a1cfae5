"""The pages list every public name, option and command, and name files that exist."""

import ast
import json
import re
import shlex
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import pytest

import clubface

ROOT = Path(__file__).parent.parent


def test_the_interface_page_lists_every_public_name():
    text = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"^\.\. auto(?:function|class|module):: (?:clubface\.)?(\w+)$", text, re.MULTILINE))
    assert set(clubface.__all__) - {"ClubfaceError"} <= listed  # that one is a member of errors


NOT_INSTALLED = {f"clubface.{each}" for each in ("jax", "torch") if find_spec(each) is None}


def public(path):
    """Return whether a path such as "clubface.fem.Ball" is a name that its module lists, or a module with a list."""
    name, _, last = path.rpartition(".")
    try:
        module = import_module(name)
    except ImportError:
        return False
    if last in getattr(module, "__all__", ()):
        return hasattr(module, last)
    try:
        return bool(import_module(path).__all__)
    except (ImportError, AttributeError):
        return False


def shown_code():
    """Yield the code that people read, each with where it stands: in pages, examples and notebooks."""
    for page in (ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))):
        if "_build" not in page.parts:
            text = re.sub(r"<!--.*?-->", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
            for block in re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE):
                yield page, block
    for example in sorted((ROOT / "examples").rglob("*.py")):
        yield example, example.read_text(encoding="utf-8")
    for notebook in sorted((ROOT / "notebooks").glob("*.ipynb")):
        for cell in json.loads(notebook.read_text(encoding="utf-8"))["cells"]:
            if cell["cell_type"] == "code":
                lines = [line for line in "".join(cell["source"]).splitlines() if not line.startswith(("%", "!"))]
                yield notebook, "\n".join(lines)


def imported(code):
    """Return the paths that code imports from the package."""
    paths = set()
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.ImportFrom) and node.module is not None:
            paths |= {f"{node.module}.{each.name}" for each in node.names}
        elif isinstance(node, ast.Import):
            paths |= {each.name for each in node.names}
    return {each for each in paths if each.startswith("clubface.")}


def test_the_interface_page_documents_public_names_alone():
    text = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
    paths = re.findall(r"^\.\. auto(?:function|class|module):: ([\w.]+)$", text, re.MULTILINE)
    assert len(paths) > 250
    whole = {each if each.startswith("clubface.") else f"clubface.{each}" for each in paths}
    assert sorted(each for each in whole - NOT_INSTALLED if not public(each)) == []


def test_code_that_people_read_imports_public_names_alone():
    imports = {(page.name, path) for page, code in shown_code() for path in imported(code)}
    assert len(imports) > 30
    assert sorted(each for each in imports if each[1] not in NOT_INSTALLED and not public(each[1])) == []


@pytest.mark.parametrize("path", ["clubface.nothing", "clubface.equipment.described", "clubface.simulation.pose.Head"])
def test_unlisted_names_are_not_public(path):
    assert not public(path)


def test_the_command_line_page_names_every_option_and_command():
    pytest.importorskip("typer")
    from clubface.cli import options
    from clubface.cli.app import COMMANDS

    text = (ROOT / "docs" / "command-line.md").read_text(encoding="utf-8")
    for name in COMMANDS:
        assert f"clubface {name} " in text, name
    renamed = {"setting": "set"}
    for group in (options.DELIVERY, options.LAUNCH, options.EQUIPMENT, options.MODELS, options.AIR):
        for name in group:
            assert f"--{renamed.get(name, name).replace('_', '-')}" in text, name


def test_the_commands_of_the_readme_name_files_and_options_that_exist(clubface_):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    commands = [shlex.split(line, comments=True) for line in re.findall(r"^clubface .*$", text, re.MULTILINE)]
    assert len(commands) > 10
    for _, *words in commands:
        nested = words[0] in ("monitor", "golfer", "club", "export", "fem", "study")
        help_text = clubface_(*words[: 1 + nested], "--help").out
        for word in words:
            if word.startswith("-"):
                assert word in help_text, (words, word)
            elif word.startswith(("examples/", "notebooks/")):
                assert (ROOT / word).exists(), word
