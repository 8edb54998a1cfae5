#!/usr/bin/env bash
# Prints the path of a Chromium for the tests of the studio: that of CHROMIUM, one of this machine, or Debian's package,
# which the administrator's account gets installed.
set -u
for candidate in "${CHROMIUM:-}" chromium chromium-browser google-chrome; do
    [ -n "$candidate" ] && command -v "$candidate" && exit 0
done
if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    { apt-get update && apt-get install --yes --no-install-recommends chromium; } >&2 && command -v chromium && exit 0
fi
echo "The tests of the studio need Chromium: install it (Debian: chromium), or name a browser by CHROMIUM=/path." >&2
exit 1
