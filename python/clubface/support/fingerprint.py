"""Fingerprints of content, by which a store recognises the computation its parts belong to."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from itertools import zip_longest
from pathlib import Path, PurePath
from typing import Any

from clubface.errors import FileError, shortened
from clubface.schema import Document
from clubface.support.version import __version__


def fingerprint(content: Any) -> str:
    """Return a fingerprint of content made of JSON types, arrays, dataclasses and the like."""
    return hashlib.sha256(json.dumps(_as_json(content), sort_keys=True).encode()).hexdigest()


def _as_json(value: Any) -> Any:
    """Return content as JSON types; all numbers of an array count, not only those that its text shows."""
    if value is None or isinstance(value, (str, int, float)):
        return value
    if isinstance(value, Mapping):
        plain = {key: _as_json(each) for key, each in value.items()}
        return plain if all(isinstance(key, str) for key in plain) else sorted((repr(key), plain[key]) for key in plain)
    if isinstance(value, (set, frozenset)):
        value = sorted(value)
    if isinstance(value, (list, tuple)):
        return [_as_json(each) for each in value]
    if is_dataclass(value):
        return [type(value).__name__, *([each.name, _as_json(getattr(value, each.name))] for each in fields(value))]
    if isinstance(value, Document):
        return _as_json(value.data)
    if isinstance(value, (PurePath, Enum)):
        return str(value)
    import numpy as np

    if isinstance(value, np.ndarray) and value.dtype != object:
        return [str(value.dtype), value.shape, hashlib.sha256(np.ascontiguousarray(value).tobytes()).hexdigest()]
    if isinstance(value, (np.ndarray, np.generic)):
        return _as_json(value.tolist())
    raise TypeError(f"a {type(value).__name__} has no fingerprint")


def fingerprints(content: Mapping[str, Any]) -> dict[str, str]:
    """Return a fingerprint of each input of a computation and of the version, by its name for people."""
    return {name: fingerprint(each) for name, each in {**content, "version": __version__}.items()}


def check_same(
    folder: Path,
    now: Mapping[str, str],
    begun: Mapping[str, str],
    otherwise: str,
    change: Callable[[str], str] = lambda _: "",
) -> None:
    """Refuse to resume work in ``folder`` that was started with other content; both are from :func:`fingerprints`.

    ``change`` says what is different in a part, by its name.
    """
    if other := [f"{name}{change(name)}" for name in {**now, **begun} if now.get(name) != begun.get(name)]:
        what = f"with another {', another '.join(other)}" if begun else "as other work, whose record is damaged"
        raise FileError(str(folder), None, f"this was begun {what}; {otherwise}")


def first_difference(before: bytes | None, now: bytes | None) -> str:
    """Return, in brackets, the first line of a text that has changed; empty if unknown."""
    try:
        both = [[] if each is None else each.decode().splitlines() for each in (before, now)]
    except UnicodeDecodeError:
        return ""
    for number, (one, other) in enumerate(zip_longest(*both, fillvalue=""), 1):
        if one != other and before is not None and now is not None:
            shown = [shortened(each.strip(), 60) or "empty" for each in (one, other)]
            return f" (line {number} was {shown[0]} and is {shown[1]})"
    return ""
