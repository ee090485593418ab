#!/usr/bin/env python3
"""The U-bend of a metal with and without memory: springback_metals.py DELTAFORM FOLDER. A minute.

Mild steel of NUMISHEET'93 at a holder force of 2.45 kN. Published angles scatter: theta1 98 to 107, theta2 80 to 90 degrees; a mesh
twice as fine moves them by .5 and .6 degrees. A metal with a Bauschinger effect, whose modulus falls, springs back further than an
isotropic one: by more than the mesh does.
"""
import os
import shutil
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts", "studies"))
from springback_metals import METALS  # noqa: E402
from springback_study import run  # noqa: E402

MESH_ANGLE, MESH_CURL = .6, 1e-4  # degrees, 1/mm


def main():
    program, folder = os.path.abspath(sys.argv[1]), sys.argv[2]
    shutil.rmtree(folder, ignore_errors=True)  # run() does not repeat what is there
    walls = []
    for name, _, constants in METALS:
        summary = run(program, os.path.join(folder, name), "u_bend",
                      ["Material/" + entry for entry in constants] + ["Blank/Layers=15", "Tools/holder/Force=35"])
        if summary["exit_status"] != 0:
            sys.exit(f"{name}: {summary['message']}")
        walls.append(summary["measures"]["wall"])
        print(name, walls[-1])
    wrong = [f"{what} is {wall[what]:.2f}, published are {low} to {high}" for wall in walls
             for what, low, high in (("theta1", 98, 107), ("theta2", 80, 90)) if not low - MESH_ANGLE < wall[what] < high + MESH_ANGLE]
    isotropic, remembers = walls
    more = {"theta1": (remembers["theta1"] - isotropic["theta1"], MESH_ANGLE),
            "theta2": (isotropic["theta2"] - remembers["theta2"], MESH_ANGLE),
            "curl": (1 / remembers["rho"] - 1 / isotropic["rho"], MESH_CURL)}
    wrong += [f"{what} springs back further by {value:.2g} only" for what, (value, mesh) in more.items() if value < mesh]
    sys.exit("; ".join(wrong) or 0)


if __name__ == "__main__":
    main()
