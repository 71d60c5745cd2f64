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

# Sets release, or ends with a message that says where this works and what to do elsewhere. Nothing has
# been installed or built by then.
require_release() {
  release=$(find_release)
  [ -z "$release" ] || return 0
  local system
  system=$(os_word PRETTY_NAME)
  fail 2 "this works on Debian 12, 13 and testing, and this is ${system:-an unknown system}." \
    "Elsewhere, build by hand. It takes a C++17 compiler, CMake 3.18, Ninja, and ParaView 5.11 or newer with its" \
    "development files, Python modules and MPI; without ParaView, VTK 9.1 or newer. On Debian 13 these packages:" \
    "  $(packages_to build 13 | xargs)" \
    "Then, in $root:" \
    "  cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF -DPython3_EXECUTABLE=/usr/bin/python3" \
    "  cmake --build build    (VTK alone: -DAHD_BUILD_PARAVIEW_PLUGIN=OFF in the line above)" \
    "and the plugin is build/lib/paraview-VERSION/plugins/AdaptiveHilbertDelaunay/AdaptiveHilbertDelaunay.so" \
    "For the tests: -DBUILD_TESTING=ON, and what Debian 13 calls" \
    "  $(packages_to test 13 | xargs) $(packages_to draw 13)"
}
