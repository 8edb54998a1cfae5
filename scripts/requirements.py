"""Print the requirements of some extras of pyproject.toml, one a line: pip installs them while the core compiles.

``python scripts/requirements.py excel plots`` prints those of the package itself and of the extras named.
"""

import sys
import tomllib
from pathlib import Path

PROJECT = tomllib.loads((Path(__file__).parent.parent / "pyproject.toml").read_text(encoding="utf-8"))["project"]

print(
    *PROJECT["dependencies"],
    *(line for extra in sys.argv[1:] for line in PROJECT["optional-dependencies"][extra]),
    sep="\n",
)
