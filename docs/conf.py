"""Sphinx configuration: Markdown pages, formulas, and an API reference read from the docstrings."""

import sys
import warnings
from importlib.metadata import version as installed_version
from pathlib import Path

from clubface.errors import RangeWarning

sys.path.insert(0, str(Path(__file__).parent / "_ext"))
warnings.simplefilter("ignore", RangeWarning)  # the pages compare models beyond their ranges, and say so

project = "clubface"
author = "The clubface authors"
copyright = author
version = release = installed_version("clubface")

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx.ext.napoleon",
    "core_tables",
    "errata_tables",
    "findings_tables",
    "flight_tables",
    "findings_tour",
    "notebook_pages",
    "published_tables",
    "validation_tables",
]
exclude_patterns = ["_build"]
html_theme = "furo"
html_title = f"clubface {release}"
html_static_path = ["_static"]
html_css_files = ["clubface.css"]

myst_enable_extensions = ["amsmath", "attrs_block", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 4

autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented_params"
napoleon_google_docstring = False
napoleon_use_ivar = True
napoleon_use_rtype = False


def keep_names_together(app, what, name, obj, options, lines):
    """Let one description serve several attributes: a space in ``:ivar toe, high:`` would make a type of the first."""
    for number, line in enumerate(lines):
        names, found, rest = line.removeprefix(":ivar ").partition(":")
        if line.startswith(":ivar ") and found and ", " in names:
            together = names.replace(", ", ",\N{ZERO WIDTH SPACE}")
            lines[number] = f":ivar {together}:{rest}"


def setup(app):
    """Run after napoleon, which makes the fields."""
    app.connect("autodoc-process-docstring", keep_names_together, priority=900)
