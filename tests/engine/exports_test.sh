#!/usr/bin/env bash
# The shared library exports what the public headers declare, under a version, and nothing else.
# usage: exports_test.sh LIBRARY FOLDER_OF_HEADERS
set -euo pipefail
library=$1 headers=$2
failed=0
wrong() { echo "$*" >&2; failed=1; }

for header in "$headers"/*.h; do
  # Not an attribute of the namespace: for clang that would leave out functions that are defined elsewhere.
  grep -q '^#pragma GCC visibility push(default)$' "$header" || wrong "$header exports nothing"
done

exported=$(nm --dynamic --defined-only --demangle "$library" | sed -E 's/^[0-9a-f]* *. //' |
  grep -v '^PUPFLOW_[0-9.]*$')
declared=$(cat "$headers"/*.h)
count=0
while read -r symbol; do
  count=$((count + 1))
  [[ $symbol == *@@PUPFLOW_* ]] || wrong "$symbol has no version"
  symbol=${symbol#typeinfo for } symbol=${symbol#typeinfo name for } symbol=${symbol#vtable for }
  if [[ $symbol != pupflow::* ]]; then
    wrong "$symbol is not in namespace pupflow"
    continue
  fi
  name=${symbol#pupflow::}
  name=${name%%[^A-Za-z0-9_]*}
  grep -qw "$name" <<<"$declared" || wrong "$symbol is in no public header"
done <<<"$exported"
[ $count -gt 100 ] || wrong "only $count symbols are exported"
grep -q '^pupflow::Simulation::step(' <<<"$exported" || wrong "pupflow::Simulation::step is not exported"
grep -q 'typeinfo for pupflow::InvalidParams' <<<"$exported" || wrong "InvalidParams could not be caught"
echo "$count symbols"
exit $failed
