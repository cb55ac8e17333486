#!/usr/bin/env bash
# Every verb that prints JSON prints an object or a list that a JSON reader takes, and `run --json`
# has every digit that the CSV file has.
set -euo pipefail
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
reads() { python3 -c 'import json, sys; json.load(sys.stdin)' || { echo "no JSON: $*" >&2; exit 1; }; }

printf 'title = "A \\"quote\\" and more"\npups = 3\nsteps = 40\ndiscard = 39\n' >scene.toml
"$program" run scene.toml --json --csv run.csv >run.json
"$program" sweep scene.toml --vary ta=0,1 --seeds 2 --out a --quiet
"$program" sweep scene.toml --vary ta=0,1 --seeds 3 --out b --quiet
"$program" compare a b --json | reads compare
"$program" explain scene.toml --after 1 --json --quiet | reads explain
"$program" doctor --json | reads doctor
for verb in params fields scenes; do "$program" $verb --format json | reads $verb; done
python3 - <<'END'
import csv, json
with open("run.json") as file:
    run = json.load(file)
with open("run.csv") as file:
    last = list(csv.DictReader(line for line in file if not line.startswith("#")))[-1]
assert run["title"] == 'A "quote" and more', run["title"]
assert run["steps"] == 40 and run["steps_in_means"] == 1, run
assert run["means"]["mean_tb"] == float(last["mean_tb"]), (run["means"], last)
assert run["parameters"]["pups"] == 3 and run["status"] == "fine"
END
