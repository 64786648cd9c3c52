# shellcheck shell=bash disable=SC2034  # what is unused here is used by the scripts
# What the scripts share; they source it from the project's root.

PATH="$PATH:/usr/local/sbin:/usr/sbin:/sbin"  # dpkg's helpers live there
jobs=$(nproc)

# What one build has compiled another one need not, though it lies in another folder.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1

say() { printf '%s\n' "$*"; }
complain() { printf '%s\n' "$*" >&2; }

# What each task needs: Debian's package name, and why.
needs_for_build="
g++                  the compiler
cmake                configures the build
ninja-build          runs the build
pkg-config           finds what reads and draws files: Cairo, SQLite, lz4, ...
libeigen3-dev        linear algebra, all that the core needs
libhwy-dev           vectorizes the match in the plane: headers only, nothing to link
libcairo2-dev        pictures, SVG and PNG
libpng-dev           reads map_server maps whose image is PNG
liblz4-dev           reads bags packed with lz4
libbz2-dev           reads bags packed with bzip2
zlib1g-dev           reads logs packed with gzip
liblzma-dev          reads logs packed with xz
libzstd-dev          reads logs packed with zstd
libcli11-dev         the command line
nlohmann-json3-dev   --json summaries
libyaml-cpp-dev      --config files, metadata.yaml of rosbag2, map_server maps
libsqlite3-dev       reads rosbag2
libfastcdr-dev       reads messages of ROS 2
"
needs_for_tests="
libgtest-dev         unit tests
librapidcheck-dev    property tests
python3              the test of the include graph
python3-yaml         an independent reader of map_server maps ...
python3-pil          ... and of their images
python3-rosbag       an independent reader and writer of ROS 1 bags ...
python3-sensor-msgs  ... with the messages that logs are made of
python3-nav-msgs     ... of odometry
python3-tf2-msgs     ... and of frames
ccache               saves compiling the same twice
libnanoflann-dev     slamicp-bench: the tree of the paper's agents
libbenchmark-dev     micro-benchmarks
octave-dev           SLAMICP in Octave ...
gnuplot-nox          ... whose examples draw ...
fonts-freefont-otf   ... and write ...
ghostscript          ... into PNG files
python3-venv         a clean Python for the wheel ...
python3-dev          ... and what it is compiled with
"
# Where npm does not come with Node.js, as it does outside Debian.
command -v npm >/dev/null || needs_for_tests+="npm                  fetches what else writes MCAP, to compare
"
needs_for_ros="
libroscpp-dev        slamicp_node for ROS 1 ...
libsensor-msgs-dev   ... and its messages: scans, clouds
libnav-msgs-dev      ... maps, odometry
libgeometry-msgs-dev ... poses
libtf2-msgs-dev      ... frames
libvisualization-msgs-dev ... markers
libdiagnostic-msgs-dev ... diagnostics
libstd-srvs-dev      ... and services
ros-message-generation makes headers of its own messages ...
ros-std-msgs         ... which have headers of these
python3-roslaunch    the master that tests run it with ...
rosout               ... and what the master starts
python3-rospy        robots of tests
python3-rosbag       that play recordings
python3-sensor-msgs  and hear what the node says
python3-nav-msgs     the same
python3-tf2-msgs     the same
python3-visualization-msgs the same
python3-diagnostic-msgs the same
python3-std-srvs     the same
"
needs_for_dds="
cyclonedds-dev       slamicp_dds for ROS 2 machines ...
cyclonedds-tools     ... and its messages
libfastrtps-dev      another vendor's DDS, to test it against
"
needs_for_clang="
clang                the second compiler
libclang-rt-14-dev   its fuzzer and sanitizers
"
needs_for_tidy="
clang                headers for clang-tidy
clang-tidy           static analysis
clang-format         layout of the sources
git                  which files have changed
"

needs_for_windows="
g++-mingw-w64-x86-64-posix  compiles for Windows
libz-mingw-w64-dev   reads logs packed with gzip there
wine64               runs what was compiled
googletest           GoogleTest's sources
"
needs_for_arm64="
g++-aarch64-linux-gnu  compiles for 64-bit ARM
qemu-user            runs what was compiled
googletest           GoogleTest's sources
"
needs_for_armhf="
clang                compiles for 32-bit ARM ...
libstdc++-12-dev-armhf-cross  ... with its headers
"
needs_for_packages="
dpkg-dev             which libraries a package needs
file                 which files are programs
fakeroot             packages belong to root
help2man             manual pages
lintian              what is wrong with a package
mmdebstrap           a clean root to try them in
zip                  packs what is for Windows
git                  which files are the sources
"

missing_of() {
  local package _reason
  while read -r package _reason; do
    [[ -z $package ]] && continue
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || say "$package"
  done <<<"$1"
}

# fetch_ahead "NAME  REASON..."...: where time is short, what later steps install is downloaded while this one goes on.
fetching=""
fetch_ahead() {
  [[ ${CI:-} == true && $(id -u) == 0 ]] && command -v apt-get >/dev/null || return 0
  local missing
  missing=$(for needs in "$@"; do missing_of "$needs"; done)
  [[ -n $missing ]] || return 0
  # shellcheck disable=SC2086  # one word a package
  apt-get -qq install -y --no-install-recommends --download-only $missing </dev/null >/dev/null 2>&1 &
  fetching=$!
}

# need "NAME  REASON...": installs the packages named, where they are not there yet. Returns 1 where it cannot.
need() {
  local missing package root=()
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    complain "There is no apt-get here. Please see to it that these are installed (Debian's names):$1"
    return 1
  fi
  missing=$(missing_of "$1")
  [[ -z $missing ]] && return 0
  if [[ -n $fetching ]]; then
    wait "$fetching" || true  # what it could not fetch is fetched now
    fetching=""
  fi

  for package in $missing; do
    say "installing $(grep -E "^${package//+/\\+} " <<<"$1")"
  done
  if [[ $(id -u) != 0 ]]; then
    if ! command -v sudo >/dev/null; then
      complain "Only root may install. Please run: apt-get install ${missing//$'\n'/ }"
      return 1
    fi
    root=(sudo)
  fi
  local apt=("${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300)
  if [[ ${CI:-} == true ]]; then apt+=(-o Dpkg::Options::=--force-unsafe-io); fi  # a machine that is thrown away
  "${apt[@]}" update </dev/null || true
  # shellcheck disable=SC2086  # one word a package
  "${apt[@]}" install -y --no-install-recommends $missing </dev/null >/dev/null
}

# configure_release [CMAKE_OPTION...]: the first time without tests, which need more packages, and several sources as
# one, which takes half the time; scripts/test chooses anew, and then it stays so.
# shellcheck disable=SC2120
configure_release() {
  local first=()
  [[ -f build/release/CMakeCache.txt ]] || first=(-DSLAMICP_BUILD_TESTS=OFF -DCMAKE_UNITY_BUILD=ON)
  configure release "${first[@]}" "$@"
}

# configure PRESET [CMAKE_OPTION...]: quiet, unless it fails.
configure() {
  local log=build/$1-configure.log
  mkdir -p build
  if ! cmake --preset "$@" >"$log" 2>&1; then
    cat "$log" >&2
    return 1
  fi
  grep -A5 -i warning "$log" >&2 || true
}

# build PRESET [TARGET...]
build() {
  local preset=$1
  shift
  cmake --build --preset "$preset" --parallel "$jobs" ${1:+--target "$@"}
}
