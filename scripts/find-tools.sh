#!/usr/bin/env bash
# Prints the Python to build with. Of each tool that is missing, says in one line what to install, and fails.
set -u
cd "$(dirname "$0")/.." || exit 1
missing=0

lack() {
    echo "clubface: $*" >&2
    missing=1
}

python=""
for candidate in python3 python3.14 python3.13 python3.12 python3.11; do
    if "$candidate" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null; then
        python=$candidate
        break
    fi
done
if [ -z "$python" ]; then
    lack "Python 3.11 or newer is missing: install it from https://www.python.org or your system's packages (python3)."
elif ! "$python" -c 'import ensurepip, venv' 2>/dev/null; then
    lack "$python cannot make virtual environments: install your system's package python3-venv."
fi

command -v make >/dev/null || lack "make is missing: install GNU make from your system's packages."
command -v cc >/dev/null || lack "a C linker (cc) is missing: install gcc or clang from your system's packages."

if ! rustc --version >/dev/null 2>&1 || ! cargo --version >/dev/null 2>&1; then
    lack "Rust (cargo) is missing: install it from https://rustup.rs."
else
    wanted=$(sed -n 's/^rust-version *= *"\(.*\)".*/\1/p' Cargo.toml)
    found=$(rustc --version | cut -d ' ' -f 2)
    if [ -n "$wanted" ] && [ "$(printf '%s\n%s\n' "$wanted" "$found" | sort -V | head -n 1)" != "$wanted" ]; then
        lack "Rust $found is too old, $wanted or newer is needed: run \`rustup update stable\` or install it from https://rustup.rs."
    fi
fi

[ "$missing" = 0 ] && echo "$python"
exit "$missing"
