#!/usr/bin/env bash
# Builds the native library of units for co-simulation (FMI) and puts it into the package: fmi-library.sh PROFILE [TARGET].
# For another machine, which TARGET names as Rust does, zig links.
set -eu
cd "$(dirname "$0")/.."
profile=$1
target=${2:-}
cargo=(cargo rustc)
if [ -n "$target" ]; then
    cargo=(scripts/with-zig.sh "$target" cargo-zigbuild rustc --target "$target")
fi
"${cargo[@]}" --profile "$profile" --locked --quiet --package clubface-fmi --crate-type cdylib -- -C strip=symbols
mkdir -p python/clubface/export/native
for name in libclubface_fmi.so libclubface_fmi.dylib clubface_fmi.dll; do
    built="${CARGO_TARGET_DIR:-target}/${target:+$target/}$profile/$name"
    [ ! -f "$built" ] || cp "$built" "python/clubface/export/native/${name#lib}"
done
