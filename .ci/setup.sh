# shellcheck shell=bash disable=SC2154
# SPDX-License-Identifier: BSD-3-Clause
#
# What Plugin/demo.sh and Testing/test.sh share: installing Debian packages, running a long step
# with its progress shown and its output logged, and saying what to do when something fails.
# To be sourced by bash; REQUIRES: program (the name to speak under) and logs (a folder) are set.

# What runs in the background must not outlive this: it does not hear Ctrl-C by itself.
job=""
server=""
trap 'kill $job $server 2>/dev/null' EXIT

# Fails with a message. fail <exit code> <line>...
fail() {
  local code=$1
  shift
  printf '%s: %s\n' "$program" "$1" >&2
  shift
  [ $# -eq 0 ] || printf '  %s\n' "$@" >&2
  exit "$code"
}

# step <what is being done> <log name> <command>...
# Runs the command with its output in a log and a sign of life now and then. Returns its status;
# where it fails, the end of the log is shown.
step() {
  local what=$1 log="$logs/$2.log" started=$SECONDS status=0 pause=20 last
  shift 2
  mkdir -p "$logs"
  [ -t 1 ] && pause=3
  printf '%s\n' "$what"
  "$@" </dev/null >"$log" 2>&1 &
  job=$!
  local waited=0
  while kill -0 "$job" 2>/dev/null; do
    sleep 0.2
    waited=$((waited + 1))
    if [ $((waited % (5 * pause))) -eq 0 ]; then
      last=$(tail -c 2000 "$log" | tr '\r' '\n' | grep -v '^[[:space:]]*$' | tail -n 1 | cut -c 1-88)
      printf '  %3d s  %s\n' $((SECONDS - started)) "$last"
    fi
  done
  wait "$job" || status=$?
  job=""
  if [ $status -ne 0 ]; then
    printf '%s: this failed (exit code %d): %s\n' "$program" "$status" "$what" >&2
    tail -n 25 "$log" | sed 's/^/  | /' >&2
    printf '  All of it is in %s\n' "$log" >&2
  elif [ $((SECONDS - started)) -gt 2 ]; then
    printf '  done in %d s\n' $((SECONDS - started))
  fi
  return $status
}

# The packages among the arguments that are not installed.
missing_packages() {
  local name
  for name in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$name" 2>/dev/null)" = installed ] || printf '%s ' "$name"
  done
}

# Runs a command as root: as it is, or through sudo, which may ask for the password (on the terminal).
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  else
    sudo -n "$@"
  fi
}

# Makes sure that as_root works, before anything is run in the background.
become_root() {
  local missing=$1
  [ "$(id -u)" -eq 0 ] && return
  if ! command -v sudo >/dev/null; then
    fail 1 "packages are missing, and installing them needs root or sudo. Ask for them:" \
      "apt-get install --no-install-recommends $missing"
  fi
  if ! sudo -n true 2>/dev/null; then
    printf '%s packages are missing; sudo asks for your password to install them.\n' "$(wc -w <<<"$missing")"
    sudo -v || fail 1 "sudo gave no rights to install packages. Have somebody run:" \
      "apt-get install --no-install-recommends $missing"
  fi
}

apt() {
  as_root env LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive NEEDRESTART_MODE=a \
    apt-get -y -q --no-install-recommends -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@"
}

# Installs what is missing of the packages given; no network and no rights needed where all are there.
install_packages() {
  local missing
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail 1 "there is no apt-get here. Needed:" "$*"
  fi
  missing=$(missing_packages "$@")
  [ -z "$missing" ] && return
  become_root "$missing"
  refresh_lists
  local room
  room=$(room_for $missing)
  step "Installing $(wc -w <<<"$missing") packages and what they need${room:+ ($room on the disk)}: $missing" \
    install apt install $missing ||
    fail 1 "the packages could not be installed." \
      "Is there room on the disk (${room:-5 GB} and the downloads), is another apt running?"
}

# What apt says that packages and what they need take when installed, like "3,245 MB"; nothing where it does not say.
room_for() {
  LC_ALL=C apt-get install --assume-no --no-install-recommends -o Debug::NoLocking=1 "$@" </dev/null 2>/dev/null |
    sed -n 's/^After this operation, \(.*\) of additional disk space.*/\1/p; s/^ *Space needed: \([^/]*\) .*/\1/p'
}

# The lists of a fresh system are empty, those of an old one name files that are gone. This is also where it shows that
# there is no network: the first try has no retries, which take apt minutes for each package then.
refresh_lists() {
  local status=0
  step "Fetching the package lists" update apt -o Acquire::Retries=0 -o Acquire::EnableSrvRecords=false \
    -o Acquire::http::Timeout=10 -o Acquire::https::Timeout=10 update || status=$?
  if grep -q '^Err:' "$logs/update.log"; then
    grep -Eq '^(Hit|Get):' "$logs/update.log" ||
      fail 1 "none of apt's sources answers, so no packages can be installed. Is the network there?" \
        "What apt says is in $logs/update.log"
    status=0
    step "Fetching them once more" update apt update || status=$?
  fi
  [ $status -eq 0 ] || fail 1 "the package lists could not be fetched. Is another apt running?"
}

# Fails where nothing can be built, before anything is installed.
# VTK's CMake files hand paths to the shell without quotes; CMakeLists.txt says the same to those who call cmake.
require_folders() {
  local path unquoted character characters
  read -r unquoted <"$root/.ci/unquoted.txt"
  read -ra characters <<<"$unquoted"
  for path in "$root" "$build"; do
    for character in "${characters[@]}"; do
      [[ $path != *"$character"* ]] ||
        fail 2 "nothing can be built in $path, as the path has one of  $unquoted" \
          "Spaces are no trouble. Move or rename the folder."
    done
  done
  { mkdir -p "$build" && path=$(mktemp "$build/.writable.XXXXXX") && rm "$path"; } 2>/dev/null ||
    fail 2 "nothing can be written in $build, where this builds (a read-only checkout? a full disk?)." \
      "Name a folder elsewhere: AHD_BUILD_DIR=/somewhere/else $0"
}

# cached <build folder> <NAME=VALUE>: does the build folder's cache say so?
cached() {
  grep -q "^${2%%=*}:[A-Z]*=${2#*=}\$" "$1/CMakeCache.txt" 2>/dev/null
}

# configure_and_build <build folder> <NAME=VALUE>... -- <targets>...
# Configures with these cache entries where they are not set yet (NAME=VALUE? only where nothing was
# configured before), and builds the targets, or everything. What a changed CMakeLists.txt asks
# for, the build does by itself.
configure_and_build() {
  local folder=$1 name settings=() generator=() wanting=""
  shift
  [ -f "$folder/CMakeCache.txt" ] || generator=(-G Ninja)
  [ -f "$folder/build.ninja" ] || [ -f "$folder/Makefile" ] || wanting=yes
  cached "$folder" "CMAKE_HOME_DIRECTORY=$root" || wanting=yes
  while [ $# -gt 0 ] && [ "$1" != -- ]; do
    name=${1%\?}
    if [ "$name" = "$1" ] || [ ! -f "$folder/CMakeCache.txt" ]; then
      settings+=("-D$name")
      cached "$folder" "$name" || wanting=yes
    fi
    shift
  done
  [ $# -eq 0 ] || shift
  if [ -n "$wanting" ]; then
    step "Configuring in $folder" "configure-$(basename "$folder")" \
      cmake -S "$root" -B "$folder" "${generator[@]}" "${settings[@]}" ||
      fail 1 "CMake could not configure the build." \
        "If $folder is from another machine or place, remove it and try again: rm -r $folder"
  fi
  step "Building in $folder" "build-$(basename "$folder")" cmake --build "$folder" ${1:+--target "$@"} ||
    fail 1 "the build failed." \
      "If the log says Killed, memory ran out: try again with CMAKE_BUILD_PARALLEL_LEVEL=1 in the environment."
}

# start_display <folder>
# Starts an X server that shows nothing; sets server and number (empty where none would start).
# xvfb-run looks for a free number and then takes it, so two that start together may collide. Here
# a number is drawn, taken, and drawn anew if somebody had it. -noreset: else the server starts over
# when its last client leaves, and a client that comes just then (ParaView looks in, leaves and comes
# back) is turned away.
start_display() {
  local folder=$1 cookie
  cookie=$(mcookie)
  mkfifo "$folder/ready"
  for _ in 1 2 3 4 5; do
    number=$((100 + RANDOM % 20000))
    xauth -q -f "$folder/authority" add ":$number" . "$cookie"
    Xvfb ":$number" -displayfd 3 -screen 0 1920x1200x24 -noreset -nolisten tcp \
      -auth "$folder/authority" 3>"$folder/ready" </dev/null >>"$logs/display.log" 2>&1 &
    server=$!
    read -r -t 60 number <"$folder/ready" && return
    kill "$server" 2>/dev/null
    wait "$server" 2>/dev/null
  done
  server=""
  number=""
}

# with_display <command>...
# Runs the command on an X server of its own.
with_display() {
  local number="" status folder
  folder=$(mktemp -d) || return 1
  mkdir -p "$logs"
  : >"$logs/display.log"
  touch "$folder/authority"
  start_display "$folder"
  if [ -n "$number" ]; then
    # ParaView is built with Open MPI, whose hwloc would knock at displays :0 to :9 to see whether
    # they have a graphics card
    # shellcheck disable=SC2046
    env DISPLAY=":$number" XAUTHORITY="$folder/authority" HWLOC_COMPONENTS=-gl \
      $(grep '^[A-Z]' "$root/.ci/mpi.env") "$@"
    status=$?
    kill "$server" 2>/dev/null
    wait "$server" 2>/dev/null
    server=""
  fi
  rm -r "$folder"
  [ -n "$number" ] || fail 1 "the X server Xvfb did not start; see $logs/display.log"
  return $status
}
