"""The files of every Rust crate use each other without circles, and only what stands below them."""

import re
import shutil
import subprocess
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from arrows import circle, upward

CRATES = Path(__file__).parent.parent / "crates"

# Folders (and files at the root) of each crate, from the lowest to the highest. A file may use its own folder and those
# before it. The root file of a crate (lib.rs, main.rs) only puts them together.
LAYERS = {
    "clubface-math": ("scalar", "elementary", "vec3", "mat3", "quat", "dual", "pack", "ode"),
    "clubface-impact": (
        "error", "fault", "description", "series", "unit", "quantity", "ball", "face", "face_spring",
        "head_inertia", "club",
        "delivery", "shot", "inertia_check", "check", "launch", "first_touch", "guided_mass", "giving_face", "impact",
        "columns",
        "parallel", "contact", "own_law", "rings", "model", "models", "kernels", "impact_model", "multibody",
        "struck_ball", "registry", "batch", "sensitivity", "flight", "describe",
    ),
    "clubface-fem": (
        "error", "environment", "block", "moments", "mesh", "material", "element", "contact", "solve", "ball", "head",
        "cases", "sensitivity", "description",
    ),
    "clubface-design": (
        "normal", "sequence", "golfer", "tally", "strokes", "shot_batch", "dispersion", "outline", "face_map",
        "feasibility",
    ),
    "clubface-c": (
        "abi", "result", "rows", "names", "shots", "stepped", "flights", "dispersion", "face_map", "feasibility", "fem",
    ),
    "clubface-fmi": ("unit", "fmi2", "fmi3"),
}  # fmt: skip

USE = re.compile(r"\b(pub(?:\([a-z ]+\))?\s+)?use\s+([^;]+);")
PATH = re.compile(r"(?<![\w$:])((?:crate|super|self)(?:::\w+)+)")
TESTS = re.compile(r"^#\[cfg\((?:all\()?test\b[^\n]*\n(?:#\[[^\n]*\n)*mod \w+(?:;| \{.*?^\})", re.M | re.S)
COMMENT = re.compile(r"//[^\n]*")


def expand(tree: str) -> Iterator[list[str]]:
    """Split the tree of a use declaration, ``a::{b, c::d as e}``, into its paths."""
    head, brace, rest = tree.strip().partition("{")
    prefix = [part.strip() for part in head.split("::") if part.strip()]
    if not brace:
        yield re.sub(r"\s+as\s+\w+$", "", tree.strip()).split("::")
        return
    depth, start = 0, 0
    inside = rest[: rest.rindex("}")]
    for at, letter in enumerate(inside + ","):
        depth += {"{": 1, "}": -1}.get(letter, 0)
        if letter == "," and depth == 0:
            if inside[start:at].strip():
                for path in expand(inside[start:at]):
                    yield prefix + [part.strip() for part in path]
            start = at + 1


class Crate:
    """The files of a crate by the paths of their modules, and what each uses."""

    def __init__(self, folder: Path) -> None:
        self.source = folder / "src"
        self.files: dict[tuple[str, ...], Path] = {}
        for file in sorted(self.source.rglob("*.rs")):
            parts = file.relative_to(self.source).with_suffix("").parts
            self.files[parts[:-1] if parts[-1] in ("mod", "lib", "main") else parts] = file
        self.code = {module: self._code(file) for module, file in self.files.items()}
        self.exported = {module: dict(self._exports(module)) for module in self.files}

    @staticmethod
    def _code(file: Path) -> str:
        return COMMENT.sub("", TESTS.sub("", COMMENT.sub("", file.read_text())))

    def _absolute(self, module: tuple[str, ...], path: list[str]) -> tuple[str, ...] | None:
        """Return a path from the root of the crate, or None for one that leads out of the crate."""
        at = list(module)
        if path[0] == "crate":
            return tuple(path[1:])
        if path[0] not in ("super", "self"):
            return (*module, *path) if (*module, path[0]) in self.files else None
        while path and path[0] in ("super", "self"):
            if path[0] == "super":
                if not at:
                    return None
                at.pop()
            path = path[1:]
        return (*at, *path)

    def _exports(self, module: tuple[str, ...]) -> Iterator[tuple[str, tuple[str, ...]]]:
        """Yield the names that a module passes on from others, with their paths."""
        for public, tree in USE.findall(self.code[module]):
            if public:
                for path in expand(tree):
                    absolute = self._absolute(module, path)
                    if absolute:
                        yield absolute[-1], absolute

    def _owner(self, path: tuple[str, ...], depth: int = 0) -> tuple[str, ...] | None:
        """Return the module whose file defines what a path names: its own, not one that passes it on."""
        for length in range(len(path), -1, -1):
            module = path[:length]
            if module in self.files:
                rest = path[length:]
                if rest and depth < 8 and rest[0] in self.exported[module]:
                    return self._owner(self.exported[module][rest[0]] + rest[1:], depth + 1)
                return module
        return None

    def arrows(self) -> dict[tuple[str, ...], set[tuple[str, ...]]]:
        """Return which modules each module uses. What a mod.rs or lib.rs passes on does not count."""
        arrows: dict[tuple[str, ...], set[tuple[str, ...]]] = {}
        for module, file in self.files.items():
            if file.parent == self.source and file.stem in ("lib", "main"):
                continue
            paths = [path for public, tree in USE.findall(self.code[module]) if not public for path in expand(tree)]
            paths += [match.split("::") for match in PATH.findall(USE.sub("", self.code[module]))]
            used = set()
            for path in paths:
                absolute = self._absolute(module, path)
                owner = absolute and self._owner(absolute)
                if owner and owner != module:
                    used.add(owner)
            arrows[module] = used
        return arrows


def folders(layers: tuple[str, ...]):
    """Return the floor of a module, by its folder."""
    return lambda module: layers.index(module[0]) if module else -1


@cache
def arrows_of(name: str) -> dict[tuple[str, ...], set[tuple[str, ...]]]:
    """Return the arrows of a crate of this project."""
    return Crate(CRATES / name).arrows()


@pytest.mark.parametrize("crate", sorted(path.parent.name for path in CRATES.glob("*/Cargo.toml")))
def test_no_files_of_a_crate_use_each_other_in_a_circle(crate):
    assert not circle(arrows_of(crate))


@pytest.mark.parametrize("name", sorted(LAYERS))
def test_no_file_uses_a_higher_folder(name):
    arrows = arrows_of(name)
    missing = {module[0] for module in arrows} - set(LAYERS[name])
    assert not missing, f"add the folders {', '.join(sorted(missing))} to LAYERS"
    assert not upward(arrows, folders(LAYERS[name]))


def test_crates_use_lower_crates_only():
    order = ["clubface-math", "clubface-impact", "clubface-design", "clubface-fem"]
    for number, name in enumerate(order):
        manifest = (CRATES / name / "Cargo.toml").read_text()
        used = set(re.findall(r"^(clubface-\w+) = ", manifest, re.M))
        assert used <= set(order[:number]), name


SMALL = {
    "lib.rs": "mod low;\nmod high;\npub use low::Thing;\n",
    "low/mod.rs": "mod a;\nmod b;\npub use a::Thing;\npub use b::Other;\n",
    "low/a.rs": "use super::b::Other;\npub struct Thing;\n",
    "low/b.rs": "pub struct Other;\n",
    "high.rs": "use crate::low::{Other, Thing as Renamed};\n",
}


@pytest.mark.parametrize(
    ("text", "result", "up"),
    [
        ("pub struct Other;\n", set(), False),
        # Each of these plants a mistake.
        ("use super::Thing;\npub struct Other;\n", {("low", "a"), ("low", "b")}, False),
        ("fn f() -> crate::low::a::Thing {}\n", {("low", "a"), ("low", "b")}, False),
        ("use crate::high::{self, f as g};\n", {("high",), ("low", "a"), ("low", "b")}, True),
        ("// use super::a::Thing;\n#[cfg(test)]\nmod tests {\n    use super::super::a::Thing;\n}\n", set(), False),
    ],
)
def test_planted_circles_and_upward_arrows_are_found(tmp_path, text, result, up):
    for name, content in {**SMALL, "low/b.rs": text}.items():
        path = tmp_path / "src" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)
    arrows = Crate(tmp_path).arrows()
    assert set(circle(arrows)) <= result
    assert bool(circle(arrows)) == bool(result)
    assert upward(arrows, folders(("low", "high"))) == ([(("low", "b"), ("high",))] if up else [])


SELECTIONS = {
    "the package": ("--package", "clubface-python", "--edges", "normal"),
    "the FMU": ("--package", "clubface-fmi", "--edges", "normal"),
    "the tests": (
        "--workspace",
        "--exclude",
        "clubface-python",
        "--exclude",
        "clubface-benches",
        "--edges",
        "normal,dev",
    ),
}
"""What `make build` and `make test` compile."""


def features(selection: tuple[str, ...]) -> set[tuple[str, str]]:
    """Return clubface-impact and all that it uses, each with its features, when cargo compiles a selection."""
    shape = ("--prefix", "depth", "--no-dedupe", "--format", " {p}|{f}")
    command = ["cargo", "tree", "--offline", "--locked", *selection, *shape]
    lines = subprocess.run(command, cwd=CRATES, capture_output=True, text=True, check=True).stdout.splitlines()
    result, inside = set(), None
    for line in lines:
        if match := re.match(r"(\d+) (\S+) v[^|]*\|(.*)", line):
            depth, name, chosen = int(match[1]), match[2], match[3].split(" ")[0]
            if inside is not None and depth <= inside:
                inside = None
            if name == "clubface-impact" and depth:
                inside = depth
            if inside is not None:
                result.add((name, chosen))
    return result


@pytest.mark.skipif(shutil.which("cargo") is None, reason="cargo is not installed")
def test_the_core_is_compiled_once_for_package_fmu_and_tests() -> None:
    """Cargo compiles a crate anew where any crate below it has other features: here minutes, twice."""
    package, fmu, tests = (features(each) for each in SELECTIONS.values())
    assert {"serde", "syn", "rayon"} <= {name for name, _ in package}
    assert package == fmu
    assert package - tests == set()
