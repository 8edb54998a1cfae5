"""Flights beside published ones: carry, height and descent from the published launch."""

import numpy as np
import pytest

import clubface
from clubface import published_data

YARD = 0.9144


def deviations(name):
    """Return carry [%], height [yd] and angle of descent [deg] less the published ones, a row each."""
    table = published_data.table(name).columns
    launch = {"ball_speed": table["ball_speed"], "launch": table["launch"], "backspin": table["spin"], "sidespin": 0.0}
    flights = clubface.fly(launch)
    rows = [100.0 * (flights.carry / table["carry"] - 1.0)]
    if "apex" in table:
        rows.append((flights.apex - table["apex"]) / YARD)
    if "landing_angle" in table:
        rows.append(np.degrees(flights.landing_angle - table["landing_angle"]))
    return np.array(rows)


def rms(values):
    return np.sqrt(np.mean(values**2, axis=1))


@pytest.mark.parametrize(
    ("table", "most"),
    [
        # Fitted to these.
        ("pga-2023", (2.3, 1.6, 2.3)),
        ("lpga-2023", (2.6, 2.2, 2.3)),
        # Held out.
        ("pga-2019", (2.1, 2.2, 2.2)),
        ("lpga-2019", (2.2, 1.6, 3.2)),
        ("optimum-trackman-2010", (1.8,)),
    ],
)
def test_carries_heights_and_descents_are_those_of_published_launches(table, most):
    """Root mean square over the clubs: carry [%], height [yd], descent [deg]. Averages of launches make no average
    flight, and the ranges' air is unknown; coefficients of the spin parameter alone missed the descents by 5 to 6."""
    result = rms(deviations(table))
    assert (result < most).all(), result


def test_a_monitors_flights_are_its_own():
    """A TrackMan's computed flights, part of the fit, and a Garmin R50's, which are not."""
    carry, apex, descent = deviations("flights-computed-trackman")
    assert abs(carry.mean()) < 2.0
    assert abs(apex.mean()) < 0.6
    assert abs(descent.mean()) < 1.5
    carry, apex = deviations("flights-computed-garmin-r50")
    assert abs(carry.mean()) < 2.5
    assert abs(apex.mean()) < 1.0


def test_flights_that_were_seen_to_their_end_are_bounded():
    """Outdoors, in unknown wind and air, and held out: carries are up to 5% shorter, descents up to 3 degrees less."""
    carry, apex, descent = deviations("flights-tracked-trackman")
    assert 0.0 < carry.mean() < 5.0
    assert abs(apex.mean()) < 1.5
    assert abs(descent.mean()) < 3.0


@pytest.mark.parametrize("table", ["pga-2023", "lpga-2023"])
def test_every_club_carries_farther_at_altitude(table):
    """The drag crisis comes earlier in thin air, and does not take away what less air gives: 1% of carry at 1500 m."""
    columns = published_data.table(table).columns
    launch = {"ball_speed": columns["ball_speed"], "launch": columns["launch"], "backspin": columns["spin"]}
    low, high = (clubface.fly({**launch, "sidespin": 0.0}, air={"altitude": each}).carry for each in (0.0, 1500.0))
    assert (high / low > 1.01).all(), high / low
