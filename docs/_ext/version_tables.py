"""Tables of the versions and machines on which the tests ran, made from what the runs recorded."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path
from typing import Any

from core_tables import CoreTable, markdown_table
from sphinx.application import Sphinx

ROOT = Path(__file__).parents[2]


def runs() -> list[dict[str, Any]]:
    """Return the runs that `make test-oldest`, `test-newest` and `test-beyond` recorded."""
    return json.loads((ROOT / "docs" / "tested-versions.json").read_text(encoding="utf-8"))


def machine_runs() -> list[dict[str, Any]]:
    """Return the runs that `make wheel-check`, `test-foreign` and `test-wheel` recorded."""
    return json.loads((ROOT / "docs" / "tested-machines.json").read_text(encoding="utf-8"))


def version_key(version: str) -> list[int]:
    """Return the numbers of a version, which sort as versions do."""
    return [int(part) for part in re.findall(r"\d+", version)]


def allowed_versions() -> dict[str, str]:
    """Return what pyproject.toml allows of each direct dependency."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = {name: lines for name, lines in project["optional-dependencies"].items() if name not in ("all", "dev")}
    lines = [line for group in (project["dependencies"], *extras.values()) for line in group]
    split = (re.fullmatch(r"([\w-]+)(.*)", line) for line in lines)
    return {match[1]: match[2].replace(",", ", ") for match in split if match}


class TestedRuns(CoreTable):
    """``{tested-runs}``: on which Python, system and day which tests ran, and how they ended."""

    def table(self) -> list[str]:
        """One row a run."""
        heads = ("dependencies", "Python", "system", "tests", "passed", "skipped", "failed", "extras left out", "date")
        rows = (
            [
                each["versions"], each["release"] + "t" * each["python"].endswith("t"), each["machine"],
                "all" if each["tests"] == "all" else "a selection", each["passed"], each["skipped"], each["failed"],
                ", ".join(each["left_out"]) or "none", each["date"],
            ]
            for each in sorted(runs(), key=lambda each: (each["versions"] != "oldest", version_key(each["release"])))
        )  # fmt: skip
        return markdown_table(heads, rows)


class TestedPackages(CoreTable):
    """``{tested-packages}``: of each dependency, the versions allowed and the lowest and highest tested."""

    def table(self) -> list[str]:
        """One row a dependency; what was tried beyond the allowed versions does not count."""
        packages: dict[str, list[str]] = {}
        for run in runs():
            if run["versions"] != "beyond" and not run["failed"]:
                for name, version in run["packages"].items():
                    packages.setdefault(name, []).append(version)
        rows = []
        for name, allowed in sorted(allowed_versions().items()):
            tested = sorted(packages.get(name, []), key=version_key)
            rows.append([name, allowed, *((tested[0], tested[-1]) if tested else ("not tested", "not tested"))])
        return markdown_table(("package", "allowed", "lowest tested", "highest tested"), rows)


class TestedMachines(CoreTable):
    """``{tested-machines}``: for each kind of machine, its wheel and which tests ran how, and how they ended."""

    def table(self) -> list[str]:
        """One row a kind of machine."""
        recorded = {(each["target"], each["what"]): each for each in machine_runs()}
        heads = ("machine", "wheel", "Rust", "Python, from the wheel")
        rows = (
            [
                f"`{target}`",
                contents_cell(recorded.get((target, "contents"))),
                *(tests_cell(recorded.get((target, what))) for what in ("tests", "wheel")),
            ]
            for target in dict.fromkeys(each["target"] for each in machine_runs())
        )
        return markdown_table(heads, rows)


def contents_cell(run: dict[str, Any] | None) -> str:
    """Return what the checks of a wheel found."""
    if run is None:
        return "not built"
    platform = run["wheel"].removesuffix(".whl").rpartition("-")[2].partition(".")[0]
    return f"`{platform}`, {run['megabytes']} MB, {run['passed']} checks passed, {run['failed']} failed"


def tests_cell(run: dict[str, Any] | None) -> str:
    """Return how tests ran and ended."""
    if run is None:
        return "not run"
    selection = "all" if run["tests"] == "all" else "a selection"
    return f"{run['how']}, {selection}: {run['passed']} passed, {run['failed']} failed, {run['date']}"


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    app.add_directive("tested-runs", TestedRuns)
    app.add_directive("tested-packages", TestedPackages)
    app.add_directive("tested-machines", TestedMachines)
    return {"parallel_read_safe": True}
