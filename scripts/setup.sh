# shellcheck shell=bash
# Shared by demo, check and the others of scripts, which source it: finds the source tree, installs what is
# missing (Debian and Ubuntu), configures and builds. Does nothing by itself.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# What Debian and Ubuntu call what is needed. Of `a|b` one is enough; a is installed where none is there.
build_packages=(g++ cmake 'ninja-build|make' pkg-config
  libeigen3-dev libcli11-dev libtomlplusplus-dev libpng-dev libhdf5-dev libisal-dev zlib1g-dev libfreetype-dev fonts-dejavu-core
  libegl-dev libgl-dev libglew-dev libglfw3-dev libx11-dev libgl1-mesa-dri libimgui-dev libstb-dev
  gnuplot-nox
  python3-dev python3-numpy pybind11-dev)
check_packages=(libgtest-dev libgmock-dev xvfb xdotool imagemagick zsh
  ffmpeg doxygen libopenmpi-dev openmpi-bin libbenchmark-dev libarmadillo-dev
  python3-brian python3-h5py python3-h5netcdf python3-matplotlib python3-xarray)
format_packages=(clang-format-14)
lint_packages=(clang-tidy-14)
package_packages=(dpkg-dev file libopenmpi-dev lintian desktop-file-utils appstream)
fuzz_packages=(clang-14 libclang-rt-14-dev libgtest-dev libgmock-dev)

say() { printf '\n== %s\n' "$*"; }

stop() {
  printf '%s\n' "$@" >&2
  exit 1
}

# as_root COMMAND...: runs it as root, by sudo where we are not.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# room PRESET: prints what build/PRESET takes, rounded up. As of version 0.2.0, with GCC.
room() {
  case $1 in
    release) echo "60 MB" ;;
    engine) echo "30 MB" ;;
    check) echo "190 MB" ;;
  esac
}

has() { command -v "$1" >/dev/null; }

is_debian() { has dpkg-query && has apt-get; }

# Its words are read here, and nobody answers questions.
apt_get=(env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get -q --no-install-recommends)

is_installed() {
  # dpkg-query fails for a package that it has never heard of: that one is missing too.
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null || true)" = installed ]
}

# missing PACKAGE...: prints those that are not installed.
missing() {
  local needed package found
  for needed in "$@"; do
    found=no
    for package in ${needed//|/ }; do
      if is_installed "$package"; then found=yes; fi
    done
    [ $found = yes ] || printf '%s\n' "${needed%%|*}"
  done
}

# apt_knows PACKAGE...: whether apt can install them as its lists are. Needs no root.
apt_knows() { "${apt_get[@]}" -o Debug::NoLocking=1 --simulate install "$@" >/dev/null 2>&1; }

# sizes PACKAGE...: prints what installing them, and what they need, fetches and takes on the disk.
sizes() {
  local plan
  plan=$("${apt_get[@]}" -o Debug::NoLocking=1 --assume-no install "$@" 2>/dev/null || true)
  sed -n -e 's/^\([0-9]*\) upgraded, \([0-9]*\) newly installed.*/\2 packages/p' \
    -e 's/^Need to get \(.*\) of archives\.$/, \1 to download/p' \
    -e 's/^After this operation, \(.*\) of additional disk space will be used\.$/, \1 on the disk/p' \
    <<<"$plan" | tr -d '\n'
}

# need PACKAGE...: says what is missing and how much that is, and installs it; stops where it cannot.
need() {
  is_debian || stop "This is no Debian or Ubuntu system, so nothing can be installed here by itself." \
    "Install what these Debian packages hold: ${*//|/ or }" \
    "Then run the same command again with --no-install."
  local names packages
  names=$(missing "$@")
  [ -n "$names" ] || return 0
  mapfile -t packages <<<"$names"
  if [ "$(id -u)" -ne 0 ] && ! has sudo; then
    stop "These packages are missing, and installing them needs root:" \
      "  apt-get install --no-install-recommends ${packages[*]}" "($(sizes "${packages[@]}"))"
  fi
  # The lists of a fresh system are empty.
  if ! apt_knows "${packages[@]}"; then
    say "To install: ${packages[*]}"
    echo "First apt fetches its lists of packages."
    as_root "${apt_get[@]}" update
  fi
  say "Installing ${packages[*]}"
  echo "With what they need: $(sizes "${packages[@]}")"
  # Lists that are old name files that are gone: they are fetched once more then.
  as_root "${apt_get[@]}" install -y "${packages[@]}" ||
    { as_root "${apt_get[@]}" update && as_root "${apt_get[@]}" install -y "${packages[@]}"; } ||
    stop "The packages could not be installed: ${packages[*]}"
}

# tell_missing PACKAGE...: says in one line what is not installed as a package.
tell_missing() {
  local names
  if ! is_debian; then
    echo "Taken to be here: what the Debian packages ${*//|/ or } hold"
    return
  fi
  names=$(missing "$@")
  [ -z "$names" ] || echo "Not installed as packages: ${names//$'\n'/ }"
}

# prepare INSTALL PACKAGE...: needs the packages where INSTALL is yes, else tells what is missing.
prepare() {
  local install=$1
  shift
  if [ "$install" = yes ]; then need "$@"; else tell_missing "$@"; fi
}

# check_format INSTALL: the format of the sources, where the clang-format that it goes by can be had.
check_format() {
  if [ "$1" = yes ] && is_debian && ! has clang-format-14; then
    apt_knows "${format_packages[@]}" || as_root "${apt_get[@]}" update
    if apt_knows "${format_packages[@]}"; then need "${format_packages[@]}"; fi
  fi
  if has clang-format-14; then
    say "Format"
    "$root/scripts/format" --check
  else
    say "Format: not checked, this system has no clang-format-14"
  fi
}

has_builder() {
  case $1 in
    Ninja) has ninja ;;
    'Unix Makefiles') has make ;;
    *) false ;;
  esac
}

# generator FOLDER: prints what CMake is to write there: what it wrote before, Ninja's files, or make's.
generator() {
  local name before
  before=$(sed -n 's/^CMAKE_GENERATOR:INTERNAL=//p' "$1/CMakeCache.txt" 2>/dev/null || true)
  for name in "$before" Ninja 'Unix Makefiles'; do
    if has_builder "$name"; then
      printf '%s\n' "$name"
      return
    fi
  done
  stop "Neither ninja nor make is here; one of them builds the program: apt-get install ninja-build"
}

# configure PRESET: configures build/PRESET. CMake's last line says what is built without.
configure() {
  local folder=$root/build/$1 launcher=() chosen
  if has ccache; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  chosen=$(generator "$folder")
  # A folder whose builder is gone begins anew: CMake changes no generator.
  if [ -e "$folder/CMakeCache.txt" ] && ! grep -qx "CMAKE_GENERATOR:INTERNAL=$chosen" "$folder/CMakeCache.txt"; then
    rm -rf "$folder/CMakeCache.txt" "$folder/CMakeFiles"
  fi
  (cd "$root" && cmake --preset "$1" -G "$chosen" --log-level=NOTICE "${launcher[@]}" >/dev/null)
}

# build PRESET: configures and builds build/PRESET.
build() {
  say "Building build/$1"
  configure "$1"
  cmake --build "$root/build/$1" --parallel "$(nproc)"
}
