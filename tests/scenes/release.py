#!/usr/bin/env python3
"""What a tool leaves behind is what it carried, for every rule, enforcement, delta and blank.

    release.py DELTAFORM SCENE FOLDER

SCENE is release_force.prm: its holder presses 8000 and leaves over the second stage.
"""
import os
import subprocess
import sys

from run_files import rows_of

FORCE = 8000.
VARIANTS = {
    "loose": ["Contact/Allowed penetration=1e-2*thickness"],
    "tight": ["Contact/Allowed penetration=1e-5*thickness"],
    "constant": ["Contact/Penalty rule=constant", "Contact/Penalty factor=1e5"],
    "element stiffness": ["Contact/Penalty rule=element stiffness"],
    "paper": ["Contact/Penalty rule=paper"],
    "proportional": ["Contact/Penalty rule=proportional"],
    "gap driven": ["Contact/Penalty rule=gap driven"],
    "augmented": ["Contact/Enforcement=augmented Lagrangian"],
    "compensated": ["Contact/Enforcement=adaptive compensated"],
    "active set": ["Contact/Enforcement=active set"],
    "outer fibre": ["Blank/Contact point=outer fibre"],
    "initial thickness": ["Tools/die/Contact thickness=initial", "Tools/holder/Contact thickness=initial"],
    "rigid": ["Tools/die/Thickness compliance=off", "Tools/holder/Thickness compliance=off"],
    "degree 2": ["Blank/Degree=2"],
    "solid": ["Blank/Kind=solid", "Blank/Elements through thickness=2"],
    "solid of degree 2": ["Blank/Kind=solid", "Blank/Degree=2", "Blank/Elements through thickness=1"],
}


def history(folder):
    return rows_of(os.path.join(folder, "history.csv"))


def check(program, scene, folder, sets):
    """Sentences on what is wrong."""
    command = [program, scene, "--quiet", "--output", folder]
    for entry in sets:
        command += ["--set", entry]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode != 0:
        return [f"status {run.returncode}: {run.stderr.strip()[:300]}"]
    rows = history(folder)
    wrong = []
    released = [row for row in rows if row["stage"] == "free"]
    for row in released:
        time, holder, die = (float(row[name]) for name in ("time", "holder_force_z", "die_force_z"))
        if abs(holder - FORCE * (2 - time)) > 1e-6 * FORCE:
            wrong.append(f"at {time:g} the holder leaves {holder:g}, not {FORCE * (2 - time):g}")
        if abs(holder + die) > 1e-4 * FORCE:
            wrong.append(f"at {time:g} holder and die carry {holder:g} and {die:g}")
    if len(released) < 5:
        wrong.append("the stage after the release is missing")
    return wrong[:3]


def main():
    program, scene, folder = sys.argv[1:]
    failed = 0
    for name, sets in VARIANTS.items():
        for sentence in check(program, scene, os.path.join(folder, name.replace(" ", "_")), sets):
            failed += 1
            print(f"{name}: {sentence}")
    print(f"{len(VARIANTS)} variants")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
