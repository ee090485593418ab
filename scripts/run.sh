#!/usr/bin/env bash
# The main job in one command: sets up, builds, computes the cup of prm/cup.prm and says where the results are.
#   scripts/run.sh [SCENE.prm [options of deltaform]]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release
scene=${1:-$root/prm/cup.prm}
shift || true
results=$root/output/$(basename "$scene" .prm)

"$root/scripts/build.sh" "$build" deltaform

status=0
"$build/deltaform" "$scene" --output "$results" "$@" || status=$?
# 2 and 3 stop on the way, with everything up to there on disk.
((status == 0 || status == 2 || status == 3)) || exit "$status"

cat <<TEXT

Results: ${results#"$PWD"/}
  history.csv      forces, travels, penetration, energies: a row per increment
  profile_*.csv    thickness, strains, stresses along the blank
  contact_*.csv    the touching points: penetration, allowed penetration, pressure, slip
  scene.pvd        open this in ParaView
  summary.json     the outcome in a page
Pictures of them:  scripts/pictures.sh ${results#"$PWD"/}
TEXT
exit "$status"
