"""Sphinx configuration: Markdown pages, formulas, and an API reference read from the docstrings."""

import re
import sys
import warnings
from dataclasses import is_dataclass
from importlib.util import find_spec
from pathlib import Path

from clubface.errors import RangeWarning
from clubface.schema import PhysicalValue, entries
from clubface.support.version import __version__
from clubface.units import SI_UNITS

sys.path[:0] = [str(Path(__file__).parent / "_ext"), str(Path(__file__).parents[1] / "studies")]
warnings.simplefilter("ignore", RangeWarning)  # the pages compare models beyond their ranges, and say so

project = "clubface"
author = "The clubface authors"
copyright = author
version = release = __version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "benchmark_tables",
    "built_pages",
    "core_tables",
    "errata_tables",
    "findings_tables",
    "flight_tables",
    "findings_tour",
    "mathml",
    "notebook_pages",
    "page_figures",
    "pictures",
    "published_tables",
    "site_parts",
    "validation_tables",
    "version_tables",
]
exclude_patterns = ["_build"]
html_theme = "furo"
html_title = f"clubface {release}"
html_math_renderer = "mathml"
html_static_path = ["_static"]
html_css_files = ["clubface.css"]
html_js_files = ["from-files.js"]

myst_enable_extensions = ["amsmath", "attrs_block", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 4

autodoc_member_order = "bysource"
autodoc_mock_imports = [] if find_spec("torch") else ["torch"]  # gigabytes, for the signatures of four functions
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented_params"
napoleon_google_docstring = False
napoleon_use_ivar = True
napoleon_use_rtype = False


def keep_names_together(app, what, name, obj, options, lines):
    """Let one description serve several attributes: a space in ``:ivar toe, high:`` would make a type of the first."""
    for number, line in enumerate(lines):
        names, colon, rest = line.removeprefix(":ivar ").partition(":")
        if line.startswith(":ivar ") and colon and ", " in names:
            together = names.replace(", ", ",\N{ZERO WIDTH SPACE}")
            lines[number] = f":ivar {together}:{rest}"


def describe_fields(app, what, name, obj, options, lines):
    """Describe the fields of a dataclass that is the schema of a file, as they are declared."""
    if what != "class" or not is_dataclass(obj):
        return
    documented = re.findall(r"[\w]+(?=[,:])", " ".join(each for each in lines if each.startswith(":ivar ")))
    for each in entries(obj).values():
        if each.attribute not in documented:
            has_unit = isinstance(each.value, PhysicalValue) and each.unit != "1"
            unit = f" [{SI_UNITS[each.dimension]}]" if has_unit else ""
            meaning = each.meaning.replace("`", "``")
            lines.append(f":ivar {each.attribute}: {meaning[:1].upper()}{meaning[1:]}{unit}.")


def setup(app):
    """Run after napoleon, which makes the fields."""
    app.connect("autodoc-process-docstring", describe_fields, priority=890)
    app.connect("autodoc-process-docstring", keep_names_together, priority=900)
