"""Run a tutorial page as one script from top to bottom: its Python and its shell blocks, in one folder.

``python docs/tutorials/run.py PAGE FOLDER`` leaves the files that the page makes in FOLDER and fails where the page
shows another output than it gives. ``--update`` writes the outputs into the page, and its pictures into docs/figures.

A block marked ``text`` that follows a block of code directly is its output; three dots in it stand for anything.
"""

from __future__ import annotations

import argparse
import contextlib
import doctest
import io
import os
import re
import shutil
import subprocess
import sys
import warnings
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

FIGURES = Path(__file__).parent.parent / "figures"
BLOCK = re.compile(
    r"^```(?P<language>python|shell)\n(?P<code>.*?)^```\n(?:\n```text\n(?P<shown>.*?)^```\n)?", re.DOTALL | re.MULTILINE
)
PICTURE = re.compile(r"figures/([\w-]+\.(?:svg|png))")
WIDTH = "100"
"""Columns of the terminal of the shell blocks."""


class Ran(NamedTuple):
    """A block that was run.

    Attributes
    ----------
    line
        Of its first line of code in the page.
    shown
        The output that the page shows; None where it shows none.
    printed
        The output that it gave.
    """

    line: int
    shown: str | None
    printed: str

    @property
    def agrees(self) -> bool:
        """Whether the page shows what was printed, spaces and line breaks apart."""
        flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
        return self.shown is None or doctest.OutputChecker().check_output(self.shown, self.printed, flags)


def run(page: Path, folder: Path) -> Iterator[Ran]:
    """Run the blocks of a page in ``folder`` one after the other, those in Python in one namespace."""
    text = page.read_text(encoding="utf-8")
    names: dict[str, Any] = {"__name__": "__main__"}
    with contextlib.chdir(folder):
        for block in BLOCK.finditer(text):
            line = text.count("\n", 0, block.start("code")) + 1
            code = block["code"]
            printed = _shell(code) if block["language"] == "shell" else _python(code, names, page, line)
            yield Ran(line, block["shown"], printed)


def _shell(code: str) -> str:
    """Return what commands print on both streams; a command that fails stops the page."""
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    environment = {**os.environ, "PATH": path, "COLUMNS": WIDTH, "OPENBLAS_NUM_THREADS": "1"}
    ran = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", code],
        env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False,
    )  # fmt: skip
    if ran.returncode != 0:
        raise AssertionError(f"exit status {ran.returncode} of\n{code}\n{ran.stdout}")
    return ran.stdout


def _python(code: str, names: dict[str, Any], page: Path, line: int) -> str:
    """Return what a block prints; a warning is an error, since a reader would stumble over it."""
    out = io.StringIO()
    with warnings.catch_warnings(), contextlib.redirect_stdout(out):
        warnings.simplefilter("error")
        exec(compile("\n" * (line - 1) + code, str(page), "exec"), names)
    return out.getvalue()


def update(page: Path, folder: Path) -> None:
    """Write the outputs into the page, and the pictures it shows and makes into docs/figures."""
    import matplotlib as mpl

    # The same picture is then the same file.
    os.environ["SOURCE_DATE_EPOCH"] = "0"
    mpl.use("agg")
    mpl.rcParams["svg.hashsalt"] = "clubface"
    printed = iter([each.printed for each in run(page, folder)])

    def filled(block: re.Match[str]) -> str:
        new = next(printed)
        shown = block["shown"]
        if shown is None or "..." in shown:
            return block[0]
        new = "".join(f"{line.rstrip()}\n" for line in new.splitlines())
        return block[0][: block.start("shown") - block.start()] + new + "```\n"

    text = page.read_text(encoding="utf-8")
    page.write_text(BLOCK.sub(filled, text), encoding="utf-8")
    for name in PICTURE.findall(text):
        if (folder / name).exists():
            shutil.copyfile(folder / name, FIGURES / name)


def main() -> int:
    """Run a page; return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("page", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--update", action="store_true", help="write outputs and pictures into the documentation")
    given = parser.parse_args()
    given.folder.mkdir(parents=True, exist_ok=True)
    if any(given.folder.iterdir()):
        parser.error(f"{given.folder} holds files already; name a new folder")
    if given.update:
        update(given.page, given.folder)
        return 0
    wrong = [each for each in run(given.page.resolve(), given.folder) if not each.agrees]
    for each in wrong:
        print(f"{given.page}:{each.line} shows\n{each.shown}but prints\n{each.printed}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
