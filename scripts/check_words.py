"""Names that no engineer would look for: each with the reason, and what to write in its place.

``python scripts/check_words.py`` reads the names (functions, parameters, variables, classes) of everything in Python,
tests, pages and examples included, and prints those of the list; the exit status is 1 if there are any.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]
SOURCES = (
    "python/clubface/**/*.py", "scripts/**/*.py", "tests/**/*.py", "docs/**/*.py", "studies/**/*.py",
    "benchmarks/**/*.py", "examples/**/*.py", "paper/**/*.py", "studio/*.py", "studio/tests/**/*.py",
)  # fmt: skip

WORDS = {
    "told": "a participle says nothing of what it holds: write describe_..., words, message",
    "found": "everything that is computed was found: write what it is, or result",
    "said": "write note, message or sentence",
    "say": "write print_note",
    "aside": "write offset, sideways or rejects",
    "beside": "a preposition is no name: write sibling, other or compare_with",
    "hit": "it is no noun for a set-up: write setup",
}
"""Words of names of functions, parameters and variables, whose words are joined by underscores.

Names of tests are sentences, and may have them.
"""
PARAMETERS = {
    "of": "a preposition is no parameter: write the noun it stands for",
    "which": "a pronoun is no parameter: write the noun it stands for",
    "with_": "a preposition is no parameter: write equipment",
}
"""Names of parameters."""


def names_of(tree: ast.AST) -> Iterator[tuple[int, str, bool]]:
    """Yield line and name of everything that a module names, and whether it is a parameter."""
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            yield node.lineno, node.name, False
        elif isinstance(node, ast.arg):
            yield node.lineno, node.arg, True
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            yield node.lineno, node.id, False


def findings(text: str) -> list[tuple[int, str, str]]:
    """Return line, name and reason of every name of a module that is on the list."""
    listed = []
    for line, name, is_parameter in names_of(ast.parse(text)):
        words = [] if name.startswith("test_") else name.lower().split("_")
        reasons = [WORDS[word] for word in words if word in WORDS]
        if is_parameter and name in PARAMETERS:
            reasons.append(PARAMETERS[name])
        listed += [(line, name, reason) for reason in reasons]
    return sorted(listed)


def main() -> int:
    """Print what is on the list; return the exit status."""
    count = 0
    for path in sorted(path for pattern in SOURCES for path in ROOT.glob(pattern)):
        for line, name, reason in findings(path.read_text(encoding="utf-8")):
            print(f"{path.relative_to(ROOT)}:{line}: {name}: {reason}")
            count += 1
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
