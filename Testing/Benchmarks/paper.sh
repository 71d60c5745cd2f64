#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Builds the programs that repeat the paper's experiments, and runs them. See help below, or paper.sh --help.
set -uo pipefail
program=paper.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${AHD_BUILD_DIR:-$root/build/paper}
logs=$build/logs
. "$root/.ci/setup.sh"

help() {
  cat <<'EOF'
Testing/Benchmarks/paper.sh [--quick | sizes...] [--no-peers | --only-peers] [--resume] [--rounds=N]
                            [--out=FOLDER] [-DNAME=VALUE...]

Repeats the experiments of Su et al., Computers & Graphics 54 (2016), on one core: Tables 2 to 6 with RG, MG,
HG, HG with control points at every level, our default and CGAL, each result certified; ablations; and
the peers, other libraries on the same files (peers/peers.py). Writes Results.json (all numbers) and
Results.md (tables, and sentences computed from them) and updates the table in README.md.
Without sizes: the paper's, 2e6 4e6 6e6 8e6 1e7, about an hour, and hours more for the peers. The machine should
do nothing else meanwhile.

--quick       2e5 points, few rounds: two minutes, and numbers that only show that all is measured
sizes         numbers of points, such as 2e5 1e6
--no-peers    without other libraries (which are fetched from PyPI into a venv in the build folder): those there stay
--only-peers  only them, into the results there are
--resume      keeps what this build has measured on this machine before it was stopped
--rounds=N    measurements of each (default: 5, in the ablations 9)
--out=FOLDER  where Results.* go. Default: Testing/Benchmarks, where the published ones are; for
              --quick or sizes of your own: build/paper/results
-D...         go to CMake

Installs no packages: what is missing is named.
exit code    0 measured and certified, 1 something is missing or failed
environment  AHD_BUILD_DIR: the folder to build in (default: build/paper)
             AHD_DATA: a folder with real data for the peers (see peers.py --help)
EOF
}

out=
trial=
settings=()
options=()
for argument in "$@"; do
  case $argument in
    -h | --help) help && exit 0 ;;
    -D*) settings+=("$argument") ;;
    --quick) trial=yes && options+=("$argument") ;;
    --no-peers | --only-peers | --resume | --rounds=*) options+=("$argument") ;;
    --out=*) out=${argument#--out=} ;;
    [1-9]*) trial=yes && options+=("$argument") ;;
    *) fail 1 "unknown option: $argument. See --help." ;;
  esac
done
if [ -z "$out" ]; then
  out=$root/Testing/Benchmarks
  [ -z "$trial" ] || out=$build/results
fi

if command -v dpkg-query >/dev/null; then
  missing=$(missing_packages g++ cmake ninja-build libbenchmark-dev libcgal-dev libgmp-dev libmpfr-dev \
    libgtest-dev python3 python3-venv)
  [ -z "$missing" ] || fail 1 "packages are missing:" "apt-get install --no-install-recommends $missing"
fi

mkdir -p "$logs"
cmake -S "$root/Testing/Benchmarks" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  ${settings[@]+"${settings[@]}"} >"$logs/configure.log" 2>&1 ||
  fail 1 "CMake could not configure the benchmarks: see $logs/configure.log"
step "Building in $build" build-benchmarks cmake --build "$build" --target Benchmarks ||
  fail 1 "the benchmarks could not be built."

exec python3 "$root/Testing/Benchmarks/paper.py" --program "$build/PaperExperiments" --out "$out" \
  --peers-work "$build/peers" ${options[@]+"${options[@]}"}
