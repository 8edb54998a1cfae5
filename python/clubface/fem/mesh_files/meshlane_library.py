"""What meshlane finds in a mesh file; run in a process of its own, see :mod:`clubface.support.processes`."""

from __future__ import annotations

import os
import sys
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from typing import Any

import meshlane


def contents(path: str) -> dict[str, Any]:
    """Return the parts of a mesh that a head is made of, and ``notes``, what a reader had to say."""
    printed, notes = StringIO(), StringIO()
    try:
        with redirect_stdout(printed), redirect_stderr(notes):
            mesh = meshlane.read(path)
    except SystemExit:
        # All readers for this kind of name have tried, and printed why they gave up.
        ending = os.path.splitext(path)[1]
        tried = printed.getvalue() or f"it does not hold what files of this name ({ending}) hold"
        sys.exit(tried)
    parts = {name: getattr(mesh, name) for name in ("points", "field_data", "cell_data", "cell_sets")}
    return {**parts, "cells": [(block.type, block.data) for block in mesh.cells], "notes": notes.getvalue()}
