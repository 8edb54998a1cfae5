"""Conditions that select shots: ``smash > 1.3 and club == '7i'``, ``abs(face - path) < 2 deg``.

A condition uses Python's grammar, restricted to comparisons, ``and``, ``or``, ``not``, ``in``, the four arithmetic
operations and ``abs``; it is never executed as code. A number may be followed by a unit. If a value that decides the
condition was not measured, the shot matches neither the condition nor its negation.
"""

from __future__ import annotations

import ast
import operator
import re
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface.errors import InputError, UnknownNameError
from clubface.results.notes import note
from clubface.shots.club_names import same_club, same_text
from clubface.shots.recorded import RecordedShots
from clubface.shots.tables.headings import HAND, shot_words, unit_symbol
from clubface.units import DIMENSIONLESS, from_si, symbols, to_si, unit

LONGEST = 1000
"""Maximum number of characters in a condition."""
EXAMPLE = 'as in "smash > 1.3 and club == \'7i\'" or "ball_speed > 150 mph"'
CLUB, PLAYER, ROW, SMASH = "club", "player", "row", "smash"

_QUOTED = re.compile(r"""('[^']*'|"[^"]*")""")
_WITH_UNIT = re.compile(
    r"(?<![\w.])(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(?!in\s*[\[(])"
    r"(?P<unit>[^\W\d_]+(?:/[^\W\d_]+)?|°(?:/s)?|%)(?![\w/])"
)
_UNIT_NAME = "value_with_unit_{}"
_COMPARED: Mapping[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge, ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
}  # fmt: skip
_OPPOSITES = (ast.NotEq, ast.NotIn)


class Match(NamedTuple):
    """The shots that match a condition."""

    mask: NDArray[np.bool_]  # shots for which it is true
    undecided: int  # number of shots it cannot decide, because something was not measured


class _Number(NamedTuple):
    """Numbers of one dimension [SI], or pure numbers (None); NaN means not measured."""

    values: Any
    dimension: str | None = None
    shown: str = ""


class _Text(NamedTuple):
    """The texts of a column with the comparison ``same``, or a single typed text without ``same``."""

    values: Any
    same: Callable[[str, str], bool] | None = None


class _Truth(NamedTuple):
    """Shots for which something is true, and shots for which it is false; for all others it is unknown."""

    true: Any
    false: Any


def match_shots(shots: RecordedShots, condition: str) -> Match:
    """Return which shots match a condition.

    Parameters
    ----------
    condition
        Quantities of a delivery or launch by the names of :class:`RecordedShots` or as headings with a unit
        (``ball_speed_mph``, a number in that unit), ``club``, ``player``, ``hand`` and ``row``; numbers with units;
        texts in quotation marks. Clubs match under any common name: ``'7i'`` is "7 Iron" too.

    Raises
    ------
    InputError
        The condition is invalid, or compares values that cannot be compared.
    UnknownNameError
        A name is not a quantity, or was not measured.
    """
    if len(condition) > LONGEST:
        raise InputError("where", condition[:40] + "...", f"a condition of at most {LONGEST} characters")
    given: dict[str, _Number] = {}
    text = "".join(
        part if place % 2 else _WITH_UNIT.sub(lambda match: _named(match, given), part)
        for place, part in enumerate(_QUOTED.split(condition))
    )
    reader = _Reader(shots, condition, given)
    try:
        result = reader.value(ast.parse(text.strip(), mode="eval").body)
    except (SyntaxError, ValueError, RecursionError, MemoryError) as error:
        if isinstance(error, InputError):
            raise
        raise InputError("where", condition, f"a condition on the shots, {EXAMPLE}") from None
    if not isinstance(result, _Truth):
        raise InputError("where", condition, f"a condition that is true or false, {EXAMPLE}")
    true, false = (np.broadcast_to(each, len(shots)) for each in result)
    return Match(true, int((~(true | false)).sum()))


def matching_shots(shots: RecordedShots, condition: str) -> tuple[RecordedShots, NDArray[np.intp]]:
    """Return the shots that match a condition, with a note, and their places; raise an error if there are none."""
    mask, undecided = match_shots(shots, condition)
    if not mask.any():
        remark = f"; {undecided} lack a measurement it needs" if undecided else ""
        raise InputError("where", condition, f"a condition that some of the {len(shots)} shots meet{remark}")
    notes = [note("condition-fulfilled", fulfil=int(mask.sum()), shots=len(shots), condition=condition)]
    if undecided:
        notes.append(note("condition-undecided", undecided=undecided, shots=len(shots), condition=condition))
    return shots.select(mask).with_notes(*notes), np.flatnonzero(mask)


def _named(match: re.Match[str], given: dict[str, _Number]) -> str:
    """Replace a number with a unit by a name, and store its value under that name."""
    symbol = unit_symbol(match["unit"])
    if symbol is None:
        return match[0]
    name = _UNIT_NAME.format(len(given))
    value, dimension = to_si(float(match["number"]), symbol), unit(symbol).dimension
    given[name] = _Number(value, None if dimension == DIMENSIONLESS else dimension, match[0])
    return name


class _Reader:
    """Evaluates the tree of a condition."""

    def __init__(self, shots: RecordedShots, condition: str, given: Mapping[str, _Number]) -> None:
        self._shots = shots
        self._condition = condition
        self._given = given
        self._measured = shots.deliveries | shots.launches
        if SMASH not in self._measured and {"speed", "ball_speed"} <= set(self._measured):
            self._measured[SMASH] = self._measured["ball_speed"] / self._measured["speed"]

    def value(self, node: ast.expr) -> _Number | _Text | _Truth:
        """Return the value of a part of the condition."""
        match node:
            case ast.BoolOp():
                return self._joined(node.op, [self._truth(each) for each in node.values])
            case ast.UnaryOp(op=ast.Not()):
                return _Truth(*self._truth(node.operand)[::-1])
            case ast.UnaryOp(op=ast.USub() | ast.UAdd()):
                number = self._number(node.operand)
                return number._replace(values=-number.values) if isinstance(node.op, ast.USub) else number
            case ast.BinOp():
                return self._calculated(node.op, self._number(node.left), self._number(node.right))
            case ast.Compare():
                sides = [node.left, *node.comparators]
                pairs = zip(node.ops, sides[:-1], sides[1:], strict=True)
                return self._joined(ast.And(), [self._pair(*each) for each in pairs])
            case ast.Call(func=ast.Name(id="abs"), args=[only], keywords=[]):
                number = self._number(only)
                return number._replace(values=np.abs(number.values))
            case ast.Constant(value=bool() | None):
                raise self._error(f"{node.value} is not a value of a shot; compare with a number or a text")
            case ast.Constant(value=int() | float() as number):
                return _Number(float(number), None, str(number))
            case ast.Constant(value=str() as text):
                return _Text(text)
            case ast.Name():
                return self._name(node.id)
            case _:
                raise self._error("only comparisons, and, or, not, in, + - * / and abs() are known")

    def _error(self, what: str) -> InputError:
        return InputError("where", self._condition, f"a condition on the shots, {EXAMPLE} ({what})")

    def _number(self, node: ast.expr) -> _Number:
        if isinstance(result := self.value(node), _Number):
            return result
        raise self._error(f"{ast.unparse(node)} is not a number")

    def _truth(self, node: ast.expr) -> _Truth:
        if isinstance(result := self.value(node), _Truth):
            return result
        raise self._error(f"{ast.unparse(node)} is neither true nor false; compare it with something")

    @staticmethod
    def _joined(how: ast.boolop, parts: list[_Truth]) -> _Truth:
        every, some = np.logical_and.reduce, np.logical_or.reduce
        if isinstance(how, ast.Or):
            every, some = some, every
        count = np.broadcast_arrays(*[each for part in parts for each in part])
        return _Truth(every(count[::2]), some(count[1::2]))

    def _calculated(self, how: ast.operator, left: _Number, right: _Number) -> _Number:
        shown = f"{left.shown} and {right.shown}"
        with np.errstate(divide="ignore", invalid="ignore"):
            match how:
                case ast.Add() | ast.Sub():
                    dimension = self._common(left, right)
                    sign = 1.0 if isinstance(how, ast.Add) else -1.0
                    return _Number(left.values + sign * right.values, dimension, shown)
                case ast.Mult() if None in (left.dimension, right.dimension):
                    return _Number(left.values * right.values, left.dimension or right.dimension, shown)
                case ast.Div() if right.dimension in (None, left.dimension):
                    values = np.asarray(left.values) / np.asarray(right.values)
                    return _Number(values, left.dimension if right.dimension is None else None, shown)
        raise self._error(f"{shown} cannot be combined this way")

    def _common(self, left: _Number, right: _Number) -> str | None:
        """Return the common dimension of two numbers; 0 has any unit."""
        if left.dimension == right.dimension or (np.ndim(right.values) == 0 and right.values == 0.0):
            return left.dimension
        if np.ndim(left.values) == 0 and left.values == 0.0:
            return right.dimension
        if None in (left.dimension, right.dimension):
            needs, bare = (left, right) if right.dimension is None else (right, left)
            remark = f"{bare.shown} needs a unit" if np.ndim(bare.values) == 0 else f"{bare.shown} is a pure number"
            units = " or ".join(symbols(needs.dimension)[:3])
            raise self._error(f"{remark}: {needs.shown} is in {units}")
        raise self._error(f"{left.shown} and {right.shown} are of different kinds: {left.dimension}, {right.dimension}")

    def _pair(self, how: ast.cmpop, left: ast.expr, right: ast.expr) -> _Truth:
        if isinstance(how, (ast.In, ast.NotIn)):
            if not (isinstance(right, (ast.Tuple, ast.List)) and right.elts):
                raise self._error("in needs a list, as in club in ('7i', '8i')")
            any_of = self._joined(ast.Or(), [self._pair(ast.Eq(), left, each) for each in right.elts])
        elif type(how) not in _COMPARED:
            raise self._error("compare with <, <=, >, >=, ==, != or in")
        else:
            first, second = self.value(left), self.value(right)
            if isinstance(first, _Text) and isinstance(second, _Text):
                any_of = self._same(how, first, second)
            elif isinstance(first, _Number) and isinstance(second, _Number):
                self._common(first, second)
                known = ~(np.isnan(first.values) | np.isnan(second.values))
                holds = _COMPARED[type(how)](first.values, second.values)
                return _Truth(known & holds, known & ~np.asarray(holds))
            else:
                raise self._error(f"{ast.unparse(left)} and {ast.unparse(right)} cannot be compared")
        return _Truth(*any_of[::-1]) if isinstance(how, _OPPOSITES) else any_of

    def _same(self, how: ast.cmpop, first: _Text, second: _Text) -> _Truth:
        column, typed = (first, second) if first.same else (second, first)
        if column.same is None or typed.same is not None or not isinstance(how, (ast.Eq, ast.NotEq)):
            raise self._error("compare a name with text in quotation marks, by == or !=")
        equal = {each: column.same(each, typed.values) for each in dict.fromkeys(column.values)}
        true = np.array([equal[each] for each in column.values], dtype=bool)
        return _Truth(true, (np.array(column.values, dtype=object) != "") & ~true)

    def _name(self, name: str) -> _Number | _Text:
        if name in self._given:
            return self._given[name]
        texts = {CLUB: self._shots.clubs, PLAYER: self._shots.players, HAND: self._shots.hand}
        if name in texts:
            column = texts[name]
            if column is None:
                raise self._error(f"the shots of {self._shots.source} have no {name}")
            return _Text([str(each) for each in column], same_club if name == CLUB else same_text)
        if name == ROW:
            return _Number(self._shots.rows.astype(float), None, name)
        words = shot_words()
        quantity, symbol = words.quantity(name), words.headings.parts(name).unit
        if quantity is None or quantity not in self._measured:
            raise UnknownNameError("name in where", name, (*self._measured, *texts, ROW))
        values, dimension = self._measured[quantity], words.dimensions[quantity]
        if symbol is not None:
            unit(symbol, name=name, dimension=dimension)
            return _Number(from_si(values, symbol), None, name)
        return _Number(values, None if dimension == DIMENSIONLESS else dimension, name)
