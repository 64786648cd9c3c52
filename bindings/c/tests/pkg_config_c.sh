#!/bin/sh
# pkg_config_c.sh COMPILER LIBDIR SOURCE OUTPUT: builds and runs SOURCE with what pkg-config says.
set -eu
compiler=$1 libdir=$2 source=$3 output=$4
export PKG_CONFIG_PATH="$libdir/pkgconfig"
# The flags are words to be split.
# shellcheck disable=SC2046
"$compiler" -std=c11 -Wall -Wextra -Wpedantic -Werror "$source" -o "$output" $(pkg-config --cflags --libs slamicp-c)
LD_LIBRARY_PATH="$libdir" "$output"
