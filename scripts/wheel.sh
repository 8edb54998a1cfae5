#!/usr/bin/env bash
# Builds a wheel with the library of units for co-simulation and the built studio in it: wheel.sh PROFILE [TARGET]. For
# another machine, which TARGET names as Rust does, zig links. The variable INTERPRETER names another Python.
set -eu
cd "$(dirname "$0")/.."
profile=$1
target=${2:-}
package=python/clubface
native=$package/export/native
kept=$(mktemp -d)

# A checkout serves the studio that it has built last, and uses the library of its own machine.
restore() {
    rm -rf $package/studio_site
    if [ -n "$target" ]; then
        rm -rf $native
        [ ! -d "$kept/native" ] || cp -R "$kept/native" $native
    fi
    rm -rf "$kept"
}
trap restore EXIT
trap 'exit 130' INT TERM

if [ -n "$target" ]; then
    [ ! -d $native ] || mv $native "$kept/native"
fi
scripts/fmi-library.sh "$profile" "$target"
rm -rf $package/studio_site
cp -R studio/dist $package/studio_site
interpreter=${INTERPRETER:-}
# A name alone, where no interpreter of this machine says which stable interface is meant.
case "$target" in *-windows-* | *-apple-*) interpreter=${interpreter:-python3.11} ;; esac
maturin=(maturin build --profile "$profile" ${interpreter:+--interpreter "$interpreter"})
if [ -n "$target" ]; then
    maturin=(scripts/with-zig.sh "$target" "${maturin[@]}" --target "$target" --zig)
fi
"${maturin[@]}"
