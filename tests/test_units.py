"""Conversions against the definitions of the units, and what is refused."""

import contextlib
import math

import numpy as np
import pytest
from hypothesis import given, strategies as st

from clubface import units
from clubface.errors import InputError, UnitError
from clubface.quantities import display_unit
from clubface.units import UNITS

# One unit is so many of the SI, and zero of it is so much. Sources: BIPM, The International System of Units (2019), for
# prefixes, degrees, minutes and the degree Celsius; the agreement of 1959 on yard (0.9144 m) and pound (0.45359237 kg),
# exact, for inches, feet, miles and ounces; NIST SP 811 (2008), Appendix B, for inches of mercury at 0 degC and degrees
# Fahrenheit. Numbers are typed from there, not from the package.
TURN = 2.0 * math.pi
FACTORS = {
    "speed": {"m/s": 1.0, "mph": 0.44704, "km/h": 1000.0 / 3600.0, "ft/s": 0.3048},
    "angle": {"rad": 1.0, "deg": TURN / 360.0},
    "length": {"m": 1.0, "mm": 0.001, "cm": 0.01, "in": 0.0254, "yd": 0.9144, "ft": 0.3048},
    "area": {"m2": 1.0, "cm2": 0.0001, "mm2": 0.000001},
    "volume": {"m3": 1.0, "cm3": 0.000001},
    "mass": {"kg": 1.0, "g": 0.001, "oz": 0.45359237 / 16.0},
    "inertia": {"kg m2": 1.0, "g cm2": 0.0000001},
    "mass moment": {"kg m": 1.0, "g cm": 0.00001},
    "angular rate": {"rad/s": 1.0, "deg/s": TURN / 360.0, "rpm": TURN / 60.0},
    "temperature": {"K": 1.0, "degC": 1.0, "degF": 5.0 / 9.0},
    "pressure": {"Pa": 1.0, "hPa": 100.0, "kPa": 1000.0, "MPa": 1000000.0, "GPa": 1000000000.0, "inHg": 3386.389},
    "time": {"s": 1.0, "ms": 0.001, "us": 0.000001},
    "force": {"N": 1.0, "kN": 1000.0},
    "energy": {"J": 1.0},
    "density": {"kg/m3": 1.0, "g/cm3": 1000.0},
    "volumetric stiffness": {"N/m3": 1.0},
    "inverse speed": {"s/m": 1.0, "ms/m": 0.001},
    "rotary stiffness": {"N m/rad": 1.0},
    "rotary damping": {"N m s/rad": 1.0},
    "area damping": {"N s/m2": 1.0},
    "dimensionless": {"1": 1.0, "%": 0.01},
}
ZEROS = {"degC": 273.15, "degF": 459.67 * 5.0 / 9.0}
ALL_UNITS = sorted({each.symbol for each in UNITS.values()})


@pytest.mark.parametrize("dimension", FACTORS)
def test_every_unit_has_the_size_of_its_source(dimension):
    known = {each.symbol for each in UNITS.values() if each.dimension == dimension}
    assert known == set(FACTORS[dimension])
    for symbol, factor in FACTORS[dimension].items():
        zero = ZEROS.get(symbol, 0.0)
        # Two or three roundings of 1.1e-16 each; a temperature adds those of its zero, 273 K.
        assert units.parse(f"1 {symbol}", dimension) == pytest.approx(zero + factor, rel=4e-16, abs=0), symbol
        assert units.from_si(zero + 7.0 * factor, symbol) == pytest.approx(7.0, rel=2e-13 if zero else 4e-16), symbol


def test_every_dimension_is_in_the_table():
    assert {each.dimension for each in UNITS.values()} == set(FACTORS)


def test_grams_and_millimetres_convert_to_the_last_bit():
    assert units.parse("204 g", "mass") == 0.204
    assert units.parse("305mm", "length") == 0.305
    assert units.parse("5900 g cm²", "inertia") == 5900e-7


@given(st.sampled_from(ALL_UNITS), st.floats(-1e12, 1e12, allow_subnormal=False))
def test_text_in_any_unit_comes_back_from_si(symbol, number):
    result = units.unit(symbol)
    value = units.parse(f"{number!r} {symbol}", result.dimension)
    # Each direction rounds three times (eps 1.1e-16); an offset of up to 273 K adds its own rounding, about 1e-13.
    # Below 1e-300 a scaled value is subnormal and loses digits.
    tolerance = 8e-16 * abs(number) + (3e-13 if result.offset else 1e-300)
    assert abs(units.from_si(value, symbol) - number) <= tolerance


def test_a_bare_number_is_si():
    assert units.parse(50, "speed") == 50.0
    assert units.parse(np.float32(0.5), "angle") == 0.5


@pytest.mark.parametrize("text", ["50", "-1.3", "1e3"])
def test_digits_as_text_need_a_unit_unless_they_are_zero_or_count(text):
    with pytest.raises(InputError, match="unit"):
        units.parse(text, "speed")
    assert units.parse(text, units.DIMENSIONLESS) == float(text)
    assert units.parse("0", "speed") == 0.0


@pytest.mark.parametrize("text", ["-1.3deg", "−1.3 deg", " -1.3   deg ", "-13e-1 °", "-1.3degrees"])
def test_spacing_and_spelling_do_not_matter(text):
    assert units.parse(text, "angle") == pytest.approx(-1.3 * math.pi / 180.0, rel=4e-16)
    assert units.parse("13.5 N·m/rad", "rotary stiffness") == 13.5
    assert units.parse("6.25e9 N/m^3", "volumetric stiffness") == 6.25e9


def test_a_unit_of_the_wrong_dimension_names_parameter_and_what_is_allowed():
    with pytest.raises(UnitError, match=r"club_speed is .108 deg.; .*mph.*, not an angle") as caught:
        units.parse("108 deg", "speed", name="club_speed")
    assert caught.value.parameter == "club_speed"
    assert caught.value.value == "108 deg"


def test_an_unknown_unit_names_the_nearest_and_in_a_heading_the_column():
    with pytest.raises(UnitError, match=r"did you mean .*mph"):
        units.parse("108 mphh", "speed")
    with pytest.raises(UnitError, match="club_speed"):
        units.parse_column_name("club_speed [knots]")


@pytest.mark.parametrize(
    "value",
    [
        math.nan, math.inf, -math.inf, "nan", "inf m/s", "1e999 m/s", 10**400, None, True, [1.0], {}, b"1", "", "fast",
        "1,000 m/s", "--1", "m/s", 1j,
    ],
)  # fmt: skip
def test_what_is_no_finite_number_is_refused_with_its_name(value):
    with pytest.raises(InputError, match="club_speed"):
        units.parse(value, "speed", name="club_speed")


@given(st.text())
def test_any_text_is_a_finite_number_or_an_error(text):
    with contextlib.suppress(InputError):
        assert math.isfinite(units.parse(text, "speed"))


def test_arrays_keep_their_shape_and_their_bad_rows():
    given_texts = [["100 mph", 50], ["0", "36 km/h"]]
    assert units.parse_values(given_texts, "speed") == pytest.approx(np.array([[44.704, 50.0], [0.0, 10.0]]))
    assert np.isnan(units.parse_values(np.array([1.0, np.nan]), "speed")[1])
    with pytest.raises(InputError, match=r"speed\[1\]"):
        units.parse_values(["1 m/s", "x"], "speed", name="speed")


@pytest.mark.parametrize(
    ("column", "expected"),
    [
        ("club_speed_mph", ("club_speed", "mph")),
        ("club_speed [mph]", ("club_speed", "mph")),
        ("club_speed (mph)", ("club_speed", "mph")),
        (" club_speed ", ("club_speed", None)),
        ("ball_speed_mps", ("ball_speed", "m/s")),
        ("closure_deg_s", ("closure", "deg/s")),
        ("izz_gcm2", ("izz", "g cm2")),
        ("peak_force_n", ("peak_force", "N")),
        ("backspin_rpm", ("backspin", "rpm")),
        ("iyy [g cm^2]", ("iyy", "g cm2")),
        ("face", ("face", None)),
        ("cg_x", ("cg_x", None)),
        ("mph", ("mph", None)),
        ("toe (in)", ("toe", "in")),
    ],
)
def test_a_column_heading_carries_its_unit(column, expected):
    assert units.parse_column_name(column) == expected


def test_a_known_column_name_is_never_taken_apart():
    assert units.parse_column_name("time_s", {"time_s"}) == ("time_s", None)


def test_people_read_spin_in_rpm_and_closure_in_degrees_a_second():
    assert display_unit("backspin", "rad/s") == "rpm"
    assert display_unit("closure", "rad/s") == "deg/s"
    assert display_unit("ball_speed", "m/s") == "mph"
    assert units.show(0.204, "g") == "204 g"


# The unit in which golfers and engineers read each quantity.
SHOWN = {
    "toe": "mm", "high": "mm", "bulge": "mm", "roll": "mm", "face_width": "mm", "face_height": "mm", "cg_x": "mm",
    "cg_y": "mm", "cg_z": "mm", "dcg_x": "mm", "dcg_y": "mm", "dcg_z": "mm", "ball_radius": "mm", "radius": "mm",
    "cover_thickness": "mm", "penetration": "mm", "contact_area": "mm2", "contact_time": "us", "peak_force": "kN",
    "characteristic_time": "us", "included_time": "us", "shear_modulus": "MPa", "ring_modulus": "MPa", "humidity": "%",
    "closure": "deg/s", "pitch_rate": "deg/s", "lie_rate": "deg/s",
}  # fmt: skip


@pytest.mark.parametrize(("name", "unit"), SHOWN.items())
def test_a_quantity_is_shown_in_the_unit_it_is_read_in(name, unit):
    si = units.SI_UNITS[units.unit(unit).dimension]
    assert display_unit(name, si) == unit


@pytest.mark.parametrize(
    ("name", "si", "unit"),
    [
        ("sweet_spot_toe", "m", "mm"), ("thickness_crown", "m", "mm"), ("target_mass", "kg", "g"), ("carry", "m", "yd"),
        ("toe_error", "m", "mm"), ("closure_mean", "rad/s", "deg/s"), ("toe_speed", "m/s", "mph"),
    ],
)  # fmt: skip
def test_lengths_of_a_head_and_what_is_computed_of_a_quantity_have_their_usual_unit(name, si, unit):
    assert display_unit(name, si) == unit
