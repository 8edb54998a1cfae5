"""The location of a value: its file and line, if it has one, and its name in messages."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from clubface.errors import ClubfaceError, FileError, InputError, UnknownNameError
from clubface.schema.document import Document

__all__ = ["Place"]


@dataclass(repr=False, eq=False)
class Place:
    """The location of a value in a file, a mapping or an object.

    Attributes
    ----------
    document
        The file, or None.
    path
        Keys and indices that lead to the value.
    name
        What messages call it, such as "shape.loft".
    label
        What the table is called that holds the value, such as "trim toe"; a key of it is then "x of trim toe".
    """

    document: Document | None = None
    path: tuple[str | int, ...] = ()
    name: str = ""
    label: str = ""

    @property
    def folder(self) -> Path | None:
        """The folder of the file, from which relative paths start."""
        return None if self.document is None else Path(self.document.path).parent

    @property
    def title(self) -> str:
        """The name of the value or its table in messages, including the label."""
        return f"{self.name} of {self.label}" if self.name and self.label else self.name or self.label

    def key(self, key: str) -> Place:
        """Return the location of a key of this table."""
        name = f"{self.name}.{key}" if self.name else key
        return replace(self, path=(*self.path, key), name=name)

    def item(self, index: int, label: str = "") -> Place:
        """Return the location of an item of this list; a table may have a label."""
        path = (*self.path, index)
        if label or self.document is not None:
            return Place(self.document, path, label=label)
        return replace(self, path=path, name=f"{self.name}[{index}]")

    def invalid(self, value: Any, allowed: str) -> InputError:
        """Return the error for a value that cannot be used."""
        return InputError(self.title, value, allowed)

    def check_keys(self, given: Iterable[str], known: Iterable[str], required: Iterable[str]) -> None:
        """Refuse unknown keys, naming the nearest known one, and list missing required keys."""
        given = dict.fromkeys(given)
        known = tuple(known)
        for key in given:
            if key not in known:
                within = f" of {self.title}" if self.document is None and self.title else ""
                with self.key(key).errors():
                    raise UnknownNameError(f"key{within}", key, known)
        self.require_keys(given, required)

    def require_keys(self, given: Iterable[str], required: Iterable[str]) -> None:
        """Refuse a table that lacks required keys, and list them."""
        given = set(given)
        missing = [key for key in required if key not in given]
        if not missing:
            return
        if self.document is None:
            raise InputError(self.key(missing[0]).title, None, "give it")
        section = ".".join(part for part in self.path if isinstance(part, str))
        inside = f" of [{section}]" if section else ""
        line = self.document.line_of(self.path)
        raise FileError(self.document.path, line, f"these keys{inside} are missing: {', '.join(missing)}")

    @contextmanager
    def errors(self) -> Iterator[None]:
        """Add file and line to errors raised within the block."""
        try:
            yield
        except FileError as error:
            if self.document is None or error.line is not None or error.path == self.document.path:
                raise
            raise self.wrap(error) from error
        except ClubfaceError as error:
            if self.document is None:
                raise
            raise self.wrap(error) from error

    def wrap(self, error: ClubfaceError) -> FileError:
        """Return an error with file and line of the value it is about, if that is here or below."""
        assert self.document is not None
        if self.label and isinstance(error, InputError) and not isinstance(error, UnknownNameError):
            error.parameter += f" of {self.label}" * (" of " not in error.parameter)
        parameter = getattr(error, "parameter", None) or self.title
        names = [re.split(r" of |\[", parameter)[0]]
        names += [names[0].rpartition(".")[0]] * ("." in names[0])
        names += [parameter.rpartition(" ")[2]] * (" " in parameter)
        if isinstance(error, UnknownNameError) and isinstance(error.value, str):
            names.append(error.value)  # the name that is unknown may be a key itself
        at = self.document.line_of(self.path)
        lines = (self.document.line_like(name, self.path) for name in names)
        line = next((each for each in lines if each != at), at)
        return FileError(self.document.path, line, str(error), parameter or None)
