#!/usr/bin/env bash
# Every test that a page promises is there: patterns_test.sh SOURCE BUILD PRESET. In each command
# `ctest --preset PRESET -R PATTERN` of the pages, each alternative of the pattern must match the name
# of a test in the folder BUILD.
set -euo pipefail
source=$1 build=$2 preset=$3

names=$(ctest --test-dir "$build" -N | sed -n 's/^ *Test *#[0-9]*: //p')
# A table of a page writes | as \|.
commands=$(sed 's/\\|/|/g' "$source"/README.md "$source"/docs/*.md |
  grep -oE "ctest --preset $preset -R ('[^']+'|[^] \`'|]+)" || true)
patterns=$(sed -E "s/.* -R //; s/'//g" <<<"$commands" | tr '|' '\n')
[ -n "$patterns" ] || { echo "no page names a test of preset $preset"; exit 1; }

failed=0 count=0
while read -r pattern; do
  count=$((count + 1))
  grep -qE -- "$pattern" <<<"$names" && continue
  echo "no test of preset $preset matches $pattern"
  failed=1
done <<<"$patterns"
echo "$count patterns of preset $preset"
exit $failed
