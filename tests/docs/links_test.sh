#!/usr/bin/env bash
# Every relative link and picture of the README and docs/ leads to a file.
set -euo pipefail
cd "$1"
links=0 broken=0
for page in README.md CHANGELOG.md docs/*.md docs/*/*.md docs/reports/*/*.md; do
  while read -r target; do
    links=$((links + 1))
    [ -e "$(dirname "$page")/$target" ] && continue
    echo "$page links to $target, which is not there" >&2
    broken=$((broken + 1))
  done < <(grep -o '](\([^)# ]*\)' "$page" | sed 's/^](//' | grep -v -e '^https\?:' -e '^$' || true)
done
echo "$links links, $broken broken"
[ $links -gt 5 ] && [ $broken -eq 0 ]
