#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Points in, a triangulated surface and a picture out, through the plugin in ParaView.
# See help below, or ./Plugin/demo.sh --help.
set -uo pipefail
program=demo.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=${AHD_BUILD_DIR:-$root/build}
logs=$build/logs
. "$root/.ci/setup.sh"
. "$root/.ci/packages.sh"

help() {
  cat <<'EOF'
./Plugin/demo.sh [file] [options]

Triangulates the points of a file with the Adaptive Hilbert Delaunay 2D filter in ParaView, writes the
surface as <name>.vtp and a picture of it as <name>.png, and reports the time. On the first run it
installs missing packages (Debian 12, 13 or testing, as root or with sudo; untested on systems made from Debian or
Ubuntu) and builds the plugin in build/; that takes minutes, later runs take seconds. A plugin that was built by hand
is used unchanged, on every system.

file       default: Data/survey.csv, soundings of an invented sea
  .csv .xyz .txt        one point per line; commas, semicolons, tabs or spaces. Column names for x, y and z are
                        recognised (Easting, lat, Elevation_NAVD88, Tiefe ...), counters (ID, FID, Nr) ignored;
                        without names the first columns are used; unclear names are refused
  .vtk .vtp .vtu .ply   any data with points
  .las .laz             lidar; for the first .laz, laspy and lazrs are fetched from PyPI into build/

options
  --x NAME --y NAME --z NAME   the columns, by name or by number from 1 (--z none: a flat set)
  --columns X,Y,Z              the same in one option, for example --columns lon,lat,depth or 2,3,5
  --nodata NUMBER              leave out points whose z is this number, such as -9999 (tables and lidar)
  --simplify ERROR             leave out points as long as the surface differs at none of them by more than this, in the
                               unit of z; the surface has the others, and their numbers from 0 as "Fate"
  --exaggeration FACTOR        the vertical exaggeration of the picture (default: chosen and reported)
  --edges                      draw the triangles' edges
  --raster CELL                write the heights on a raster, too, with cells of this size in the unit of x and y
                               (degrees, if these are longitude and latitude):
                               <name>.vti, and a GeoTIFF <name>.tif if Python has GDAL (python3-gdal) or rasterio;
                               outside the surface NaN, the borders of cells multiples of CELL
  --method METHOD              the interpolation of heights: linear (default), natural, laplace or nearest
  --crs EPSG:CODE              the coordinate reference system of the GeoTIFF, for example EPSG:32633
  --output DIR                 the folder of the results (default: build/demo); files of others there are kept
  --help                       this text

exit code  0 done, 1 something failed (a log is named), 2 the file, an option or this system cannot be used
environment  AHD_BUILD_DIR: the folder to build in (default: build in the source tree, which must then be writable)
EOF
}

# What reads .laz, in a folder of its own. NumPy, which laspy needs, is Debian's.
install_laz() {
  local folder=$build/laz wanted=$root/Plugin/Demo/requirements.txt
  cmp -s "$wanted" "$folder/requirements.txt" && return
  [ -z "$release" ] || install_packages python3-pip
  rm -rf "$folder"
  step "Installing laspy and lazrs, which read .laz" laz /usr/bin/python3 -m pip install --disable-pip-version-check \
    --no-deps --no-compile --retries 2 --target "$folder" --requirement "$wanted" ||
    fail 1 "laspy and lazrs could not be installed from PyPI. Is the network there?" \
      "A .las, which other programs can make of the file, does not need them."
  cp "$wanted" "$folder/"
}

arguments=()
output=$build/demo
file=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) help && exit 0 ;;
    --output) [ $# -gt 1 ] || fail 2 "--output needs a folder" && output=$2 && shift ;;
    --output=*) output=${1#*=} ;;
    --x | --y | --z | --columns | --exaggeration | --nodata | --simplify | --raster | --method | --crs)
      [ $# -gt 1 ] || fail 2 "$1 needs a value; --help lists the options"
      arguments+=("$1=$2") && shift
      ;;
    -*) arguments+=("$1") ;;
    *)
      [ -z "$file" ] || fail 2 "one file at a time: $file or $1"
      file=$1
      arguments+=("$1")
      ;;
  esac
  shift
done
# Before minutes of installing and building: is there a file at all?
[ -z "$file" ] || [ ! -d "$file" ] || fail 2 "$file is a directory, not a file"
[ -z "$file" ] || [ -f "$file" ] || fail 2 "no such file: $file"
[ -z "$file" ] || [ -r "$file" ] || fail 2 "no permission to read $file"
arguments+=("--output=$output")
[ "$output" != "$build/demo" ] || arguments+=(--own-output)

find_plugin() {
  find "$build/lib" -name AdaptiveHilbertDelaunay.so -path '*/plugins/*' 2>/dev/null | head -n 1
}

require_release "$(find_plugin)" build draw
export PYTHONDONTWRITEBYTECODE=1
if [ -n "$release" ]; then
  require_folders
  # shellcheck disable=SC2046
  install_packages $(packages_to build "$release") $(packages_to draw "$release")
fi
/usr/bin/python3 "$root/Plugin/Demo/demo.py" --check "${arguments[@]}" || exit
[[ ${file,,} != *.laz ]] || install_laz
if [ -n "$release" ]; then
  configure_and_build "$build" BUILD_TESTING=OFF? AHD_BUILD_PARAVIEW_PLUGIN=ON AHD_PLUGIN_DOC=ON AHD_WRAP_PYTHON=ON \
    Python3_EXECUTABLE=/usr/bin/python3 -- AHDInstalled
fi
plugin=$(find_plugin)
[ -n "$plugin" ] || fail 1 "the build made no plugin. Remove the build folder and try again: rm -r $build"

# pvbatch draws on an X display of its own, so nothing appears on the screen.
export PYTHONPATH="$build/lib/python3/dist-packages:$build/laz" PYTHONUNBUFFERED=1
with_display pvbatch "$root/Plugin/Demo/demo.py" --plugin "$plugin" "${arguments[@]}"
status=$?
case $status in
  0 | 2) ;;
  *) fail 1 "ParaView stopped with exit code $status. Its own words are above." \
    "If they are about X or DISPLAY: the X server's are in $logs/display.log" ;;
esac
exit $status
