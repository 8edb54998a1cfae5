"""A dataclass is the schema of its file: read, checked, written and described from its fields."""

import json
import tomllib
from dataclasses import dataclass

import pytest

from clubface.errors import FileError, InputError, UnknownNameError
from clubface.schema import (
    FILES,
    FLAG,
    NAME,
    TEXT,
    Choice,
    Document,
    Interval,
    Items,
    PhysicalValue,
    Record,
    Table,
    Tables,
    check_values,
    count,
    decode,
    encode,
    file_key,
    file_schema,
    json_schema,
    key_rows,
    template,
)
from clubface.support.files import DATA


@dataclass(frozen=True, kw_only=True)
class Peg:
    """A peg."""

    name: str = file_key(NAME, "its name")
    height: float = file_key(PhysicalValue("mm", 0, 100), "above the ground", example="38 mm")


@dataclass(frozen=True, kw_only=True)
class Tee:
    """A place to play from."""

    name: str = file_key(NAME, "its name")
    width: float = file_key(PhysicalValue("m", above=0), "from side to side", example="4 m", multiples={"half": 2.0})
    colour: str = file_key(Choice(("white", "red")), "of its markers", default="white")
    level: bool = file_key(FLAG, "whether it is level", old_name="flat", default=True)
    holes: tuple[int, ...] = file_key(Items(count(1, 18)), "the holes it serves", default=())
    winds: tuple[float, float] | None = file_key(Interval(PhysicalValue("m/s")), "least and greatest", default=None)
    grass: dict[str, float] = file_key(
        Record({"length": PhysicalValue("mm")}), "what grows there", default_factory=dict
    )
    pegs: tuple[Peg, ...] = file_key(Tables(Table(Peg), "peg"), "what stands there", default=())

    def __post_init__(self) -> None:
        check_values(self)


FILE = """\
name = "first"
width = "4 m"
colour = "red"
level = false
holes = [1, 10]
winds = ["0 m/s", "5 m/s"]

[grass]
length = "8 mm"

[[pegs]]
name = "short"
height = "20 mm"

[[pegs]]
name = "tall"
height = "80 mm"
"""


def test_a_file_is_read_in_si_and_written_as_it_was():
    tee = decode(Tee, Document(FILE))
    assert (tee.width, tee.colour, tee.level, tee.holes, tee.winds) == (4.0, "red", False, (1, 10), (0.0, 5.0))
    assert tee.grass == {"length": 0.008}
    assert tee.pegs[1] == Peg(name="tall", height=0.08)
    assert encode(tee) == FILE
    assert decode(Tee, {"name": "first", "half": "2 m"}) == Tee(name="first", width=4.0)


def test_a_key_may_have_an_old_name_that_is_read_with_a_warning():
    with pytest.warns(DeprecationWarning, match="flat is called level now"):
        tee = decode(Tee, {"name": "first", "width": "4 m", "flat": False})
    assert not tee.level
    assert json_schema(Tee, "a tee")["properties"]["flat"]["deprecated"]


@pytest.mark.parametrize(
    ("old", "new", "line", "words"),
    [
        (
            "colour",
            "color",
            3,
            "unknown key 'color' (did you mean colour?); it must be one of name, width, colour, level",
        ),
        ('"red"', '"rad"', 3, "unknown colour 'rad' (did you mean red?); it must be one of white, red"),
        ('name = "first"\n', "", None, "these keys are missing: name"),
        ('name = "tall"\n', "", 15, "these keys of [pegs] are missing: name"),
        ('"4 m"', '"4 kg"', 2, "width is '4 kg'; it must be in m"),
        ('"4 m"', '"0 m"', 2, "width is '0 m'; it must be above 0 m"),
        (
            "level = false",
            "level = false\nflat = true",
            5,
            "flat is True; it must be left out: give level or flat, not both",
        ),
        ('"4 m"', '"4 m"\nhalf = "2 m"', 3, "half is '2 m'; it must be left out: give width or half, not both"),
        ("false", "3", 4, "level is 3; it must be true or false"),
        ("[1, 10]", "[1, 19]", 5, "holes is 19; it must be a whole number from 1 to 18"),
        ('["0 m/s", "5 m/s"]', '["5 m/s", "0 m/s"]', 6, "winds is ['5 m/s', '0 m/s']; it must be two values, least"),
        ('"8 mm"', "true", 9, "grass.length is True; it must be a finite number"),
        ("[grass]", "[[grass]]", 8, "grass is [{'length': '8 mm'}]; it must be a table: [grass]"),
        ('"80 mm"', '"8 m"', 17, "height of peg tall is '8000 mm'; it must be 0 to 100 mm"),
        ('"tall"', '"short"', 16, "name of peg short is 'short'; it must be unique"),
    ],
)
def test_a_mistake_is_described_with_file_line_key_value_and_what_is_allowed(old, new, line, words):
    assert FILE.count(old) == 1
    with pytest.raises(FileError) as caught:
        decode(Tee, Document(FILE.replace(old, new), "tee.toml"))
    place = "tee.toml" if line is None else f"tee.toml:{line}"
    assert str(caught.value).startswith(f"{place}: {words}")


def test_a_mapping_and_an_object_made_in_python_are_checked_alike():
    with pytest.raises(InputError, match="width is '-1 m'; it must be above 0 m"):
        Tee(name="x", width="-1 m")
    with pytest.raises(InputError, match="width is '-1 m'; it must be above 0 m"):
        decode(Tee, {"name": "x", "width": "-1 m"})
    with pytest.raises(UnknownNameError, match="did you mean width"):
        decode(Tee, {"name": "x", "widht": 1.0})
    with pytest.raises(InputError, match="width is missing; give it"):
        decode(Tee, {"name": "x"})
    with pytest.raises(InputError, match=r"height of peg a is '200 mm'.*0 to 100 mm"):
        decode(Tee, {"name": "x", "width": 1.0, "pegs": [{"name": "a", "height": "200 mm"}]})


def test_an_object_of_a_dataclass_is_also_read_from_the_words_of_its_template():
    lines = template(Tee, {"name": '"mine"'})
    assert lines[1] == 'width = "4 m"               # from side to side'
    assert decode(Tee, Document("\n".join(lines))) == Tee(name="mine", width=4.0)


def test_the_keys_have_rows_for_a_page():
    rows = {name: (allowed, meaning) for name, allowed, meaning in key_rows(Tee)}
    assert rows["`width` or `half`"] == ("above 0 m", "from side to side")
    assert rows["`colour`"] == ("`white`, `red`; default `white`", "of its markers")
    assert rows["`pegs.height`"] == ("0 to 100 mm", "above the ground")
    assert list(rows) == [*(f"`{key}`" if key != "width" else "`width` or `half`" for key in (
        "name", "width", "colour", "level", "holes", "winds", "grass", "grass.length", "pegs", "pegs.name",
        "pegs.height"))]  # fmt: skip


def test_the_json_schema_holds_all_keys_and_can_be_written():
    schema = json.loads(json.dumps(json_schema(Tee, "tee")))
    assert schema["required"] == ["name"]
    assert schema["properties"]["colour"]["enum"] == ["white", "red"]
    assert schema["properties"]["pegs"]["items"]["required"] == ["name", "height"]
    assert schema["properties"]["holes"]["items"] == {"type": "integer", "minimum": 1, "maximum": 18}
    assert not schema["additionalProperties"]


def test_text_that_no_file_can_hold_is_refused():
    @dataclass(frozen=True, kw_only=True)
    class Note:
        text: str = file_key(TEXT, "a note")

    with pytest.raises(InputError, match="text in quotes"):
        decode(Note, {"text": "\ud800"})


SHIPPED = {
    "club": "clubs", "parameters": "parameters", "golfer": "golfers", "fem-case": "fem_cases",
    "published-tables": "measurements", "driver-head": "fem_heads/paper", "iron-head": "fem_heads/7-iron",
    "ball-of-pieces": "balls/modern", "ball": "balls/conforming",
}  # fmt: skip
"""Where files of each kind are shipped."""


@pytest.mark.parametrize("name", SHIPPED)
def test_every_shipped_file_is_valid_by_its_json_schema_and_one_with_another_key_is_not(name):
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads(json.dumps(json_schema(file_schema(name), name)))
    validator = jsonschema.Draft202012Validator(schema)
    paths = list(DATA.glob(f"{SHIPPED[name]}.toml")) or list((DATA / SHIPPED[name]).glob("*.toml"))
    assert paths
    for path in paths:
        data = tomllib.loads(path.read_text(encoding="utf-8"))
        assert [each.message for each in validator.iter_errors(data)] == []
        assert list(validator.iter_errors({**data, "another": 1}))


@pytest.mark.parametrize("name", FILES)
def test_every_kind_of_file_has_a_schema_with_a_meaning_for_its_keys(name, clubface_):
    schema = json.loads(clubface_("schema", name).out)
    assert schema["properties"]
    rows = [row for row in key_rows(file_schema(name)) if "." not in row[0]]
    assert rows
    # The tables of a study are named after its kinds, whose own keys have the meanings.
    assert [key for key, _, meaning in rows if not meaning] == [] or name == "study"
    with pytest.raises(UnknownNameError, match="did you mean"):
        file_schema(name + "s")
