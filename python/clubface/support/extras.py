"""Libraries that come with extras of the package, and what to do where one is missing."""

from __future__ import annotations

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
"""The extra of the package that brings each optional library."""


def missing_extra(error: ModuleNotFoundError) -> str | None:
    """Return which extra brings a library that is not installed; None of one that belongs to none."""
    library = (error.name or "").partition(".")[0]
    if library not in EXTRAS:
        return None
    return f"this needs {library}, which is not installed: pip install 'clubface[{EXTRAS[library]}]'"
