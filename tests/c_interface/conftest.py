"""How a program is compiled against the installed C library."""

import os
import shutil

import pytest

from c_programs import ran


@pytest.fixture(scope="session")
def flags(install):
    """Options of a compiler, as pkg-config prints them, and the place of the library for the program that starts."""
    if shutil.which("pkg-config") is None:
        pytest.skip("libclubface is not tested with pkg-config, which is not installed")
    environment = {**os.environ, "PKG_CONFIG_PATH": str(install / "lib" / "pkgconfig")}
    words = ran("pkg-config", "--cflags", "--libs", "clubface", env=environment).split()
    return [*words, f"-Wl,-rpath,{install / 'lib'}"]
