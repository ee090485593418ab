#!/usr/bin/env python3
"""Shell against solid in the springback of the U-bend, over elements, points or elements across, and increments.

    scripts/studies/springback_study.py PROGRAM FOLDER [--write]

--write renews doc/measured/springback_u_bend.csv. Runs that are finished in FOLDER are not repeated. A quarter of an hour on one core.
"""
import argparse
import json
import os
import subprocess

from measured import ROOT, MeasuredTable

HALF_STEPS = ["Steps/form/Largest increment=0.0013", "Steps/release/Largest increment=0.01"]  # the program takes .0026 to .0032 on average
# Name, scene, entries, what the table says.
RUNS = [
    ("shell", "u_bend", [], "175 elements, 9 points across"),
    ("shell_fine", "u_bend", ["Blank/Elements=350", "Blank/Layers=15"], "350 elements, 15 points across"),
    ("shell_steps", "u_bend", HALF_STEPS, "175 elements, 9 points across; increments half as long"),
    ("solid", "u_bend_solid", [], "175 x 1 elements of degree 2"),
    ("solid_fine", "u_bend_solid", ["Blank/Elements=350"], "350 x 1 elements of degree 2"),
    ("solid_across", "u_bend_solid", ["Blank/Elements through thickness=2"], "175 x 2 elements of degree 2"),
    ("solid_both", "u_bend_solid", ["Blank/Elements=350", "Blank/Elements through thickness=2"], "350 x 2 elements of degree 2"),
]
LEFT_OUT = {"solid_both_2450N"}  # minutes by itself
HOLDERS = [("2450N", 35, "2.45 kN"), ("19600N", 280, "19.6 kN")]


def run(program, folder, scene, sets):
    if not os.path.exists(os.path.join(folder, "summary.json")):
        command = [program, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--output", folder]
        for entry in sets + ["Output/Pictures=0"]:
            command += ["--set", entry]
        subprocess.run(command, check=False)
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        return json.load(file)


def rows(program, folder):
    for label, force, holder in HOLDERS:
        for name, scene, entries, sentence in RUNS:
            if f"{name}_{label}" in LEFT_OUT:
                continue
            own = os.path.join(folder, f"{name}_{label}")
            summary = run(program, own, scene, entries + [f"Tools/holder/Force={force}"])
            if summary["exit_status"] != 0:
                yield holder, f"{name.split('_')[0]}, {sentence}", f"stopped: {summary['message'][:80]}", "", "", ""
                continue
            wall = summary["measures"]["wall"]
            yield (holder, f"{name.split('_')[0]}, {sentence}", f"{wall['theta1']:.2f}", f"{wall['theta2']:.2f}", f"{wall['rho']:.1f}",
                   summary["newton_iterations"])


def study(documentation, head, rows_of, name, title):
    """The main function of a study of springback: rows_of(PROGRAM, FOLDER) as a table."""
    parser = argparse.ArgumentParser(description=documentation.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    table = MeasuredTable(head, rows_of(os.path.abspath(arguments.program), arguments.folder))
    print(table)
    if arguments.write:
        table.write(name, title)


if __name__ == "__main__":
    study(__doc__, ["holder", "blank", "theta1", "theta2", "rho", "iterations"], rows, "springback_u_bend",
          "springback of the U-bend: angles [degree], side-wall curl [mm]")
