"""The check of the built pages finds what a reader would miss: addresses of a network and links that lead nowhere."""

import pytest

from script_files import load_script

HEAD = '<!doctype html><html><head><link rel="stylesheet" href="style.css?v=1"></head><body>'
SOUND = f'{HEAD}<h1 id="top">A</h1><a href="https://example.org">out</a><a href="#top">up</a><img src="data:,"></body>'


@pytest.fixture
def problems():
    pytest.importorskip("sphinx")
    return load_script("docs/_ext/built_pages.py").problems


@pytest.fixture
def site(tmp_path):
    (tmp_path / "style.css").write_text("p { background: url(data:,) }", encoding="utf-8")
    (tmp_path / "a.html").write_text(SOUND, encoding="utf-8")
    return tmp_path


def test_pages_that_hold_all_they_need_have_no_problem(problems, site):
    (site / "below").mkdir()
    (site / "below" / "b.html").write_text(
        '<p id="x"><a href="../a.html#top">a</a><a href="#x">x</a>', encoding="utf-8"
    )
    assert list(problems(site)) == []


def test_a_link_may_hold_what_the_page_shows(problems, site):
    (site / "b.html").write_text('<a href="a.html#club=driver&speed=105mph">a drive</a>', encoding="utf-8")
    assert list(problems(site)) == []


@pytest.mark.parametrize(
    ("markup", "address"),
    [
        ('<script src="https://cdn.example.org/m.js"></script>', "https://cdn.example.org/m.js"),
        ('<img src="//cdn.example.org/p.png">', "//cdn.example.org/p.png"),
        ('<img srcset="style.css 1x, http://cdn.example.org/p.png 2x">', "http://cdn.example.org/p.png"),
        ('<link rel="stylesheet" href="http://cdn.example.org/s.css">', "http://cdn.example.org/s.css"),
        ("<style>@import 'https://cdn.example.org/f.css';</style>", "https://cdn.example.org/f.css"),
        ('<p style="background: url(https://cdn.example.org/b.png)">', "https://cdn.example.org/b.png"),
        ('<a href="gone.html">', "gone.html"),
        ('<img src="gone.png">', "gone.png"),
        ('<a href="a.html#gone">', "a.html#gone"),
        ('<a href="#gone">', "#gone"),
    ],
)
def test_a_page_that_needs_a_network_or_links_nowhere_is_named_with_the_address(problems, site, markup, address):
    (site / "b.html").write_text(markup, encoding="utf-8")
    (problem,) = problems(site)
    assert "b.html" in problem
    assert address in problem


def test_a_style_sheet_that_needs_a_network_is_named(problems, site):
    (site / "style.css").write_text('@font-face { src: url("https://cdn.example.org/f.woff2") }', encoding="utf-8")
    (problem,) = problems(site)
    assert "style.css" in problem
    assert "https://cdn.example.org/f.woff2" in problem
