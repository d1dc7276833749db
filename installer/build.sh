#!/usr/bin/env bash
# Installs what is missing, configures a preset and builds it.   installer/build.sh PRESET [TARGET...]
# Quiet unless something fails; on a terminal ninja's progress line shows.
set -euo pipefail
cd "$(dirname "$0")/.."
preset=$1
shift
installer/install_packages.sh

folder=build
[[ $preset == release ]] || folder=build-$preset
mkdir -p "$folder"
log=$folder/lacuna-build.log
fail() {
    grep -v '^\[[0-9]*/[0-9]*\] ' "$log" | tail -n 60 >&2 || true
    echo "The $preset build failed; the whole log is $folder/lacuna-build.log" >&2
    exit 1
}
if [[ ! -f $folder/build.ninja ]]; then
    echo "Configuring ($preset)"
    if ! cmake --preset "$preset" >"$log" 2>&1; then
        rm -f "$folder/build.ninja"
        fail
    fi
fi

build=(cmake --build "$folder")
[[ $# -eq 0 ]] || build+=(--target "$@")
if [[ -t 1 ]]; then
    "${build[@]}" 2>&1 | tee "$log" | sed -u -n 's/^\(\[[0-9]*\/[0-9]*\]\).*/\1/p' |
        while read -r step; do printf '\rBuilding (%s) %s\033[K' "$preset" "$step"; done || { echo; fail; }
    printf '\r\033[K'
else
    [[ -f $folder/.built ]] || echo "Building ($preset); the first time takes several minutes"
    "${build[@]}" >"$log" 2>&1 || fail
fi
touch "$folder/.built"
