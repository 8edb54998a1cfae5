"""What people do with results without thinking: print them, and change a list that they were handed."""

import html
import importlib.resources
import json
import pkgutil
from contextlib import suppress
from importlib import import_module
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import clubface
from clubface import published_data
from clubface.design.rules import rules
from clubface.fem.materials import laws
from clubface.inference.evaluation import published
from clubface.results.result import Presentable, Result
from clubface.shots.monitors import FORMATS
from clubface.simulation import results

pytestmark = pytest.mark.filterwarnings("ignore")
DRIVE = {"speed": "105 mph", "loft": "12 deg"}
MONITOR = Path(__file__).parent / "data" / "launch_monitors" / "trackman.csv"
SHOT = {"delivery": DRIVE}

SCHEMA = json.loads(importlib.resources.files("clubface").joinpath("data/schemas/result-1.json").read_text())

RESULTS = {
    "a launch": lambda: clubface.impact("driver", DRIVE, toe=np.array([0.0, 0.01])),
    "shots that all fail": lambda: clubface.impact("driver", speed=np.full(3, -1.0), on_error="nan"),
    "several models": lambda: clubface.impact("driver", DRIVE, model=["response", "standard"]),
    "a history": lambda: clubface.history("driver", DRIVE),
    "a flight": lambda: clubface.fly(clubface.impact("driver", DRIVE)),
    "a path": lambda: clubface.trajectory(clubface.impact("driver", DRIVE)),
    "derivatives": lambda: clubface.sensitivity("driver", DRIVE),
    "a map of the face": lambda: clubface.map_face("driver", DRIVE, grid=(7, 5)),
    "a golfer": lambda: clubface.golfer(clubface.golfers()[0]),
    "a dispersion": lambda: clubface.dispersion(clubface.golfers()[0], count=256),
    "a comparison": lambda: clubface.compare({each: {"club": each, **SHOT} for each in ("driver", "3-wood")}),
    "the best loft": lambda: clubface.best_loft(45.0, club="driver"),
    "a posterior": lambda: clubface.infer({"ball_speed": "150 mph", "launch": "13 deg"}, club="driver", samples=100),
    "why a shot flies as it does": lambda: clubface.explain("driver", {**DRIVE, "path": "-3 deg"}),
    "recorded shots": lambda: clubface.shots.read(MONITOR),
    "what a shaft takes part in": lambda: clubface.hosel_reaction(
        clubface.impact(clubface.club("driver").on_shaft("graphite"), DRIVE)
    ),
    "a club": lambda: clubface.club("driver"),
    "a ball": lambda: clubface.ball("modern"),
}  # fmt: skip


@pytest.mark.parametrize("name", RESULTS)
def test_printing_a_result_computes_nothing(monkeypatch, name):
    made = RESULTS[name]()

    def computed(*arguments, **named):
        raise AssertionError("something was computed to print it")

    for each in ("impact", "fly", "sensitivities", "history", "trajectory", "fly_sensitivity"):
        monkeypatch.setattr(f"clubface._core.{each}", computed)
    assert repr(made)
    assert str(made)


DESCRIPTIONS = {"a golfer", "a club", "a ball"}
"""What is described and not computed."""
SURFACES = ("to_result", "to_dict", "to_pandas", "to_xarray", "_repr_html_")


@pytest.mark.parametrize("name", sorted(RESULTS.keys() - DESCRIPTIONS))
def test_what_is_computed_is_a_document_a_table_a_dataset_and_a_page(name):
    made = RESULTS[name]()
    document = made.to_dict()
    jsonschema.validate(document, SCHEMA)
    assert document["tables"] or document["values"]
    assert document["provenance"]["inputs"]
    assert len(made.to_pandas())
    assert made.to_xarray().nbytes
    assert made.to_result().title in html.unescape(made._repr_html_())


def classes():
    """Every class of the package."""
    for each in pkgutil.walk_packages(clubface.__path__, "clubface."):
        if each.name not in ("clubface.__main__", "clubface.torch", "clubface.jax"):
            for member in vars(import_module(each.name)).values():
                if isinstance(member, type) and member.__module__ == each.name:
                    yield member


def test_every_class_with_a_result_has_all_surfaces():
    known = {Result, Presentable}
    described = {each for each in classes() if hasattr(each, "to_result")} - known
    assert len(described) > 30
    assert [(each, name) for each in described for name in SURFACES if not hasattr(each, name)] == []


def test_launches_by_several_models_keep_every_number():
    toes = np.array([0.0, 0.01, 0.02])
    compared = clubface.impact("driver", DRIVE, toe=toes, model=["response", "standard"])
    rows = compared.to_result().table().to_pandas()
    dataset = compared.to_xarray()
    for name in ("ball_speed", "sidespin"):
        numbers = np.array([each.get(name) for each in compared.values()])
        assert np.array_equal(rows[name].to_numpy().reshape(2, 3), numbers)
        assert np.array_equal(dataset[name].transpose("model", "toe"), numbers)
    assert rows["model"].tolist() == ["response"] * 3 + ["standard"] * 3
    assert dataset["model"].values.tolist() == ["response", "standard"]


@pytest.mark.parametrize("name", ["a history", "a path"])
def test_a_series_is_the_same_table_in_pandas_and_in_its_result(name):
    made = RESULTS[name]()
    own, of_result = made.to_pandas(), made.to_result().table().to_pandas()
    assert list(own) == list(of_result)
    assert np.array_equal(own.to_numpy(), of_result.to_numpy())
    assert own.attrs["units"] == of_result.attrs["units"]


REGISTRIES = {
    "models": clubface.models,
    "published tables": published_data.subjects,
    "tables of a subject": lambda: next(iter(published_data.subjects().values())),
    "rules": rules,
    "published accuracy": published,
    "materials": laws,
    "inputs": results.inputs,
    "outputs": results.outputs,
    "quantities of a launch": lambda: clubface.impact("driver", DRIVE).quantities(),
    "columns": results.input_columns,
    "dimensions": results.input_dimensions,
    "inputs of a flight": results.flight_inputs,
    "formats": lambda: FORMATS,
}


@pytest.mark.parametrize("name", REGISTRIES)
@pytest.mark.parametrize(
    "change",
    [
        lambda mapping: mapping.clear(),
        lambda mapping: mapping.pop(next(iter(mapping))),
        lambda mapping: mapping.update(mine=None),
        lambda mapping: mapping.popitem(),
    ],
    ids=["clear", "pop", "update", "popitem"],
)
def test_a_registry_stays_as_it_is_whatever_is_done_to_what_it_gives(name, change):
    before = dict(REGISTRIES[name]())
    with suppress(TypeError):  # some refuse to be changed, others are the caller's own
        change(REGISTRIES[name]())
    assert dict(REGISTRIES[name]()) == before
    assert clubface.impact("driver", DRIVE).ball_speed > 60.0


def test_the_models_may_be_changed_by_whoever_asked_for_them():
    own = clubface.models()
    del own["rings"]
    assert "rings" in clubface.models()
