#!/usr/bin/env bash
# scripts/setup.sh on systems that are made up here: a folder of few programs is all that PATH has.
set -euo pipefail
source_folder=$1 cmake=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

# system NAME PROGRAM...: a fresh system with basic tools and these programs, which do nothing.
system() {
  local tool
  name=$1 bin=$work/$1/bin
  shift
  mkdir -p "$bin"
  for tool in bash cat dirname env grep id rm sed tr; do ln -s "$(command -v $tool)" "$bin/$tool"; done
  for tool in "$@"; do printf '#!/bin/sh\n' >"$bin/$tool"; done
  chmod +x "$bin"/*
}

# debian PACKAGE...: dpkg and apt for this system, with these packages installed. apt keeps a log of what it
# is asked to do; it knows packages once the file `lists` is there.
debian() {
  printf '%s\n' "$@" >"$work/$name/installed"
  cat >"$bin/dpkg-query" <<TEXT
#!/bin/sh
for package; do :; done
grep -qx "\$package" "$work/$name/installed" || exit 1
printf installed
TEXT
  cat >"$bin/apt-get" <<TEXT
#!/bin/sh
case "\$*" in
  *--simulate*) [ -e "$work/$name/lists" ] ;;
  *--assume-no*)
    echo "0 upgraded, 95 newly installed, 0 to remove and 0 not upgraded."
    echo "Need to get 107 MB of archives."
    echo "After this operation, 498 MB of additional disk space will be used."
    exit 1 ;;
  *update*) echo update >>"$work/$name/log"; : >"$work/$name/lists" ;;
  *) echo "\$*" | sed 's/.*install -y /install /' >>"$work/$name/log" ;;
esac
TEXT
  chmod +x "$bin"/*
}

# user NUMBER: who runs this system's programs.
user() { rm "$bin/id"; printf '#!/bin/sh\necho %s\n' "$1" >"$bin/id"; chmod +x "$bin/id"; }

# there COMMAND: runs it after setup.sh on this system; output and exit status follow.
there() {
  local status=0
  output=$(PATH=$bin bash -euo pipefail -c "source '$source_folder/scripts/setup.sh'; root=$work/$name; $1" 2>&1) || status=$?
  output+=$'\n'"status $status"
}

# expect WORDS...: each is in the output.
expect() {
  local words
  for words in "$@"; do
    [[ $output == *"$words"* ]] && continue
    failed=1
    printf 'line %s, system %s: expected\n  %s\nin\n%s\n' "${BASH_LINENO[0]}" "$name" "$words" "$output"
  done
}

# expect_log LINE...: what apt was asked to do.
expect_log() {
  local log
  log=$(cat "$work/$name/log" 2>/dev/null || true)
  [ "$log" = "$(printf '%s\n' "$@")" ] && return
  failed=1
  printf 'line %s, system %s: apt was asked\n%s\n' "${BASH_LINENO[0]}" "$name" "$log"
}

system bare
debian g++ make
user 0
there "need g++ cmake 'ninja-build|make' 'a|b'"
expect "To install: cmake a" "Installing cmake a" "95 packages, 107 MB to download, 498 MB on the disk" "status 0"
expect_log update "install cmake a"

system complete
debian g++ b
there "need g++ 'a|b'; tell_missing g++ 'a|b'"
expect $'\nstatus 0'
[ "$output" = $'\nstatus 0' ] || expect "nothing else"
expect_log ''

system without_root
debian g++
user 1000
there "need g++ cmake"
expect "installing them needs root" "apt-get install --no-install-recommends cmake" "95 packages, 107 MB" "status 1"
expect_log ''
there "prepare no g++ cmake make"
expect "Not installed as packages: cmake make" "status 0"

system with_sudo
debian g++
user 1000
: >"$work/$name/lists"
printf '#!/bin/sh\nexec "$@"\n' >"$bin/sudo"
chmod +x "$bin/sudo"
there "need cmake"
expect "status 0"
expect_log "install cmake"

system other_system make
there "need g++ cmake"
expect "This is no Debian or Ubuntu system" "g++ cmake" "--no-install" "status 1"
there "prepare no g++ 'ninja-build|make'"
expect "Taken to be here: what the Debian packages g++ ninja-build or make hold" "status 0"
there "check_format yes"
expect "Format: not checked, this system has no clang-format-14" "status 0"

# What builds: what built before, Ninja, make.
there 'generator "$root/none"'
expect $'Unix Makefiles\nstatus 0'
system with_both make ninja
there 'generator "$root/none"'
expect $'Ninja\nstatus 0'
mkdir "$work/$name/before"
echo "CMAKE_GENERATOR:INTERNAL=Unix Makefiles" >"$work/$name/before/CMakeCache.txt"
there 'generator "$root/before"'
expect $'Unix Makefiles\nstatus 0'
rm "$bin/make"
there 'generator "$root/before"'
expect $'Ninja\nstatus 0'
rm "$bin/ninja"
there 'generator "$root/before"'
expect "Neither ninja nor make" "status 1"

# A folder whose builder is gone begins anew.
system without_ninja make cmake
mkdir -p "$work/$name/build/release/CMakeFiles"
echo "CMAKE_GENERATOR:INTERNAL=Ninja" >"$work/$name/build/release/CMakeCache.txt"
there 'configure release'
expect "status 0"
if [ -e "$work/$name/build/release/CMakeCache.txt" ]; then expect "no cache left"; fi

# What CMake says of optional parts.
system optional ffmpeg
ln -s "$cmake" "$bin/cmake"
cat >"$work/$name/tell.cmake" <<TEXT
set(PROJECT_SOURCE_DIR $source_folder)
set(PROJECT_BINARY_DIR $work/$name)
set(PROJECT_VERSION 1.2.3)
set(CMAKE_INSTALL_FULL_BINDIR /usr/bin)
set(CMAKE_INSTALL_FULL_LIBDIR /usr/lib)
include($source_folder/cmake/OptionalParts.cmake)
pupflow_tell_optional_parts()
TEXT
there "cmake -P '$work/$name/tell.cmake'"
expect "pupflow 1.2.3. Found: ffmpeg. Goes without: MPI (for sweeps over several machines: apt install libopenmpi-dev)" \
  "gnuplot (for the figures of sweeps: apt install gnuplot-nox)" "status 0"

exit $failed
