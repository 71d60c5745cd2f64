# shellcheck shell=bash disable=SC2034,SC2154
# SPDX-License-Identifier: BSD-3-Clause
#
# Where Plugin/demo.sh and Testing/test.sh work, and which Debian packages they need there.
# To be sourced by bash after setup.sh. REQUIRES: root (the folder of the sources) is set.

# The file that says which system this is. (A test names another one.)
os_release=${AHD_OS_RELEASE:-/etc/os-release}

# One word of os-release, in a shell of its own: the file is made of assignments.
os_word() {
  # shellcheck disable=SC1090
  (. "$os_release" 2>/dev/null && printf '%s' "${!1:-}")
}

# Prints 12, 13 or testing, or nothing for any other system.
find_release() {
  [ "$(os_word ID)" = debian ] || return 0
  case $(os_word VERSION_CODENAME) in
    bookworm) echo 12 ;;
    trixie) echo 13 ;;
    forky | sid) echo testing ;;
    # what is testing when forky is released has no version yet, either
    *) [ -n "$(os_word VERSION_ID)" ] || echo testing ;;
  esac
}

# packages_to <what> <release>
# what is   build  the plugin and the Python package, with the pages of ParaView's help
#           draw   without a screen
#           test   what Testing/test.sh runs, without what the two above say
#           arm, wine  what Testing/Package/arm.sh and wine.sh run
#           vtk    the release's own VTK, which can't be installed beside its ParaView; nothing in testing,
#                  whose ParaView uses it
packages_to() {
  case $1-$2 in
    # ParaView's CMake files name python3-paraview and MPI
    build-*) echo g++ cmake ninja-build paraview-dev python3-paraview libopenmpi-dev ;;&
    build-12) echo qttools5-dev qtxmlpatterns5-dev-tools ;;
    build-13) echo python3-dev libdouble-conversion-dev qttools5-dev qtxmlpatterns5-dev-tools ;;
    build-testing) echo python3-dev libdouble-conversion-dev libvtk9-dev qt6-tools-dev qt6-tools-dev-tools xsltproc ;;

    draw-*) echo xvfb xauth ;;

    # ranks; compiling once what several builds need; sanitizers, benchmarks, lint, wheels; PyPI's, GeoTIFFs; the
    # development files of an unpacked VTK want TBB
    test-*)
      echo openmpi-bin libglew-dev git libgtest-dev libbenchmark-dev libcgal-dev libgmp-dev libmpfr-dev
      echo ccache clang llvm valgrind shellcheck pyflakes3 libtbb-dev python3-venv python3-pip python3-gdal
      # what brings geometries and rasters to the Python package
      echo python3-geopandas python3-rasterio python3-shapely python3-xarray
      ;;&
    test-12) echo clang-format libclang-rt-14-dev ;;
    test-13 | test-testing) echo libclang-rt-dev ;;

    # what runs the package's wheels for other systems
    arm-*) echo qemu-user ;;
    wine-*) echo wine64 ;;

    # all are needed: the files that let CMake find VTK name files of each
    vtk-12) echo libvtk9-dev libvtk9.1 libvtk9.1-qt libvtk9-java python3-vtk9 vtk9 ;;
    vtk-13) echo libvtk9-dev libvtk9.3 libvtk9.3-qt libvtk9-java python3-vtk9 vtk9 ;;
  esac
}

# Prints the release whose packages a system made from Debian or Ubuntu has, by the ParaView in its package lists:
# nothing where that is older than ParaView 5.11 or where there is none.
release_by_paraview() {
  local version
  version=$(LC_ALL=C apt-cache policy paraview-dev 2>/dev/null | sed -n 's/^ *Candidate: \([0-9].*\)/\1/p')
  case $version in
    '') ;;
    5.11*) echo 12 ;;
    5.1[2-9]*) echo 13 ;;
    [6-9]* | [1-9][0-9]*) echo testing ;;
  esac
}

# Those of the packages given that the package lists do not have.
unknown_packages() {
  LC_ALL=C apt-cache policy "$@" 2>/dev/null |
    awk '/^[^ ]/ { name = substr($1, 1, length($1) - 1) } $1 == "Candidate:" && $2 != "(none)" { print name }' |
    sort | comm -13 - <(printf '%s\n' "$@" | sort -u) | xargs
}

# Sets release where this is made from Debian or Ubuntu and its package lists have what is needed; else sets why, which
# says what they lack. find_like <what is needed, as for packages_to>...
find_like() {
  local what base wanted="" lacking
  base=" $(os_word ID_LIKE) "
  [[ $base == *" debian "* || $base == *" ubuntu "* || -n $(os_word DEBIAN_CODENAME)$(os_word UBUNTU_CODENAME) ]] &&
    command -v apt-cache >/dev/null || return
  # the lists of a fresh system are empty
  [ -n "$(LC_ALL=C apt-cache policy g++ 2>/dev/null)" ] || { become_root g++ && refresh_lists; }
  release=$(release_by_paraview)
  why=", whose package lists have no ParaView from 5.11 on"
  [ -n "$release" ] || return
  for what in "$@"; do
    wanted+=" $(packages_to "$what" "$release" | xargs)"
  done
  # shellcheck disable=SC2086
  lacking=$(unknown_packages $wanted)
  [ -n "$lacking" ] || return 0
  why=", whose package lists lack $lacking"
  release=
  return 1
}

# require_release [<finished> <what is needed, as for packages_to>...]
# Sets release: 12, 13 or testing, on a system made from Debian or Ubuntu the one it is like (then like is set, too), and
# nothing where there is only what was built before (finished: the plugin, or nothing). Or ends with a message that says
# what to do here. Nothing has been installed or built by then.
require_release() {
  local system finished=${1-} why=
  [ $# -eq 0 ] || shift
  release=$(find_release)
  like=
  [ -z "$release" ] || return 0
  [ -z "$finished" ] || return 0
  system=$(os_word PRETTY_NAME)
  system=${system:-an unknown system}
  if find_like "$@"; then
    like=$release
    printf '%s: not tested here: %s is taken for Debian %s, whose packages it has.\n' "$program" "$system" "$release"
    return
  fi
  fail 2 "this works on Debian 12, 13 and testing, and this is $system$why." \
    "What works here, all of it but the compiled plugin:" \
    "  pip install .           in $root, in a venv, with a C++17 compiler: Python, VTK, PyVista" \
    "  the wheel               without a compiler: Plugin/Documentation/GetIt.md" \
    "  the plugin in Python    for ParaView's official binaries, from the wheel: Plugin/Python/README.md" \
    "To build the compiled plugin by hand, it takes a C++17 compiler, CMake 3.18, Ninja, and ParaView 5.11 or newer with its" \
    "development files, Python modules and MPI; without ParaView, VTK 9.1 or newer. On Debian 13 these packages:" \
    "  $(packages_to build 13 | xargs)" \
    "Then, in $root:" \
    "  cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF -DPython3_EXECUTABLE=/usr/bin/python3" \
    "  cmake --build build    (VTK alone: -DAHD_BUILD_PARAVIEW_PLUGIN=OFF in the line above)" \
    "and the plugin is build/lib/paraview-VERSION/plugins/AdaptiveHilbertDelaunay/AdaptiveHilbertDelaunay.so," \
    "which demo.sh then takes. For the tests: -DBUILD_TESTING=ON, and what Debian 13 calls" \
    "  $(packages_to test 13 | xargs) $(packages_to draw 13)"
}
