"""The built site is found by its setting, in the package or in the checkout, or it is said what makes one."""

import pytest

pytest.importorskip("starlette")

from clubface.errors import FileError
from clubface.studio import serve
from studio_pages import made_site


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package in a checkout, or in an installation where nothing else is."""
    monkeypatch.delenv(serve.SITE_VARIABLE, raising=False)
    monkeypatch.setattr(serve, "DATA", tmp_path / "python" / "clubface" / "data")
    return tmp_path / "python" / "clubface"


def test_the_site_of_a_wheel_comes_before_that_of_a_checkout(package, tmp_path):
    with pytest.raises(FileError, match=r"this installation has no built studio.*--site or CLUBFACE_STUDIO_SITE"):
        serve.site_folder()
    (tmp_path / "studio").mkdir()
    (tmp_path / "studio" / "package.json").write_text("{}")
    with pytest.raises(FileError, match="not built yet: make studio-build"):
        serve.site_folder()
    built = made_site(tmp_path / "studio" / "dist")
    assert serve.site_folder() == built
    shipped = made_site(package / "studio_site")
    assert serve.site_folder() == shipped


def test_a_folder_that_is_named_comes_first(package, tmp_path, monkeypatch):
    made_site(package / "studio_site")
    one, other = made_site(tmp_path / "one"), made_site(tmp_path / "other")
    monkeypatch.setenv(serve.SITE_VARIABLE, str(one))
    assert serve.site_folder() == one
    assert serve.site_folder(other) == other
    with pytest.raises(FileError, match=r"there is no index\.html in it"):
        serve.site_folder(tmp_path)
