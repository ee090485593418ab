#!/usr/bin/python3
"""The cup computed with shell and with solid: punch force, draw-in and thickness in one figure.

    scripts/studies/shell_and_solid.py [--program PROGRAM] [--output output/shell_and_solid] [--write]

Runs prm/cup.prm with 50 and 400 shell elements and prm/cup_solid.prm (100 x 2 quadrilaterals of degree 2), one after the
other, and prints the differences in numbers. --write copies the picture to doc/gallery. About a minute.
"""
import os
import shutil
import subprocess
import sys

from measured import ROOT, arguments_of

import numpy as np

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from plot import STYLE  # noqa: E402
from results import Table  # noqa: E402

TRAVELS = [round(0.05 * i, 2) for i in range(1, 21)]
SECTIONS = (0.6, 1.0)
CASES = (("shell, 50 elements", "cup", {}, "#8a6d1b", ":"),
         ("shell, 400 elements", "cup", {"Blank/Elements": 400}, "#1f4e79", "-"),
         ("solid, 100 x 2 of degree 2", "cup_solid", {}, "#b3402a", "--"))


def run(program, folder, name, scene, entries):
    out = os.path.join(folder, name.replace(" ", "_").replace(",", ""))
    command = [program, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--output", out,
               "--set", "Output/Pictures=0", "--set", "Output/Travels=" + ", ".join(f"{t:g}" for t in TRAVELS)]
    for entry, value in entries.items():
        command += ["--set", f"{entry}={value}"]
    subprocess.run(command, check=True)
    return out


class Results:
    """What the figure needs of a run."""

    def __init__(self, folder):
        history = Table(os.path.join(folder, "history.csv"))
        self.travel, self.force = history["punch_travel"], history["punch_force_z"]
        self.profiles = {t: Table(os.path.join(folder, f"profile_{t:g}.csv")) for t in TRAVELS}
        self.draw_in = np.array([self.profiles[t]["R0"][-1] - self.profiles[t]["r"][-1] for t in TRAVELS])

    def force_at(self, travel):
        return np.interp(travel, self.travel, self.force)

    def strain(self, travel):
        return self.profiles[travel]["R0"], self.profiles[travel]["eps_thickness"]


def figure(results, path):
    """Curves above; below, what they differ by from the shell of 400 elements, because the curves lie on each other."""
    picture, axes = plt.subplots(2, 3, figsize=(13, 6.6), height_ratios=[2, 1], sharex="col")
    fine = results[1]
    inner = np.array(TRAVELS)[np.array(TRAVELS) > 0.09]  # below, a per cent of almost nothing
    for (name, _, _, colour, line), result in zip(CASES, results):
        style = {"color": colour, "linestyle": line, "linewidth": 1.5}
        axes[0, 0].plot(result.travel, result.force, label=name, **style)
        axes[0, 1].plot([0.0, *TRAVELS], [0.0, *result.draw_in], **style)
        for travel in SECTIONS:
            axes[0, 2].plot(*result.strain(travel), **style)
        if result is fine:
            continue
        axes[1, 0].plot(inner, [100 * (result.force_at(t) / fine.force_at(t) - 1) for t in inner], **style)
        axes[1, 1].plot(TRAVELS, 1e3 * (result.draw_in - fine.draw_in), **style)
        place, value = result.strain(SECTIONS[-1])
        axes[1, 2].plot(place, value - np.interp(place, *fine.strain(SECTIONS[-1])), **style)
    for axis, title in zip(axes[0], ("Punch force [tonf]", "Draw-in of the rim [in]", "Thickness strain")):
        axis.set_title(title)
    for axis, title in zip(axes[1], ("difference to the shell, 400 elements [%]", "difference [1e-3 in]",
                                     f"difference at {SECTIONS[-1]:g} in")):
        axis.set_title(title, fontsize=9, fontweight="normal")
    for axis in axes[1, :2]:
        axis.set_xlabel("punch travel [in]")
    axes[1, 2].set_xlabel("initial radius [in]")
    for travel in SECTIONS:
        place, value = results[-1].strain(travel)
        lowest = np.argmin(value)
        axes[0, 2].annotate(f"{travel:g} in", (place[lowest], value[lowest]), xytext=(0, -12), textcoords="offset points",
                            ha="center", fontsize=8.5)
    axes[0, 0].legend()
    picture.tight_layout()
    picture.savefig(path)


def largest_difference(one, other, travel):
    """Of the thickness strain, and where; the second is interpolated to the places of the first."""
    place, value = one.strain(travel)
    difference = np.abs(value - np.interp(place, *other.strain(travel)))
    worst = np.argmax(difference)
    return difference[worst], place[worst]


def numbers(results):
    shell, solid = results[1], results[2]
    print("| travel [in] | force, shell | force, solid | difference | draw-in, shell | draw-in, solid | difference |")
    print("|---|---|---|---|---|---|---|")
    for travel in TRAVELS[3::4]:
        force = shell.force_at(travel), solid.force_at(travel)
        rim = [r.draw_in[TRAVELS.index(travel)] for r in (shell, solid)]
        print(f"| {travel:g} | {force[0]:.4f} | {force[1]:.4f} | {100 * (force[1] / force[0] - 1):+.2f} % | "
              f"{rim[0]:.5f} | {rim[1]:.5f} | {100 * (rim[1] / rim[0] - 1):+.2f} % |")
    for travel in SECTIONS:
        worst, place = largest_difference(shell, solid, travel)
        print(f"thickness strain at {travel:g} in: largest difference {worst:.4f} at R0 = {place:.3f}")


def main():
    parser = arguments_of(__doc__, "shell_and_solid", write="copy the picture to doc/gallery")
    parser.add_argument("--draw", action="store_true", help="draw what an earlier call has left in the folder; run nothing")
    arguments = parser.parse_args()
    if not arguments.draw and not os.access(arguments.program, os.X_OK):
        sys.exit(f"shell_and_solid: no program '{arguments.program}': build it (scripts/build.sh) or name it with --program")
    os.makedirs(arguments.output, exist_ok=True)
    plt.rcParams.update(STYLE)
    results = []
    for name, scene, entries, *_ in CASES:
        folder = os.path.join(arguments.output, name.replace(" ", "_").replace(",", ""))
        if not arguments.draw:
            folder = run(arguments.program, arguments.output, name, scene, entries)
        results.append(Results(folder))
    picture = os.path.join(arguments.output, "cup_shell_solid.png")
    figure(results, picture)
    numbers(results)
    if arguments.write:
        shutil.copy(picture, os.path.join(ROOT, "doc", "gallery"))


if __name__ == "__main__":
    main()
