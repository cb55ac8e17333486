#!/usr/bin/env bash
# Every file and folder that docs/architecture.md names is there, and every folder of the code is named.
# A name without a slash may lie anywhere; `x.*` stands for x.h, x.cpp, ....
set -euo pipefail
cd "$1"
page=docs/architecture.md
wrong=0

complain() {
  echo "$page: $*" >&2
  wrong=1
}

all=$(git ls-files 2>/dev/null || true)
[ -n "$all" ] || all=$(find . -path ./build -prune -o -type f -printf '%P\n')

# there NAME: whether a file is called so, with whatever folders before it, or a folder.
there() {
  local pattern=${1//./\\.}
  pattern=${pattern//\\.\*/\\.[a-z]+}
  pattern=${pattern//\*/[^/]*}
  pattern=${pattern%/}
  grep -qE "(^|/)$pattern(/|$)" <<<"$all"
}

# shellcheck disable=SC2016  # the quotes are the page's
names=$(grep -oE '`[A-Za-z0-9_./*-]+`' "$page" | tr -d '`' | grep -E '/|\.(h|cpp|inl|md|py|txt|sh|json|glsl|\*)$' |
  grep -vE '^(pupflow/…|build/.*|\./.*|/.*)$' | sort -u)
for name in $names; do
  there "$name" || complain "names $name, which is not there"
done
for folder in engine/ python/ bench/ shaders/ assets/ tests/ packaging/ $(grep -oE '^app/[a-z]+/' <<<"$all" | sort -u); do
  grep -qF "\`$folder" "$page" || complain "does not name the folder $folder"
done
echo "$(wc -w <<<"$names") names"
exit $wrong
