"""Print, as JSON, what commands give that a page shows, each typed as it stands there.

``python typed_commands.py COMMANDS.json``: a list of ``clubface shot ...`` commands, run in the folder of the list.
Each shot is its row, SI, by the names of the quantities.
"""

from __future__ import annotations

import json
import os
import shlex
import sys
from pathlib import Path

from command_line import printed, row


def main(path: str) -> None:
    """Run every command."""
    commands = json.loads(Path(path).read_text())
    os.chdir(Path(path).parent)
    json.dump([row(printed(shlex.split(each)[1:], {})) for each in commands], sys.stdout)


if __name__ == "__main__":
    main(*sys.argv[1:])
