#!/bin/sh
# symbols.sh NM LIBRARY HEADER: what the library exports is what the header declares, each under a version.
set -eu
nm=$1 library=$2 header=$3
# Sanitizers and code coverage add symbols of their own.
exported=$("$nm" -D --defined-only "$library" | awk '$2 != "A" {print $3}' | grep -v -E '^(__|_)' | sort)
declared=$(grep -E -o '^SLAMICP_API .*' "$header" | sed -E 's/.*[ *](slamicp_[a-z_]+)\(.*/\1@@SLAMICP_1/' | sort)
if [ "$exported" != "$declared" ]; then
  printf 'exported:\n%s\ndeclared:\n%s\n' "$exported" "$declared"
  exit 1
fi
