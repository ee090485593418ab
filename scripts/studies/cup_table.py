#!/usr/bin/env python3
"""Runs the cup of prm/cup.prm on 16 to 400 elements to a travel of 1.2 in: convergence with the mesh.

    scripts/studies/cup_table.py [--write] [--program build/release/deltaform]

--write renews doc/measured/cup_*.csv. Standard library only; about half a minute.
"""
import json
import math
import os
import subprocess
import sys
import tempfile

from measured import ROOT, MeasuredTable, arguments_of
from csv_file import rows_of

ELEMENTS = [25, 50, 100, 200, 400]
COARSE = [16, 20, 25, 30, 35, 40, 50]
REFINED = [8, 12] + COARSE
KEPT = "Blank/Refinement/Largest bend=0"
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

    def sharpest_bend(self):
        """Largest angle by which an element bends [degree], in the profiles."""
        return max(math.degrees(abs(float(b["rotation"]) - float(a["rotation"])))
                   for rows in self.profiles.values() for a, b in zip(rows, rows[1:]))

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


def quantity(title, digits, values_at, values_table, errors_table):
    """Values on all meshes, extrapolated value, observed order; the differences to the finest mesh and to the extrapolated value, and the
    worst of them."""
    worst = [[0., 0.] for _ in ELEMENTS]
    for travel in TRAVELS:
        values = values_at(travel)
        limit = extrapolated(values)
        values_table.add(title, f"{travel:g}", *(f"{v:.{digits}f}" for v in values), f"{limit:.{digits}f}", observed_order(values))
        cells = []
        for k, value in enumerate(values):
            finest, exact = 100 * (value / values[-1] - 1), 100 * (value / limit - 1)
            worst[k] = [max(worst[k][0], abs(finest)), max(worst[k][1], abs(exact))]
            cells.append(f"{finest:+.2f} / {exact:+.2f}")
        errors_table.add(title, f"{travel:g}", *cells)
    errors_table.add(title, "worst", *(f"{a:.2f} / {b:.2f}" for a, b in worst))


def convergence(runs):
    """Tables of values and of differences."""
    meshes = [str(n) for n in ELEMENTS]
    values = MeasuredTable(["quantity", "travel [in]", *meshes, "extrapolated", "observed order"])
    errors = MeasuredTable(["quantity", "travel [in]", *meshes])
    for title, digits, member in (("Punch force [tonf]", 4, Run.force), ("Draw-in of the rim [in]", 5, Run.draw_in),
                                  ("Smallest thickness [in]", 6, Run.thickness)):
        quantity(title, digits, lambda t, member=member: [member(run, t) for run in runs], values, errors)
    return values, errors


def profiles(runs):
    table = MeasuredTable(["travel [in]", *(str(n) for n in ELEMENTS[:-1])])
    end = float(runs[-1].profiles[TRAVELS[0]][-1]["R0"])
    for travel in TRAVELS:
        cells = []
        finest = [runs[-1].strain(travel, end * i / 400) for i in range(401)]
        for run in runs[:-1]:
            differences = [run.strain(travel, end * i / 400) - finest[i] for i in range(401)]
            cells.append(f"{max(map(abs, differences)):.4f} / {math.sqrt(sum(d * d for d in differences) / 401):.4f}")
        table.add(f"{travel:g}", *cells)
    return table


def cost(runs):
    table = MeasuredTable(["elements", "increments", "Newton iterations", "seconds", "energy error", "largest p/delta"])
    for n, run in zip(ELEMENTS, runs):
        s = run.summary
        table.add(n, f"{s['increments']:g}", f"{s['newton_iterations']:g}", f"{s['seconds']:.2f}", f"{s['energy_error']:.1e}",
                  f"{s['max_penetration_over_delta']:.4f}")
    return table


def bends(numbers, coarse, finest):
    """Meshes that are too coarse: how far elements bend, and what comes out."""
    table = MeasuredTable(["elements", "at the end", "increments", "largest bend of one [degree]", "punch force [%]", "draw-in [%]",
                           "smallest thickness [%]"])
    for n, run in zip(numbers, coarse):
        worst = [max(abs(100 * (of(run, t) / of(finest, t) - 1)) for t in TRAVELS)
                 for of in (Run.force, Run.draw_in, Run.thickness)]
        table.add(n, len(run.profiles[TRAVELS[-1]]) - 1, f"{run.summary['increments']:g}", f"{run.sharpest_bend():.1f}",
                  *(f"{w:.2f}" for w in worst))
    return table


def rules(program):
    """The paper's three choices, on its 50 elements."""
    table = MeasuredTable(["scene", *(f"force at {t:g} in" for t in (.6, 1., 1.2)), "largest penetration [in]", "between nodes [in]",
                           "Newton iterations", "min thickness at 1 in [in]"])
    for scene in COMPARED:
        run = Run(program, scene)
        deepest = max(float(row["max_penetration"]) for row in run.history)
        table.add(scene, *(f"{run.force(t):.4f}" for t in (.6, 1., 1.2)), f"{deepest:.2e}",
                  f"{run.summary['max_penetration_between_nodes']:.2e}", f"{run.summary['newton_iterations']:g}", f"{run.thickness(1.):.5f}")
    return table


def main():
    options = arguments_of(__doc__, write="renew doc/measured/cup_*.csv").parse_args()

    program = os.path.abspath(options.program)
    runs = [Run(program, "cup", f"Blank/Elements={n}", KEPT) for n in ELEMENTS]
    coarse = [Run(program, "cup", f"Blank/Elements={n}", KEPT) for n in COARSE]
    refined = [Run(program, "cup", f"Blank/Elements={n}") for n in REFINED]
    values, errors = convergence(runs)
    tables = {
        "cup_convergence": (values, "cup, 25 to 400 elements of degree 1: values, extrapolated value (order 2) and observed order"),
        "cup_differences": (errors, "cup: difference to 400 elements / to the extrapolated value [%]"),
        "cup_strain": (profiles(runs), "cup: largest / root-mean-square difference of ln(h/h0) to 400 elements, at 401 initial radii"),
        "cup_cost": (cost(runs), "cup to a travel of 1.2 in: cost, energy error, largest penetration over delta"),
        "cup_bend": (bends(COARSE, coarse, runs[-1]),
                     "cup on coarse meshes that stay: largest bend of an element; worst difference of six travels to 400 elements"),
        "cup_refined": (bends(REFINED, refined, runs[-1]),
                        "cup on coarse meshes, elements that bend are halved; worst difference of six travels to 400 elements"),
        "cup_choices": (rules(program), "cup, 50 elements: the paper's three choices of contact")}
    for name, (table, title) in tables.items():
        print(f"{title}\n{table}\n")
        if options.write:
            table.write(name, title)


if __name__ == "__main__":
    main()
