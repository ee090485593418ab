#!/usr/bin/env python3
"""Without energies a run is the same, to the last digit, and says nothing about them.

    without_energies.py DELTAFORM SCENE FOLDER [--set SECTION/ENTRY=VALUE]...
"""
import json
import os
import subprocess
import sys

from run_files import rows_of


def history(folder):
    return rows_of(os.path.join(folder, "history.csv"))


def main():
    program, scene, folder, *sets = sys.argv[1:]
    rows, summaries = [], []
    for flag in ("true", "false"):
        own = os.path.join(folder, flag)
        subprocess.run([program, scene, "--quiet", "--output", own, *sets, "--set", "Output/Pictures=0", "--set", f"Output/Energies={flag}"],
                       check=True)
        rows.append(history(own))
        with open(os.path.join(own, "summary.json"), encoding="utf-8") as file:
            summaries.append(json.load(file))
    gone = [name for name in rows[0][0] if name not in rows[1][0]]
    wrong = [name for name in gone if not (name.endswith(("_energy", "_work")) or name == "energy_error")]
    if wrong or len(gone) != 9 or "energy_error" not in summaries[0] or "energy_error" in summaries[1]:
        sys.exit(f"without_energies.py: the columns {gone} are gone")
    if len(rows[0]) != len(rows[1]):
        sys.exit(f"without_energies.py: {len(rows[0])} increments with energies, {len(rows[1])} without")
    for a, b in zip(*rows):
        for name, value in b.items():
            if value != a[name]:
                sys.exit(f"without_energies.py: increment {a['increment']}, {name}: {a[name]} with energies, {value} without")
    print(f"{len(rows[0])} increments are the same without energies")


if __name__ == "__main__":
    main()
