"""Warnings about a fit: each bound, contact and figure just on either side of where it is told."""

from types import SimpleNamespace

import numpy as np
import pytest

from clubface.inference.identification.checks import at_bound, bounds_met, unphysical_contacts, worse

NEAR = 1e-4
"""Part of its range within which a parameter meets a bound."""


def two():
    declared = [SimpleNamespace(name="cor", unit="1"), SimpleNamespace(name="slip_y", unit="m")]
    return SimpleNamespace(
        names=("cor", "slip_y"), declared=lambda: declared, lower=np.array([0.5, -0.01]), upper=np.array([1.0, 0.5])
    )


@pytest.mark.parametrize(
    ("place", "side"),
    [(0.0, "lower"), (0.99 * NEAR, "lower"), (1.01 * NEAR, None), (0.5, None), (1.0 - 1.01 * NEAR, None),
     (1.0 - 0.99 * NEAR, "upper"), (1.0, "upper")],
)  # fmt: skip
def test_a_parameter_at_either_bound_is_reported_with_it(place, side):
    point = np.array([place, 0.5])
    assert at_bound(two(), point) == (() if side is None else ("cor",))
    bound = {"lower": "0.5", "upper": "1"}
    expected = [] if side is None else [{"parameter": "cor", "side": side, "bound": bound[side]}]
    assert [each.data for each in bounds_met(two(), point)] == expected


@pytest.mark.parametrize(
    ("time", "force", "speed", "words"),
    [
        (450e-6, 12e3, 50.0, []), (351e-6, 8.1e3, 50.0, []), (599e-6, 16.9e3, 50.0, []),
        (349e-6, 12e3, 50.0, ["lasts 349 us"]), (601e-6, 12e3, 50.0, ["lasts 601 us"]),
        (450e-6, 7.9e3, 50.0, ["7.9 kN"]), (450e-6, 17.1e3, 50.0, ["17.1 kN"]),
        # Hertz: half the speed has 2^-1.2 = 0.435 of the force, 3.5 to 7.4 kN.
        (450e-6, 3.6e3, 25.0, []), (450e-6, 7.3e3, 25.0, []), (450e-6, 3.4e3, 25.0, ["3.4 kN"]),
        (450e-6, 7.5e3, 25.0, ["7.5 kN"]), (np.nan, 1.0, 50.0, []),
    ],
)  # fmt: skip
def test_an_unphysical_contact_is_reported(time, force, speed, words):
    simulator = SimpleNamespace(
        contact=lambda _: (np.array([time, time]), np.array([force, force])),
        shots=SimpleNamespace(mean=lambda name: {"speed": speed}[name]),
    )
    warned = unphysical_contacts(simulator, np.array([0.5]))
    assert len(warned) == len(words)
    assert all(word in each.sentence for word, each in zip(words, warned, strict=True))


def test_a_quantity_that_a_fit_makes_worse_by_more_than_a_twentieth_is_reported():
    def figures(mae, before):
        return SimpleNamespace(mae=mae, mae_before=before, mean=60.0)

    mph = 0.44704
    warned = worse(
        {"ball_speed": figures(1.06 * mph, mph), "launch": figures(1.04, 1.0), "backspin": figures(1e-5, 0.0)},
        "registry",
    )
    assert len(warned) == 1
    assert warned[0].data == {"before": "registry", "names": ["ball_speed (MAE 1.06 mph, 1 mph before)"]}
    assert worse({"launch": figures(1.04, 1.0)}, "registry") == []
