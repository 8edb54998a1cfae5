"""What a command prints as JSON follows the schema that is written down, and its tables follow from one place."""

import csv
import importlib.resources
import io
import json

import jsonschema
import pytest

SCHEMA = json.loads(importlib.resources.files("clubface").joinpath("data/schemas/result-1.json").read_text())
SPEED = ("--speed", "113 mph")
COMMANDS = {
    "clubs": ("clubs",),
    "clubs-one": ("clubs", "driver"),
    "models": ("models",),
    "models-one": ("models", "rings"),
    "flight": ("flight", "--ball-speed", "165 mph", "--launch", "11 deg", "--backspin", "2500 rpm"),
    "sensitivity": ("sensitivity", "driver", *SPEED, "--by", "toe,loft"),
    "shot": ("shot", "driver", *SPEED, "--model", "response,standard"),
}
"""A run of each command whose result has a report, by its name."""


@pytest.mark.parametrize("name", COMMANDS)
def test_the_json_of_a_command_follows_the_schema(clubface_, name):
    document = clubface_(*COMMANDS[name], "--json").json
    jsonschema.validate(document, SCHEMA)
    for made in document["tables"].values():
        for row in made["rows"]:
            assert list(row) == list(made["columns"])


def test_a_document_that_breaks_the_schema_is_noticed(clubface_):
    document = clubface_(*COMMANDS["flight"], "--json").json
    document["values"]["carry_m"] = {"value": 1.0}
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(document, SCHEMA)


@pytest.mark.parametrize("name", COMMANDS)
def test_the_data_of_a_report_are_those_of_the_json_to_the_last_digit(clubface_, tmp_path, saved_tables, name):
    report = tmp_path / "report.html"
    document = clubface_(*COMMANDS[name], "--json", "--report", str(report)).json
    saved = saved_tables(report)
    wanted = {each: made["rows"] for each, made in document["tables"].items()}
    if document["values"]:
        wanted[document["kind"]] = [document["values"]]
    assert wanted
    for each, rows in wanted.items():
        read = list(csv.DictReader(io.StringIO(saved[f"{each.replace('_', '-')}.csv"])))
        assert read == [{key: "" if value is None else str(value) for key, value in row.items()} for row in rows]
