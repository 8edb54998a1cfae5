"""What the pages show runs, and the figures the README gives are those the package computes."""

import re
import shlex
from pathlib import Path

import pytest

import clubface
from clubface import units
from clubface.equipment.backends import OWN
from clubface.quantities import quantity as quantity_named
from clubface.validation import tour

ROOT = Path(__file__).parent.parent
TUTORIALS = ROOT / "docs" / "tutorials"
PAGES = [ROOT / "README.md", *(page for page in sorted((ROOT / "docs").glob("**/*.md")) if page.parent != TUTORIALS)]
"""The pages whose blocks stand alone; those of a tutorial build on its commands, and have a test of their own."""


def blocks(page):
    return re.findall(r"^```python\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page)], ids=lambda page: page.stem)
def test_the_code_of_a_page_runs(page, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # pages may write files
    names = {}
    try:
        for block in blocks(page):
            exec(compile(block, str(page), "exec"), names)
    finally:
        OWN.clear()  # a page may register a law of contact


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
        nested = words[0] in ("monitor", "golfer", "club", "fem", "study")
        help_text = clubface_(*words[: 1 + nested], "--help").out
        for word in words:
            if word.startswith("-"):
                assert word in help_text, (words, word)
            elif word.startswith(("examples/", "notebooks/")):
                assert (ROOT / word).exists(), word


def test_the_readme_gives_the_errors_of_this_version():
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    given = re.findall(r"^\| (\w+) \| ([\d.]+) \| ([\d.]+) \| (\d+) \| ([\d.]+) \|$", text, re.MULTILINE)
    results = [tour.tour(table=name) for name in tour.TABLES]
    assert [row[0] for row in given] == results[0].models
    for name, *figures in given:
        errors = tour.mean_absolute_error(results, name)
        for quantity, figure in zip(("ball_speed", "launch", "spin", "carry"), figures, strict=True):
            error = units.from_si(errors[quantity], quantity_named(quantity).golf.unit)
            # Half of the last digit, which is how the figures are rounded.
            half = 0.5 if "." not in figure else 0.05
            assert float(figure) == pytest.approx(error, abs=1.001 * half)
