#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the benchmarks and measures every target of speed. See help below, or speed.sh --help.
set -uo pipefail
program=speed.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${AHD_BUILD_DIR:-$root/build/benchmarks}
logs=$build/logs
. "$root/.ci/setup.sh"

help() {
  cat <<'EOF'
Testing/Benchmarks/speed.sh [--quick] [--scaling] [--only WORD] [--write] [-DNAME=VALUE...]

Builds the benchmarks in build/benchmarks, as shipped (Release, for every x86-64), runs them, and
prints tables and, last, one line a target:  ok|short  name  value  target
Takes about 40 minutes on two cores. The machine should do nothing else meanwhile.

--quick      few points: a minute, and numbers that only show that all is measured
--only WORD  only the targets in whose line it is
--write      the tables go into Testing/Benchmarks/Speed.md (and .json), and a line into README.md
--scaling    no times, only how the insertion is shared by 2 to 64 threads, counted
-D...        go to CMake

Installs nothing: what is missing is named. Without ParaView's or VTK's development files all is
measured but the filter.
exit code    0 measured, 1 something is missing or failed
environment  AHD_BUILD_DIR: the folder to build in (default: build/benchmarks)
EOF
}

settings=()
options=()
write=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) help && exit 0 ;;
    -D*) settings+=("$1") ;;
    --quick | --scaling) options+=("$1") ;;
    --only) options+=("$1" "${2:?a word, see --help}") && shift ;;
    --write) write=yes options+=(--out "$root/Testing/Benchmarks") ;;
    *) fail 1 "unknown option: $1. See --help." ;;
  esac
  shift
done

if command -v dpkg-query >/dev/null; then
  missing=$(missing_packages g++ cmake ninja-build libbenchmark-dev libcgal-dev libgmp-dev libmpfr-dev python3)
  [ -z "$missing" ] || fail 1 "packages are missing:" "apt-get install --no-install-recommends $missing"
  missing=$(missing_packages paraview-dev libgtest-dev)
  [ -z "$missing" ] || printf 'The filter may not be measured: missing are %s\n' "$missing"
fi

# configure <source folder> <settings>...: quietly; a configured folder stays unchanged
configure() {
  local source=$1
  shift
  cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@" \
    ${settings[@]+"${settings[@]}"} >"$logs/configure.log" 2>&1 && return
  rm -rf "$build/CMakeCache.txt" "$build/CMakeFiles"
  return 1
}

# With ParaView's VTK, or VTK alone, or neither.
configure_any() {
  local whole=(-DBUILD_TESTING=ON -DAHD_WRAP_PYTHON=OFF -DAHD_GUI_TESTS=OFF)
  if [ -f "$build/CMakeCache.txt" ]; then
    configure "$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")" && return
  fi
  configure "$root" "${whole[@]}" -DAHD_BUILD_PARAVIEW_PLUGIN=ON ||
    configure "$root" "${whole[@]}" -DAHD_BUILD_PARAVIEW_PLUGIN=OFF ||
    configure "$root/Testing/Benchmarks"
}

mkdir -p "$logs"
configure_any || fail 1 "CMake could not configure the benchmarks: see $logs/configure.log"
step "Building in $build" build-benchmarks cmake --build "$build" --target Benchmarks ||
  fail 1 "the benchmarks could not be built."

# where_is <program>: in the project's build, or in that of the benchmarks alone
where_is() {
  local file
  for file in "$build/bin/$1" "$build/$1"; do
    [ ! -x "$file" ] || { printf '%s' "$file" && return; }
  done
}

# The engine of an old commit, against which one row is measured; empty if it is not available.
build_before() {
  local commit folder=$build/before
  commit=$(sed -n 's/^BEFORE = "\([0-9a-f]*\)".*/\1/p' "$root/Testing/Benchmarks/speed_rows.py")
  if [ ! -x "$folder/build/EngineBenchmark" ]; then
    git -C "$root" cat-file -e "$commit" 2>/dev/null || return
    mkdir -p "$folder/source" && git -C "$root" archive "$commit" | tar -x -C "$folder/source" &&
      cmake -S "$folder/source/Testing/Benchmarks" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release &&
      cmake --build "$folder/build" --target EngineBenchmark
  fi >"$logs/before.log" 2>&1
  find "$folder/build" -name EngineBenchmark -type f -perm -u+x | head -n 1
}
before=$(build_before)
filter=$(where_is FilterBenchmark)
python3 "$root/Testing/Benchmarks/speed.py" --engine "$(where_is EngineBenchmark)" \
  --counts "$(where_is EngineCounts)" --constraints "$(where_is ConstraintBenchmark)" \
  ${filter:+--filter "$filter"} ${before:+--before "$before"} ${options[@]+"${options[@]}"} || exit
[ -z "$write" ] || exec python3 "$root/Testing/Benchmarks/speed.py" --render
