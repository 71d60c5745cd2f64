#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Which lines of Filters/Engine the fuzz corpus reaches. See help below.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

help() {
  cat <<'EOT'
Testing/Fuzz/coverage.sh [--folder DIR] [--tests] [--inputs DIR]...

Compiles the engine with clang's coverage, as shipped and with small thresholds, runs what is in
Data/Corpus through the fuzz targets once, and writes the lines that are not reached to
DIR/coverage-fuzz.txt.

--tests        then the engine's tests too (with fewer points): DIR/coverage-all.txt
--folder DIR   where to build (default: build/fuzz-coverage)
--inputs DIR   further inputs, in DIR/engine and DIR/constraints; can be repeated
EOT
}

folder=$root/build/fuzz-coverage
inputs=("$root/Data/Corpus/Fuzz")
tests=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) help && exit 0 ;;
    --folder) folder=$2 && shift ;;
    --inputs) inputs+=("$2") && shift ;;
    --tests) tests=yes ;;
    *) printf 'coverage.sh: what is %s? See --help\n' "$1" >&2 && exit 2 ;;
  esac
  shift
done
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
testing=$folder/tests
compiler=${CXX:-$(command -v clang++-14 || command -v clang++)}

# tool <name>: llvm's, of the version of the compiler
tool() {
  command -v "$1-14" || command -v "$1"
}
profdata=$(tool llvm-profdata)
cov=$(tool llvm-cov)

# lines <name> <programs>...: from DIR/<name>/*.profraw to DIR/<name>.lcov
lines() {
  local name=$1 program objects=()
  shift
  for program in "$@"; do
    objects+=(-object "$program")
  done
  "$profdata" merge -sparse -o "$folder/$name.profdata" "$folder/$name"/*.profraw
  "$cov" export -format=lcov -instr-profile="$folder/$name.profdata" "${objects[@]}" >"$folder/$name.lcov"
}

# report <name> <lcov files>...
report() {
  local name=$1
  shift
  python3 "$here/uncovered.py" "$root/Filters/Engine" "$@" >"$folder/$name.txt"
  printf '%s: %s\n' "$name" "$(tail -n 1 "$folder/$name.txt")"
}

# fuzz <name of the build> <settings of cmake>
fuzz() {
  local build=$folder/$1 target from files
  cmake -S "$here" -B "$build" -DCMAKE_CXX_COMPILER="$compiler" -DAHD_FUZZ_COVERAGE=ON "$2" >/dev/null
  cmake --build "$build" --parallel
  rm -rf "$folder/seeds" "$folder/profiles-$1"
  mkdir -p "$folder/seeds/engine"
  "$build/FuzzSeeds" "$root/Data/Corpus" "$folder/seeds/engine"
  cp -r "$folder/seeds/engine" "$folder/seeds/constraints"
  for target in engine:EngineFuzz constraints:ConstraintFuzz; do
    files=()
    for from in "$folder/seeds" "${inputs[@]}"; do
      [ ! -d "$from/${target%:*}" ] || files+=("$from/${target%:*}"/*)
    done
    LLVM_PROFILE_FILE=$folder/profiles-$1/%p.profraw "$build/${target#*:}" "${files[@]}" \
      >"$folder/$1-${target%:*}.log" 2>&1
  done
  lines "profiles-$1" "$build/EngineFuzz" "$build/ConstraintFuzz"
}

fuzz build -DAHD_FUZZ_SMALL=OFF
fuzz build-small -DAHD_FUZZ_SMALL=ON
fuzzed=("$folder/profiles-build.lcov" "$folder/profiles-build-small.lcov")
report coverage-fuzz "${fuzzed[@]}"
[ -n "$tests" ] || exit 0

cmake -S "$root/Testing/Engine" -B "$testing" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None \
  -DCMAKE_CXX_FLAGS="-O1 -fprofile-instr-generate -fcoverage-mapping -DAHD_REDUCED_TESTS" >/dev/null
cmake --build "$testing" --parallel
rm -rf "$folder/profiles-tests"
LLVM_PROFILE_FILE=$folder/profiles-tests/%p.profraw ctest --test-dir "$testing" -L engine --output-on-failure
mapfile -t programs < <(find "$testing" -maxdepth 1 -type f -perm -u+x -name 'Engine*')
lines profiles-tests "${programs[@]}"
report coverage-all "${fuzzed[@]}" "$folder/profiles-tests.lcov"
