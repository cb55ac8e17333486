#!/usr/bin/env bash
# Builds packaging/Containerfile on a bare Debian in a folder, with buildah, and runs its program. Needs root,
# and no service. usage: try_container.sh SYSTEM [OPTION_OF_BUILD...]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
system=$1
shift
store=$(mktemp -d)
trap 'rm -rf --one-file-system "$store"' EXIT
export BUILDAH_ISOLATION=chroot
# Plain folders in place of mounts that not every file system bears.
image() { buildah --storage-driver vfs --root "$store/images" --runroot "$store/run" "$@"; }

base=$(image from scratch)
tar --create --directory "$system" . >"$store/system.tar"
image add --quiet "$base" "$store/system.tar" / >/dev/null
rm "$store/system.tar"
image commit --quiet --rm "$base" localhost/bare >/dev/null
image build --quiet --build-arg BASE=localhost/bare --file "$root/packaging/Containerfile" \
  --ignorefile "$root/packaging/Containerfile.dockerignore" --tag pupflow "$@" "$root"

container=$(image from pupflow)
[ "$(image inspect --format '{{.OCIv1.Config.Entrypoint}}' "$container")" = "[pupflow]" ]
folder=$(image mount "$container")/work
chmod 777 "$folder"
image run --user 1000:1000 "$container" -- pupflow doctor
image run --user 1000:1000 "$container" -- pupflow figure1 --out figure1.png --quiet
[ "$(head -c 4 "$folder/figure1.png" | tail -c 3)" = PNG ]
image run --user 1000:1000 "$container" -- pupflow sweep --vary ta=0.2,0.8 --seeds 1 --steps 5 --set discard=0 --out sweep --quiet
[ -s "$folder/sweep/runs.csv" ]
image run --user 1000:1000 "$container" -- python3 -c 'import pupflow; print(pupflow.Litter("cold").tb.mean())'
echo "the container works"
