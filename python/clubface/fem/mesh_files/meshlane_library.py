"""Reading of mesh files with meshlane; runs in its own process, see :mod:`clubface.support.processes`."""

from __future__ import annotations

import os
import sys
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from typing import Any

import meshlane


def contents(path: str) -> dict[str, Any]:
    """Return the relevant parts of a mesh, and ``notes``, the reader's messages."""
    printed, notes = StringIO(), StringIO()
    try:
        with redirect_stdout(printed), redirect_stderr(notes):
            mesh = meshlane.read(path)
    except SystemExit:
        # All readers for this file name have failed, and printed their reasons.
        ending = os.path.splitext(path)[1]
        tried = printed.getvalue() or f"it does not contain what files of this name ({ending}) contain"
        sys.exit(tried)
    parts = {name: getattr(mesh, name) for name in ("points", "field_data", "cell_data", "cell_sets")}
    return {**parts, "cells": [(block.type, block.data) for block in mesh.cells], "notes": notes.getvalue()}
