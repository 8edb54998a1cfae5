"""What ``import clubface`` costs and offers."""

import subprocess
import sys
import types

import clubface


def test_importing_the_package_loads_neither_numpy_nor_anything_slow():
    code = (
        "import sys, clubface; clubface.club('driver'); "
        "print(sorted({'numpy', 'pandas', 'matplotlib', 'rich', 'typer'} & set(sys.modules)))"
    )
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert result.stdout.strip() == "[]"


def test_a_function_is_not_hidden_by_the_module_of_its_name():
    import clubface.models

    assert isinstance(sys.modules["clubface.models"], types.ModuleType)
    assert callable(clubface.models)


def test_public_names_are_listed():
    assert {"impact", "history", "sensitivity", "fly", "Club", "Ball", "ParameterSet"} <= set(dir(clubface))
    assert not hasattr(clubface, "nonsense")
