#!/usr/bin/env bash
# Runs every command of a page, from its ```sh blocks, in an empty folder, with the program's folder
# in front of PATH. The live window is left to tests/window: it needs a display.
set -euo pipefail
page=$1 program_folder=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$page" |
  grep -v '^pupflow live' >"$work/commands" || true
[ -s "$work/commands" ] || { echo "$page shows no command" >&2; exit 1; }
mkdir "$work/here"
cd "$work/here"
PATH=$program_folder:$PATH bash -eux "$work/commands" </dev/null
