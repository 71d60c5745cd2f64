#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# refused.sh [compiler]: does the engine refuse to compile where arithmetic would not be as written, with a clear
# message? And does it compile elsewhere?
set -uo pipefail
header=$(dirname "${BASH_SOURCE[0]}")/../../Filters/Engine/Predicates/Filters.h
compiler=${1:-g++}
status=0

# compile <flags>...
# Prints the first error.
compile() {
  "$compiler" -std=c++17 -fsyntax-only -x c++ "$@" "$header" 2>&1 | grep 'error' | head -n 1 || true
}

refused=(-ffast-math -Ofast -ffinite-math-only)
if ! "$compiler" --version | grep -q clang; then
  refused+=(-funsafe-math-optimizations -mfpmath=387) # clang lacks the one, and does not define a macro for the other
fi
for flag in "${refused[@]}"; do
  error=$(compile "$flag")
  if [[ $error != *'Compile the engine'* ]]; then
    printf '%s %s is not refused: %s\n' "$compiler" "$flag" "${error:-no error}"
    status=1
  fi
done
for flag in -O0 -O3 -march=native; do
  error=$(compile "$flag")
  if [ -n "$error" ]; then
    printf '%s %s is refused: %s\n' "$compiler" "$flag" "$error"
    status=1
  fi
done
exit $status
