"""The errors that are planted: one small edit of a source file each, as a slip of the pen would make it."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import NamedTuple

OPERATORS = {
    ast.Add: ("+", "-"), ast.Sub: ("-", "+"), ast.Mult: ("*", "/"), ast.Div: ("/", "*"), ast.FloorDiv: ("//", "*"),
    ast.Mod: ("%", "*"), ast.Pow: ("**", "*"),
    ast.Lt: ("<", "<="), ast.LtE: ("<=", "<"), ast.Gt: (">", ">="), ast.GtE: (">=", ">"), ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="), ast.In: ("in", "not in"), ast.NotIn: ("not in", "in"), ast.Is: ("is", "is not"),
    ast.IsNot: ("is not", "is"), ast.And: ("and", "or"), ast.Or: ("or", "and"),
}  # fmt: skip
"""How each operator is written, and what takes its place."""
UNITS = {
    "mph": "m/s", "deg": "rad", "rpm": "rad/s", "deg/s": "rad/s", "mm": "m", "yd": "m", "ft": "m", "us": "s", "ms": "s",
    "kN": "N", "%": "1", "g": "kg", "MPa": "Pa", "GPa": "Pa", "g cm2": "kg m2", "mm2": "m2", "cm2": "m2", "m/s": "mph",
    "rad": "deg",
}  # fmt: skip
"""A unit, and another one of the same dimension."""


class Mutation(NamedTuple):
    """An edit of a file: the text from ``start`` to ``end`` (characters) becomes ``new``; ``line`` is for people."""

    line: int
    start: int
    end: int
    old: str
    new: str

    def apply(self, source: str) -> str:
        """Return the source with the error in it."""
        return source[: self.start] + self.new + source[self.end :]

    def __str__(self) -> str:
        return f"{self.old or '(nothing)'} -> {self.new or '(nothing)'}"


def mutations(source: str) -> Iterator[Mutation]:
    """Yield every error that can be planted in a source file."""
    starts = [0]
    for line in source.splitlines(keepends=True):
        starts.append(starts[-1] + len(line.encode()))
    octets = source.encode()

    def at(line: int, column: int) -> int:
        return len(octets[: starts[line - 1] + column].decode())

    def edit(line: int, start: int, end: int, new: str) -> Mutation:
        return Mutation(line, start, end, source[start:end], new)

    def between(left: ast.expr, right: ast.expr, operator: ast.AST) -> Iterator[Mutation]:
        old, new = OPERATORS.get(type(operator), ("", ""))
        first = at(left.end_lineno or 0, left.end_col_offset or 0)
        text = source[first : at(right.lineno, right.col_offset)]
        word = r"\b" if old.isalpha() else ""
        if old and (match := re.search(word + re.escape(old).replace(r"\ ", r"\s+") + word, text)):
            yield edit(left.end_lineno or 0, first + match.start(), first + match.end(), new)

    for node in _code(ast.parse(source)):
        match node:
            case ast.Compare(left=left, ops=[operator, *_], comparators=[right, *_]):
                yield from between(left, right, operator)
            case ast.BinOp(left=left, op=operator, right=right) if not (_is_text(left) or _is_text(right)):
                yield from between(left, right, operator)
            case ast.BoolOp(op=operator, values=[left, right, *_]):
                yield from between(left, right, operator)
            case ast.UnaryOp(op=ast.USub() | ast.Not() as operator):
                start = at(node.lineno, node.col_offset)
                yield edit(node.lineno, start, start + (1 if isinstance(operator, ast.USub) else 3), "")
            case ast.If(test=test) | ast.IfExp(test=test):
                start, end = at(test.lineno, test.col_offset), at(test.end_lineno or 0, test.end_col_offset or 0)
                yield edit(test.lineno, start, end, f"not ({source[start:end]})")
            case ast.AugAssign(target=target, op=ast.Add() | ast.Sub(), value=value):
                first = at(target.end_lineno or 0, target.end_col_offset or 0)
                place = source.index("=", first) - 1
                yield edit(value.lineno, place, place + 1, "-" if source[place] == "+" else "+")
            case ast.Constant(value=value) if (new := _other(value)) is not None:
                start, end = at(node.lineno, node.col_offset), at(node.end_lineno or 0, node.end_col_offset or 0)
                yield edit(node.lineno, start, end, new)


def _other(value: object) -> str | None:
    """Return another constant of the same kind."""
    if isinstance(value, bool):
        return repr(not value)
    if isinstance(value, int):
        return repr(value + 1)
    if isinstance(value, float):
        return repr(value * 1.2 if value else 1.0)
    if isinstance(value, str) and value in UNITS:
        return f'"{UNITS[value]}"'
    return None


def _is_text(node: ast.expr) -> bool:
    """Return whether an operand is plainly text or a list, whose sum is no arithmetic."""
    return isinstance(node, ast.JoinedStr | ast.List | ast.Tuple | ast.Dict) or (
        isinstance(node, ast.Constant) and isinstance(node.value, str)
    )


def _code(node: ast.AST) -> Iterator[ast.AST]:
    """Yield the nodes that compute something: no annotations, no text with values in it, nothing for type checkers."""
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "returns", "type_params"):
            continue
        for child in value if isinstance(value, list) else [value]:
            if not isinstance(child, ast.AST) or isinstance(child, ast.JoinedStr):
                continue
            # Statements of what holds, which nothing does otherwise: zip(..., strict=True), and dataclass(eq=False) of
            # values with arrays, which are not compared.
            if isinstance(child, ast.keyword) and child.arg in ("strict", "eq"):
                continue
            if isinstance(child, ast.If) and "TYPE_CHECKING" in ast.dump(child.test):
                continue
            if isinstance(child, ast.FunctionDef) and any(
                "overload" in ast.dump(each) for each in child.decorator_list
            ):
                continue
            yield child
            yield from _code(child)
