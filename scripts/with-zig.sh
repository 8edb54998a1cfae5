#!/usr/bin/env bash
# Runs a command with zig as the linker of a target, named as Rust does: with-zig.sh TARGET COMMAND... cargo-zigbuild and
# maturin would each name a linker of their own, and cargo compiles everything again where the linker is another.
set -eu
target=$1
shift
case "$target" in
*-linux-gnu) zig=${target%%-*}-linux-gnu.2.17 ;; # the glibc of manylinux2014
*-linux-musl) zig=${target%%-*}-linux-musl ;;
*-windows-gnu) zig=${target%%-*}-windows-gnu ;;
*-apple-darwin)
    # The oldest system that the name of the wheel promises; zig by itself asks for a newer one.
    export MACOSX_DEPLOYMENT_TARGET=${MACOSX_DEPLOYMENT_TARGET:-11.0}
    zig=${target%%-*}-macos.$MACOSX_DEPLOYMENT_TARGET-none
    ;;
*) echo "with-zig.sh: $target is not a target that zig links here" >&2 && exit 1 ;;
esac
name=CARGO_TARGET_$(tr a-z- A-Z_ <<<"$target")_LINKER
if [ -z "${!name:-}" ]; then
    folder=${CARGO_TARGET_DIR:-$(dirname "$0")/../target}/zig
    mkdir -p "$folder"
    folder=$(cd "$folder" && pwd)
    linker=$folder/$target
    # maturin 1.16 asks Windows for PyInit_clubface._core, where the module _core has PyInit__core.
    printf '#!/bin/sh\nsed -i s/PyInit_clubface._core/PyInit__core/ %s/../maturin/*.def 2>/dev/null\n' "$folder" >"$linker"
    printf 'exec cargo-zigbuild zig cc -- -g -fno-sanitize=all -target %s "$@"\n' "$zig" >>"$linker"
    chmod +x "$linker"
    export "$name=$linker"
fi
exec "$@"
