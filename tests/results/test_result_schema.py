"""Every command prints one document as JSON, which follows the schema that is written down.

The data that a report lets a reader save are the same columns with the same digits.
"""

import csv
import importlib.resources
import io
import json
import shlex
import sys
from pathlib import Path

import jsonschema
import pytest
import typer

from clubface.cli.app import app
from clubface.cli.show import Output
from clubface.present.document import as_markdown
from clubface.present.report import report_blocks
from clubface.present.terminal import as_text
from clubface.results.result import Result
from clubface.results.table import column, table

sys.path.insert(0, str(Path(__file__).parents[2] / "scripts"))
from golden_outputs import write_inputs

SCHEMA = json.loads(importlib.resources.files("clubface").joinpath("data/schemas/result-1.json").read_text())
MONITOR = str(Path(__file__).parents[1] / "data" / "launch_monitors" / "trackman.csv")
COMMANDS = {
    "best-loft": "best-loft --speed '100 mph' --attack '0 deg' --model standard",
    "capture join": "capture join shots.csv swings/truth.csv -o joined.csv",
    "capture markers": "capture markers swings/swing-001.c3d",
    "capture read": "capture read swings/swing-001.c3d --markers swings/markers.toml --club driver -o shots.csv",
    "capture study": "capture study --count 1 --noise '0.3 mm'",
    "chart": "chart",
    "club check": "club check mine.toml",
    "clubs": "clubs driver",
    "compare": "compare driver 3-wood --speed '105 mph' --toe '10 mm' --model standard",
    "dispersion": "dispersion handicap-10-driver --count 256 --model standard --no-shares",
    "evaluate": "evaluate driver.parquet --models standard,slip --resamples 100 --where 'row <= 30'",
    "explain": "explain driver --speed '105 mph' --path '-3 deg' --model standard",
    "fem ball": "fem ball ball.toml",
    "fem design": "fem design walls.toml -o best-head.toml --workers 2",
    "fem face": "fem face head.toml --ball ball.toml --toe 0:8:8 --high 0:0:1 --workers 2",
    "fem head": "fem head head.toml",
    "fem paper": "fem paper --case drive.toml --no-sweep",
    "fem reference": "fem reference --ball ball.toml",
    "fem run": "fem run throw.toml",
    "fem sweep": "fem sweep --case drive.toml --speed 30 --loft 9,11 --workers 2",
    "flight": "flight --ball-speed '165 mph' --launch '11 deg' --backspin '2500 rpm'",
    "golfer estimate": "golfer estimate session.csv --only driver",
    "golfer list": "golfer list",
    "golfer show": "golfer show bogey-driver",
    "identify": "identify driver.parquet --model standard --population 8 --generations 2 --refined 1 --folds 0 "
    "--bootstrap 0 --no-profiles --where 'row <= 30'",
    "infer": "infer --club driver --ball-speed '159 mph' --launch '14.5 deg' --backspin '2900 rpm' --samples 100 "
    "--model standard",
    "map": "map driver --speed '105 mph' --grid 5x5 --spread '12 mm x 9 mm' --model standard",
    "models": "models response",
    "monitor formats": "monitor formats garmin",
    "monitor read": "monitor read trackman.csv",
    "monitor summary": "monitor summary session.csv",
    "optimise": "optimise better.toml",
    "predict": "predict deliveries.csv --club driver -o predicted.csv",
    "sensitivity": "sensitivity driver --speed '113 mph' --by toe,loft",
    "shot": "shot driver --speed '113 mph' --model response,standard",
    "study join": "study join samples.toml --store here",
    "study run": "study run samples.toml --workers 1 --store here",
    "study status": "study status samples.toml --store here",
    "study summary": "study summary samples.toml --store here",
    "tour": "tour --averages lpga-2019 --model standard",
    "validate": "validate --model standard --check tour-driver",
}
"""A run of every command, in the folder of the golden outputs' input files."""
PREPARED = {
    "capture": ["capture synthesize -o swings --count 1 --noise '0.2 mm'"],
    "capture join": ["capture read swings/swing-001.c3d --markers swings/markers.toml --club driver -o shots.csv"],
    "club check": ["club new mine -o mine.toml"],
    "study": ["study run samples.toml --workers 1 --store here"],
}
"""What is run before a command, or before those of its group."""
DRAWN_ELSEWHERE = {
    "best-loft", "compare", "dispersion", "fem head", "fem run", "golfer estimate", "golfer show", "map", "optimise",
    "shot", "study summary",
}  # fmt: skip
"""Commands whose reports `tests/cli/test_reports_of_all_kinds.py` writes with their pictures."""
LIVE = {"monitor listen"}
"""Commands that wait for another program; tests of their own read what they print."""


def leaves(command, name=()):
    """Every command of the command line with its options, groups opened."""
    if hasattr(command, "list_commands"):
        context = typer.Context(command)
        for each in command.list_commands(context):
            yield from leaves(command.get_command(context, each), (*name, each))
    else:
        yield " ".join(name), {option for each in command.params for option in each.opts}


OPTIONS = dict(leaves(typer.main.get_command(app)))


@pytest.fixture(scope="module")
def inputs(tmp_path_factory):
    """A folder with the input files of the golden outputs."""
    folder = tmp_path_factory.mktemp("inputs") / "files"
    write_inputs(folder)
    return folder


@pytest.fixture
def run(clubface_, inputs, monkeypatch):
    """Run a command line in the folder of inputs, after what it needs."""
    monkeypatch.chdir(inputs)

    def ran(name, *more):
        for each in (*PREPARED.get(name.split()[0], ()), *PREPARED.get(name, ())):
            if name != each:
                clubface_(*shlex.split(each))
        done = clubface_(*shlex.split(COMMANDS[name]), "--json", *more)
        assert done.status == 0, done.err
        return done.json

    return ran


def test_every_command_with_json_is_among_them():
    assert {name for name, options in OPTIONS.items() if "--json" in options} == set(COMMANDS) | LIVE


@pytest.fixture
def shown(monkeypatch):
    """The results that commands show."""
    results = []
    show = Output.show
    monkeypatch.setattr(
        Output, "show", lambda self, result, **more: (results.append(result), show(self, result, **more))
    )
    return results


@pytest.mark.parametrize("name", COMMANDS)
def test_the_json_of_a_command_follows_the_schema(run, name, tmp_path, saved_tables, shown, request):
    if name in DRAWN_ELSEWHERE:
        request.getfixturevalue("without_pictures")
    report = tmp_path / "report.html"
    document = run(name, *(["--report", str(report)] if "--report" in OPTIONS[name] else []))
    jsonschema.validate(document, SCHEMA)
    assert document["tables"] or document["values"]
    for made in document["tables"].values():
        for row in made["rows"]:
            assert list(row) == list(made["columns"])
    for each in shown[-1].tables:
        frame, dataset = shown[-1].to_pandas(each.name), shown[-1].to_xarray(each.name)
        assert len(frame) == len(each)
        assert set(dataset.variables) == set(frame)
    # What a terminal shows of it stays within its width.
    for width in (80, 120):
        lines = as_text(shown[-1], width=width).split("\n")
        assert [line for line in lines if len(line) > width] == []
    if "--report" in OPTIONS[name]:
        saved = saved_tables(report)
        wanted = {each.replace("_", "-"): made["rows"] for each, made in document["tables"].items() if made["rows"]}
        if document["values"]:
            wanted[f"{document['kind']}-values"] = [document["values"]]
        for each, rows in wanted.items():
            read = list(csv.DictReader(io.StringIO(saved[f"{each}.csv"])))
            assert read == [{key: "" if value is None else str(value) for key, value in row.items()} for row in rows]


def test_a_document_that_breaks_the_schema_is_noticed(run):
    document = run("flight")
    document["values"]["carry_m"] = {"value": 1.0}
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(document, SCHEMA)


def test_the_parts_of_a_result_are_in_every_rendering():
    part = Result("part", "The part", tables=(table("numbers", column("carry", [200.0])),))
    whole = Result("whole", "The whole", parts=(part,))
    document = whole.to_dict()
    jsonschema.validate(document, SCHEMA)
    assert document["parts"][0]["tables"]["numbers"]["rows"] == [{"carry_m": 200.0}]
    for shown in (str(whole), whole._repr_html_(), as_markdown(list(report_blocks(whole)))):
        assert shown.index("The whole") < shown.index("The part") < shown.index("218.7")
