"""Every tutorial runs from top to bottom and prints what its page shows, as do the first examples of the README."""

import importlib.util
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
PAGES = [
    ROOT / "README.md",
    *(ROOT / "docs" / f"{name}.md" for name in ("index", "getting-started", "compare", "face-maps")),
    *sorted((ROOT / "docs" / "tutorials").glob("*.md")),
]
NEEDED = ("typer", "rich", "matplotlib", "pandas", "pyarrow", "ezc3d", "pymoo", "scipy")

specification = importlib.util.spec_from_file_location("tutorial", ROOT / "docs" / "tutorials" / "run.py")
tutorial = importlib.util.module_from_spec(specification)
specification.loader.exec_module(tutorial)


@pytest.mark.parametrize(
    "page", [page for page in PAGES if tutorial.BLOCK.search(page.read_text())], ids=lambda it: it.stem
)
def test_a_tutorial_prints_what_its_page_shows(page, tmp_path):
    for module in NEEDED:
        pytest.importorskip(module)
    pytest.importorskip("matplotlib").use("agg")
    for ran in tutorial.run(page, tmp_path):
        assert ran.agrees, f"{page.name}:{ran.line} shows\n{ran.shown}but prints\n{ran.printed}"


def test_an_output_that_changed_is_noticed(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(
        "```python\nprint(1 + 1)\n```\n\n```text\n3\n```\n\n```shell\necho a  b\n```\n\n```text\na b\n```\n"
    )
    assert [each.agrees for each in tutorial.run(page, tmp_path)] == [False, True]


def test_a_command_that_fails_or_a_warning_stops_a_tutorial(tmp_path, write):
    page = write("```shell\nfalse | cat\n```\n", "page.md")
    with pytest.raises(AssertionError, match="exit status 1"):
        list(tutorial.run(page, tmp_path))
    page.write_text("```python\nimport warnings\nwarnings.warn('ball', UserWarning)\n```\n")
    with pytest.raises(UserWarning, match="ball"):
        list(tutorial.run(page, tmp_path))
