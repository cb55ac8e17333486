#!/usr/bin/env bash
# The program that the README shows is the one that the tests compile.
set -euo pipefail
cd "$1"
diff <(awk '/^```cpp$/ { inside = 1; next } /^```/ { inside = 0 } inside' README.md) \
  docs/examples/warm_or_cold.cpp
