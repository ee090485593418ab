#!/usr/bin/env python3
"""The bulge that is blown by volume, checked by mechanics alone at several heights, before and past the maximum of the pressure:
the volume that the history reports is that under the profile, and the pole is in equilibrium, p R / (2 t) = flow stress.

    bulge_equilibrium.py PROGRAM SCENE FOLDER
"""
import csv
import glob
import math
import subprocess
import sys

K, E0, N = 565.32, .007117, .2589  # flow curve of the scene; Mises


def table(path):
    with open(path) as file:
        return [{k: float(v) if k != "stage" else v for k, v in row.items()}
                for row in csv.DictReader(line for line in file if not line.startswith("#"))]


def volume_under(profile):
    """Of the truncated cones between neighbouring nodes, above the flat sheet."""
    pairs = list(zip(profile, profile[1:]))
    return sum(math.pi / 3. * (b["r"] - a["r"]) * (a["z"] * (2. * a["r"] + b["r"]) + b["z"] * (a["r"] + 2. * b["r"])) for a, b in pairs)


def main():
    program, scene, folder = sys.argv[1:]
    subprocess.run([program, scene, "--quiet", "--output", folder, "--set", "Output/Times=.3,.5,.6,.65,.7,.78", "--set", "Steps/blow/End time=.78",
                    "--set", "Material/Yield surface/r-bar=1"], check=True)
    history = {round(row["time"], 9): row for row in table(folder + "/history.csv")}
    pressures = []
    for path in glob.glob(folder + "/profile_*.csv"):
        time = float(path.split("_")[-1][:-4])
        profile, row = table(path), history[time]
        error = volume_under(profile) / row["pressure_volume"] - 1.
        if abs(error) > 5e-4:
            sys.exit(f"at {time} the volume under the profile is {error:.2e} off")
        # Radius at the pole, from z = z0 - r^2 / (2 R) by the parabola through nodes near it.
        near = [(p["r"] ** 2, p["z"]) for p in profile if p["r"] < 6.]
        mean = [sum(v) / len(near) for v in zip(*near)]
        slope = sum((a - mean[0]) * (b - mean[1]) for a, b in near) / sum((a - mean[0]) ** 2 for a, _ in near)
        pole = profile[0]
        stress = row["pressure_pressure"] * (-.5 / slope) / (2. * pole["thickness"])
        flow = K * (E0 + pole["equivalent_plastic_strain"]) ** N
        print(f"{time}: height {row['pressure_height']:.3f}, p {row['pressure_pressure']:.5f}, p R/(2 t) {stress:.2f}, flow stress {flow:.2f}")
        if abs(stress / flow - 1.) > .01:
            sys.exit("the pole is not in equilibrium")
        pressures.append((time, row["pressure_pressure"]))
    pressures.sort()
    if len(pressures) != 6 or not max(p for _, p in pressures) > 1.005 * pressures[-1][1]:
        sys.exit(f"the maximum of the pressure was not passed: {pressures}")


if __name__ == "__main__":
    main()
