"""Checks of single values, with errors that state what is allowed, and other small shared functions.

The latter are immutable mappings, conversion to JSON types, and warnings given once.
"""

from __future__ import annotations

import dataclasses
import math
import sys
import threading
import warnings
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from numbers import Real
from operator import index
from pathlib import Path
from typing import Any, NoReturn, TypeGuard, TypeVar

from clubface.errors import InputError, UnknownNameError


def is_name(value: object) -> bool:
    """Return whether a value is non-empty, printable text."""
    return isinstance(value, str) and value.strip() != "" and value.isprintable()


def is_text(value: object) -> bool:
    """Return whether a value is text that can be written to a file, that is, without lone surrogates."""
    return isinstance(value, str) and not any("\ud800" <= each <= "\udfff" for each in value)


def check_name(name: object) -> None:
    """Raise InputError for a name that is empty, not text, or not printable."""
    if not is_name(name):
        raise InputError("name", name, "printable text, not empty")


def check_text(parameter: str, value: object) -> None:
    """Raise InputError for a value that is not text, or cannot be written to a file."""
    if not is_text(value):
        raise InputError(parameter, value, "text")


def check_choice(parameter: str, value: object, known: Iterable[str]) -> None:
    """Raise UnknownNameError for a value that is not one of the ``known`` words."""
    known = tuple(known)
    if not isinstance(value, str) or value not in known:  # ``in`` is undefined for an array
        raise UnknownNameError(parameter, value, known)


def check_names(what: str, names: Iterable[object], known: Iterable[str]) -> None:
    """Raise UnknownNameError for names that are not ``known``; ``what`` describes a name in the error."""
    known = tuple(known)
    for name in names:
        check_choice(what, name, known)


def is_number(value: object) -> TypeGuard[float]:
    """Return whether a value is a real number; ``True`` and ``False`` are not."""
    return isinstance(value, Real) and not isinstance(value, bool)


def check_share(share: object) -> None:
    """Raise InputError for a value that is not a number between 0 and 1."""
    if not (is_number(share) and 0.0 < share < 1.0):
        raise InputError("share", share, "between 0 and 1")


MOST_SEED = 2**63 - 1
"""Maximum random seed."""


def whole(value: object) -> int | None:
    """Return a whole number of any type, including NumPy's, as an ``int``; None for anything else and for ``True``."""
    if isinstance(value, bool) or getattr(getattr(value, "dtype", None), "kind", "") == "b":  # NumPy 2.0 takes np.True_
        return None
    try:
        return index(value)  # pyright: ignore[reportArgumentType]
    except TypeError:
        return None


def is_count(value: object, least: int, most: int) -> bool:
    """Return whether a value is a whole number within limits."""
    count = whole(value)
    return count is not None and least <= count <= most


def check_count(parameter: str, value: object, least: int, most: int) -> int:
    """Return a whole number within limits; raise InputError for anything else."""
    count = whole(value)
    if count is None or not least <= count <= most:
        raise InputError(parameter, value, f"a whole number from {least} to {most}")
    return count


K = TypeVar("K")
V = TypeVar("V")


class Frozen(dict[K, V]):
    """A dictionary that cannot be changed.

    Unlike ``types.MappingProxyType``, it can be pickled and deep-copied.
    """

    def _refused(self, *arguments: object, **named: object) -> NoReturn:
        raise TypeError("this mapping cannot be changed; make another with dict(...) and replace()")

    __setitem__ = __delitem__ = __ior__ = clear = pop = popitem = setdefault = update = _refused  # pyright: ignore[reportAssignmentType]

    def __reduce__(self) -> tuple[type[Frozen[K, V]], tuple[dict[K, V]]]:
        return type(self), (dict(self),)


def plain(value: Any) -> Any:
    """Return ``value`` as plain JSON types; NumPy numbers and arrays are converted."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, dict) or hasattr(value, "items"):
        return {str(key): plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    return value


_given: dict[str, object] = {}
"""Warnings already issued, with the call that issued them."""
_filters = threading.RLock()
_silent: ContextVar[tuple[type[Warning], ...]] = ContextVar("_silent", default=())


@contextmanager
def without_warnings(category: type[Warning] = Warning) -> Iterator[None]:
    """Suppress warnings of a category; a suppressed warning can still be issued later."""
    token = _silent.set((*_silent.get(), category))
    try:
        yield
    finally:
        _silent.reset(token)


@contextmanager
def without_foreign_warnings(category: type[Warning] = Warning) -> Iterator[None]:
    """Suppress warnings from other packages, one thread at a time.

    Python's filters apply to the whole process: if two blocks overlapped, the filters of the first would remain for
    good.
    """
    with _filters, warnings.catch_warnings():
        warnings.simplefilter("ignore", category)
        yield


def is_silent(category: type[Warning]) -> bool:
    """Return whether warnings of a category are suppressed."""
    return issubclass(category, _silent.get())


def warn_once(message: str, category: type[Warning], *, key: str | None = None) -> None:
    """Issue a warning once per process for each message or ``key``."""
    call = object()
    if not is_silent(category) and _given.setdefault(message if key is None else key, call) is call:
        warnings.warn(message, category, stacklevel=_level_of_the_caller())


def _level_of_the_caller() -> int:
    """Return the stack level, counted from ``warn_once``, of the first code outside the package."""
    inside = (str(Path(__file__).parent.parent), dataclasses.__file__, "<string>")
    frame, level = sys._getframe(2), 2
    while frame.f_back is not None and frame.f_code.co_filename.startswith(inside):
        frame, level = frame.f_back, level + 1
    return level
