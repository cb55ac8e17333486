#!/usr/bin/env bash
# What a binary must not do: look for libraries in the current folder, keep its linkage tables
# writable, run code on its stack, or reach for a network.
set -euo pipefail
failed=0
wrong() { echo "$1: $2" >&2; failed=1; }

for binary in "$@"; do
  dynamic=$(readelf --dynamic --wide "$binary")
  paths=$(sed -nE 's/.*\((RUNPATH|RPATH)\).*\[(.*)\]/\2/p' <<<"$dynamic")
  if [ -n "$paths" ]; then
    while read -r -d : path; do
      [[ $path == /* ]] || [ "$path" = '$ORIGIN' ] || wrong "$binary" "looks for libraries in '$path'"
    done <<<"$paths:"
  fi
  grep -qE 'BIND_NOW|FLAGS_1.* NOW' <<<"$dynamic" || wrong "$binary" "binds lazily (-z now is missing)"
  segments=$(readelf --program-headers --wide "$binary")
  grep -q GNU_RELRO <<<"$segments" || wrong "$binary" "has no RELRO segment"
  grep -qE 'GNU_STACK.* RWE' <<<"$segments" && wrong "$binary" "has an executable stack"
  imported=$(nm --dynamic --undefined-only "$binary" |
    grep -oE '\b(socket|connect|bind|listen|accept4?|getaddrinfo|gethostbyname|sendto|recvfrom)(@|$)' || true)
  [ -z "$imported" ] || wrong "$binary" "imports $imported"
done
exit $failed
