"""``python -m clubface``: the command line."""

from clubface.cli import main

main()
