"""Every page runs from top to bottom, and its outputs and figures are those it shows."""

from pathlib import Path

import pytest

import clubface
from clubface.equipment.models import OWN
from script_files import load_script

ROOT = Path(__file__).parent.parent
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
NEEDED = ("typer", "rich", "matplotlib", "pandas", "pyarrow", "ezc3d", "pymoo", "scipy")
LIBRARIES = ("jax", "torch", "casadi", "mujoco")
"""What only some pages use."""

run_page = load_script("docs/run.py")


def pages_with(name):
    """The pages that have a block of code or a comment of figures in which a group matches."""
    return [page for page in PAGES if any(block[name] for block in run_page.BLOCK.finditer(page.read_text()))]


def check(page, folder, **options):
    text = page.read_text(encoding="utf-8")
    for module in (
        *NEEDED,
        *(each for each in LIBRARIES if f"import {each}" in text or f"clubface.{each}" in text),
    ):
        pytest.importorskip(module, reason=f"{module} is not installed")
    pytest.importorskip("matplotlib").use("agg")
    try:
        for ran in run_page.run(page, folder, **options):
            assert ran.agrees, f"{page.name}:{ran.line} shows\n{ran.shown}\nbut gives\n{ran.printed}"
    finally:
        OWN.clear()  # a page may register a law of contact


@pytest.mark.parametrize("page", dict.fromkeys([*pages_with("code"), *pages_with("figures")]), ids=lambda it: it.stem)
def test_a_page_shows_what_it_computes(page, tmp_path, request, monkeypatch):
    if any("pkg-config" in (block["code"] or "") for block in run_page.BLOCK.finditer(page.read_text("utf-8"))):
        monkeypatch.setenv("PKG_CONFIG_PATH", str(request.getfixturevalue("install") / "lib" / "pkgconfig"))
    check(page, tmp_path)


@pytest.mark.study
@pytest.mark.parametrize("page", pages_with("study"), ids=lambda it: it.stem)
def test_a_page_shows_what_takes_minutes_to_compute(page, tmp_path):
    check(page, tmp_path, study=True)


def test_an_output_that_changed_is_noticed(tmp_path):
    page = tmp_path / "page.md"
    page.write_text(
        "```python\nprint(1 + 1)\n```\n\n```text\n3\n```\n\n```shell\necho a  b\n```\n\n```text\na b\n```\n"
    )
    assert [each.agrees for each in run_page.run(page, tmp_path)] == [False, True]


def test_a_command_that_fails_or_a_warning_stops_a_tutorial(tmp_path, write):
    page = write("```shell\nfalse | cat\n```\n", "page.md")
    with pytest.raises(AssertionError, match="exit status 1"):
        list(run_page.run(page, tmp_path))
    page.write_text("```python\nimport warnings\nwarnings.warn('ball', UserWarning)\n```\n")
    with pytest.raises(UserWarning, match="ball"):
        list(run_page.run(page, tmp_path))


PAGE = """It carries 250
yd, **1,250** in five, and 40–50% more than 3 others, by `far`.

| club | spin |
| --- | --- |
| driver | +2.5e3 |

<!-- figures
far = 246.8
carries # yd = far
**#** in five, and #–#% more = 5 * far, (39.6, 50.4)[0], 50.4
| driver | # | = 2540
by `far` = far > 240
than # others = given
-->
"""


def test_figures_in_sentences_are_held_to_what_is_computed(write):
    page = write(PAGE, "page.md")
    ran = {each.line: each for each in run_page.run(page, page.parent)}
    wrong = [each for each in run_page.run(page, page.parent) if not each.agrees]
    assert sorted((each.shown, each.printed) for each in wrong) == [
        ("**1,250** in five, and 40–50% more", "**1,234** in five, and 40–50% more"),
        ("carries 250\nyd", "carries 247\nyd"),
    ]
    assert set(ran) == {1, 2, 6}


def test_an_update_writes_figures_with_the_digits_of_the_page(write, tmp_path):
    page = write(PAGE, "page.md")
    run_page.update(page, tmp_path)
    assert page.read_text() == PAGE.replace("250\n", "247\n").replace("1,250", "1,234")


def test_a_claim_that_is_wrong_and_a_quotation_that_is_not_unique_are_noticed(write, tmp_path):
    page = write("So it is, 5 of 5.\n\n<!-- figures\nSo it is = 1 > 2\n-->\n", "page.md")
    assert [each.agrees for each in run_page.run(page, tmp_path)] == [False]
    page.write_text("It is 5 of 5.\n\n<!-- figures\n# = 5\n-->\n")
    with pytest.raises(AssertionError, match="2 times"):
        list(run_page.run(page, tmp_path))


def test_figures_of_a_command_come_from_its_document_in_the_unit_of_the_page(write, tmp_path):
    comment = """
<!-- figures
shot = clubface shot driver --speed "108 mph" --model standard,slip
At # mph = shot("ball_speed", "mph", model="slip")
-->
"""
    page = write(f"At 157 mph.\n{comment}", "page.md")
    speed = clubface.impact("driver", speed="108 mph", model="slip").get("ball_speed", "mph")
    assert [each.printed for each in run_page.run(page, tmp_path)] == [f"At {speed:.0f} mph"]


def test_long_computations_wait_for_the_study_and_leave_the_commit(write, tmp_path):
    page = write("It is 5 m.\n\n<!-- figures study abc123\nis # m = 6\n-->\n", "page.md")
    assert list(run_page.run(page, tmp_path)) == []
    run_page.update(page, tmp_path, study=True)
    assert page.read_text().startswith("It is 6 m.\n\n<!-- figures study ")
    assert "abc123" not in page.read_text()


def test_figures_that_nothing_checks_are_listed(write):
    page = write(PAGE + "\nBut 7 mm, $x$ at `8 mm` and 40 % stay.\n", "page.md")
    assert [figure for _, figure in run_page.uncovered(page)] == ["7 mm", "40 %"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_no_figure_is_added_that_nothing_checks(page):
    figures = run_page.uncovered(page)
    assert not figures, f"`python docs/run.py --uncovered {page.relative_to(ROOT)}` lists them: {figures}"


@pytest.mark.parametrize("page", pages_with("study"), ids=lambda page: page.stem)
def test_figures_that_take_long_name_the_commit_that_computed_them(page):
    blocks = [block for block in run_page.BLOCK.finditer(page.read_text()) if block["study"]]
    assert all(len(block["commit"] or "") >= 7 for block in blocks)
