"""Errors that say how to fix them: with the parameter, its value, what is allowed, and the line.

Every error of the package is a :class:`ClubfaceError`; those about a value are also a ``ValueError``, so that code
unaware of clubface catches them.
"""

from __future__ import annotations

from collections.abc import Iterable

__all__ = [
    "AssumptionWarning", "CaptureWarning", "ClubfaceError", "EdgeWarning", "FileError", "ImplausibleWarning",
    "InputError", "LinkError", "MeshWarning", "RangeWarning", "RuleWarning", "RunError", "ShotError",
    "TargetWarning", "UnitError", "UnknownNameError", "Wording",
]  # fmt: skip


EXTRAS = {
    "matplotlib": "plots",
    "pandas": "tables",
    "xarray": "tables",
    "pyarrow": "tables",
    "openpyxl": "excel",
    "meshlane": "fem",
    "ezc3d": "capture",
    "pymoo": "fit",
    "scipy": "fit",
    "distributed": "cluster",
    "dask": "cluster",
    "starlette": "studio",
    "uvicorn": "studio",
    "websockets": "studio",
    "jax": "jax",
    "torch": "torch",
    "mujoco": "mujoco",
}
"""The extra of the package that installs each optional library."""


class ClubfaceError(Exception):
    """Base class of all errors that clubface raises on purpose.

    Its text is a single line; quoted input is shortened.
    """

    def __str__(self) -> str:
        return in_a_line(self._message())

    def _message(self) -> str:
        """Return the full message."""
        return super().__str__()


_LINE = 100
"""Maximum length of text quoted in a message, from a file, a caller or another program [characters]."""
_LONGEST = 1000
"""Maximum length of a message [characters]; the longest of the package itself are lists of names."""


_ADVICE = ("give ", "leave ", "use ", "keep ")
"""Starts of ``allowed`` texts that are sentences of their own."""


_MOST, _FIRST = 60, 10
"""Maximum number of names listed in full, and number listed if there are more."""


class Wording(str):
    """Text that describes a value in a message, shown without quotation marks."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


class InputError(ClubfaceError, ValueError):
    """A value that cannot be used.

    Attributes
    ----------
    parameter
        Name of the quantity, as the caller wrote it.
    value
        The given value.
    allowed
        What is allowed, as the end of "it must be ..."; or a sentence that starts with "give", "leave", "use" or
        "keep".
    """

    def __init__(self, parameter: str, value: object, allowed: str) -> None:
        super().__init__(parameter, value, allowed)
        self.parameter = parameter
        self.value = value
        self.allowed = allowed

    def _message(self) -> str:
        given = "missing" if self.value is None else _shown(self.value)
        return f"{self.parameter} is {given}; {'' if self.allowed.startswith(_ADVICE) else 'it must be '}{self.allowed}"


class ShotError(InputError):
    """A shot that cannot be computed, or a club or ball that is physically impossible.

    Attributes
    ----------
    parameter
        Name of the input at fault.
    value
        Its value [SI].
    allowed
        The value in practical units and what is allowed.
    row
        Index of the shot in its batch; empty for a single shot.
    others
        Number of further shots of the batch that cannot be computed.
    """

    def __init__(self, parameter: str, value: object, allowed: str, row: tuple[int, ...] = (), others: int = 0) -> None:
        super().__init__(parameter, value, allowed)
        self.args = (parameter, value, allowed, row, others)
        self.row = row
        self.others = others

    def _message(self) -> str:
        place = f"shot {', '.join(map(str, self.row))}: " if self.row else ""
        more = f' (and {self.others} more shots; on_error="nan" computes the rest)' if self.others else ""
        return f"{place}{self.parameter}: {self.allowed}{more}"


class UnitError(InputError):
    """A unit that is unknown or has another dimension."""


class UnknownNameError(InputError, KeyError):
    """A name of a club, ball, model, parameter or key that does not exist; the nearest names are suggested.

    Attributes
    ----------
    known
        The existing names.
    nearest
        Names that resemble the given one, best first.
    """

    def __init__(self, parameter: str, value: object, known: Iterable[str]) -> None:
        self.known = tuple(known)
        self.nearest = nearest_names(str(value), self.known)
        super().__init__(parameter, value, "one of " + _listed(self.known) if self.known else "left out")

    def _message(self) -> str:
        hint = f" (did you mean {' or '.join(self.nearest)}?)" if self.nearest else ""
        return f"unknown {self.parameter} {_shown(self.value)}{hint}; it must be {self.allowed}"


class FileError(ClubfaceError, ValueError):
    """A file that cannot be read or that holds something unusable.

    Attributes
    ----------
    path
        The file.
    line
        The line, counted from 1, or None if unknown.
    message
        What is wrong there.
    parameter
        The key at fault, or None.
    """

    def __init__(self, path: str, line: int | None, message: str, parameter: str | None = None) -> None:
        super().__init__(path, line, message, parameter)
        self.path = path
        self.line = line
        self.message = message
        self.parameter = parameter

    def _message(self) -> str:
        place = self.path if self.line is None else f"{self.path}:{self.line}"
        return f"{place}: {self.message}"


class LinkError(ClubfaceError, ConnectionError):
    """A connection to another program that cannot be made, is lost, or gives no answer.

    Attributes
    ----------
    address
        Host and port.
    message
        What is wrong.
    """

    def __init__(self, address: str, message: str) -> None:
        super().__init__(address, message)
        self.address = address
        self.message = message

    def _message(self) -> str:
        return f"{self.address} {self.message}"


class RunError(ClubfaceError, RuntimeError):
    """A run that ended early.

    A finite element run, whose results up to that point are kept, or a user-defined contact law that failed.
    """


class RuleWarning(UserWarning):
    """A club or ball does not conform to the Rules of Golf; it is computed anyway."""


class RangeWarning(UserWarning):
    """A shot is outside the range of a model or its parameters; it is computed anyway."""


class AssumptionWarning(UserWarning):
    """A required quantity was not given and cannot be derived; the warning says which value was assumed."""


class ImplausibleWarning(UserWarning):
    """A value that no real club has, usually for lack of a unit (``mass = 204`` means 204 kg)."""


class TargetWarning(UserWarning):
    """A meshed head that misses its targets; it is as close as its bounds allow."""


class MeshWarning(UserWarning):
    """Something in a mesh was changed or left out to make a head of it."""


class EdgeWarning(UserWarning):
    """The ball reached the edge of a meshed face, where contact ends; its launch is uncertain."""


class CaptureWarning(UserWarning):
    """Something in a recorded swing was repaired or is doubtful; its delivery is given anyway."""


def _listed(names: tuple[str, ...]) -> str:
    """Return names separated by commas, only the first ones if there are many."""
    return ", ".join(names) if len(names) <= _MOST else f"{', '.join(names[:_FIRST])}, ... ({len(names)} in all)"


def nearest_names(name: str, known: Iterable[str]) -> tuple[str, ...]:
    """Return up to three of the ``known`` names that resemble ``name``, best first, in any letter case."""
    from difflib import get_close_matches

    spelled: dict[str, str] = {}
    for candidate in known:
        spelled.setdefault(candidate.lower(), candidate)
    return tuple(spelled[match] for match in get_close_matches(name[:80].lower(), spelled, 3, 0.5))


def in_a_line(text: str) -> str:
    """Return a message on one line: quoted text and long words shortened, and :func:`legible`."""
    if text.isprintable() and len(text) <= _LINE:
        return text
    import re

    # A quotation mark has no letter on its outer side, unlike an apostrophe.
    long = rf"(?<!\w)'(?:[^'\\]|\\.){{{_LINE},}}'(?!\w)|(?<!\w)\"(?:[^\"\\]|\\.){{{_LINE},}}\"(?!\w)|\S{{{2 * _LINE},}}"
    text = re.sub(long, lambda result: shortened(result[0], _LINE), text, flags=re.DOTALL)
    text = shortened(text, _LONGEST)
    return legible(text)


def legible(text: str, keep: str = "") -> str:
    """Escape invisible characters of a text; all text for a screen, a page or a table passes through here.

    Escapes control characters, characters that change the text direction or have no width, and bytes of names that are
    not text; ``keep`` are characters to keep, such as line breaks.
    """
    plain = text
    for each in keep:
        plain = plain.replace(each, "")
    if plain.isprintable():
        return text
    return "".join(each if each.isprintable() or each in keep or each in _SPACES else _escape(each) for each in text)


LINES = "\n\r\t"
"""Characters that separate lines and columns."""
_SPACES = "\u00a0\u1680\u2000\u2001\u2002\u2003\u2004\u2005\u2006\u2007\u2008\u2009\u200a\u202f\u205f\u3000"
"""Spaces of other widths, as between thousands, which look like a gap."""


def _escape(character: str) -> str:
    if "\udc80" <= character <= "\udcff":  # a byte of a name that is not UTF-8, as Python represents it
        return f"\\x{ord(character) - 0xDC00:02x}"
    if character in "\n\r\t":
        return repr(character)[1:-1]
    return f"\\u{ord(character):04x}" if character <= "\uffff" else f"\\U{ord(character):08x}"


def shortened(text: str, most: int) -> str:
    """Shorten a text of more than ``most`` characters to its start and end, with the number of characters omitted."""
    if len(text) <= most:
        return text
    end = most // 4
    return f"{text[: most - end - 5]} ... {text[-end:]}"


def _shown(value: object) -> str:
    """Return ``repr`` of a value on one line, shortened if necessary."""
    try:
        text = repr(value)
    except Exception:
        text = f"a {type(value).__name__}"
    first, *more = text.splitlines() or [""]
    return first if len(first) <= 80 and not more else first[:77] + "..."


def missing_extra(error: ModuleNotFoundError) -> str | None:
    """Return the extra that installs a missing library, or None if there is none."""
    library = (error.name or "").partition(".")[0]
    if library not in EXTRAS:
        return None
    return f"this needs {library}, which is not installed: pip install 'clubface[{EXTRAS[library]}]'"
