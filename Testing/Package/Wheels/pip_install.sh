#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# `pip install .` in a clean venv with the system's compiler, and whether what it installed is right:
#   pip_install.sh PYTHON FOLDER [COMPILER_LAUNCHER]
# FOLDER is made anew. Needs PyPI.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
python=$1
folder=$2
launcher=${3-}
rm -rf "$folder"
mkdir -p "$folder"
"$python" -m venv "$folder/venv"
"$folder/venv/bin/pip" install --no-input --disable-pip-version-check "$root" \
  "--config-settings=build-dir=$folder/build" "--config-settings=cmake.define.CMAKE_CXX_COMPILER_LAUNCHER=$launcher"
cd "$folder"
venv/bin/python "$root/Testing/Package/Wheels/check_wheel.py" "$root/Data"
