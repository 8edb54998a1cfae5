"""Reduce pictures of the studio to few colours: ``python docs/figures/studio.py FOLDER``, for `make studio-figures`."""

import sys
from pathlib import Path

from PIL import Image

COLOURS = 256


def main(folder: str) -> None:
    """Write each picture of the folder next to this file."""
    for path in sorted(Path(folder).glob("studio-*.png")):
        with Image.open(path) as picture:
            reduced = picture.convert("RGB").quantize(COLOURS, dither=Image.Dither.NONE)
        reduced.save(Path(__file__).with_name(path.name), optimize=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
