"""Mappings that nobody changes after they were made, and that can be copied and sent to other processes."""

from __future__ import annotations

from typing import NoReturn, TypeVar

K = TypeVar("K")
V = TypeVar("V")


class Frozen(dict[K, V]):
    """A dictionary that refuses to be changed.

    Unlike ``types.MappingProxyType`` it can be pickled and deep-copied, and so can what holds it.
    """

    def _refused(self, *arguments: object, **named: object) -> NoReturn:
        raise TypeError("this mapping cannot be changed; make another with dict(...) and replace()")

    __setitem__ = __delitem__ = __ior__ = clear = pop = popitem = setdefault = update = _refused  # pyright: ignore[reportAssignmentType]

    def __reduce__(self) -> tuple[type[Frozen[K, V]], tuple[dict[K, V]]]:
        return type(self), (dict(self),)
