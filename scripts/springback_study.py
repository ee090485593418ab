#!/usr/bin/env python3
"""Shell against solid in the springback of the U-bend, over elements, points or elements across, and increments.

    scripts/springback_study.py PROGRAM FOLDER [--write doc/springback.md]

Runs that are finished in FOLDER are not repeated. A quarter of an hour on one core.
"""
import argparse
import json
import os
import subprocess

import springback

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
FINE_STEPS = ["Steps/form/Largest increment=0.005", "Steps/release/Largest increment=0.01"]
# Name, scene, entries, what the table says.
RUNS = [
    ("shell", "u_bend", [], "175 elements, 9 points across"),
    ("shell_fine", "u_bend", ["Blank/Elements=350", "Blank/Layers=15"], "350 elements, 15 points across"),
    ("shell_steps", "u_bend", FINE_STEPS, "175 elements, 9 points across; increments a quarter as long"),
    ("solid", "u_bend_solid", [], "175 x 1 elements of degree 2"),
    ("solid_fine", "u_bend_solid", ["Blank/Elements=350"], "350 x 1 elements of degree 2"),
    ("solid_across", "u_bend_solid", ["Blank/Elements through thickness=2"], "175 x 2 elements of degree 2"),
    ("solid_both", "u_bend_solid", ["Blank/Elements=350", "Blank/Elements through thickness=2"], "350 x 2 elements of degree 2"),
]
LEFT_OUT = {"solid_both_2450N"}  # a quarter of an hour by itself
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
                yield f"| {holder} | {name.split('_')[0]}, {sentence} | stopped: {summary['message'][:80]} | | | |"
                continue
            theta1, theta2, rho = springback.measure_run(own)
            yield (f"| {holder} | {name.split('_')[0]}, {sentence} | {theta1:.2f} | {theta2:.2f} | {rho:.1f} | "
                   f"{summary['newton_iterations']} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folder")
    parser.add_argument("--write", metavar="PAGE")
    arguments = parser.parse_args()
    table = "\n".join(["| holder | blank | theta1 | theta2 | rho | iterations |", "|---|---|---:|---:|---:|---:|",
                       *rows(os.path.abspath(arguments.program), arguments.folder)])
    print(table)
    if arguments.write:
        with open(arguments.write, encoding="utf-8") as file:
            page = file.read()
        begin, end = "<!-- table -->\n", "<!-- end -->"
        before, rest = page.split(begin)
        with open(arguments.write, "w", encoding="utf-8") as file:
            file.write(before + begin + "\n" + table + "\n\n" + end + rest.split(end)[1])


if __name__ == "__main__":
    main()
