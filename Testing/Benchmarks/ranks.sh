#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Two ranks beside one: builds RanksBenchmark, runs it in turns and prints medians and least times.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

help() {
  cat <<'EOF'
Testing/Benchmarks/ranks.sh [--points N] [--rounds N] [--cpu]

One triangulation of N uniform points (10^7) by the filter: one rank with two threads, one rank with one, two ranks
with one each, in turns, N rounds (5), a new process each time. The machine should do nothing else; it takes about 10 s
a round. With --cpu, CPU time of one thread: what it tells does not depend on what else the machine does, but for
its caches; ranks that wait for each other take CPU time too.

environment  AHD_BUILD_DIR: the project's build folder, configured (default: build)
EOF
}

points=10000000 rounds=5 cpu=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) help && exit 0 ;;
    --points) points=$2 && shift ;;
    --rounds) rounds=$2 && shift ;;
    --cpu) cpu=--cpu ;;
    *) echo "unknown option: $1. See --help." >&2 && exit 1 ;;
  esac
  shift
done
build=${AHD_BUILD_DIR:-$root/build}
cmake --build "$build" --target RanksBenchmark >/dev/null
set -a
. "$root/.ci/mpi.env"
set +a
[ -n "$cpu" ] || unset OMPI_MCA_mpi_yield_when_idle # no time is lost by ranks that wait
lines=$(mktemp)
trap 'rm -f "$lines"' EXIT

# run <ranks> <threads>
run() {
  mpirun --bind-to none -np "$1" "$build/bin/RanksBenchmark" --points="$points" --threads="$2" --runs=1 \
    $cpu >>"$lines"
}

for _ in $(seq "$rounds"); do
  [ -n "$cpu" ] || run 1 2
  run 1 1
  run 2 1
done
python3 "$root/Testing/Benchmarks/ranks.py" "$lines"
