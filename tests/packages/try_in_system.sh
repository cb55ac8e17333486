#!/usr/bin/env bash
# Installs the packages into a bare Debian, uses them as somebody who is not root, and removes them again.
# Needs root. usage: try_in_system.sh SYSTEM PACKAGE.deb...
# SYSTEM is the folder of a minimal system, which is changed.
set -euo pipefail
system=$1
shift
names=()
for package in "$@"; do names+=("$(dpkg-deb --field "$package" Package)"); done
mkdir -p "$system/packages"
cp "$@" "$system/packages"
chmod -R go=rX "$system/packages"

# inside COMMAND: by root in the system, with processes and mounts of its own.
inside() {
  unshare --mount --pid --fork chroot "$system" \
    env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    bash -euo pipefail -c "mount -t proc proc /proc; mount -t sysfs sysfs /sys; mount -t tmpfs tmpfs /dev/shm; $1"
}
files() { (cd "$system" && find . -path ./proc -prune -o -path ./sys -prune -o -path ./tmp -prune -o -path ./packages -prune -o -print | sort); }

say() { printf '\n-- %s\n' "$*"; }

# What the packages depend on, and what is used beside them, stays behind and is no trace of them.
inside "apt-get -q update
  needed=\$(apt-get -q install --simulate --no-install-recommends /packages/*.deb | awk '\$1 == \"Inst\" { print \$2 }')
  needed=\$(grep -vxF '$(printf '%s\n' "${names[@]}")' <<<\"\$needed\")
  apt-get -q install -y --no-install-recommends \$needed g++ cmake make pkg-config man-db bash-completion openmpi-bin"
inside "useradd --create-home --shell /bin/bash user"
files >"$system.before"

say "Installing ${names[*]}"
inside "apt-get -q install -y --no-install-recommends /packages/*.deb"

say "Beside those of another architecture"
inside "dpkg-query --show --showformat '\${Package} \${Multi-Arch}\n' ${names[*]}" >"$system.fields"
for line in 'libpupflow[0-9.]* same' 'libpupflow-dev same' 'pupflow-doc foreign'; do
  grep -x "$line" "$system.fields"
done

say "As somebody who is not root"
cat >"$system/tmp/try.sh" <<'TEXT'
set -euo pipefail
cd "$(mktemp -d)"
echo "* the program"
pupflow version
pupflow doctor
pupflow run cold --steps 20 --csv litter.csv --quiet
pupflow verify litter.csv
pupflow run --like litter.csv --csv again.csv --quiet
pupflow verify litter.csv again.csv
echo "* pictures"
pupflow figure1 --out figure1.png --quiet
[ "$(head -c 4 figure1.png | tail -c 3)" = PNG ]
echo "* a sweep by MPI"
mpirun -n 2 --oversubscribe pupflow sweep --vary ta=0.2,0.8 --seeds 1 --steps 5 --set discard=0 --out sweep --quiet
[ "$(wc -l <sweep/runs.csv)" -ge 3 ]
echo "* Python"
python3 -c 'import pupflow; litter = pupflow.Litter("cold"); litter.step(5); print(litter.tb.mean(), litter.image(64, 64).shape)'
echo "* the example project, by make"
cp -r /usr/share/doc/pupflow/docs/examples example
cmake -S example -B example/build >/dev/null
cmake --build example/build >/dev/null
example/build/warm_or_cold
sed 's/pupflow::engine)/pupflow::engine_shared)/' example/CMakeLists.txt >example/shared
mv example/shared example/CMakeLists.txt
cmake -S example -B example/shared >/dev/null
cmake --build example/shared >/dev/null
diff <(example/shared/warm_or_cold) <(example/build/warm_or_cold)
ldd example/shared/warm_or_cold | grep -F libpupflow.so
# shellcheck disable=SC2046  # words
g++ -std=c++20 example/warm_or_cold.cpp -o by_pkg_config $(pkg-config --cflags --libs pupflow)
diff <(./by_pkg_config) <(example/build/warm_or_cold)
echo "* man pages"
for page in /usr/share/man/man1/pupflow*; do
  man --warnings -l "$page" 2>warnings | grep -q 'EXIT STATUS'
  [ ! -s warnings ] || { cat "$page" warnings; exit 1; }
done
echo "* completion"
bash -ic 'source /usr/share/bash-completion/bash_completion; _completion_loader pupflow; complete -p pupflow' 2>/dev/null
TEXT
inside "runuser --login user --command 'bash /tmp/try.sh'"

say "Removing them"
inside "apt-get -q purge -y ${names[*]}"
files >"$system.after"
# Lists of what is installed, logs and caches of the system itself change with every installation.
diff <(grep -vE '^\./(var/(lib|cache|log)|home|run)/' "$system.before") \
  <(grep -vE '^\./(var/(lib|cache|log)|home|run)/' "$system.after")
if grep -i pupflow "$system.after" | grep -vE '^\./(home|var/log)/'; then
  echo "is left behind" >&2
  exit 1
fi
echo "nothing is left behind"
