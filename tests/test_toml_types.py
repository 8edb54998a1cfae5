"""A value of the wrong type under any key of a TOML file is refused in one line with file, line and key."""

from __future__ import annotations

import pytest

pytest.importorskip("ezc3d")
pytest.importorskip("meshlane")

from fuzz_readers import READERS
from toml_types import flaw_of, must_be_refused, variants, with_value

SHARE = {
    "fem-head": 11, "fem-case": 40, "sweep-study": 60, "shells": 120, "club": 6, "prior": 1, "golfer": 2, "ball": 60,
    "fem-ball": 60,
}  # fmt: skip
"""One wrong value in so many is tried, and two of each key, one where there are very many; ``make fuzz`` tries all."""
OF_ELEMENTS = ("cube", "pieces")
"""What a ball says of itself for finite elements alone, which read it."""


@pytest.mark.parametrize("name", [name for name, reader in READERS.items() if reader.ending == "toml"])
def test_a_value_of_the_wrong_type_is_refused_with_file_line_and_key(name, tmp_path):
    path, wrong, seen = tmp_path / "in.toml", [], set()
    share = SHARE.get(name, 3)
    always = ("true",) if share > 20 else ("true", "{}")
    for data in READERS[name].seeds():
        for count, (place, raw) in enumerate(variants(data.decode())):
            if (place, raw) in seen or (count % share and raw not in always):
                continue
            seen.add((place, raw))
            if name == "ball" and place[0] in OF_ELEMENTS:
                continue
            value, text = with_value(data.decode(), place, raw)
            path.write_text(text, encoding="utf-8")
            if flaw := flaw_of(READERS[name].read, path, place, must_be_refused(value, raw)):
                wrong.append(f"{'.'.join(map(str, place))} = {raw}: {flaw}")
    assert not wrong, "\n" + "\n".join(wrong)
