"""What people do with results without thinking: print them, and change a list that they were handed."""

from contextlib import suppress

import numpy as np
import pytest

import clubface
from clubface import published_data
from clubface.design.rules import rules
from clubface.fem.materials import laws
from clubface.inference.evaluation import published
from clubface.shots.monitors import FORMATS
from clubface.simulation import results

pytestmark = pytest.mark.filterwarnings("ignore")
DRIVE = {"speed": "105 mph", "loft": "12 deg"}
SHOT = {"delivery": DRIVE}

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
    "a club": lambda: clubface.club("driver"),
    "a ball": lambda: clubface.ball("modern"),
}  # fmt: skip


@pytest.mark.parametrize("name", RESULTS)
def test_printing_a_result_computes_nothing(monkeypatch, name):
    made = RESULTS[name]()

    def computed(*arguments, **named):
        raise AssertionError("something was computed to print it")

    for each in ("impact", "fly", "sensitivity", "sensitivities", "history", "trajectory", "fly_sensitivity"):
        monkeypatch.setattr(f"clubface.simulation.core.{each}", computed)
    assert repr(made)
    assert str(made)


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
