"""Lines of TOML files: an error names the line that sets a key, wherever it stands."""

import pytest

from clubface.errors import FileError
from clubface.schema import Document

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
    ("path", "line"),
    [
        (("name",), 1), (("parts", 0, "name"), 4), (("parts", 1, "name"), 6), (("shape", "loft"), 8),
        (("parts", 1), 5), (("shape",), 7), (("parts",), 3), (("parts", 1, "none"), 5), (("none",), None), ((), None),
    ],
)  # fmt: skip
def test_a_value_is_in_the_line_of_its_key_or_of_the_nearest_table_around_it(path, line):
    assert Document(TEXT, "x.toml").line_of(path) == line


@pytest.mark.parametrize(
    ("key", "path", "line"),
    [("loft", (), 8), ("shape.loft", (), 8), ("shape_loft", (), 8), ("name", ("parts", 1), 6), ("name", (), 1),
     ("loft", ("parts",), 3), ("lof", (), None)],
)  # fmt: skip
def test_a_key_is_looked_for_below_a_path_with_points_or_low_lines(key, path, line):
    assert Document(TEXT, "x.toml").line_like(key, path) == line


NESTED = """\
[[p]]
n = "c" # [x]
[p.v]
s = 1
[[p.m]]
k = 2
[[p]]
v = { s = 3, t = [1,
 {q = 2}] }
"a b".c = \"\"\"
[p]
\"\"\"
[[p.m]]
k = 5
"""


def test_tables_in_lists_and_braces_have_lines_of_their_own():
    lines = {("p", 0, "v", "s"): 4, ("p", 0, "m", 0, "k"): 6, ("p", 1): 7, ("p", 1, "v", "s"): 8}
    lines |= {("p", 1, "v", "t", 1, "q"): 9, ("p", 1, "a b", "c"): 10, ("p", 1, "m", 0, "k"): 14}
    document = Document(NESTED)
    assert {path: document.line_of(path) for path in lines} == lines


@pytest.mark.parametrize("before", ["", 'name = "x"\n'])
@pytest.mark.parametrize("after", ["", "\n", "\nloft = 1\n"])
def test_a_name_with_a_colon_is_to_be_quoted_even_on_the_last_line(before, after):
    with pytest.raises(FileError, match=r'put the name into quotes: "club:HEAD1" = \.\.\.') as caught:
        Document(f"{before}club:HEAD1 = 1{after}", "x.toml")
    assert caught.value.line == 1 + before.count("\n")


def test_a_byte_order_mark_is_no_part_of_the_first_name(tmp_path):
    file = tmp_path / "x.toml"
    file.write_bytes(b"\xef\xbb\xbf" + TEXT.encode())
    assert Document.read(file).data["name"] == "x"


@pytest.mark.parametrize("again", ["of = 2", "[shape]"])
def test_a_duplicate_key_is_reported_in_plain_words(again):
    with pytest.raises(FileError, match=r"x\.toml:3: this is not TOML: .* defined twice"):
        Document(f"[shape]\nof = 1\n{again}\n", "x.toml")
