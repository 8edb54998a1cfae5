"""What ``import clubface`` costs and offers."""

import ast
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

import pytest

import clubface
from clubface.support.renamed import GONE_WITH


def test_importing_the_package_loads_neither_numpy_nor_anything_slow():
    code = (
        "import sys, clubface; clubface.club('driver'); "
        "print(sorted({'numpy', 'pandas', 'matplotlib', 'rich', 'typer', 'starlette'} & set(sys.modules)))"
    )
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.strip() == "[]"


HEAVY = {
    "numpy", "pandas", "xarray", "scipy", "matplotlib", "pyarrow", "pymoo", "meshlane", "ezc3d", "rich", "typer",
    "starlette", "uvicorn", "websockets",
}  # fmt: skip


def test_a_reduced_model_needs_numpy_alone():
    code = (
        "import sys, clubface; launch = clubface.impact('driver', speed='113 mph');"
        "clubface.fly(launch);"
        f"print(sorted({HEAVY} & set(sys.modules)), 'clubface.fem' in sys.modules)"
    )
    result = subprocess.run([sys.executable, "-W", "ignore", "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.strip() == "['numpy'] False"


def test_no_module_hides_a_public_function_of_its_package():
    """Importing a module sets it as an attribute of its package, in place of a function of that name."""
    root = Path(clubface.__file__).parent
    packages = [path.parent for path in root.rglob("__init__.py")]
    for package in packages:
        name = ".".join(("clubface", *package.relative_to(root).parts))
        modules = {each.stem for each in package.iterdir() if each.is_dir() or each.suffix == ".py"}
        public = re.findall(r"\b(\w+) as \1\b|^def (\w+)", (package / "__init__.py").read_text(), re.MULTILINE)
        for exported in modules & {each for pair in public for each in pair}:
            assert isinstance(getattr(import_module(name), exported), ModuleType), f"{name}.{exported}"
        assert not modules & set(getattr(import_module(name), "_HOME", ())), name


def test_public_names_are_listed():
    assert {"impact", "history", "sensitivity", "fly", "Club", "Ball", "ParameterSet"} <= set(dir(clubface))
    assert not hasattr(clubface, "nonsense")


def test_type_checkers_see_every_public_name_where_it_is_defined():
    tree = ast.parse(Path(clubface.__file__).read_text(encoding="utf-8"))
    [block] = [each for each in tree.body if isinstance(each, ast.If) and ast.unparse(each.test) == "TYPE_CHECKING"]
    seen = {
        alias.asname: each.module.removeprefix("clubface").lstrip(".")
        for each in block.body if isinstance(each, ast.ImportFrom) for alias in each.names
    }  # fmt: skip
    assert seen == {**clubface._HOME, **dict.fromkeys(clubface._MODULES, "")}


@pytest.mark.parametrize(("old", "new"), clubface._MOVED.items())
def test_an_old_name_of_a_module_goes_on_working_and_names_the_new_one(old, new):
    package, _, name = f"clubface.{old}".rpartition(".")
    code = (
        "import warnings\n"
        "with warnings.catch_warnings(record=True) as caught:\n"
        "    warnings.simplefilter('always')\n"
        f"    import clubface.{old}\n"
        f"    from {package} import {name}\n"
        f"import clubface.{new}\n"
        f"assert {name} is clubface.{new} and {name}.__spec__.name == 'clubface.{new}'\n"
        "print([(each.category.__name__, each.filename, str(each.message)) for each in caught])"
    )
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    message = f"clubface.{old} is called clubface.{new} now; version {GONE_WITH} drops the old name"
    warning = ("DeprecationWarning", "<string>", message)
    assert result.stdout.strip() == str([warning])


def test_a_module_in_a_package_that_was_renamed_is_the_same_by_both_names():
    code = (
        "from clubface.launch_monitor.open_connect import Listener; from clubface.shots import open_connect;"
        "from clubface.motion_capture import synthetic; import clubface.capture.synthetic as new;"
        "print(Listener is open_connect.Listener, synthetic is new)"
    )
    result = subprocess.run([sys.executable, "-W", "ignore", "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.strip() == "True True"
