#!/usr/bin/env bash
# Installs what building and testing need on Debian 12 (also Debian 13, Ubuntu 22.04 and later). Done in a moment when
# everything is there; asks for sudo only when something is missing.
set -euo pipefail

packages=(git ca-certificates cmake ninja-build g++ python3 libdeal.ii-dev libboost-program-options-dev
          libboost-serialization-dev libboost-test-dev libeigen3-dev libfmt-dev nlohmann-json3-dev libspectra-dev
          libopenblas0-serial valgrind)
# Further packages may be named: scripts/setup.sh python3-vtk9 xvfb
packages+=("$@")

if ! command -v dpkg-query >/dev/null; then
  echo "setup: not a Debian system; these packages (or their like) are needed: ${packages[*]}" >&2
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
[[ ${#missing[@]} -eq 0 ]] && exit 0

as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "setup: as root, please: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup: installing ${missing[*]}"
"${as_root[@]}" apt-get update --quiet=2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --yes --quiet=2 --no-install-recommends "${missing[@]}"
