#!/usr/bin/env python3
"""Friction that is a share of the flow stress knows the face as it is at the end of an increment: late_friction.py DELTAFORM SCENE FOLDER.

SCENE is prm/shop/ring_compression.prm. Where its perfectly plastic metal slides, nodes carry m k = m Y/sqrt(3) on their area of now, exactly: the
median is 3e-4 off at most, 1.7e-2 where areas are those of the begin of the increment. With a metal that hardens the inner radius
does not depend on the increments: at 40 % it moves by .3875 and .3857 with 50 and 400 of them, by .3687 and .3912 where area and flow stress are late.
"""
import csv
import math
import os
import subprocess
import sys

SHEAR_FACTOR, FLOW_STRESS = .3, 200.
HARDENS = ("Law=swift", "Prestrain=.01", "Strength coefficient=500", "Hardening exponent=.25")


def run(program, scene, output, *entries):
    subprocess.run([program, scene, "--quiet", "--force", "--output", output] +
                   [part for entry in (f"Tools/die/Shear factor={SHEAR_FACTOR}", "Output/Pictures=0") + entries for part in ("--set", entry)],
                   check=True)


def rows(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def shear_errors(folder, name):
    """Of the points that touch, sorted."""
    expected = SHEAR_FACTOR * FLOW_STRESS / math.sqrt(3.)
    return sorted(abs(abs(float(row["tangential_force"])) * float(row["pressure"]) / float(row["normal_force"]) / expected - 1.)
                  for row in rows(folder, name) if float(row["normal_force"]) > 0.)


def main():
    program, scene, folder = sys.argv[1:]
    wrong = []
    plastic = os.path.join(folder, "plastic")
    run(program, scene, plastic, "Blank/Contact points=nodes")
    for travel in ("0.8", "1.6", "2.4"):
        errors = shear_errors(plastic, f"contact_{travel}.csv")
        median = errors[len(errors) // 2]
        print(f"perfectly plastic, {travel} mm: shear stress of {len(errors)} points {median:.1e} off (median)")
        if median > 1e-3:
            wrong.append(f"at {travel} mm the shear stress is {median:.1e} off")
    radii = []
    for increments in (50, 400):
        hardens = os.path.join(folder, f"hardens_{increments}")
        run(program, scene, hardens, f"Steps/press/Largest increment={2.4 / increments}", *("Material/Hardening/" + entry for entry in HARDENS))
        radii.append(float(rows(hardens, "profile_1.6.csv")[0]["u_r"]))
    print(f"hardens: the inner radius moves by {radii[0]:.4f}, with eight times as many increments by {radii[1]:.4f}")
    if abs(radii[0] / radii[1] - 1.) > .01:
        wrong.append(f"the inner radius moves by {radii[0]:.4f} or {radii[1]:.4f} by the increments")
    sys.exit("; ".join(wrong) or 0)


if __name__ == "__main__":
    main()
