#!/usr/bin/env bash
# All tests in one command: sets up, builds, runs them two at a time. The last line counts: "N passed, M failed".
#   scripts/test.sh [options of ctest, such as -R contact]
# Without those of the label extra, which need packages of their own (scripts/test_extra.sh), and of the label long (ctest -L long).
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build/release

if ! "$root/scripts/build.sh" "$build"; then
  echo "The build failed; no test has run."
  echo "0 passed, 1 failed"
  exit 1
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
(cd "$build" && ctest -j2 --output-on-failure -LE "extra|long" "$@") 2>&1 | tee "$log"
status=${PIPESTATUS[0]}

# "97% tests passed, 3 tests failed out of 100" is ctest's way to say it.
failed=$(sed -n 's/.*tests passed, \([0-9]*\) tests failed out of.*/\1/p' "$log")
total=$(sed -n 's/.*tests failed out of \([0-9]*\).*/\1/p' "$log")
if [[ -z $total || $total -eq 0 ]]; then
  echo "no test has run" >&2
  exit 1
fi
echo "$((total - failed)) passed, $failed failed"
exit "$status"
