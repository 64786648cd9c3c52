#!/bin/sh
# pkg_config.sh COMPILER LIBDIR SOURCE OUTPUT: builds and runs SOURCE with what pkg-config says, no CMake about.
set -eu
compiler=$1 libdir=$2 source=$3 output=$4
export PKG_CONFIG_PATH="$libdir/pkgconfig"

# The flags are words to be split.
# shellcheck disable=SC2046
"$compiler" -std=c++20 "$source" -o "$output-core" $(pkg-config --cflags --libs slamicp-core)
# shellcheck disable=SC2046
"$compiler" -std=c++20 -DUSE_IO "$source" -o "$output-io" $(pkg-config --cflags --libs slamicp-io)

LD_LIBRARY_PATH="$libdir" "$output-core"
LD_LIBRARY_PATH="$libdir" "$output-io"
