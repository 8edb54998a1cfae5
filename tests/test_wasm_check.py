"""What the check of the core in WebAssembly computes there has every input that the core has."""

import runpy
from pathlib import Path

from clubface.simulation.results import inputs

SCRIPT = Path(__file__).parents[1] / "scripts" / "wasm_check.py"


def test_the_deliveries_have_every_input_and_each_of_the_delivery_varies():
    columns = runpy.run_path(str(SCRIPT))["_deliveries"]()
    assert len(columns) == len(inputs())
    for each, column in zip(inputs().values(), columns, strict=True):
        assert len(column) == len(columns[0])
        if each.group == "delivery":
            assert len(set(column)) > 100
