"""What all tests need."""

from __future__ import annotations

import signal

# A test run started in the background inherits an ignored interrupt, and passes that on to the commands it starts: then
# Ctrl-C would reach nobody. The handler of an interactive run is what the tests of interruption mean.
signal.signal(signal.SIGINT, signal.default_int_handler)
