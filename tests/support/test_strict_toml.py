"""Lines of TOML files: an error names the line that sets a key, wherever it stands."""

import pytest

from clubface.errors import FileError
from clubface.support.strict_toml import Document

TEXT = """\
name = "x"

[[parts]]
name = "core"
[[parts]]
name = "cover"
[shape]
loft = "10 deg"
"""


@pytest.mark.parametrize(
    ("key", "table", "occurrence", "line"),
    [
        ("name", "", 0, 1), ("name", "parts", 0, 4), ("name", "parts", 1, 6), ("loft", "shape", 0, 8),
        ("", "parts", 1, 5), ("shape", "", 0, 7), ("parts", "", 0, 3),
        ("loft", "", 0, None), ("loft", "parts", 0, None), ("name", "parts", 2, None), ("name", "shape", 0, None),
    ],
)  # fmt: skip
def test_a_key_is_found_in_its_table(key, table, occurrence, line):
    assert Document(TEXT, "x.toml").line(key, table, occurrence) == line


def test_an_error_carries_its_key_and_one_of_a_whole_table_carries_none():
    document = Document(TEXT, "x.toml")
    told = document.error("is wrong", "loft", "shape")
    assert (told.path, told.line, told.parameter) == ("x.toml", 8, "loft")
    assert str(told) == "x.toml:8: is wrong"
    of_table = document.error("is wrong", "", "parts", 1)
    assert (of_table.line, of_table.parameter) == (5, None)
    assert (document.error("is wrong").line, document.error("is wrong").parameter) == (None, None)


@pytest.mark.parametrize("before", ["", 'name = "x"\n'])
@pytest.mark.parametrize("after", ["", "\n", "\nloft = 1\n"])
def test_a_name_with_a_colon_is_to_be_quoted_even_on_the_last_line(before, after):
    with pytest.raises(FileError, match=r'put the name into quotes: "club:HEAD1" = \.\.\.') as told:
        Document(f"{before}club:HEAD1 = 1{after}", "x.toml")
    assert told.value.line == 1 + before.count("\n")


def test_a_byte_order_mark_is_no_part_of_the_first_name(tmp_path):
    file = tmp_path / "x.toml"
    file.write_bytes(b"\xef\xbb\xbf" + TEXT.encode())
    assert Document.read(file).data["name"] == "x"


@pytest.mark.parametrize("again", ["of = 2", "[shape]"])
def test_what_is_there_twice_is_told_in_plain_words(again):
    with pytest.raises(FileError, match=r"x\.toml:3: this is not TOML: .* set or opened before"):
        Document(f"[shape]\nof = 1\n{again}\n", "x.toml")
