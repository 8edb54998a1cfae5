"""Formulas of the pages become MathML that means what the LaTeX means."""

import pytest

from script_files import load_script


@pytest.fixture
def extension():
    pytest.importorskip("sphinx")
    return load_script("docs/_ext/mathml.py")


def markup(extension, formula):
    from docutils import nodes

    return "".join(extension.mathml(nodes.math("", formula)).split())


def test_a_fraction_of_two_digits_is_no_twelve_over_what_follows(extension):
    assert "<mn>1</mn><mn>2</mn></mfrac><mi>ρ</mi>" in markup(extension, r"\tfrac12 \rho")


def test_a_bold_letter_is_one_letter_and_takes_nothing_with_it(extension):
    assert "<mfrac><mi>𝛚</mi><mi>ω</mi></mfrac><mi>x</mi>" in markup(extension, r"\frac{\boldsymbol\omega}{\omega} x")


def test_a_fraction_without_denominator_is_refused(extension):
    # docutils makes a row of all that follows \boldsymbol, so that the fraction has one part.
    assert markup(extension, r"\frac{\boldsymbol x}{y}").startswith("<code>")
