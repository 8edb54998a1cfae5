#!/usr/bin/env bash
# Builds the native library of units for co-simulation (FMI) and puts it into the package: fmi-library.sh PROFILE
set -eu
cd "$(dirname "$0")/.."
cargo rustc --profile "$1" --locked --quiet --package clubface-fmi --crate-type cdylib -- -C strip=symbols
mkdir -p python/clubface/export/native
for name in libclubface_fmi.so libclubface_fmi.dylib clubface_fmi.dll; do
    built="${CARGO_TARGET_DIR:-target}/$1/$name"
    [ ! -f "$built" ] || cp "$built" "python/clubface/export/native/${name#lib}"
done
