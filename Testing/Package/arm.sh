#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs the wheel for Linux on ARM in an emulator. See help below, or ./Testing/Package/arm.sh --help.
set -uo pipefail
program=arm.sh
target=manylinux_2_17_aarch64
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

help() {
  cat <<'EOF'
./Testing/Package/arm.sh

Builds the wheel for aarch64 (wheels.sh), and runs it by qemu-user in Debian's Python and NumPy for arm64, which are
unpacked in build/arm (32 MB are fetched once): the tests of the C interface, results against Data/Hashes, and every
test of Arrays. What an emulator runs says nothing of speed.

exit code  0 all passed, 1 something failed (a log is named), 2 this system is not supported
environment  AHD_BUILD_DIR: the folder to build in (default: build in the source tree)
EOF
}
. "$root/Testing/Package/elsewhere.sh"

# Debian's Python for arm64 and what it needs, in a folder: apt is configured for arm64, with nothing installed.
fetch_python() {
  [ ! -f "$folder/fetched" ] || return 0
  local archive own=$folder/apt
  rm -rf "$folder/root" "$own"
  mkdir -p "$folder/root" "$own/lists/partial" "$own/archives/partial"
  local apt=(apt-get -q -y --no-install-recommends -o APT::Architecture=arm64 -o APT::Architectures=arm64
    -o "Dir::State=$own" -o Dir::State::status=/dev/null -o "Dir::Cache=$own" -o APT::Sandbox::User=root
    -o Debug::NoLocking=1)
  "${apt[@]}" update && "${apt[@]}" --download-only install python3-numpy || return
  for archive in "$own"/archives/*.deb; do
    dpkg-deb -x "$archive" "$folder/root" || return
  done
  rm -r "$own"
  cd "$folder/root/usr/lib/aarch64-linux-gnu" && ln -s blas/libblas.so.3 lapack/liblapack.so.3 . &&
    touch "$folder/fetched"
}

require_release
# shellcheck disable=SC2046
install_packages $(packages_to arm "$release")
step "Fetching Debian's Python and NumPy for arm64" fetch fetch_python ||
  fail 1 "Debian's packages for arm64 could not be had"
get_wheel
unpack_wheel "$folder/root/usr/lib/python3/dist-packages"
emulator=(qemu-aarch64 -L "$folder/root")
# -0: runs its children, too
printf '#!/bin/sh\nexec %s -0 "$0" "%s" "$@"\n' "${emulator[*]@Q}" "$folder/root/usr/bin/python3" >"$folder/python"
chmod +x "$folder/python"
step "Running the tests of the C interface" c test_c "" "${emulator[@]}" || exit
run_tests Arrays
