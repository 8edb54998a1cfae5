#!/usr/bin/env bash
# Runs the tests of packs, batches and flights as 64-bit Arm computes them: on such a machine itself, elsewhere by qemu,
# which shows results and not speed. Installs nothing; of each tool that is missing, says what to install, and fails.
set -eu
cd "$(dirname "$0")/.."
target=aarch64-unknown-linux-gnu
missing=0

lack() {
    echo "test-aarch64: $*" >&2
    missing=1
}

options=(--release --locked)
case "$(uname -m)" in
aarch64 | arm64) ;;
*)
    command -v aarch64-linux-gnu-gcc >/dev/null || lack "no linker for 64-bit Arm: install gcc-aarch64-linux-gnu (Debian)."
    command -v qemu-aarch64 >/dev/null || lack "no qemu-aarch64: install qemu-user (Debian)."
    [ -e /usr/aarch64-linux-gnu/lib/libc.so.6 ] || lack "no C library for 64-bit Arm: install libc6-dev-arm64-cross (Debian)."
    [ -d "$(rustc --print sysroot)/lib/rustlib/$target" ] || lack "Rust lacks this target: run \`rustup target add $target\`."
    [ "$missing" = 0 ] || exit 1
    options+=(--target "$target")
    export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
    export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER="qemu-aarch64 -L /usr/aarch64-linux-gnu"
    ;;
esac

cargo test "${options[@]}" --package clubface-math
# What runs in packs against the same shots one by one.
cargo test "${options[@]}" --package clubface-impact --test verification -- lanes batches flight batch_derivatives
