#!/usr/bin/env bash
# clean_root.sh DEBS: a clean Debian that has a compiler and our packages from the folder DEBS, nothing else of ours.
# README's C++ example is built there and run, by CMake and by pkg-config, with shared and with static libraries; C and
# Python too. Needs root and mmdebstrap. The clean Debian is kept in build/clean-root.tar: the next time no mirror is
# asked.
set -euo pipefail
debs=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tar=$PWD/build/clean-root.tar root=$PWD/build/clean-root
suite=bookworm
# Where this machine's own packages come from.
mirror=${SLAMICP_DEBIAN_MIRROR:-$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | sed -n 1p)}
export DEBIAN_FRONTEND=noninteractive LC_ALL=C

if ! compgen -G "$debs/libslamicp-dev_*.deb" >/dev/null; then
  echo "There are no packages in $debs: run scripts/package deb first." >&2
  exit 1
fi

# What our packages need of Debian, and what builds a program.
packages_of_debian() {
  printf '%s\n' g++ cmake ninja-build pkg-config
  for package in "$debs"/*.deb; do dpkg-deb -f "$package" Depends; done | tr ',' '\n' |
    sed -E 's/^ *([a-z0-9.+-]+).*/\1/' | grep -vE '^(lib|python3-)?slamicp'
}
wanted=$(packages_of_debian | sort -u | paste -sd,)

if [[ ! -f $tar || $(cat "$tar.packages" 2>/dev/null) != "$wanted" ]]; then
  echo "making a clean Debian $suite from $mirror"
  rm -rf "$root"
  if ! mmdebstrap --variant=minbase --dpkgopt=force-unsafe-io --include="$wanted" "$suite" "$tar.part.tar" "$mirror" \
    >build/clean-root.log 2>&1; then
    tail -5 build/clean-root.log >&2
    echo "No clean Debian: mmdebstrap could not make one from $mirror (build/clean-root.log)." >&2
    exit 1
  fi
  mv "$tar.part.tar" "$tar"
  echo "$wanted" >"$tar.packages"
fi
rm -rf "$root"
mkdir "$root"
tar -C "$root" -xf "$tar"

mkdir "$root/work"
cp "$debs"/*.deb examples/localize_log.cpp examples/align_clouds.cpp bindings/c/examples/localize.c "$root/work"
cat >"$root/work/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.22)
project(robot LANGUAGES C CXX)
find_package(slamicp 0.1 REQUIRED COMPONENTS core io c)
add_executable(robot localize_log.cpp)
target_link_libraries(robot PRIVATE slamicp::io)
add_executable(robot_c localize.c)
target_link_libraries(robot_c PRIVATE slamicp::c m)
CMAKE
cat >"$root/work/run.sh" <<'RUN'
set -eux
cd /work
dpkg -i ./*.deb
slamicp --version
slamicp simulate --out run.clf --map-out map.pcd --obstacle A1 --speed 0.55
# By CMake: shared.
cmake -G Ninja -S . -B build -DCMAKE_BUILD_TYPE=Release
cmake --build build
./build/robot map.pcd run.clf 5.9 -4.2 1.5558 | tail -3 | tee shared.txt
./build/robot_c
ldd build/robot | grep -q libslamicp_core.so
# By pkg-config: the same, and with our libraries static.
g++ -std=c++20 -O1 localize_log.cpp -o robot_shared $(pkg-config --cflags --libs slamicp-io)
./robot_shared map.pcd run.clf 5.9 -4.2 1.5558 | tail -3 | cmp - shared.txt
g++ -std=c++20 -O1 align_clouds.cpp -o robot_static $(pkg-config --cflags slamicp-core) -l:libslamicp_core.a
./robot_static
if ldd robot_static | grep slamicp; then exit 1; fi
gcc -std=c11 localize.c -o robot_c $(pkg-config --cflags --libs slamicp-c) -lm
./robot_c
python3 -c 'import slamicp, numpy; print(slamicp.__version__, slamicp.Map(numpy.zeros((3, 2))))'
grep -q "ends at 1[67]\." shared.txt
dpkg -P $(dpkg-query -W -f='${Package} ' '*slamicp*')
test ! -e /usr/bin/slamicp
RUN
chroot "$root" sh /work/run.sh >build/clean-root-run.log 2>&1 || { tail -30 build/clean-root-run.log >&2; exit 1; }
tail -12 "$root/work/shared.txt"
rm -rf "$root"
echo "The packages work in a clean Debian $suite: build/clean-root-run.log"
