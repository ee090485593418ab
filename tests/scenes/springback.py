#!/usr/bin/env python3
"""The U-bend of a shell springs back as that of a solid does: springback.py DELTAFORM SCENE FOLDER.

SCENE is prm/u_bend.prm, with the holder force of 19.6 kN on 35 mm of width. The solid has 350 x 2 elements of degree 2
(doc/verification.md); the tolerances are the sum of what both meshes are known to leave: .3 and .7 degrees, 1.3 and .8 degrees,
1.4e-4 and 1.1e-3 per mm of curl.
"""
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
import springback

REFERENCE = {"theta1": (95.31, 1.0), "theta2": (87.87, 2.1), "curl": (1 / 205.0, 1.2e-3)}


def main():
    program, scene, folder = sys.argv[1:]
    subprocess.run([program, scene, "--quiet", "--output", folder, "--set", "Tools/holder/Force=280", "--set", "Output/Pictures=0"],
                   check=True)
    theta1, theta2, rho = springback.measure_run(folder)
    found = {"theta1": theta1, "theta2": theta2, "curl": 1 / rho}
    wrong = [f"{name} is {found[name]:.5g}, the solid has {value:.5g}" for name, (value, tolerance) in REFERENCE.items()
             if abs(found[name] - value) > tolerance]
    # The bottom does not arch: what an engineer would laugh at.
    released = springback.table(max((os.path.join(folder, name) for name in os.listdir(folder) if name.startswith("profile_")),
                                    key=os.path.getmtime))
    bottom = [row for row in released if row["R0"] < 15.]
    if max(abs(row["rotation"]) for row in bottom) > .02:
        wrong.append("the bottom arches")
    strains = [row["equivalent_plastic_strain"] for row in released]
    if max(strains) > .12:
        wrong.append(f"the plastic strain is {max(strains):.3g}")
    print(f"theta1 {theta1:.2f}, theta2 {theta2:.2f} degrees, rho {rho:.1f}")
    sys.exit("; ".join(wrong) or 0)


if __name__ == "__main__":
    main()
