"""Deprecated names, which keep working with a warning until the next minor version."""

from __future__ import annotations

import functools
import sys
from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

from clubface.support.checks import warn_once

GONE_WITH = "0.3.0"
"""The version that removes the old names: the next minor one."""

RENAMED = ".* is called .* now; version"
"""Pattern that matches the start of these warnings."""

P = ParamSpec("P")
T = TypeVar("T")


def warn_renamed(old: str, new: str) -> None:
    """Warn once per process that a name has changed."""
    warn_once(f"{old} is called {new} now; version {GONE_WITH} drops the old name", DeprecationWarning)


def renamed_names(module: str, **names: str) -> Callable[[str], Any]:
    """Return a ``__getattr__`` that makes a module's names available under their old names too.

    ::

        if not TYPE_CHECKING:  # otherwise a type checker accepts every misspelt name
            __getattr__ = renamed_names(__name__, Blow="FaceImpact")

    Parameters
    ----------
    module
        Name of the module.
    names
        The new names by the old ones.
    """

    def get(name: str) -> Any:
        if name not in names:
            raise AttributeError(f"module {module!r} has no attribute {name!r}", name=name, obj=sys.modules[module])
        warn_renamed(f"{module}.{name}", names[name])
        return getattr(sys.modules[module], names[name])

    return get


def renamed_arguments(**names: str) -> Callable[[Callable[P, T]], Callable[P, T]]:
    """Let a function accept arguments under their old names: ``@renamed_arguments(which="ball")``.

    Parameters
    ----------
    names
        The new names by the old ones.

    Raises
    ------
    TypeError
        The function is called with both the old and the new name.
    """

    def decorate(function: Callable[P, T]) -> Callable[P, T]:
        @functools.wraps(function)
        def call(*arguments: Any, **options: Any) -> T:
            for old, new in names.items():
                if old in options:
                    if new in options:
                        raise TypeError(f"{function.__name__}() was given '{new}' twice, by its old name '{old}', too")
                    warn_renamed(f"'{old}' of {function.__name__}()", f"'{new}'")
                    options[new] = options.pop(old)
            return function(*arguments, **options)

        return call

    return decorate
