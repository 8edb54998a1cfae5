"""Where compiled functions are."""

from __future__ import annotations

import ctypes
from typing import Any


def function_address(function: Any) -> int:
    """Return where a compiled function is, of ctypes or with an ``address`` as a cfunc of Numba; 0 for any other."""
    address = getattr(function, "address", None)
    if isinstance(address, int):
        return address
    if isinstance(function, ctypes._CFuncPtr):  # pyright: ignore[reportPrivateUsage, reportAttributeAccessIssue]
        return ctypes.cast(function, ctypes.c_void_p).value or 0
    return 0
