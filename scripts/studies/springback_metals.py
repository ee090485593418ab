#!/usr/bin/env python3
"""Springback of the U-bend with isotropic hardening against Yoshida and Uemori's backstress, over meshes and increments.

    scripts/studies/springback_metals.py PROGRAM FOLDER [--write]

Mild steel of NUMISHEET'93 with r0 = 1.79, r90 = 2.27 (Hill 1948). --write renews doc/measured/springback_metals.csv. Runs that are
finished in FOLDER are not repeated. Ten minutes on one core.
"""
import os

from springback_study import HOLDERS, run, study

HILL = ["Yield surface/Law=hill", "Yield surface/r0=1.79", "Yield surface/r90=2.27"]
YOSHIDA_UEMORI = ["Young's modulus=205e3", "Falling modulus/Saturated modulus=159e3", "Falling modulus/Rate=61",
                  "Hardening/Law=perfectly plastic", "Hardening/Flow stress=124",
                  "Backstress/Law=yoshida-uemori", "Backstress/Yield stress=124", "Backstress/Bounding stress=168",
                  "Backstress/Yield surface rate=500", "Backstress/Bounding surface rate=12.5",
                  "Backstress/Bounding backstress=9.3", "Backstress/Stagnation=0.5", "Backstress/Saturation stress=190"]
METALS = [("isotropic", "isotropic (Swift)", HILL), ("yoshida_uemori", "Yoshida and Uemori", HILL + YOSHIDA_UEMORI)]
BASE = ["Blank/Layers=15"]
HALF_STEPS = ["Steps/form/Largest increment=0.0009", "Steps/release/Largest increment=0.01"]  # the program takes .0018 on average
# Name, entries, what the table says, holder forces: one thing changes at a time.
MESHES = [
    ("base", BASE, "175 elements, 15 layers", HOLDERS),
    ("elements", BASE + ["Blank/Elements=350"], "350 elements, 15 layers", HOLDERS),
    ("layers", ["Blank/Layers=9"], "175 elements, 9 layers", HOLDERS[:1]),
    ("steps", BASE + HALF_STEPS, "175 elements, 15 layers, increments half as long", HOLDERS),
]


def rows(program, folder):
    for name, entries, sentence, holders in MESHES:
        for holder_name, force, holder in holders:
            for metal_name, metal, constants in METALS:
                summary = run(program, os.path.join(folder, f"{metal_name}_{name}_{holder_name}"), "u_bend",
                              ["Material/" + entry for entry in constants] + entries + [f"Tools/holder/Force={force}"])
                if summary["exit_status"] != 0:
                    yield holder, metal, sentence, f"stopped: {summary['message'][:80]}", "", "", ""
                    continue
                wall = summary["measures"]["wall"]
                yield (holder, metal, sentence, f"{wall['theta1']:.2f}", f"{wall['theta2']:.2f}", f"{wall['rho']:.1f}",
                       summary["newton_iterations"])


def sorted_rows(program, folder):
    return sorted(rows(program, folder), key=lambda row: (row[0], row[1]))


if __name__ == "__main__":
    study(__doc__, ["holder", "metal", "blank", "theta1", "theta2", "rho", "iterations"], sorted_rows, "springback_metals",
          "springback of the U-bend over metals: angles [degree], side-wall curl [mm]")
