#!/usr/bin/env bash
# Whatever names the version names the same one. usage: version_test.sh SOURCE VERSION
set -euo pipefail
cd "$1"
version=$2

# says FILE PATTERN: the first thing that PATTERN (sed, one group) finds in FILE is the version.
says() {
  local found
  found=$(sed -nE "s/$2/\1/p" "$1" | head -n 1)
  [ "$found" = "$version" ] && return
  echo "$1 says ${found:-nothing}, CMake $version" >&2
  exit 1
}

says CITATION.cff '^version: (.*)$'
says packaging/pupflow.metainfo.xml '.*<release version="([^"]*)".*'
says CHANGELOG.md '^## \[([0-9.]+)\].*'
