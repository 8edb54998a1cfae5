"""Mapping files: strictly checked, every mistake with its line."""

import re
from pathlib import Path

import pytest

from clubface import shots as launch_monitor
from clubface.errors import FileError
from clubface.shots.formats import mapping_of

PAGE = Path(__file__).parents[2] / "docs" / "launch-monitors.md"
COLUMN = '[columns.speed]\nheading = "Tempo"\nunit = "km/h"\n'


@pytest.mark.parametrize(
    ("content", "line", "message"),
    [
        ("", None, "these keys are missing: columns"),
        ("columns = 3", 1, r"columns is 3; it must be a table, as in \[columns.speed\]"),
        ("[columns]", 1, "at least one is not optional"),
        ("[columns", None, "not TOML"),
        ('decimals = ","\n' + COLUMN, 1, "did you mean decimal"),
        ("decimal = 1\n" + COLUMN, 1, "unknown decimal 1"),
        ('decimal = "x"\n' + COLUMN, 1, "unknown decimal 'x'"),
        ('delimiter = ","\ndecimal = ","\n' + COLUMN, 2, "cannot both be a comma"),
        ('speed_at = "toe"\n' + COLUMN, 1, "must be one of cg, face"),
        ('face_at = "cg"\n' + COLUMN, 1, "must be one of face, contact"),
        (COLUMN + '[columns.sped]\nheading = "x"', 4, "unknown key 'sped' .did you mean speed"),
        (COLUMN + '[columns.path]\nunit = "deg"', 4, r"these keys of \[columns.path\] are missing: heading"),
        (COLUMN + '[columns.path]\nheading = ""', 5, "heading is .*text with a word in it"),
        (COLUMN + "[columns.path]\nheading = 5", 5, "heading is 5; it must be text"),
        (COLUMN + '[columns.path]\nheading = "Bahn"\nunit = "mph"', 6, "in rad or deg, not a speed"),
        (COLUMN + '[columns.path]\nheading = "Bahn"\nsign = 1', 6, "unknown key 'sign'"),
        (COLUMN + '[columns.path]\nheading = "Bahn"\npositive = "rigt"', 6, "did you mean right"),
        (COLUMN + 'positive = "right"', 4, "speed has no sides"),
        (COLUMN + "optional = 1", 4, "optional is 1; it must be true or false"),
        (COLUMN + "optional = true", 1, "at least one is not optional"),
        ("columns.speed = 3", 1, r"columns.speed is 3; it must be a table"),
    ],
)
def test_a_mistake_in_a_mapping_is_reported_with_its_line(write, content, line, message):
    with pytest.raises(FileError, match=message) as caught:
        mapping_of(write(content, "mapping.toml"))
    assert caught.value.line == line


def test_a_missing_mapping_is_reported():
    with pytest.raises(FileError, match="cannot be read"):
        mapping_of("missing.toml")


def test_the_mapping_of_the_page_reads_a_file(write):
    text = re.search(r"^```toml\n(.*?)^```", PAGE.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)[1]
    mapping = write(text, "radar.toml")
    shots = launch_monitor.read(write("Schläger;Tempo;Bahn\nE7;126;1,5\n"), mapping=mapping, hand="left")
    assert shots.deliveries["speed"] == pytest.approx([35.0])
    assert shots.deliveries["path"] == pytest.approx([-0.0261799388])
    assert shots.clubs.tolist() == ["E7"]
    shots = launch_monitor.read(write("Schläger;Tempo;Bahn;Weite\nE7;126;1,5;150,5\n"), mapping=mapping)
    assert shots.launches["carry"] == pytest.approx([150.5])


def test_a_mapped_column_needs_its_unit_from_somewhere(write):
    mapping = write('[columns.speed]\nheading = "Tempo"\n', "mapping.toml")
    with pytest.raises(FileError, match="the column 'Tempo' names no unit"):
        launch_monitor.read(write("Tempo\n100\n"), mapping=mapping)
    for content in ("Tempo [mph]\n100\n", "Tempo\n[mph]\n100\n"):
        assert launch_monitor.read(write(content), mapping=mapping).deliveries["speed"] == pytest.approx([44.704])
