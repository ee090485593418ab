#!/usr/bin/env python3
"""The angle of a bottomed V does not depend on the increments: bottoming.py DELTAFORM SCENE FOLDER.

SCENE is prm/shop/v_bottoming.prm. Its pressure through the thickness triples in the last increment; where the stress of the sheet follows
it an increment later, or loses it before the forces, the released half angle is between 43.5 and 47.2 degrees, and the energies differ by
5 % of the work. What is left (2.2 %) is the trapezoidal work of a force that triples.
"""
import json
import os
import subprocess
import sys

ANGLE = .2       # degrees between any two
IMBALANCE = .03  # of the work


def main():
    program, scene, folder = sys.argv[1:]
    angles, wrong = [], []
    for length in ("0.3", "0.15", "0.075"):
        output = os.path.join(folder, length)
        subprocess.run([program, scene, "--quiet", "--force", "--output", output, "--set", "Steps/bend/Largest increment=" + length,
                        "--set", "Output/Pictures=0"], check=True)
        with open(os.path.join(output, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        angles.append(summary["measures"]["half"]["bend_angle"])
        print(f"largest increment {length}: {angles[-1]:.3f} degrees, energies differ by {summary['energy_error']:.4f}")
        if abs(summary["energy_error"]) > IMBALANCE:
            wrong.append(f"with {length} the energies differ by {summary['energy_error']:.2g}")
    if max(angles) - min(angles) > ANGLE:
        wrong.append(f"the angle is between {min(angles):.2f} and {max(angles):.2f}")
    sys.exit("; ".join(wrong) or 0)


if __name__ == "__main__":
    main()
