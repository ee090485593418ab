#!/usr/bin/env bash
# Two pictures of a run: plot.png (forces, strain, penetration, section) and render.png (the blank in colours, as a body
# if it is axisymmetric). Installs matplotlib and VTK when they are missing.
#   scripts/pictures.sh OUTPUT_FOLDER [FIELD]     default: equivalent_plastic_strain
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if [[ $# -lt 1 || $# -gt 2 || ! -f $1/history.csv ]]; then
  echo "usage: scripts/pictures.sh OUTPUT_FOLDER [FIELD]   (a folder with a history.csv)" >&2
  exit 64
fi
results=$1
field=${2:-equivalent_plastic_strain}

"$root/scripts/setup.sh" python3-matplotlib python3-vtk9 xvfb xauth

status=0
/usr/bin/python3 "$root/scripts/plot.py" "$results" || status=1

view=()
grep -q '^#.*plane strain' "$results/history.csv" || view=(--revolve)
if compgen -G "$results/blank_*.vtu" >/dev/null; then
  xvfb-run --auto-servernum /usr/bin/python3 "$root/scripts/render.py" "$results" --field "$field" "${view[@]}" || status=1
else
  echo "no blank_*.vtu in $results: nothing to render" >&2
fi
exit "$status"
