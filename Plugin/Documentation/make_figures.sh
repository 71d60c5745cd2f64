#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Draws the figures of the gallery and writes its page. See help below, or make_figures.sh --help.
set -uo pipefail
program=make_figures.sh
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
build=${AHD_BUILD_DIR:-$root/build}
logs=$build/logs
. "$root/.ci/setup.sh"
. "$root/.ci/packages.sh"

help() {
  cat <<'EOT'
./Plugin/Documentation/make_figures.sh [options]

Draws the figures of the gallery and of the recipes with ParaView and this plugin, counts the numbers of the
gallery's captions, and writes its page: Gallery.md, gallery.html and Figures/. (recipe-dem.png takes points
that are not in the repository: Scripts/recipe_pictures.py draws it.) On the first run it installs what is missing
(Debian, as root or with sudo) and builds the plugin in build/. Drawing takes some two minutes.

--plots           only the figures of times, from the results of Testing/Benchmarks/paper.sh, and the
                  page; needs neither the plugin nor ParaView
--only A,B        only these figures, and the page; their names are those of the files
--results FILE    the results to draw (default: Testing/Benchmarks/Results.json; without it, no times)
--output DIR      where to write (default: Plugin/Documentation)
--quick           small pictures of fewer points, for a test
--help            this text

exit code  0 done, 1 something failed, 2 an option or this system cannot be used
environment  AHD_BUILD_DIR: the folder to build in (default: build in the source tree)
EOT
}

arguments=()
plots=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) help && exit 0 ;;
    --plots) plots=yes && arguments+=("$1") ;;
    --quick) arguments+=("$1") ;;
    --only | --results | --output)
      [ $# -gt 1 ] || fail 2 "$1 needs a value; --help lists the options"
      arguments+=("$1" "$2") && shift
      ;;
    *) fail 2 "unknown: $1; --help lists the options" ;;
  esac
  shift
done

require_release "" build draw
require_folders
export PYTHONDONTWRITEBYTECODE=1 PYTHONUNBUFFERED=1
if [ -n "$plots" ]; then
  install_packages python3-matplotlib python3-pil
  exec /usr/bin/python3 "$here/Scripts/make_figures.py" "${arguments[@]}"
fi

# shellcheck disable=SC2046
install_packages $(packages_to build "$release") $(packages_to draw "$release") python3-matplotlib python3-pil
configure_and_build "$build" BUILD_TESTING=OFF? AHD_BUILD_PARAVIEW_PLUGIN=ON AHD_WRAP_PYTHON=ON \
  Python3_EXECUTABLE=/usr/bin/python3 -- AdaptiveHilbertDelaunay AdaptiveHilbertDelaunayPythonLibrary
export PYTHONPATH=$build/lib/python3/dist-packages # for tiles
plugin=$(find "$build/lib" -name AdaptiveHilbertDelaunay.so -path '*/plugins/*' 2>/dev/null | head -n 1)
[ -n "$plugin" ] || fail 1 "the build made no plugin. Remove the build folder and try again: rm -r $build"
with_display pvbatch "$here/Scripts/make_figures.py" --plugin "$plugin" "${arguments[@]}"
