#!/usr/bin/env bash
# What a binary must not do: look for libraries in the current folder, lie at a fixed address, keep
# its linkage tables writable, run code on its stack, leave stacks and buffers unchecked, reach for a
# network, or show the engine that it holds to others.
set -euo pipefail
failed=0
wrong() { echo "$1: $2" >&2; failed=1; }

checked_buffers=no
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
  readelf --file-header --wide "$binary" | grep -qE 'Type: +DYN' || wrong "$binary" "lies at a fixed address"
  symbols=$(nm --dynamic --undefined-only "$binary")
  grep -q __stack_chk_fail <<<"$symbols" || wrong "$binary" "has no stack protector"
  grep -qE '__(memcpy|memmove|snprintf|vsnprintf|fprintf|vfprintf|read|printf)_chk' <<<"$symbols" && checked_buffers=yes
  imported=$(grep -oE '\b(socket|connect|bind|listen|accept4?|getaddrinfo|gethostbyname|sendto|recvfrom)(@|$)' <<<"$symbols" || true)
  [ -z "$imported" ] || wrong "$binary" "imports $imported"
  exported=$(nm --dynamic --defined-only "$binary" | grep -c '_ZNK\?7pupflow10Simulation' || true)
  [ "$exported" = 0 ] || wrong "$binary" "exports $exported functions of the engine"
done
[ $checked_buffers = yes ] || wrong "all binaries" "were built without _FORTIFY_SOURCE"
exit $failed
