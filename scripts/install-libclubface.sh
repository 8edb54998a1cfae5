#!/usr/bin/env bash
# Installs the C library into a folder: shared library and archive, header, and the files by which pkg-config and CMake
# find them. The folder may be moved afterwards.
#
#     scripts/install-libclubface.sh PREFIX [FOLDER]
#
# FOLDER holds libraries that were built already; without it, cargo builds them. DESTDIR, for packages, goes before
# PREFIX.
set -eu
[ $# -ge 1 ] || { echo "usage: $0 PREFIX [FOLDER]" >&2; exit 2; }
here=$(cd "$(dirname "$0")/.." && pwd)
crate=$here/crates/clubface-c
mkdir -p "${DESTDIR:-}$1"
prefix=$(cd "${DESTDIR:-}$1" && pwd)
[ $# -lt 2 ] || built=$(cd "$2" && pwd)
cd "$here"

if [ $# -lt 2 ]; then
    cargo build --release --locked --package clubface-c
    built=${CARGO_TARGET_DIR:-target}/release
fi
version=$(sed -n '/^\[workspace.package\]/,/^$/s/^version *= *"\(.*\)"/\1/p' Cargo.toml)
interface=$(sed -n 's/.*CLUBFACE_ABI: u32 = \([0-9]*\);/\1/p' "$crate/src/abi.rs")
# What a program has to link with the archive, as the compiler itself names it.
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
libraries=$(echo | rustc --crate-type staticlib --print native-static-libs -o "$scratch/empty.a" - 2>&1 |
    sed -n 's/^note: native-static-libs: *//p')
case $(uname -s) in
    Darwin) plain=libclubface.dylib named=libclubface.$interface.dylib file=libclubface.$interface.0.0.dylib ;;
    *) plain=libclubface.so named=libclubface.so.$interface file=libclubface.so.$interface.0.0 ;;
esac

fill() {
    sed -e "s|@VERSION@|$version|g" -e "s|@FILE@|$file|g" -e "s|@SONAME@|$named|g" \
        -e "s|@SYSTEM_LIBRARIES@|$libraries|g" -e "s|@SYSTEM_LIST@|${libraries// /;}|g" \
        "$crate/packaging/$1.in" >"$2/$1"
}

mkdir -p "$prefix/include" "$prefix/lib/pkgconfig" "$prefix/lib/cmake/clubface"
cp "$crate/include/clubface.h" "$prefix/include/"
cp "$built/libclubface.a" "$prefix/lib/"
rm -f "$prefix/lib/$file"
cp "$built/$plain" "$prefix/lib/$file"
ln -sf "$file" "$prefix/lib/$named"
ln -sf "$named" "$prefix/lib/$plain"
fill clubface.pc "$prefix/lib/pkgconfig"
fill clubface-config.cmake "$prefix/lib/cmake/clubface"
fill clubface-config-version.cmake "$prefix/lib/cmake/clubface"
echo "libclubface $version in $prefix"
