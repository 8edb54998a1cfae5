"""``make release``: one version everywhere, or no tag."""

import shutil
import subprocess
from pathlib import Path

import pytest

from clubface import __version__
from script_files import load_script

ROOT = Path(__file__).parents[1]
release = load_script("scripts/release.py")

STATED = [
    "Cargo.toml", "Cargo.lock", "pyproject.toml", "python/clubface/support/version.py", "CITATION.cff", "CHANGELOG.md",
]  # fmt: skip


def git(folder, *words):
    named = ["-c", "user.name=Test", "-c", "user.email=test@example.com"]
    return subprocess.run(["git", *named, *words], cwd=folder, check=True, capture_output=True, text=True).stdout


@pytest.fixture
def sources(tmp_path, monkeypatch):
    """The files of this version in a repository of their own, with nothing unreleased."""
    for name in ("AUTHOR", "COMMITTER"):
        monkeypatch.setenv(f"GIT_{name}_NAME", "Test")
        monkeypatch.setenv(f"GIT_{name}_EMAIL", "test@example.com")
    for name in STATED:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    changes = tmp_path / "CHANGELOG.md"
    before, _, released = changes.read_text(encoding="utf-8").partition(f"## {__version__}")
    opening = before.partition("## Unreleased")[0]
    changes.write_text(f"{opening}## Unreleased\n\n## {__version__}{released}", encoding="utf-8")
    git(tmp_path, "init", "--quiet")
    commit(tmp_path)
    return tmp_path


def commit(folder):
    git(folder, "add", "--all")
    git(folder, "commit", "--quiet", "--message", "sources")


def test_every_file_states_the_version_of_the_package():
    assert {place: stated for place, stated in release.versions(ROOT) if stated != __version__} == {}


def test_a_whole_release_is_tagged_once(sources, capsys):
    assert release.main([__version__, "--check"], sources) == 0
    assert git(sources, "tag") == ""
    assert release.main([__version__], sources) == 0
    assert git(sources, "cat-file", "-t", f"v{__version__}") == "tag\n"  # annotated
    capsys.readouterr()
    assert release.main([__version__], sources) == 1
    assert "exists already" in capsys.readouterr().err


@pytest.mark.parametrize("place", STATED)
def test_a_file_of_another_version_is_named_and_no_tag_is_set(sources, capsys, place):
    path = sources / place
    text = path.read_text(encoding="utf-8")
    before, heading, rest = text.partition('name = "clubface-math"') if place == "Cargo.lock" else ("", "", text)
    path.write_text(before + heading + rest.replace(__version__, "9.9.9", 1), encoding="utf-8")
    commit(sources)
    assert release.main([__version__], sources) == 1
    message = capsys.readouterr().err
    assert message.count("\n") == 1
    assert message.startswith(place)
    assert "9.9.9" in message
    assert git(sources, "tag") == ""


@pytest.mark.parametrize(
    ("place", "old", "new", "word"),
    [
        ("CHANGELOG.md", "## Unreleased\n", "## Unreleased\n\n* New.\n", "Unreleased"),
        ("CITATION.cff", "date-released: 2", "date-released: 1", "date-released"),
    ],
    ids=["changes of no version", "another date"],
)
def test_what_no_version_has_keeps_a_release_back(sources, capsys, place, old, new, word):
    path = sources / place
    path.write_text(path.read_text(encoding="utf-8").replace(old, new))
    commit(sources)
    assert release.main([__version__], sources) == 1
    assert word in capsys.readouterr().err


def test_uncommitted_files_keep_a_release_back(sources, capsys):
    (sources / "new.py").write_text("")
    assert release.main([__version__], sources) == 1
    assert "not tracked" in capsys.readouterr().err


def test_an_invalid_version_is_refused(capsys):
    with pytest.raises(SystemExit):
        release.main(["v0.2"])
    assert "three numbers" in capsys.readouterr().err
