"""Inputs that once brought a crash, a traceback, or gigabytes: each is read, or refused in one line."""

from pathlib import Path

import pytest

pytest.importorskip("pyarrow")
pytest.importorskip("pandas")
pytest.importorskip("ezc3d")
pytest.importorskip("meshlane")

from fuzz_input import content, finding
from fuzz_readers import READERS

CORPUS = sorted(path for path in (Path(__file__).parent / "corpus").iterdir() if path.suffix != ".md")


@pytest.mark.parametrize("path", CORPUS, ids=lambda path: path.name)
def test_fuzzing_findings_stay_fixed(path, tmp_path):
    name, _, _ = path.name.partition("--")
    (tmp_path / path.name).write_bytes(path.read_bytes())
    assert finding(name, tmp_path / path.name, measure=True) is None


@pytest.mark.parametrize("name", READERS)
def test_the_examples_of_every_reader_can_be_read(name, tmp_path):
    for number, data in enumerate(READERS[name].seeds()):
        path = tmp_path / f"{number}.{READERS[name].ending}"
        path.write_bytes(data)
        READERS[name].read(path)


def test_an_input_follows_from_its_numbers():
    assert content(3, 40) == content(3, 40)
    assert content(3, 40) != content(4, 40)
