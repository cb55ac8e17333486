# shellcheck shell=bash
# Shared by demo, check and the others of scripts, which source it: finds the source tree, installs what is
# missing (Debian and Ubuntu), configures and builds. Does nothing by itself.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

build_packages=(g++ cmake ninja-build pkg-config
  libeigen3-dev libcli11-dev libtomlplusplus-dev libpng-dev libhdf5-dev libisal-dev zlib1g-dev libfreetype-dev fonts-dejavu-core
  libegl-dev libgl-dev libglew-dev libglfw3-dev libx11-dev libgl1-mesa-dri libimgui-dev libstb-dev
  gnuplot-nox
  python3-dev python3-numpy pybind11-dev)
check_packages=(libgtest-dev libgmock-dev clang-format-14 xvfb xdotool imagemagick zsh
  ffmpeg doxygen libopenmpi-dev openmpi-bin libbenchmark-dev libarmadillo-dev
  python3-brian python3-h5py python3-h5netcdf python3-matplotlib python3-xarray)
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

# missing PACKAGE...: prints those that are not installed.
missing() {
  local package state
  for package in "$@"; do
    # dpkg-query fails for a package that it has never heard of: that one is missing too.
    state=$(dpkg-query -W -f '${db:Status-Status}\n' "$package" 2>/dev/null || true)
    grep -qx installed <<<"$state" || printf '%s\n' "$package"
  done
}

# need PACKAGE...: installs what is missing, or says what to install and stops.
need() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    stop "This is no Debian or Ubuntu system, so nothing can be installed here by itself." \
      "Install what these Debian packages hold: $*" \
      "Then run the same command again with --no-install."
  fi
  local packages
  mapfile -t packages < <(missing "$@")
  [ ${#packages[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    stop "These packages are missing, and installing them needs root:" \
      "  apt-get install ${packages[*]}"
  fi
  say "Installing ${packages[*]}"
  apt_install "${packages[@]}" || stop "The packages could not be installed: ${packages[*]}"
}

# The package lists of a fresh system are empty, those of another one may be old: they are fetched
# where apt does not know a package or cannot get it.
apt_install() {
  local get=(env DEBIAN_FRONTEND=noninteractive apt-get -q --no-install-recommends)
  if as_root "${get[@]}" install --simulate "$@" >/dev/null 2>&1; then
    as_root "${get[@]}" install -y "$@" && return
  fi
  as_root "${get[@]}" update && as_root "${get[@]}" install -y "$@"
}

# configure PRESET: configures build/PRESET.
configure() {
  local launcher=()
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  (cd "$root" && cmake --preset "$1" --log-level=WARNING "${launcher[@]}" >/dev/null)
}

# build PRESET: configures and builds build/PRESET.
build() {
  say "Building build/$1"
  configure "$1"
  cmake --build "$root/build/$1"
}
