#!/usr/bin/env bash
# Is the C++ formatted, and does clang-tidy like it? Prints the findings; exit status 1 if there are any.
#   scripts/check_style.sh                       both (clang-tidy needs a configured build folder, and minutes)
#   scripts/check_style.sh --format              clang-format only
#   scripts/check_style.sh --tidy [FOLDER] [REGEX]  clang-tidy only; build folder (build/release), files that match
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit 1
what=${1:-all}
status=0

if [[ $what == all || $what == --format ]]; then
  mapfile -t files < <(find source include tests -name '*.h' -o -name '*.cc' | sort)
  if ! command -v clang-format >/dev/null; then
    echo "check_style: clang-format is not installed" >&2
    status=1
  else
    findings=$(clang-format --dry-run -Werror "${files[@]}" 2>&1)
    if [[ -n $findings ]]; then
      echo "Not formatted (clang-format -i FILE would do it):"
      grep -oE '^[^: ]+\.(h|cc):' <<<"$findings" | sort -u | tr -d ':'
      status=1
    else
      echo "${#files[@]} files are formatted"
    fi
    if grep -nE '.{121,}' "${files[@]}"; then
      echo "These lines have more than 120 columns."
      status=1
    fi
  fi
fi

if [[ $what == all || $what == --tidy ]]; then
  build=${2:-build/release}
  if [[ ! -f $build/compile_commands.json ]]; then
    echo "check_style: no compile_commands.json in $build: scripts/build.sh first" >&2
    exit 1
  fi
  # Without what only g++ understands: its precompiled header, and flags of optimization.
  commands=$(mktemp -d)
  trap 'rm -rf "$commands"' EXIT
  sed -E 's# -Winvalid-pch##; s# -include [^ ]*cmake_pch\.hxx##; s# -funroll-[a-z-]*loops##g' \
    "$build/compile_commands.json" >"$commands/compile_commands.json"
  mapfile -t sources < <(python3 - "$commands/compile_commands.json" "${3:-.}" <<'PY'
import json, re, sys
print("\n".join(sorted({entry["file"] for entry in json.load(open(sys.argv[1]))
                        if re.search(sys.argv[2], entry["file"]) and "cmake_pch" not in entry["file"]})))
PY
)
  findings=$(printf '%s\n' "${sources[@]}" |
    xargs -P "$(nproc)" -n 1 clang-tidy -p "$commands" --quiet --extra-arg=-Wno-unknown-warning-option 2>/dev/null |
    grep -E '(warning|error):' | sort -u)
  if [[ -n $findings ]]; then
    echo "${findings//$root\//}"
    echo "$(wc -l <<<"$findings") findings of clang-tidy in ${#sources[@]} files"
    status=1
  else
    echo "clang-tidy has nothing to say about ${#sources[@]} files"
  fi
fi
exit "$status"
