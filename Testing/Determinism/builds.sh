#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the test of the engine's hashes with several compilers and flags, and runs it.
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

help() {
  cat <<'HELP'
builds.sh <folder> [build]...

Builds Testing/Engine/Triangulation/Hashes.cxx with the engine once for each build named (default: all) in a folder
of its own, and runs it: each has to give the hashes of Data/Hashes/Engine.txt. Says at last which did
not, and exits with 1 if any did not.

HELP
  printf 'Builds:\n'
  printf '  %s\n' "${!flags[@]}" | sort
}

declare -A flags=(
  [g++-O0]='-O0'
  [g++-O1]='-O1'
  [g++-O2]='-O2'
  [g++-O3]='-O3'
  [g++-native]='-O3 -march=native'
  [g++-flto]='-O2 -flto=auto -ffat-lto-objects -Wodr -Werror=odr'
  [g++-unroll]='-O3 -funroll-all-loops -fipa-pta'
  [g++-portable]='-O2'
  [clang++-O0]='-O0'
  [clang++-O1]='-O1'
  [clang++-portable]='-O1'
  [clang++-O3]='-O3'
  [clang++-native]='-O3 -march=native'
)

if [ $# -eq 0 ] || [ "$1" = --help ]; then
  help
  exit 0
fi
folder=$1
shift
names=("$@")
[ $# -gt 0 ] || mapfile -t names < <(printf '%s\n' "${!flags[@]}" | sort)

# one <name>
one() {
  local build=$folder/$1
  local portable=OFF # as for a compiler without GCC's extensions
  [[ $1 != *-portable ]] || portable=ON
  cmake -S "$root/Testing/Engine" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DAHD_PORTABLE_ARITHMETIC=$portable \
    -DCMAKE_CXX_COMPILER="${1%%-*}" -DCMAKE_CXX_FLAGS="${flags[$1]}" \
    -DCMAKE_CXX_COMPILER_LAUNCHER="${CMAKE_CXX_COMPILER_LAUNCHER:-}" >"$build.log" 2>&1 &&
    cmake --build "$build" --target EngineHashes >>"$build.log" 2>&1 &&
    "$build/EngineHashes" --gtest_brief=1 --gtest_filter="Hashes.AreThose*" >>"$build.log" 2>&1
}

mkdir -p "$folder"
bad=()
for name in "${names[@]}"; do
  [ -n "${flags[$name]:-}" ] || {
    printf 'builds.sh: no build is called %s; see --help\n' "$name"
    exit 2
  }
  begin=$SECONDS
  if one "$name"; then
    printf '%-20s %4d s  the same hashes\n' "$name" $((SECONDS - begin))
  else
    printf '%-20s %4d s  FAILED; the end of %s.log:\n' "$name" $((SECONDS - begin)) "$folder/$name"
    tail -n 25 "$folder/$name.log"
    bad+=("$name")
  fi
done
[ ${#bad[@]} -eq 0 ] || {
  printf 'Not as in Data/Hashes/Engine.txt: %s\n' "${bad[*]}"
  exit 1
}
