"""The rooms of the package stand one above the other: no import runs upward, no files import each other in a loop."""

import ast
from functools import cache
from pathlib import Path

import pytest

import clubface
from arrows import circle, upward

ROOT = Path(clubface.__file__).parent

FLOORS = (
    ("errors", "support", "units", "quantities", "schema"),
    ("jobs", "results", "present"),
    ("published_data", "equipment", "simulation"),
    ("shots",),
    ("fem", "validation"),
    ("inference", "capture"),
    ("design", "studies", "plots", "jax", "torch", "export", "chain"),
    ("studio",),
    ("cli", "__main__"),
    ("clubface",),
)
"""From the ground up. Those that share a floor may import each other as long as no files do so in a loop.

The package itself, which names what is public in all of them, stands above.
"""

CORE = "clubface._core"
"""What is compiled."""


def sources():
    """The text of every module, by its name."""
    result = {}
    for path in sorted(ROOT.rglob("*.py")):
        parts = ("clubface", *path.relative_to(ROOT).with_suffix("").parts)
        result[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path.read_text()
    return result


@cache
def statements(text):
    """The imports in the text of a module, each with whether it stands in a function."""
    tree = ast.parse(text)
    functions = [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)]
    deferred = {node for each in functions for node in ast.walk(each)}
    return [(node, node in deferred) for node in ast.walk(tree) if isinstance(node, ast.Import | ast.ImportFrom)]


def imports(texts, *, views=True):
    """The modules each module imports: at its top, inside functions, and for types alone.

    Without ``views`` those are left out by which a method returns how its object is shown: a result, from the module
    ``*_result`` that imports the class, or text, from ``present``. They alone may close a loop.
    """
    result = {}
    for name, text in texts.items():
        imported = set()
        for node, deferred in statements(text):
            modules = {each.name for each in node.names}
            if isinstance(node, ast.ImportFrom):
                assert not node.level, f"{name} imports relatively"
                whole = {f"{node.module}.{each}" for each in modules}
                modules = {each if each in (*texts, CORE) else node.module for each in whole}
            if deferred and not views:
                modules = {each for each in modules if not (each.endswith("_result") or room(each) == "present")}
            imported |= modules
        result[name] = {each for each in imported if each.split(".")[0] == "clubface" and each != name}
    return result


def room(name):
    return name.split(".")[1] if "." in name else "clubface"


def floor(name):
    return next(number for number, rooms in enumerate(FLOORS) if room(name) in rooms) if name != CORE else -1


def test_every_room_has_its_floor():
    assert sorted({room(name) for name in sources()}) == sorted(each for rooms in FLOORS for each in rooms)


def test_no_import_runs_upward():
    assert upward(imports(sources()), floor) == []


def test_no_files_import_each_other_in_a_loop():
    assert circle(imports(sources(), views=False)) == []


def test_the_core_is_called_from_few_rooms():
    users = {room(name) for name, imported in imports(sources()).items() if CORE in imported}
    assert users == {"design", "equipment", "fem", "inference", "present", "quantities", "simulation", "units"}


@pytest.mark.parametrize(
    ("name", "line", "imported"),
    [
        ("clubface.units", "from clubface.cli import app", "clubface.cli.app"),
        (
            "clubface.fem.core",
            "def later():\n    import clubface.inference.prior",
            "clubface.inference.prior",
        ),
        ("clubface.errors", "from clubface import impact", "clubface"),
    ],
)
def test_an_import_that_runs_upward_is_seen_wherever_it_stands(name, line, imported):
    texts = sources()
    texts[name] += f"\n{line}\n"
    assert upward(imports(texts), floor) == [(name, imported)]


@pytest.mark.parametrize(
    ("name", "line", "imported"),
    [
        ("clubface.fem.settings", "def later():\n    from clubface.fem import result", "clubface.fem.result"),
        ("clubface.fem.result", "from clubface.fem.impact_result import impact_result", "clubface.fem.impact_result"),
        ("clubface.results.table", "from clubface.present import terminal", "clubface.present.terminal"),
    ],
)
def test_a_loop_of_files_is_seen(name, line, imported):
    texts = sources()
    texts[name] += f"\n{line}\n"
    assert {name, imported} <= set(circle(imports(texts, views=False)))
