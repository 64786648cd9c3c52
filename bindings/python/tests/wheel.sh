#!/usr/bin/env bash
# wheel.sh PYTHON BUILD VENV CMAKE_OPTION...: builds the wheel from the project's root as a user does (pip, the backend and
# nanobind from PyPI), in the folder BUILD, and installs it into VENV, a clean one. Exit status 77: PyPI is not to be reached.
set -euo pipefail
python=$1 build=$2 venv=$3
shift 3
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_ROOT_USER_ACTION=ignore PIP_NO_COMPILE=1
# What the build before has compiled with the same options is not compiled again.
export CCACHE_BASEDIR=$PWD CCACHE_NOHASHDIR=1

rm -rf "$venv" "$build/wheels"
"$python" -m venv "$venv"
if ! "$venv/bin/pip" install --quiet numpy pytest matplotlib; then
  echo "skipped: PyPI cannot be reached" >&2
  if [[ ${CI:-} == true ]]; then exit 1; fi
  exit 77
fi
"$venv/bin/pip" wheel --quiet --no-deps --wheel-dir "$build/wheels" --config-settings build-dir="$build" \
  "${@/#/--config-settings=cmake.define.}" .
"$venv/bin/pip" install --quiet --no-index --no-deps "$build"/wheels/slamicp-*.whl
"$venv/bin/python" -c 'import slamicp; print("slamicp", slamicp.__version__, "in", slamicp.__file__)'
