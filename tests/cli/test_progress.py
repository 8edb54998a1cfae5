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
    assert len(lines) == (0 if kept is None else 1 + 3)
    assert all(kept in line for line in lines[:1])
    assert all(" of 10 designs" in line for line in lines[1:])
