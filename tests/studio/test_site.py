"""The built site is found by its setting, in the package or in the checkout, or it is said what makes one."""

import pytest

pytest.importorskip("starlette")

from clubface.errors import FileError
from clubface.studio import site
from studio_pages import made_site


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package in a checkout, or in an installation where nothing else is."""
    monkeypatch.delenv(site.SITE_VARIABLE, raising=False)
    monkeypatch.setattr(site, "DATA", tmp_path / "python" / "clubface" / "data")
    return tmp_path / "python" / "clubface"


def test_the_site_of_a_wheel_comes_before_that_of_a_checkout(package, tmp_path):
    with pytest.raises(FileError, match=r"this installation has no built studio.*--site or CLUBFACE_STUDIO_SITE"):
        site.site_folder()
    (tmp_path / "studio").mkdir()
    (tmp_path / "studio" / "package.json").write_text("{}")
    with pytest.raises(FileError, match="not built yet: make studio-build"):
        site.site_folder()
    built = made_site(tmp_path / "studio" / "dist")
    assert site.site_folder() == built
    shipped = made_site(package / "studio_site")
    assert site.site_folder() == shipped


def test_a_folder_that_is_named_comes_first(package, tmp_path, monkeypatch):
    made_site(package / "studio_site")
    one, other = made_site(tmp_path / "one"), made_site(tmp_path / "other")
    monkeypatch.setenv(site.SITE_VARIABLE, str(one))
    assert site.site_folder() == one
    assert site.site_folder(other) == other
    with pytest.raises(FileError, match=r"there is no index\.html in it"):
        site.site_folder(tmp_path)
