#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the fuzz targets and runs them. See help below, or ./Testing/Fuzz/fuzz.sh --help.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)

help() {
  cat <<'EOT'
Testing/Fuzz/fuzz.sh [options] [-- CMake's own options for the first build]

Builds the fuzz targets with clang and the address and undefined-behaviour sanitizers, runs what is in
Data/Corpus, then goes on with mutations of it.

--minutes N     for how long, all targets together (default: 60); --seconds N likewise
--target NAME   engine, constraints, filter or lifetime; can be repeated (default: all that were built)
--folder DIR    where to build and keep what is found (default: build/fuzz)
--seed N        begin with this random number (default: another one each time)
--small         fuzz an engine that does for a few points what it else does for tens of thousands: shares
                them among threads, sorts in several passes, asks whether to stop (SmallThresholds.cmake)
--build         build only; --built: do not build
--minimise      no fuzzing: write the fewest inputs that reach all that the found ones reach to
                Data/Corpus/Fuzz

What is new stays in DIR/corpus/NAME for the next time; an input on which a target fails, in
DIR/found/NAME. To run one input:  DIR/build/EngineFuzz FILE  (build-small, if --small was given).
exit code  0: nothing found, 1: something was, 2: wrong use
EOT
}

folder=$root/build/fuzz
seconds=3600
seed=0
targets=()
mode=run
variant=build
built=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) help && exit 0 ;;
    --minutes) seconds=$(($2 * 60)) && shift ;;
    --seconds) seconds=$2 && shift ;;
    --target) targets+=("$2") && shift ;;
    --folder) folder=$2 && shift ;;
    --seed) seed=$2 && shift ;;
    --small) variant=build-small ;;
    --build) mode=build ;;
    --built) built=yes ;;
    --minimise) mode=minimise ;;
    --) shift && break ;;
    *) printf 'fuzz.sh: what is %s? See --help\n' "$1" >&2 && exit 2 ;;
  esac
  shift
done

# program <target's name>
program() {
  local name=${1^}
  printf '%s/%sFuzz' "$folder/$variant" "${name/%Constraints/Constraint}"
}

build() {
  local generator=() small=OFF
  [ "$variant" = build ] || small=ON
  if [ ! -f "$folder/$variant/CMakeCache.txt" ]; then
    command -v ninja >/dev/null && generator=(-G Ninja)
    CXX=${CXX:-$(command -v clang++-14 || command -v clang++)}
    export CXX CC=${CC:-${CXX/clang++/clang}}
    cmake -S "$here" -B "$folder/$variant" -DAHD_FUZZ_SMALL=$small \
      ${generator[@]+"${generator[@]}"} "$@"
  fi
  cmake --build "$folder/$variant" --parallel
}

# fuzz <target's name> <seconds>
fuzz() {
  local name=$1 corpus=() seeds=$folder/seeds/$1 longest=4096
  mkdir -p "$folder/corpus/$name" "$folder/found/$name" "$seeds"
  if [ "$name" = filter ]; then
    longest=1024
  elif [ "$name" = lifetime ]; then
    longest=256
  else
    "$folder/$variant/FuzzSeeds" "$root/Data/Corpus" "$seeds"
  fi
  for kept in "$seeds" "$root/Data/Corpus/Fuzz/$name"; do
    [ ! -d "$kept" ] || corpus+=("$kept")
  done
  ASAN_OPTIONS=malloc_context_size=6:quarantine_size_mb=32 UBSAN_OPTIONS=print_stacktrace=1 \
    "$(program "$name")" "$folder/corpus/$name" "${corpus[@]}" \
    -max_total_time="$2" -seed="$seed" -max_len="$longest" -timeout=60 -rss_limit_mb=3000 \
    -artifact_prefix="$folder/found/$name/" -print_final_stats=1 -verbosity=1 -reload=0
}

# minimise <target's name>
minimise() {
  local name=$1 kept=$root/Data/Corpus/Fuzz/$1 fresh=$folder/minimised/$1 seeds=
  [ ! -d "$folder/seeds/$1" ] || seeds=$folder/seeds/$1
  rm -rf "$fresh"
  mkdir -p "$fresh" "$folder/corpus/$name" "$kept"
  # by the lines reached, not by how often: a tenth as many
  "$(program "$name")" -set_cover_merge=1 -use_counters=0 -max_len=4096 -timeout=60 \
    "$fresh" "$kept" "$folder/corpus/$name" ${seeds:+"$seeds"}
  # named files stay
  find "$kept" -type f -regextype posix-extended -regex '.*/[0-9a-f]{40}' -delete
  cp "$fresh"/* "$kept"
}

[ -n "$built" ] || build "$@"
[ "$mode" != build ] || exit 0
if [ ${#targets[@]} -eq 0 ]; then
  for name in engine constraints filter lifetime; do
    [ ! -x "$(program "$name")" ] || targets+=("$name")
  done
fi
status=0
for name in "${targets[@]}"; do
  if [ "$mode" = minimise ]; then
    minimise "$name"
  else
    fuzz "$name" $((seconds / ${#targets[@]})) || status=1
  fi
done
exit $status
