#!/usr/bin/env bash
# A report of one or more runs as one HTML file, report.html in the first folder; opens without network. Installs plotly when it is missing.
#   scripts/report.sh OUTPUT_FOLDER... [--file FILE]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if [[ $# -lt 1 ]]; then
  echo "usage: scripts/report.sh OUTPUT_FOLDER... [--file FILE]" >&2
  exit 64
fi
[[ " $* " == *" --plotly"* ]] || "$root/scripts/setup.sh" python3-plotly
exec python3 "$root/scripts/report.py" "$@"
