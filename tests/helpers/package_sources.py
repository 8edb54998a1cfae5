"""The modules of the package as syntax trees, parsed once in a process."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

import clubface

ROOT = Path(clubface.__file__).parent


@cache
def trees() -> dict[str, list[ast.AST]]:
    """Return all nodes of every module, by its path in the package."""
    return {
        path.relative_to(ROOT).as_posix(): list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
        for path in sorted(ROOT.rglob("*.py"))
    }
