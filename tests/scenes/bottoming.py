#!/usr/bin/env python3
"""A bottomed V as a shell and as a solid: bottoming.py DELTAFORM SHELL SOLID FOLDER.

SOLID is prm/shop/v_bottoming.prm, SHELL the same with a shell. The angle of the shell does not depend on the increments: its pressure
through the thickness triples in the last increment, and where the stress of the sheet follows it an increment later, or loses it before the
forces, the released half angle is between 45.2 and 48.9 degrees, and the energies differ by 5 % of the work. What is left (2.2 %) is the
trapezoidal work of a force that triples. The shell springs back as the solid does, but is squeezed: its force is too large (1.12 to 1.24 times, by its
increments), and it says so.
"""
import json
import os
import subprocess
import sys

ANGLE = .2       # degrees between any two
IMBALANCE = .03  # of the work


def run(program, scene, output, *entries):
    subprocess.run([program, scene, "--quiet", "--force", "--output", output, "--set", "Output/Pictures=0"] +
                   [part for entry in entries for part in ("--set", entry)], check=True)
    with open(os.path.join(output, "summary.json"), encoding="utf-8") as file:
        return json.load(file)


def main():
    program, shell, solid, folder = sys.argv[1:]
    lengths = ("0.3", "0.15", "0.075")
    runs = [run(program, shell, os.path.join(folder, length), "Steps/bend/Largest increment=" + length) for length in lengths]
    runs.append(run(program, solid, os.path.join(folder, "solid")))
    wrong = []
    for name, summary in zip(lengths + ("solid",), runs):
        print(f"{name}: {summary['measures']['half']['bend_angle']:.3f} degrees, {summary['tools']['punch']['max_force']:.1f} N/mm, energies "
              f"differ by {summary['energy_error']:.4f}")
        if abs(summary["energy_error"]) > IMBALANCE:
            wrong.append(f"{name}: the energies differ by {summary['energy_error']:.2g}")
        if (name == "solid") == any(warning.startswith("squeezed shell") for warning in summary["warnings"]):
            wrong.append(f"{name}: the warnings are {summary['warnings']}")
    angles = [summary["measures"]["half"]["bend_angle"] for summary in runs]
    if max(angles) - min(angles) > ANGLE:
        wrong.append(f"the angle is between {min(angles):.2f} and {max(angles):.2f}")
    ratio = runs[-2]["tools"]["punch"]["max_force"] / runs[-1]["tools"]["punch"]["max_force"]
    if not 1.05 < ratio < 1.4:
        wrong.append(f"the force of the shell is {ratio:.3f} times that of the solid")
    sys.exit("; ".join(wrong) or 0)


if __name__ == "__main__":
    main()
