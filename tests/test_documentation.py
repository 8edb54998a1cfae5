"""The pages list every public name, option and command, and name files that exist."""

import re
import shlex
from pathlib import Path

import pytest

import clubface

ROOT = Path(__file__).parent.parent


def test_the_interface_page_lists_every_public_name():
    text = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
    listed = set(re.findall(r"^\.\. auto(?:function|class|module):: (?:clubface\.)?(\w+)$", text, re.MULTILINE))
    assert set(clubface.__all__) - {"ClubfaceError"} <= listed  # that one is a member of errors


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
