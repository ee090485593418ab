#!/usr/bin/env bash
# The tests of the label extra: the Python package and its examples, the plot of a sweep, the report in a browser, the Debian
# package. Installs what they need on Debian, builds, runs them one at a time. The last line counts: "N passed, M failed".
#   scripts/test_extra.sh [options of ctest, such as -R python]
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release

"$root/scripts/setup.sh" python3-dev pybind11-dev python3-numpy python3-scipy python3-matplotlib \
  python3-plotly python3-selenium chromium chromium-driver dpkg-dev file || exit 1
"$root/scripts/build.sh" "$build" || exit 1
# The packages may be newer than the build folder.
cmake -S "$root" -B "$build" >/dev/null && "$root/scripts/build.sh" "$build" || exit 1

log=$(mktemp)
trap 'rm -f "$log"' EXIT
(cd "$build" && ctest --output-on-failure -L extra "$@") 2>&1 | tee "$log"
status=${PIPESTATUS[0]}
failed=$(sed -n 's/.*tests passed, \([0-9]*\) tests failed out of.*/\1/p' "$log")
total=$(sed -n 's/.*tests failed out of \([0-9]*\).*/\1/p' "$log")
if [[ -z $total || $total -eq 0 ]]; then
  echo "no test has run" >&2
  exit 1
fi
echo "$((total - failed)) passed, $failed failed"
exit "$status"
