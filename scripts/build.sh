#!/usr/bin/env bash
# Sets up, configures and builds in Release.
#   scripts/build.sh [FOLDER [TARGET...]]     default: everything, into build/release
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=${1:-$root/build/release}
shift || true

"$root/scripts/setup.sh"

mkdir -p "$folder"
if [[ ! -f $folder/build.ninja ]]; then
  cmake -G Ninja -S "$root" -B "$folder" -DCMAKE_BUILD_TYPE=Release >"$folder/configure.log" 2>&1 ||
    { cat "$folder/configure.log" >&2; exit 1; }
fi

# A compiler process takes up to 1.5 GB here: no more of them than cores, nor than memory allows.
jobs=$(nproc)
room=$(awk '/MemAvailable/ {print int($2 / 1500000)}' /proc/meminfo)
((room < jobs)) && jobs=$((room > 0 ? room : 1))
ninja -C "$folder" -j "$jobs" "$@"
