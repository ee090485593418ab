#!/usr/bin/env python3
"""The points of an edge share their friction: friction_of_edges.py DELTAFORM SCENE FOLDER.

SCENE is common/ironing_with_limit.prm. Which of the twenty points of an edge carry its force is nearly arbitrary; their sum is not. Where each
of them has a limit of its own, min(mu lambda, m k A), the punch's friction is 30 kN, and 13 kN with increments of a quarter, for 45 kN with one
point at each node; where they share that of their mean pressure it is 43.1 and 42.4 kN (mean from 7 mm on).
"""
import csv
import os
import subprocess
import sys

LARGEST = .08  # of the friction, between any two
BEGIN = 7.     # mm: from here on the process is steady


def friction(program, scene, folder, *entries):
    subprocess.run([program, scene, "--quiet", "--force", "--output", folder] + [part for entry in entries for part in ("--set", entry)], check=True)
    with open(os.path.join(folder, "history.csv"), encoding="utf-8") as file:
        rows = [(float(row["time"]), float(row["punch_force_z"])) for row in csv.DictReader(line for line in file if not line.startswith("#"))]
    steady = [row for row in rows if row[0] >= BEGIN]
    area = sum((t1 - t0) * (f0 + f1) / 2. for (t0, f0), (t1, f1) in zip(steady, steady[1:]))
    return area / (steady[-1][0] - steady[0][0])


def main():
    program, scene, folder = sys.argv[1:]
    runs = {"nodes": ("Blank/Contact points=nodes",), "points": (), "points, short increments": ("Steps/iron/Largest increment=0.05",)}
    found = {name: friction(program, scene, os.path.join(folder, name.split(",")[0] + str(len(name))), *entries) for name, entries in runs.items()}
    for name, value in found.items():
        print(f"{name}: {value / 1e3:.2f} kN")
    if max(found.values()) / min(found.values()) - 1. > LARGEST:
        sys.exit("the friction depends on the points")


if __name__ == "__main__":
    main()
