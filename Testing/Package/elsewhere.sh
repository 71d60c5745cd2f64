# shellcheck shell=bash disable=SC2034,SC2154
# SPDX-License-Identifier: BSD-3-Clause
#
# Shared by arm.sh and wine.sh: a wheel for another system, tested by an emulator. Sourced by bash.
# REQUIRES: root, program and target (of wheels.sh) are set, help() is defined, "$@" is what the script was given.
build=${AHD_BUILD_DIR:-$root/build}
folder=$build/$(basename "$program" .sh)
logs=$folder/logs
wheels=$build/wheels
. "$root/.ci/setup.sh"
. "$root/.ci/packages.sh"
case ${1-} in
  '') ;;
  -h | --help) help && exit 0 ;;
  *) fail 1 "unknown argument: $1" "Try --help." ;;
esac

# Sets wheel.
get_wheel() {
  "$root/Testing/Package/wheels.sh" --target "$target" || exit
  wheel=$(ls "$wheels"/dist/*"$target"*.whl) || fail 1 "wheels.sh made no wheel for $target"
}

# unpack_wheel <folder of packages>: in the place of an older one. Sets library.
unpack_wheel() {
  rm -rf "$1"/adaptivehilbertdelaunay*
  python3 -m zipfile -e "$wheel" "$1" || fail 1 "$wheel could not be unpacked"
  library=$(ls "$1"/adaptivehilbertdelaunay/*adaptivehilbertdelaunay.*)
}

# compile <program> <file in C>...
compile() {
  local made=$1
  shift
  "$wheels/bin/cc-$target" -std=c11 -O1 -I"$root/Filters/Engine/Interface" -o "$folder/c/$made" "$@" \
    "$folder/c/$(basename "$library")" -lpthread -lm
}

# test_c <suffix of programs> <emulator>...
# The tests of ahd.h and the program of OutsideC. They write to pipes: Wine 8 does not write to files.
test_c() {
  local suffix=$1 name
  shift
  rm -rf "$folder/c"
  mkdir "$folder/c"
  cp "$library" "$folder/c"
  compile "CInterface$suffix" "$root"/Testing/Engine/Interface/C*.c &&
    compile "OutsideC$suffix" "$root/Testing/Package/OutsideC/OutsideC.c" || return
  for name in CInterface OutsideC; do
    LD_LIBRARY_PATH=$folder/c "$@" "$folder/c/$name$suffix" 2>&1 | cat || return
    echo "$name passed"
  done
}

# run_tests <folder of tests>...: by $folder/python. Ends with their exit code.
run_tests() {
  step "Running the tests in Python" tests python3 "$root/Testing/Package/elsewhere.py" "$folder/python" "$@" ||
    exit
  cat "$logs/tests.log"
}
