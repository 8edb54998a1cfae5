"""The paper of four pages: it is set without a remark, every number in it is inserted, and every source is cited."""

import json
import re
import shutil
import sys
from pathlib import Path

import pytest

from script_files import load_script

pytest.importorskip("matplotlib")
pytest.importorskip("sphinx", reason="the tables of the documentation are made with Sphinx")
typst = pytest.importorskip("typst", reason="Typst is not installed")

ROOT = Path(__file__).parent.parent
TEXT = (ROOT / "paper" / "paper.typ").read_text(encoding="utf-8")
PLACE = re.compile(r"\bn\.(\w+)\.(\w+)")
"""Where a number is inserted."""


@pytest.fixture(scope="module")
def build():
    before = list(sys.path)
    try:
        yield load_script("paper/build.py")
    finally:
        sys.path[:] = before


@pytest.fixture(scope="module")
def folder(build, tmp_path_factory):
    """The numbers, pictures and sources of the paper, made once."""
    folder = tmp_path_factory.mktemp("paper")
    build.prepare(folder)
    return folder


def test_the_paper_has_four_pages_and_typst_remarks_on_nothing(build, folder):
    pages, remarks = build.compiler(folder).compile_with_warnings(format="svg")
    assert len(pages) == 4
    assert [str(each) for each in remarks] == []


def test_the_same_sources_give_the_same_file(build, folder):
    files = [build.compiler(folder).compile(timestamp=build.released(folder)) for _ in range(2)]
    assert files[0].startswith(b"%PDF")
    assert files[0] == files[1]


def test_a_number_that_is_missing_is_no_paper(build, folder, tmp_path):
    shutil.copytree(folder, tmp_path, dirs_exist_ok=True)
    numbers = json.loads((folder / "numbers.json").read_text(encoding="utf-8"))
    del numbers["moduli"]["measured_spin"]
    (tmp_path / "numbers.json").write_text(json.dumps(numbers), encoding="utf-8")
    with pytest.raises(typst.TypstError, match="measured_spin"):
        build.compiler(tmp_path).compile()


def test_every_number_is_used_and_none_is_void(folder):
    numbers = json.loads((folder / "numbers.json").read_text(encoding="utf-8"))
    assert set(PLACE.findall(TEXT)) == {(section, name) for section, names in numbers.items() for name in names}
    for value in leaves(numbers):
        assert not re.search("nan|inf|None", value), value


def leaves(value):
    """Yield the texts in nested dictionaries and lists."""
    if isinstance(value, str):
        yield value
        return
    for each in value.values() if isinstance(value, dict) else value:
        yield from leaves(each)


def test_no_number_with_a_unit_is_typed():
    """What the pages of the documentation are held to: a figure is computed, or it has a source."""
    run = load_script("docs/run.py")
    prose = re.sub(r"^#(set|show|let).*$|//.*$|#v\([^)]*\)|\b[a-z-]+: [\d.]+(%|em|pt|mm)", "", TEXT, flags=re.MULTILINE)
    assert [each[0] for each in run.FIGURE.finditer(prose.replace("~", " "))] == []


def test_no_semicolon_ends_the_code_that_inserts_a_number():
    """Typst takes a semicolon after an inserted number for the end of its code, and prints none."""
    assert re.findall(r"#n\.[\w.()]+;", TEXT) == []


def test_every_source_is_cited():
    listed = re.findall(r"^@\w+\{(\w+),", (ROOT / "paper" / "references.bib").read_text(encoding="utf-8"), re.MULTILINE)
    assert sorted(set(re.findall(r"(?<![\w])@(?!fig-|tab-)(\w+)", TEXT))) == sorted(listed)
