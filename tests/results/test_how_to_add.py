"""A quantity, a note and a command are added in the places that the contributing page names, and nowhere else."""

import re
import sys
import types
from pathlib import Path

import pytest
import typer

from clubface import quantities as registry
from clubface.cli import app as commands, show
from clubface.cli.options import takes
from clubface.quantities import register_quantity
from clubface.results import Result, catalogue, column, note, text
from clubface.results.table import table

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "CONTRIBUTING.md").read_text()


def places(what):
    """Return the files that the page names for adding something."""
    paragraph = re.search(rf"\*\*{what}\.\*\* (.*?)\n\n", PAGE, re.DOTALL)
    assert paragraph is not None
    return re.findall(r"`((?:python|crates|tests)/[^`]+)`", paragraph[1])


@pytest.mark.parametrize("what", ["A quantity", "A note", "A command"])
def test_the_places_that_the_page_names_are_there(what):
    assert places(what)
    for each in places(what):
        assert (ROOT / each).exists(), each


@pytest.fixture
def paddle(monkeypatch):
    """A command that computes one new quantity and says one new note about it."""
    monkeypatch.setattr(registry, "_OWN", dict(registry._OWN))
    register_quantity("paddle_force", "N", golf=("kN", 2), label="paddle force", sides=("pull", "push"))
    monkeypatch.setitem(
        catalogue.SENTENCES, "paddle-slips", "The paddle slips at {paddle_force} after {strokes:n stroke}."
    )
    app = typer.Typer(add_completion=False)

    @app.command()
    @takes(show.REPORT, show.TABLE, show.UNITS, show.JSON)
    def run(**texts):
        """Paddle."""
        output = show.Output.check(texts)
        made = table("strokes", text("stroke", ["first", "second"]), column("paddle_force", [1234.5, -50.0]))
        output.show(Result("paddle", "Paddle", (made,), notes=(note("paddle-slips", paddle_force=1234.5, strokes=2),)))

    module = types.ModuleType("clubface.cli.paddle")
    module.app = app
    monkeypatch.setitem(sys.modules, "clubface.cli.paddle", module)
    monkeypatch.setitem(commands.COMMANDS, "paddle", "paddle")


@pytest.mark.usefixtures("paddle")
def test_a_new_quantity_note_and_command_reach_every_surface(clubface_, tmp_path, saved_tables):
    report, saved = tmp_path / "paddle.html", tmp_path / "paddle.csv"
    ran = clubface_("paddle", "--report", str(report), "--output", str(saved))
    assert ran.status == 0
    assert ["first", "1.23"] in [line.split() for line in ran.out.splitlines()]
    assert "* The paddle slips at 1.23 kN after 2 strokes." in ran.out
    assert saved.read_text() == saved_tables(report)["strokes.csv"]
    assert saved.read_text().splitlines() == ["stroke,paddle_force_kN", "first,1.2345", "second,-0.05"]
    document = clubface_("paddle", "--json").json
    assert document["tables"]["strokes"]["rows"][0] == {"stroke": "first", "paddle_force_kN": 1.2345}
    assert document["notes"][0]["data"] == {"paddle_force_kN": 1.2345, "strokes": 2}
    assert ["first", "1234"] in [
        line.split() for line in clubface_("paddle", "--unit", "paddle_force=N").out.splitlines()
    ]


def test_a_second_quantity_of_the_same_name_is_refused():
    with pytest.raises(ValueError, match="carry"):
        register_quantity("carry", "m", label="something else")
