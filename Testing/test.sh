#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Installs missing packages, builds, and runs the tests. See help below, or ./Testing/test.sh --help.
set -uo pipefail
program=test.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${AHD_BUILD_DIR:-$root/build}
logs=$build/logs
. "$root/.ci/setup.sh"
. "$root/.ci/packages.sh"

help() {
  cat <<'EOF'
./Testing/test.sh [--fast | --long] [ctest's own options]

Installs missing packages (Debian 12, 13 or testing, as root or with sudo; untested on systems made from
Debian or Ubuntu), builds everything in build/, and runs the tests through CTest: on Debian 12 and 13 first
those of the VTK filter with Debian's own VTK (9.1, 9.3), unpacked in build/vtk91 or build/vtk93; then all of
them with ParaView and its VTK, which in testing is Debian's own. A first run takes 25 minutes on two cores.

--long         also the long tests (label: long)
--fast         for the change in hand: builds and runs the quick tests of the engine, the filter and the
               package for Python, and lint, with ParaView's VTK only; the whole run is still to come
--paraview     only the tests with ParaView, not those with Debian's own VTK
others         are passed to ctest, for example  -R Corpus  or  -L engine

exit code  0 all passed, 1 something could not be installed or built (a log is named), 2 this system is not
           supported (nothing was installed), else ctest's
environment  AHD_BUILD_DIR: the folder to build in (default: build in the source tree)
             CTEST_PARALLEL_LEVEL: how many tests at a time (default: one more than there are processors, as
             some wait for a server, a window or PyPI)
EOF
}

long=OFF
own_vtk=yes
targets=()
more=()
ctest_options=()
for argument in "$@"; do
  case $argument in
    -h | --help) help && exit 0 ;;
    --long) long=ON && more+=(clang-tidy) ;;
    --paraview) own_vtk= ;;
    --fast)
      own_vtk=
      targets=(FastTests)
      ctest_options+=(-R '^(Engine|Filter|Lint|Mutations\.Apply|Package\.(Arrays|Class))' -LE 'sanitize|slow')
      ;;
    *) ctest_options+=("$argument") ;;
  esac
done

# Debian's own VTK of this version (9.1), which cannot be installed beside ParaView, as their Python packages
# exclude each other: unpacked in a folder.
unpack_vtk() {
  local version=$1 folder=$2 archive
  [ -f "$folder/unpacked" ] && return
  rm -rf "$folder/archives" "$folder/root"
  mkdir -p "$folder/archives" "$folder/root"
  # apt drops root's rights to download, which fails in a folder that only root can enter
  # shellcheck disable=SC2046
  fetch() { (cd "$folder/archives" && apt-get -q -o APT::Sandbox::User=root download $(packages_to vtk "$release")); }
  step "Fetching Debian's VTK $version (34 MB)" fetch-vtk fetch ||
    { refresh_lists && step "Fetching it once more" fetch-vtk fetch; } ||
    fail 1 "the packages of VTK $version could not be fetched. Without them: ./Testing/test.sh --paraview"
  for archive in "$folder"/archives/*.deb; do
    dpkg -x "$archive" "$folder/root" || fail 1 "$archive could not be unpacked"
  done
  rm -r "$folder/archives"
  touch "$folder/unpacked"
}

# run_ctest <name> <build folder> <ctest options>...
# Adds to the sums; keeps the first bad exit code.
total=0
failed=0
status=0
run_ctest() {
  local name=$1 folder=$2 code summary
  shift 2
  printf '\nTesting with %s\n' "$name"
  with_display ctest --test-dir "$folder" --output-on-failure --no-tests=ignore \
    --output-log "$logs/ctest.log" --parallel "${CTEST_PARALLEL_LEVEL:-$(($(nproc) + 1))}" "$@"
  code=$?
  summary=$(grep -o '[0-9]* tests failed out of [0-9]*' "$logs/ctest.log" | tail -n 1)
  if [ -n "$summary" ]; then
    failed=$((failed + ${summary%% *}))
    total=$((total + ${summary##* }))
  elif [ $code -ne 0 ]; then
    fail "$code" "ctest stopped with exit code $code before its end, testing with $name"
  fi
  [ $status -ne 0 ] || status=$code
}

require_release "" build draw test
require_folders
[ -z "$like" ] || own_vtk= # the packages of its own VTK may be called otherwise
# shellcheck disable=SC2046
install_packages $(packages_to build "$release") $(packages_to draw "$release") $(packages_to test "$release") \
  ${more[@]+"${more[@]}"}
if ! getent hosts "$(hostname)" >/dev/null; then
  printf 'The name of this machine (%s) does not resolve: tests with a server may wait a minute each.\n' \
    "$(hostname)" "  A line  127.0.1.1 $(hostname)  in /etc/hosts helps."
fi

export PYTHONDONTWRITEBYTECODE=1
XDG_RUNTIME_DIR=$build/logs/runtime # Qt wants one
export XDG_RUNTIME_DIR
mkdir -p "$XDG_RUNTIME_DIR"
chmod 700 "$XDG_RUNTIME_DIR"

# The builds with each VTK, pip's and that of a project around this one compile the engine with the same options: once.
settings=(BUILD_TESTING=ON AHD_WRAP_PYTHON=ON Python3_EXECUTABLE=/usr/bin/python3 "AHD_LONG_TESTS=$long"
  "AHD_ENGINE_LAUNCHER=env;CCACHE_DIR=$build/ccache;CCACHE_DEPEND=1;CCACHE_SLOPPINESS=locale;ccache")
# the version is in the name of the package with the libraries
version=$(packages_to vtk "$release" | grep -o 'libvtk9\.[0-9]*' | head -n 1)
version=${version#libvtk}
[ -n "$version" ] || own_vtk=
if [ -n "$own_vtk" ]; then
  folder=$build/vtk${version/./}
  unpack_vtk "$version" "$folder"
  libraries=$folder/root/usr/lib/$(g++ -print-multiarch)
  (
    export LD_LIBRARY_PATH=$libraries # the programs' own search path does not reach their libraries'
    configure_and_build "$build/with-vtk${version/./}" "${settings[@]}" AHD_BUILD_PARAVIEW_PLUGIN=OFF \
      "VTK_DIR=$libraries/cmake/vtk-$version" -- FilterTests FaultsMemory FaultsCancel \
      AdaptiveHilbertDelaunayFiltersPython AdaptiveHilbertDelaunayPythonLibrary AhdCountedMemory
  ) || exit
fi
configure_and_build "$build" "${settings[@]}" AHD_BUILD_PARAVIEW_PLUGIN=ON AHD_PLUGIN_DOC=ON AHD_GUI_TESTS=ON \
  ${targets[@]+-- "${targets[@]}"}

if [ -n "$own_vtk" ]; then
  export LD_LIBRARY_PATH=$libraries
  # what does not know this VTK runs once, with the rest
  run_ctest "VTK $version" "$build/with-vtk${version/./}" \
    -E '^(Engine|Determinism|Fuzz|Benchmark|Demo|Lint|Mutations|Package\.(Arrays|C[A-Z]|Engine|Lifetimes|Mended|Pair|PipInstall))' \
    ${ctest_options[@]+"${ctest_options[@]}"}
  unset LD_LIBRARY_PATH
fi
run_ctest "ParaView and its VTK" "$build" ${ctest_options[@]+"${ctest_options[@]}"}

printf '\nIn all, after %d min %d s:\n' $((SECONDS / 60)) $((SECONDS % 60))
if [ $total -eq 0 ]; then
  printf 'No tests were found!!!\n'
else
  printf '%d%% tests passed, %d tests failed out of %d\n' $((100 * (total - failed) / total)) $failed $total
fi
exit $status
