"""Progress of long runs where the error stream is no terminal."""

import pytest

pytest.importorskip("typer")

from clubface.cli import output


@pytest.mark.parametrize("kept", [None, "best.toml"])
def test_a_long_run_writes_lines_where_no_bar_can_be_shown(capsys, monkeypatch, kept):
    monkeypatch.setattr(output, "monotonic", iter(range(0, 1000, 25)).__next__)
    with output.progress_bar("designs", kept=kept) as progress:
        for done in range(10):
            if progress is not None:
                progress(done, 10)
    lines = capsys.readouterr().err.splitlines()
    # One at the start, and of nine more updates, 25 s apart, every third, since a minute has passed then.
    expected = [] if kept is None else [kept, "3 of 10 designs (30%)", "6 of 10 designs (60%)", "9 of 10 designs (90%)"]
    assert len(lines) == len(expected)
    assert all(words in line for words, line in zip(expected, lines, strict=True))
