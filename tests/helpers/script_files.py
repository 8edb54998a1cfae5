"""Python files outside the package and the search path of the tests, as modules."""

import importlib.util
from pathlib import Path

ROOT = Path(__file__).parents[2]


def load_script(path):
    """Return a Python file as a module; its path is from the root of the project, such as "docs/run.py"."""
    file = ROOT / path
    specification = importlib.util.spec_from_file_location(f"{file.parent.name}_{file.stem}", file)
    result = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(result)
    return result
