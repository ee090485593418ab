#!/usr/bin/env python3
"""timing.json accounts for a run: every numbered step is there, called as often as increments and iterations say, and what
stands under no name is little.

    steps_are_timed.py PROGRAM SCENE FOLDER
"""
import json
import re
import subprocess
import sys
from pathlib import Path


def main():
    program, scene, folder = sys.argv[1:]
    subprocess.run([program, scene, "--quiet", "--output", folder, "--set", "Steps/form/End time=0.4"], check=True)
    timing = json.loads((Path(folder) / "timing.json").read_text())
    summary = json.loads((Path(folder) / "summary.json").read_text())
    calls = {re.match("[0-9-]*", section["name"]).group(): section["calls"] for section in timing["sections"]}
    missing = {"1", "2", "3-6", "7-9", "10", "11", "12", "13"} - calls.keys()
    if missing:
        sys.exit(f"no step {', '.join(sorted(missing))} among {', '.join(calls)}")

    increments, iterations = summary["increments"], summary["newton_iterations"]
    if not (calls["1"] == 1 and calls["2"] == calls["3-6"] and calls["12"] == increments <= calls["13"]
            and calls["11"] >= iterations and increments <= calls["10"] <= calls["11"]):
        sys.exit(f"calls do not fit {increments} increments and {iterations} iterations: {calls}")

    named = sum(section["seconds"] for section in timing["sections"]) / timing["total"]
    print(f"named steps: {named:.0%} of the run")
    if not 0.6 <= named < 1.01:
        sys.exit(f"the named steps take {named:.0%} of the run: {timing}")


if __name__ == "__main__":
    main()
