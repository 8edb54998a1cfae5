"""Damage to a file, the same for the same random numbers: bytes, lines, cells, numbers, depth and length."""

from __future__ import annotations

import re
from random import Random

NUMBERS = (
    b"nan", b"inf", b"-inf", b"1e309", b"-1e308", b"1e-320", b"0", b"-0", b"-1", b"2147483648", b"-21474836480",
    b"9" * 30, b"9" * 5000, b"0x" + b"f" * 40, b"1_0", b"1,5", b"1.5.2", b"1e", b"", b"true", b'"x"', b"[]", b"{}",
    "²".encode(), "٣".encode(), "−5".encode(),
)  # fmt: skip
PIECES = (
    b"\0", b"\r", b"\r\n", b"\n\n\n", b"\t", b'"', b"'", b'"""', b"'''", b"\\", b"[", b"]", b"[[", b"{", b"}", b"=",
    b"#", b",", b";", b",,,,", b"\xff", b"\xef\xbb\xbf", b"\xff\xfe", b"\x1b[31m", "µ".encode(), b"\xed\xa0\x80",
    b"PAR1",    b"sep=;\n", b".", b"..", b"a.b.c", b"inf", b"%", b" deg", b" mph",
)  # fmt: skip
_NUMBER = re.compile(rb"-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
LONGEST = 400_000
"""Bytes to which a file may grow."""


def mutated(seed: bytes, other: bytes, random: Random) -> bytes:
    """Return a file with one to four kinds of damage, some of it taken from another one."""
    data = seed
    for _ in range(random.choice((1, 1, 2, 2, 3, 4))):
        data = random.choice(_MUTATIONS)(data, other, random)
    return data[:LONGEST]


def _span(data: bytes, random: Random) -> tuple[int, int]:
    start = random.randrange(len(data) + 1)
    return start, min(len(data), start + random.choice((1, 1, 2, 4, 8, 64, 512)))


def _flip(data: bytes, other: bytes, random: Random) -> bytes:
    if not data:
        return data
    place = random.randrange(len(data))
    value = random.choice((data[place] ^ (1 << random.randrange(8)), 0, 1, 127, 128, 255, random.randrange(256)))
    return data[:place] + bytes([value]) + data[place + 1 :]


def _cut(data: bytes, other: bytes, random: Random) -> bytes:
    start, end = _span(data, random)
    return data[:start] + data[end:]


def _truncate(data: bytes, other: bytes, random: Random) -> bytes:
    return data[: random.randrange(len(data) + 1)]


def _insert(data: bytes, other: bytes, random: Random) -> bytes:
    place = random.randrange(len(data) + 1)
    return data[:place] + random.choice(PIECES) + data[place:]


def _repeat(data: bytes, other: bytes, random: Random) -> bytes:
    start, end = _span(data, random)
    return data[:start] + data[start:end] * random.choice((2, 3, 50, 3000)) + data[end:]


def _splice(data: bytes, other: bytes, random: Random) -> bytes:
    start, end = _span(other, random)
    place, after = _span(data, random)
    return data[:place] + other[start:end] + data[random.choice((place, after)) :]


def _number(data: bytes, other: bytes, random: Random) -> bytes:
    result = list(_NUMBER.finditer(data))
    if not result:
        return _flip(data, other, random)
    where = random.choice(result)
    return data[: where.start()] + random.choice(NUMBERS) + data[where.end() :]


def _line(data: bytes, other: bytes, random: Random) -> bytes:
    lines = data.split(b"\n")
    place = random.randrange(len(lines))
    change = random.randrange(4)
    if change == 0:
        del lines[place]
    elif change == 1:
        lines.insert(random.randrange(len(lines) + 1), lines[place])
    elif change == 2:
        lines[place] = lines[random.randrange(len(lines))]
    else:
        lines[place] = random.choice(other.split(b"\n"))
    return b"\n".join(lines)


def _cell(data: bytes, other: bytes, random: Random) -> bytes:
    lines = data.split(b"\n")
    place = random.randrange(len(lines))
    cells = re.split(rb"([,;\t= ])", lines[place])
    cells[random.randrange(len(cells))] = random.choice((*NUMBERS, *PIECES))
    lines[place] = b"".join(cells)
    return b"\n".join(lines)


def _deep(data: bytes, other: bytes, random: Random) -> bytes:
    place = random.randrange(len(data) + 1)
    times = random.choice((5, 20, 2000, 40_000))
    return (
        data[:place]
        + random.choice((b"[", b'{"a":', b"{a=", b"a.", b"[a.", b"(", b",", b'"a".')) * times
        + data[place:]
    )


_MUTATIONS = (
    _flip,
    _flip,
    _flip,
    _cut,
    _truncate,
    _insert,
    _insert,
    _repeat,
    _splice,
    _number,
    _number,
    _line,
    _cell,
    _cell,
    _deep,
)
