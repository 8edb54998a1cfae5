"""The stub of the compiled core names what the core has."""

from __future__ import annotations

import ast
from pathlib import Path

import clubface
from clubface import _core


def public(names: object) -> set[str]:
    """Return the names of a module or a class without a leading underscore."""
    return {name for name in dir(names) if not name.startswith("_")}


def test_stub_names_every_function_and_attribute_of_the_core() -> None:
    body = ast.parse(Path(clubface.__file__).with_name("_core.pyi").read_text()).body
    classes = {node.name: node for node in body if isinstance(node, ast.ClassDef)}
    assert classes.keys() | {node.name for node in body if isinstance(node, ast.FunctionDef)} == public(_core)
    for name, node in classes.items():
        attributes = {ast.unparse(each.target) for each in node.body if isinstance(each, ast.AnnAssign)}
        methods = {each.name for each in node.body if isinstance(each, ast.FunctionDef)}
        attributes |= {each for each in methods if not each.startswith("_")}
        assert attributes == public(getattr(_core, name)), name
