#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# `pip install .` in a clean venv, then `pip install -e .`, and checks what they installed:
#   pip_install.sh PYTHON FOLDER [NAME=VALUE]...
# FOLDER is made anew. The others are entries of CMake's cache: the compiler and its launchers. Needs PyPI.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
python=$1
folder=$2
shift 2
defines=("${@/#/--config-settings=cmake.define.}")
rm -rf "$folder"
mkdir -p "$folder"
"$python" -m venv "$folder/venv"

# install <pip's arguments>...: the package is complete, the triangles are right, the command works.
install() {
  "$folder/venv/bin/pip" install --no-input --disable-pip-version-check "$@" \
    "--config-settings=build-dir=$folder/build" ${defines[@]+"${defines[@]}"}
  (cd "$folder" && venv/bin/python "$root/Testing/Package/Wheels/check_wheel.py" "$root/Data")
  (cd "$folder" && venv/bin/adaptivehilbertdelaunay tiles "$root/Data/survey.csv" --tin survey.pvtp --overwrite)
}

# in_package <expression>: Python's value of it, of the package p
in_package() {
  (cd "$folder" && venv/bin/python -c "import adaptivehilbertdelaunay._vtk as v, adaptivehilbertdelaunay as p; print($1)")
}

install "$root"
[[ $(in_package p.__file__) == "$folder"/venv/* ]]

# Edits take effect: Python comes from the sources. ParaView's plugin, which is made, is where Python said.
install -e "$root"
[ "$(in_package p.__file__)" = "$root/Filters/Python/__init__.py" ]
[ "$(in_package v.__file__)" = "$root/Filters/Python/_vtk/__init__.py" ]
(cd "$folder" && test -f "$(venv/bin/python -m adaptivehilbertdelaunay --paraview-plugin)")

# The wheels that `pip wheel .` leaves here are ignored.
if [ -e "$root/.git" ]; then
  git -C "$root" check-ignore --quiet adaptivehilbertdelaunay-1.0.0-py3-none-linux_x86_64.whl
fi
