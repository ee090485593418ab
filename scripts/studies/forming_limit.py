#!/usr/bin/python3
"""A sheet stretched over a hemisphere on its forming limit diagram: the paths of three points and the state of all.

    scripts/studies/forming_limit.py [--program PROGRAM] [--output output/forming_limit] [--write]

Runs prm/osu_stretching.prm with friction until the limit of Marciniak and Kuczynski is used up somewhere. --write copies the
picture to doc/gallery. Five seconds.
"""
import os
import shutil
import subprocess

from measured import ROOT, arguments_of

import numpy as np

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from plot import STYLE  # noqa: E402
from results import Table  # noqa: E402

TRAVELS = range(2, 41, 2)
PLACES = (0., 15., 23.4, 45.)
COLOURS = ("#1f4e79", "#2e8b57", "#8a6d1b", "#5b3a8c")


def run(program, folder):
    scene = os.path.join(ROOT, "prm", "osu_stretching.prm")
    subprocess.run([program, "fld", scene, "--output", folder], check=True, stdout=subprocess.DEVNULL)
    command = [program, scene, "--quiet", "--output", folder]
    for entry, value in {"Output/Pictures": 0, "Output/Travels": ", ".join(map(str, TRAVELS)),
                         "Tools/punch/Friction coefficient": .15, "Limits/Criteria": "forming limit",
                         "Limits/forming limit/Limit": 1, "Limits/forming limit/When reached": "end run"}.items():
        command += ["--set", f"{entry}={value}"]
    subprocess.run(command, stderr=subprocess.DEVNULL, check=False)  # ends with status 2 at the limit


def figure(folder, path):
    curve = Table(os.path.join(folder, "fld.csv"))
    files = [os.path.join(folder, f"profile_{travel}.csv") for travel in TRAVELS]
    profiles = [Table(name) for name in files if os.path.exists(name)]
    strains = [np.sort([p["eps_meridional"], p["eps_hoop"]], axis=0) for p in profiles]
    history = Table(os.path.join(folder, "history.csv"))
    with plt.rc_context(STYLE):
        plot, axes = plt.subplots(figsize=(7, 5))
        axes.plot(curve["minor_strain"], curve["major_strain"], color="#b00020", label="limit (Marciniak, Kuczynski)")
        axes.plot(*strains[-1], ".", color="#999999", markersize=4, label=f"all points at {TRAVELS[len(profiles) - 1]} mm")
        for place, colour in zip(PLACES, COLOURS):
            i = int(np.argmin(np.abs(profiles[0]["R0"] - place)))
            axes.plot([0.] + [s[0][i] for s in strains], [0.] + [s[1][i] for s in strains], "-o", color=colour,
                      markersize=3, label=f"R0 = {profiles[0]['R0'][i]:.0f} mm")
        axes.set(xlabel="minor strain", ylabel="major strain", xlim=(-.1, .4), ylim=(0., .5))
        axes.legend(loc="lower right")
        plot.tight_layout()
        plot.savefig(path, dpi=130)
    print(f"the limit is used up at a travel of {history['punch_travel'][-1]:.2f} mm, at R0 = "
          f"{history['forming_limit_R0'][-1]:.1f} mm")


def main():
    arguments = arguments_of(__doc__, "forming_limit").parse_args()
    run(arguments.program, arguments.output)
    path = os.path.join(arguments.output, "forming_limit.png")
    figure(arguments.output, path)
    if arguments.write:
        shutil.copy(path, os.path.join(ROOT, "doc", "gallery"))


if __name__ == "__main__":
    main()
