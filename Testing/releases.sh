#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
#
# Both commands of the README on bare Debian systems. See help below, or ./Testing/releases.sh --help.
set -uo pipefail
program=releases.sh
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
logs=${AHD_BUILD_DIR:-$root/build}/releases/logs
. "$root/.ci/setup.sh"

help() {
  cat <<'EOF2'
./Testing/releases.sh [options] [12 | 13 | testing]...

Makes a bare Debian system of each release (default: all three) in a folder with debootstrap, puts a clone of
the last commit in it, runs ./Plugin/demo.sh and ./Testing/test.sh there, and says what came of it: a line
for each release and command. Needs root, debootstrap and unshare, 15 GB for each release and half an hour
on two idle cores. What is mounted is mounted for these commands alone; the systems are removed afterwards.

--keep             leave the systems where they are; a later run goes on with them
--folder DIR       where the systems are made (default: below the build folder)
--demo, --test     only this command
--options "WORDS"  for ./Testing/test.sh, for example  --options "-R Filter"
--report FILE      also write the lines as a table in Markdown
--help             this text

The packages come from the first Debian mirror in apt's own sources; apt's settings, pip's and the names of
hosts are taken along. A folder named shared beside this clone is to be found beside the inner one, too.

exit code  0 all passed, 1 something failed (its log is named), 2 this cannot be done here
EOF2
}

declare -A names=([12]=bookworm [13]=trixie [testing]=forky)
releases=()
commands=()
options=
report=
keep=
folder=
while [ $# -gt 0 ]; do
  case $1 in
    -h | --help) help && exit 0 ;;
    --keep) keep=yes ;;
    --demo | --test) commands+=("${1#--}") ;;
    --folder | --options | --report)
      [ $# -gt 1 ] || fail 2 "$1 needs a value; --help lists the options"
      printf -v "${1#--}" '%s' "$2" && shift
      ;;
    12 | 13 | testing) releases+=("$1") ;;
    *) fail 2 "unknown: $1; --help lists the options" ;;
  esac
  shift
done
[ ${#releases[@]} -gt 0 ] || releases=(12 13 testing)
[ ${#commands[@]} -gt 0 ] || commands=(demo test)
folder=${folder:-$logs/../systems}

# The first mirror that apt takes Debian's packages from.
find_mirror() {
  local line
  while read -r line; do
    case $line in
      # one-line style: deb [options] URI suite component...
      deb\ *main*) sed -E 's/^deb +(\[[^]]*\] +)?//' <<<"$line" | cut -d ' ' -f 1 && return ;;
      URIs:*) cut -d ' ' -f 2 <<<"$line" && return ;;
    esac
  done < <(cat /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list /etc/apt/sources.list.d/*.sources \
    /etc/apt/sources.list.d/*.list 2>/dev/null)
}

# make_system <release> <folder>: the bare system and the clone in it
make_system() {
  local name=${names[$1]} system=$2 script=/usr/share/debootstrap/scripts
  if [ ! -f "$system/made" ]; then
    rm -rf --one-file-system "$system"
    mkdir -p "$system"
    # debootstrap may be older than a release; all are made alike
    [ -e "$script/$name" ] && script=$script/$name || script=$script/sid
    debootstrap --variant=minbase --include=ca-certificates "$name" "$system" "$mirror" "$script" || return
    cp /etc/apt/apt.conf.d/* "$system/etc/apt/apt.conf.d/" 2>/dev/null
    rm -f "$system"/etc/apt/apt.conf.d/*docker* # they are about images, not about how to reach a mirror
    touch "$system/made"
  fi
  cp -L /etc/resolv.conf /etc/hosts "$system/etc/" # names of hosts, this one's among them
  cp /etc/hostname "$system/etc/" 2>/dev/null
  mkdir -p "$system/etc/ssl/certs" "$system/clone"
  cat /etc/ssl/certs/ca-certificates.crt >"$system/etc/ssl/certs/ca-certificates.crt"
  [ ! -e /etc/pip.conf ] || cp /etc/pip.conf "$system/etc/"
  rm -rf --one-file-system "$system/clone/project"
  git clone -q --no-hardlinks "$root" "$system/clone/project"
}

# in_system <folder> <command>...: with /dev, /proc and /sys of this machine, mounted for this command alone
in_system() {
  local system=$1 shared kept
  shift
  shared=$(readlink -f "$root/../shared")
  mapfile -t kept < <(env | grep -E '^(PIP_CERT|PIP_INDEX_URL|https?_proxy|no_proxy)=')
  unshare --mount --propagation private bash -c '
    system=$1 shared=$2
    shift 2
    mount --rbind /dev "$system/dev" && mount -t proc proc "$system/proc" && mount --rbind /sys "$system/sys" || exit 125
    if [ -d "$shared" ]; then
      mkdir -p "$system/clone/shared" && mount --bind "$shared" "$system/clone/shared" || exit 125
    fi
    exec chroot "$system" env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      HOME=/root LANG=C.UTF-8 "$@"' in_system "$system" "$shared" ${kept[@]+"${kept[@]}"} "$@"
}

# The first line of what a command in the system says, without what stands before the version.
version_in() {
  in_system "$@" 2>/dev/null | grep -oE '[0-9]+\.[0-9]+(\.[0-9]+)?' | head -n 1
}

# run_command <release> <folder> <demo or test>: one line about it
run_command() {
  local release=$1 system=$2 command=$3 log="$logs/$1-$3.log" started=$SECONDS status words result versions
  case $command in
    demo) words="./Plugin/demo.sh" ;;
    test) words="./Testing/test.sh${options:+ $options}" ;;
  esac
  # shellcheck disable=SC2086
  in_system "$system" sh -c 'cd /clone/project && exec "$@"' sh $words >"$log" 2>&1 </dev/null
  status=$?
  result=failed
  [ $status -eq 0 ] && result=passed
  [ $status -eq 0 ] || bad=yes
  [ $command = demo ] && [ -s "$system/clone/project/build/demo/survey.png" ] || [ $command = test ] || result=failed
  [ $command = demo ] || result="$result: $(grep -E '^[0-9]+% tests passed' "$log" | tail -n 1)"
  versions="VTK $(sed -n 's/^-- VTK \([0-9.]*\) in .*/\1/p' "$system"/clone/project/build/logs/configure-*.log | sort -u | xargs | sed 's/ /, /g')"
  versions+="; ParaView $(version_in "$system" pvpython --version)"
  versions+="; GCC $(version_in "$system" g++ -dumpfullversion); Python $(version_in "$system" python3 --version)"
  printf 'Debian %s; %s; %s; %s; %d min %d s\n' "$release" "$versions" "$words" "$result" \
    $(((SECONDS - started) / 60)) $(((SECONDS - started) % 60)) | tee -a "$logs/lines"
  case $result in failed*) printf '  its log: %s\n' "$log" ;; esac
}

remove() {
  [ -n "$keep" ] || rm -rf --one-file-system "$1"
}

[ "$(id -u)" -eq 0 ] || fail 2 "making systems needs root"
for tool in debootstrap unshare git; do
  command -v "$tool" >/dev/null || fail 2 "$tool is needed, which is not installed"
done
mirror=$(find_mirror)
[ -n "$mirror" ] || fail 2 "apt's sources name no Debian mirror"
mkdir -p "$folder" "$logs" && folder=$(cd "$folder" && pwd)
: >"$logs/lines"
bad=
for release in "${releases[@]}"; do
  system=$folder/$release
  if ! step "Making Debian $release" "make-$release" make_system "$release" "$system"; then
    printf 'Debian %s could not be made\n' "$release" | tee -a "$logs/lines"
    bad=yes
  else
    for command in "${commands[@]}"; do
      run_command "$release" "$system" "$command"
    done
  fi
  remove "$system"
done
if [ -n "$report" ]; then
  {
    printf '| release | versions | command | result | time |\n|---|---|---|---|---|\n'
    sed -E 's/^([^;]*); (.*); (\.\/[^;]*); ([^;]*); ([^;]*)$/| \1 | \2 | `\3` | \4 | \5 |/' "$logs/lines"
  } >"$report"
fi
[ -z "$bad" ]
