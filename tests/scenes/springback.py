#!/usr/bin/env python3
"""The U-bend of a shell springs back as that of a solid does: springback.py DELTAFORM SCENE FOLDER.

SCENE is prm/u_bend.prm, with the holder force of 19.6 kN on 35 mm of width. The solid has 350 x 2 elements of degree 2
(doc/verification.md); the tolerances are below the sum of what halving the elements changes in both: .3 and .9 degrees, 1.6 and .6 degrees,
1.7e-4 and 1.2e-3 per mm of curl.
"""
import json
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from csv_file import rows_of

REFERENCE = {"theta1": (95.41, 1.0), "theta2": (88.03, 2.1), "curl": (1 / 204.7, 1.2e-3)}


def main():
    program, scene, folder = sys.argv[1:]
    subprocess.run([program, scene, "--quiet", "--output", folder, "--set", "Tools/holder/Force=280", "--set", "Output/Pictures=0"],
                   check=True)
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        wall = json.load(file)["measures"]["wall"]
    found = {"theta1": wall["theta1"], "theta2": wall["theta2"], "curl": 1 / wall["rho"]}
    wrong = [f"{name} is {found[name]:.5g}, the solid has {value:.5g}" for name, (value, tolerance) in REFERENCE.items()
             if abs(found[name] - value) > tolerance]
    # The bottom does not arch: what an engineer would laugh at.
    released = max((os.path.join(folder, name) for name in os.listdir(folder) if name.startswith("profile_")), key=os.path.getmtime)
    rows = [{name: float(row[name]) for name in ("R0", "rotation", "equivalent_plastic_strain")} for row in rows_of(released)]
    if max(abs(row["rotation"]) for row in rows if row["R0"] < 15.) > .02:
        wrong.append("the bottom arches")
    strains = [row["equivalent_plastic_strain"] for row in rows]
    if max(strains) > .12:
        wrong.append(f"the plastic strain is {max(strains):.3g}")
    print(f"theta1 {wall['theta1']:.2f}, theta2 {wall['theta2']:.2f} degrees, rho {wall['rho']:.1f}")
    sys.exit("; ".join(wrong) or 0)


if __name__ == "__main__":
    main()
