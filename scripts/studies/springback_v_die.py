#!/usr/bin/env python3
"""Springback of a V-die (air bending) with isotropic hardening and two backstress laws, over elements, layers and increments.

    scripts/studies/springback_v_die.py PROGRAM FOLDER [--write]

The strip of prm/shop/air_bending.prm. --write renews doc/measured/springback_v_die.csv. Runs that are finished in FOLDER are not
repeated. Half a minute.
"""
import os

from springback_metals import YOSHIDA_UEMORI
from springback_study import run, study

CHABOCHE = ["Hardening/Law=linear", "Hardening/Initial flow stress=155", "Hardening/Hardening modulus=300", "Backstress/Law=chaboche",
            "Backstress/Terms=8000 80; 1000 8"]
METALS = [("isotropic (Swift)", []), ("Chaboche, two terms", CHABOCHE), ("Yoshida and Uemori", YOSHIDA_UEMORI)]
# One thing changes at a time.
MESHES = [("120 elements, 11 layers", []), ("180 elements", ["Blank/Elements=180"]), ("21 layers", ["Blank/Layers=21"]),
          ("increments half as long", ["Steps/bend/Largest increment=.2"])]


def rows(program, folder):
    for metal, constants in METALS:
        for blank, entries in MESHES:
            name = f"{metal}_{blank}".replace(" ", "_").replace(",", "")
            summary = run(program, os.path.join(folder, name), "shop/air_bending",
                          ["Material/" + entry for entry in constants] + entries)
            if summary["exit_status"] != 0:
                yield metal, blank, f"stopped: {summary['message'][:80]}", "", ""
                continue
            yield (metal, blank, f"{summary['measures']['half']['bend_angle']:.3f}", f"{summary['tools']['punch']['max_force']:.2f}",
                   summary["newton_iterations"])


if __name__ == "__main__":
    study(__doc__, ["metal", "blank", "half angle", "largest force", "iterations"], rows, "springback_v_die",
          "springback of a V-die: half of the bend angle after release [degree], largest force of half the punch [N/mm]")
