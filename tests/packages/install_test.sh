#!/usr/bin/env bash
# Installs a build into a folder, as a whole and by components: every file belongs to a component of the
# table, none is missing, the program works where the tree is moved to, and uninstall leaves nothing.
# usage: install_test.sh BUILD WORK PREFIX LIBRARY_FOLDER PYTHON PYTHON_FOLDER COMPONENT...
# (PYTHON runs Python; the folders are below the prefix; the components are those of the build)
set -euo pipefail
build=$1 work=$2 prefix=$3 lib=$4 python=$5 packages=$6
shift 6
failed=0
wrong() { echo "$*" >&2; failed=1; }

# A component and a pattern of its files, below the prefix.
table="\
program  bin/pupflow
program  share/doc/pupflow/LICENSE
program  share/doc/pupflow/[A-Z.a-z]*
program  share/man/man1/pupflow.1
program  share/man/man1/pupflow-[a-z]*.1
program  share/bash-completion/completions/pupflow
program  share/zsh/vendor-completions/_pupflow
program  share/pupflow/scenes/*.toml
doc      share/doc/pupflow/docs/*.md
doc      share/doc/pupflow/docs/*
graphics $lib/pupflow/libpupflow_graphics.so
graphics share/applications/pupflow.desktop
graphics share/metainfo/pupflow.metainfo.xml
graphics share/icons/hicolor/scalable/apps/pupflow.svg
mpi      $lib/pupflow/libpupflow_mpi.so
python   $packages/pupflow/_core.*.so
python   $packages/pupflow/*.py
python   $packages/pupflow/*.pyi
python   $packages/pupflow/py.typed
library  $lib/libpupflow.so.[0-9]*
engine   $lib/libpupflow.so
engine   $lib/libpupflow.a
engine   $lib/pkgconfig/pupflow.pc
engine   $lib/cmake/pupflow/pupflow*.cmake
engine   include/pupflow/*.h"

files_in() { (cd "$1$prefix" && find . -type f -o -type l | sed 's#^\./##' | sort); }

rm -rf "$work"
DESTDIR=$work/all cmake --install "$build" >/dev/null
files_in "$work/all" >"$work/of_all"
: >"$work/of_components"
for component in "$@"; do
  DESTDIR=$work/$component cmake --install "$build" --component "$component" >/dev/null
  files_in "$work/$component" >"$work/files"
  cat "$work/files" >>"$work/of_components"
  patterns=()
  while read -r name pattern; do
    [ "$name" != "$component" ] || patterns+=("$pattern")
  done <<<"$table"
  declare -A met=()
  while read -r file; do
    known=no
    for pattern in "${patterns[@]}"; do
      # shellcheck disable=SC2053  # a pattern
      if [[ $file == $pattern ]]; then known=yes met[$pattern]=yes; fi
    done
    [ $known = yes ] || wrong "component $component has $file, which the table has not"
  done <"$work/files"
  for pattern in "${patterns[@]}"; do
    [ -n "${met[$pattern]-}" ] || wrong "component $component lacks $pattern"
  done
  unset met
done
sort "$work/of_components" | diff - "$work/of_all" >&2 || wrong "components and the whole differ (> is in no component)"

# Moved elsewhere, program and module still find what they load.
mv "$work/all$prefix" "$work/moved"
cd "$work"
[[ $(moved/bin/pupflow version) == *[0-9].[0-9].[0-9]* ]] || wrong "the moved program does not work"
moved/bin/pupflow render --steps 1 --size 64x64 --out moved.png --quiet || wrong "the moved program draws nothing"
if [[ " $* " == *" python "* ]]; then
  PYTHONPATH=$work/moved/$packages PYTHONDONTWRITEBYTECODE=1 "$python" -c \
    'import pupflow; litter = pupflow.Litter("cold"); litter.step(1); litter.image(64, 64)' ||
    wrong "the moved module does not work"
fi
mkdir -p "$(dirname "$work/all$prefix")"
mv moved "$work/all$prefix"

DESTDIR=$work/all cmake --build "$build" --target uninstall >/dev/null
left=$(cd "$work/all" && find . ! -type d -o -path '*/pupflow*')
[ -z "$left" ] || wrong "uninstall left: $left"
exit $failed
