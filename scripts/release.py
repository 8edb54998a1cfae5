"""Check that a release is whole, and set its tag.

``python scripts/release.py 0.2.0`` compares the version of the crates, their lock file, the package, the citation file
and the changelog, whose part "Unreleased" must be empty or missing, wants a folder without uncommitted changes, and
sets the annotated tag ``v0.2.0``. What disagrees is printed, with file and value, and the exit status is 1. ``--check``
sets no tag. A pushed tag makes the wheels: .github/workflows/wheels.yml.
"""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
VERSION = re.compile(r"\d+\.\d+\.\d+")


def versions(root: Path) -> Iterator[tuple[str, str]]:
    """Yield each place that states the version, and what it states."""

    def read(name: str) -> str:
        return (root / name).read_text(encoding="utf-8")

    def toml(name: str) -> dict[str, Any]:
        return tomllib.loads(read(name))

    def quoted(name: str, pattern: str) -> str:
        match = re.search(pattern, read(name), re.MULTILINE)
        return match[1] if match else "nothing"

    yield "Cargo.toml", toml("Cargo.toml")["workspace"]["package"]["version"]
    for crate in toml("Cargo.lock")["package"]:
        if "source" not in crate:  # those of the workspace
            yield f"Cargo.lock, {crate['name']}", crate["version"]
    yield "pyproject.toml", toml("pyproject.toml")["project"]["version"]
    yield "python/clubface/support/version.py", quoted("python/clubface/support/version.py", r'^__version__ = "(.*)"$')
    yield "CITATION.cff", quoted("CITATION.cff", r"^version: (\S+)$")
    yield "CHANGELOG.md", quoted("CHANGELOG.md", r"^## (\d\S*)")


def problems(root: Path, version: str) -> Iterator[str]:
    """Yield what keeps the sources in ``root`` from being released as ``version``, each in one sentence."""
    for place, stated in versions(root):
        if stated != version:
            yield f"{place} states {stated}, not {version}"
    changes = (root / "CHANGELOG.md").read_text(encoding="utf-8")
    if changes.partition("## Unreleased")[2].partition("\n## ")[0].strip():
        yield "CHANGELOG.md has changes under Unreleased; move them to the version"
    dated = re.search(r"^## \d\S* \((\d{4}-\d\d-\d\d)\)$", changes, re.MULTILINE)
    cited = re.search(r"^date-released: (\S+)$", (root / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)
    dates = dated and dated[1], cited and cited[1]
    if None in dates or dates[0] != dates[1]:
        yield f"CHANGELOG.md dates the version {dates[0]}, date-released in CITATION.cff {dates[1]}"
    if _git(root, "status", "--porcelain"):
        yield "files are changed or not tracked; commit or remove them (git status lists them)"
    if _git(root, "tag", "--list", f"v{version}"):
        yield f"the tag v{version} exists already"


def _git(root: Path, *words: str) -> str:
    return subprocess.run(["git", *words], cwd=root, capture_output=True, text=True, check=True).stdout.strip()


def main(words: list[str] | None = None, root: Path = ROOT) -> int:
    """Check, and set the tag where everything agrees; return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("version", help="the version, such as 0.2.0")
    parser.add_argument("--check", action="store_true", help="check only, and set no tag")
    given = parser.parse_args(words)
    if not VERSION.fullmatch(given.version):
        parser.error(f"version: '{given.version}' is none; give three numbers, such as 0.2.0")
    wrong = list(problems(root, given.version))
    for each in wrong:
        print(each, file=sys.stderr)
    if wrong or given.check:
        return 1 if wrong else 0
    _git(root, "tag", "--annotate", f"v{given.version}", "--message", f"clubface {given.version}")
    print(f"v{given.version} is set; git push origin v{given.version} publishes it")
    return 0


if __name__ == "__main__":
    sys.exit(main())
