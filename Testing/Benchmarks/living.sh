#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds LivingBenchmark and measures simplified, refined and edited surfaces beside others. See help below.
set -uo pipefail
program=living.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${AHD_BUILD_DIR:-$root/build/living}
logs=$build/logs
. "$root/.ci/setup.sh"

if [ "${1:-}" = --help ] || [ "${1:-}" = -h ]; then
  cat <<'EOF'
Testing/Benchmarks/living.sh [--write] [options of living.py: --quick, --only WORD, --data FOLDER, ...]

Builds the engine and LivingBenchmark in build/living, as shipped, without VTK, and calls living.py: under 15 minutes
on one core. The machine should do nothing else meanwhile. Installs nothing but PyPI's libraries, in a venv there.

--write      the tables go into Testing/Benchmarks/Living.md
environment  AHD_BUILD_DIR: the folder to build in (default: build/living)
             AHD_DATA: a folder with lidar.csv, soundings.csv, coastline.csv, sweden.txt
EOF
  exit 0
fi
options=()
for word in "$@"; do
  if [ "$word" = --write ]; then options+=(--out "$root/Testing/Benchmarks/Living.md"); else options+=("$word"); fi
done

missing=$(missing_packages g++ cmake ninja-build libbenchmark-dev libcgal-dev libgmp-dev libmpfr-dev python3 python3-venv)
[ -z "$missing" ] || fail 1 "packages are missing:" "apt-get install --no-install-recommends $missing"
mkdir -p "$logs"
cmake -S "$root/Testing/Benchmarks" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release >"$logs/configure.log" 2>&1 ||
  fail 1 "CMake could not configure the benchmarks: see $logs/configure.log"
step "Building in $build" build-living cmake --build "$build" --target LivingBenchmark ||
  fail 1 "the benchmark could not be built."
exec python3 -B "$root/Testing/Benchmarks/living.py" --program "$build/LivingBenchmark" --work "$build" \
  ${options[@]+"${options[@]}"}
