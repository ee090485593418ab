#!/usr/bin/env python3
"""Runs the cup of prm/cup.prm on 25 to 400 elements to a travel of 1.2 in and prints its convergence as Markdown.

    scripts/cup_table.py [--write doc/cup.md] [--program build/release/deltaform]

Standard library only; about half a minute.
"""
import argparse
import json
import math
import os
import subprocess
import sys
import tempfile

from csv_file import rows_of

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
ELEMENTS = [25, 50, 100, 200, 400]
TRAVELS = [.2, .4, .6, .8, 1., 1.2]
COMPARED = ["cup_constant_1e7", "cup_delta_1e-3", "cup_delta_1e-7"]


class Run:
    """One run: what the tables need of it."""

    def __init__(self, program, scene, *sets):
        with tempfile.TemporaryDirectory() as folder:
            command = [program, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--output", folder,
                       "--set", "Output/Pictures=0", "--set", "Output/Travels=" + ",".join(f"{t:g}" for t in TRAVELS),
                       "--set", "Steps/form/End time=1.2"]
            for entry in sets:
                command += ["--set", entry]
            done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            if done.returncode != 0:
                sys.exit(f"cup_table: {scene} {' '.join(sets)} ended with status {done.returncode}: {done.stderr.strip()}")
            self.history = rows_of(os.path.join(folder, "history.csv"))
            self.profiles = {t: rows_of(os.path.join(folder, f"profile_{t:g}.csv")) for t in TRAVELS}
            with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
                self.summary = json.load(file)

    def at(self, travel):
        return min(self.history, key=lambda row: abs(float(row["punch_travel"]) - travel))

    def force(self, travel):
        return float(self.at(travel)["punch_force_z"])

    def thickness(self, travel):
        return float(self.at(travel)["min_thickness"])

    def draw_in(self, travel):
        rim = self.profiles[travel][-1]
        return float(rim["R0"]) - float(rim["r"])

    def strain(self, travel, position):
        """Thickness strain at an initial radius, linear between the nodes."""
        rows = self.profiles[travel]
        for before, after in zip(rows, rows[1:]):
            a, b = float(before["R0"]), float(after["R0"])
            if position <= b + 1e-12:
                x = (position - a) / (b - a)
                return (1 - x) * float(before["eps_thickness"]) + x * float(after["eps_thickness"])
        return float(rows[-1]["eps_thickness"])


def extrapolated(values):
    """Richardson from the two finest meshes with order 2, the order of the elements."""
    return values[-1] + (values[-1] - values[-2]) / 3


def observed_order(values):
    """From the three finest meshes; no number where they do not approach a limit from one side."""
    first, second = values[-2] - values[-3], values[-1] - values[-2]
    return f"{math.log2(first / second):.1f}" if first * second > 0 and abs(first) > abs(second) else "-"


def quantity(title, digits, values_at):
    """Values on all meshes, extrapolated value, observed order; then the errors."""
    meshes = " | ".join(str(n) for n in ELEMENTS)
    dashes = "|".join(["---"] * len(ELEMENTS))
    lines = [f"## {title}", "", f"| travel [in] | {meshes} | extrapolated | observed order |", f"|---|{dashes}|---|---|"]
    errors = ["", "Difference to the finest mesh / to the extrapolated value, per cent:", "",
              f"| travel [in] | {meshes} |", f"|---|{dashes}|"]
    worst = [[0., 0.] for _ in ELEMENTS]
    for travel in TRAVELS:
        values = values_at(travel)
        limit = extrapolated(values)
        lines.append(f"| {travel:g} | " + " | ".join(f"{v:.{digits}f}" for v in values) +
                     f" | {limit:.{digits}f} | {observed_order(values)} |")
        cells = []
        for k, value in enumerate(values):
            finest, exact = 100 * (value / values[-1] - 1), 100 * (value / limit - 1)
            worst[k] = [max(worst[k][0], abs(finest)), max(worst[k][1], abs(exact))]
            cells.append(f"{finest:+.2f} / {exact:+.2f}")
        errors.append(f"| {travel:g} | " + " | ".join(cells) + " |")
    errors.append("| worst | " + " | ".join(f"{a:.2f} / {b:.2f}" for a, b in worst) + " |")
    return lines + errors + [""], worst


def profiles(runs):
    lines = ["## Thickness strain along the blank", "",
             "Largest and root-mean-square difference of ln(h/h0) to 400 elements, at 401 equally spaced initial radii:", "",
             "| travel [in] | " + " | ".join(str(n) for n in ELEMENTS[:-1]) + " |", "|---|" + "---|" * (len(ELEMENTS) - 1)]
    end = float(runs[-1].profiles[TRAVELS[0]][-1]["R0"])
    for travel in TRAVELS:
        cells = []
        finest = [runs[-1].strain(travel, end * i / 400) for i in range(401)]
        for run in runs[:-1]:
            differences = [run.strain(travel, end * i / 400) - finest[i] for i in range(401)]
            cells.append(f"{max(map(abs, differences)):.4f} / {math.sqrt(sum(d * d for d in differences) / 401):.4f}")
        lines.append(f"| {travel:g} | " + " | ".join(cells) + " |")
    return lines + [""]


def cost(runs):
    lines = ["## Cost", "", "| elements | increments | Newton iterations | seconds | energy error | largest p/delta |",
             "|---|---|---|---|---|---|"]
    for n, run in zip(ELEMENTS, runs):
        s = run.summary
        lines.append(f"| {n} | {s['increments']:g} | {s['newton_iterations']:g} | {s['seconds']:.2f} | "
                     f"{s['energy_error']:.1e} | {s['max_penetration_over_delta']:.4f} |")
    return lines + [""]


def rules(program):
    """The paper's three choices, on its 50 elements."""
    lines = ["## The paper's three choices, 50 elements", "",
             "| scene | " + " | ".join(f"force at {t:g} in" for t in (.6, 1., 1.2)) +
             " | largest penetration [in] | between nodes [in] | Newton iterations | min thickness at 1 in [in] |",
             "|---|---|---|---|---|---|---|---|"]
    for scene in COMPARED:
        run = Run(program, scene)
        deepest = max(float(row["max_penetration"]) for row in run.history)
        lines.append(f"| `{scene}` | " + " | ".join(f"{run.force(t):.4f}" for t in (.6, 1., 1.2)) +
                     f" | {deepest:.2e} | {run.summary['max_penetration_between_nodes']:.2e} | "
                     f"{run.summary['newton_iterations']:g} | {run.thickness(1.):.5f} |")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "release", "deltaform"))
    parser.add_argument("--write", metavar="FILE", help="write the page here as well")
    options = parser.parse_args()

    program = os.path.abspath(options.program)
    runs = [Run(program, "cup", f"Blank/Elements={n}") for n in ELEMENTS]
    forces, worst = quantity("Punch force [tonf]", 4, lambda t: [run.force(t) for run in runs])
    draw_in, _ = quantity("Draw-in of the rim [in]", 5, lambda t: [run.draw_in(t) for run in runs])
    thickness, _ = quantity("Smallest thickness [in]", 6, lambda t: [run.thickness(t) for run in runs])
    lines = [
        "# The cup: convergence with the mesh", "",
        "Printed by `scripts/cup_table.py` from `prm/cup.prm` (adaptive rule, delta = 1e-3 of the thickness, friction .2), equal",
        "elements of degree 1, to a travel of 1.2 in. There is no digitised curve of the original experiment to compare with.", "",
        "The extrapolated value takes the two finest meshes and assumes the order 2. The observed order comes from the three finest;",
        "`-` where they do not approach a limit from one side. Nodes slide over the die's radius one by one, so the force of a",
        "mesh oscillates in the travel by an amount that falls with the mesh: the order at one travel is not a clean number, and",
        "the extrapolated value is an estimate that rests on the assumed order. With order 1 in its place the distance of 400",
        "elements to it is the whole difference between 200 and 400 elements, three times as much.", "",
        f"Worst difference in force over all travels: 50 elements {worst[1][0]:.2f} % to the finest mesh, "
        f"400 elements {worst[4][1]:.2f} % to the extrapolated value (with order 1: {worst[3][0]:.2f} %).", "",
        *forces, *draw_in, *thickness, *profiles(runs), *cost(runs), *rules(program)]
    print("\n".join(lines))
    if options.write:
        with open(options.write, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
