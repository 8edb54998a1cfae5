"""The package of sources has what it takes to build clubface from it."""

import json
import shutil
import subprocess
import tarfile
import tomllib
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


def members(folder):
    return tomllib.loads((folder / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["members"]


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory):
    """The package of sources, as pip unpacks it."""
    for tool in ("maturin", "cargo"):
        if shutil.which(tool) is None:
            pytest.skip(f"packages of sources are not tested: that needs {tool}")
    if not (ROOT / "Cargo.toml").is_file():
        pytest.skip("packages of sources are not tested: this is no checkout")
    folder = tmp_path_factory.mktemp("sources")
    command = ["maturin", "sdist", "--manifest-path", str(ROOT / "crates" / "clubface-python" / "Cargo.toml")]
    subprocess.run([*command, "--out", str(folder)], cwd=ROOT, check=True, capture_output=True)
    (packed,) = folder.glob("*.tar.gz")
    with tarfile.open(packed) as archive:
        archive.extractall(folder, filter="data")
    return folder / packed.name.removesuffix(".tar.gz")


def test_its_lock_file_fits_its_crates(unpacked):
    """Builds are locked: with a crate less than Cargo.lock knows, cargo would have to change it, and refuses."""
    assert sorted(members(unpacked)) == sorted(members(ROOT))
    command = ["cargo", "metadata", "--locked", "--offline", "--format-version", "1"]
    done = subprocess.run(command, cwd=unpacked, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    packages = {each["name"] for each in json.loads(done.stdout)["packages"]}
    assert {"clubface-python", "clubface-fmi"} <= packages


def test_it_has_what_builds_it_and_the_data_of_the_package(unpacked):
    system = tomllib.loads((unpacked / "pyproject.toml").read_text(encoding="utf-8"))["build-system"]
    (path,) = system["backend-path"]
    assert (unpacked / path / f"{system['build-backend']}.py").is_file()
    shipped = {
        each.relative_to(ROOT) for each in (ROOT / "python" / "clubface").rglob("*")
        if each.is_file() and each.suffix in (".py", ".toml", ".csv", ".json", ".typed")
    }  # fmt: skip
    missing = {each for each in shipped if not (unpacked / each).is_file()}
    assert {each for each in missing if "studio_site" not in each.parts} == set()  # built, not kept
