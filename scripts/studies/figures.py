#!/usr/bin/python3
"""The paper's Figures 2 and 3 and what they leave open, from runs made here: CSV and PNG.

    scripts/studies/figures.py [--program PROGRAM] [--output output/figures] [--write]

Figure 2: penetration along the blank at several travels, for a constant factor 1e7 and for delta = 1e-7 and 1e-3 in.
Figure 3: condition number in every increment of the three; with beta = .01 (delta governs) and beta = 1.
Beyond the paper: friction 0 to .4, every rule, digits really lost, distribution of p/delta.
--write copies pictures to doc/gallery and renews doc/measured/figures_*.csv. Two jobs at a time, about two minutes.
"""
import concurrent.futures
import csv
import os
import shutil
import subprocess
import sys

from measured import ROOT, MeasuredTable, arguments_of

import numpy as np

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from plot import STYLE  # noqa: E402
from results import Table  # noqa: E402

TRAVELS = [0.2, 0.4, 0.6, 0.8, 1.0]
CASES = {"constant 1e7": ("cup_constant_1e7", {}),
         "delta 1e-7 in": ("cup_delta_1e-7", {}),
         "delta 1e-3 in": ("cup_delta_1e-3", {})}
RULES = ["constant", "element stiffness", "paper", "proportional", "gap driven", "adaptive"]
FRICTION = [0.0, 0.1, 0.2, 0.4]
TOOLS = ("punch", "die", "holder")
COLOURS = ["#b3402a", "#1f4e79", "#3b8a4a", "#8a6d1b", "#6b4c9a", "#444444"]


def jobs():
    """Name of every run: scene, entries."""
    result = {}
    for name, (scene, entries) in CASES.items():
        for beta in (0.01, 1.0):
            if "constant" in name and beta == 1.0:
                continue
            key = name if beta == 0.01 else f"{name}, beta 1"
            result[key] = (scene, {**entries, **({} if "constant" in name else {"Contact/Floor factor": beta})})
    for mu in FRICTION:
        friction = {f"Tools/{tool}/Friction coefficient": mu for tool in TOOLS}
        result[f"adaptive, mu {mu:g}"] = ("cup_delta_1e-3", friction)
        result[f"constant, mu {mu:g}"] = ("cup_constant_1e7", friction)
    for rule in RULES:
        result[f"rule {rule}"] = ("cup", {"Contact/Penalty rule": rule})
    for enforcement in ("active set", "adaptive compensated", "augmented Lagrangian"):
        entries = {"Contact/Enforcement": enforcement}
        if enforcement != "active set":
            entries["Contact/Allowed penetration"] = "1e-2*thickness"
        result[enforcement] = ("cup", entries)
    # As in the paper, the thickness of the sheet is rigid.
    rigid = {f"Tools/{tool}/Thickness compliance": "off" for tool in TOOLS}
    return {name: (scene, {**rigid, **entries}) for name, (scene, entries) in result.items()}


def run(program, folder, name, scene, entries):
    out = os.path.join(folder, "runs", name.replace(" ", "_").replace(",", ""))
    command = [program, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--output", out,
               "--set", "Output/Condition number every=1", "--set", "Output/Pictures=0",
               "--set", "Blank/Contact points=nodes",  # as in the paper
               "--set", "Output/Travels=" + ", ".join(f"{travel:g}" for travel in TRAVELS)]
    for entry, value in entries.items():
        command += ["--set", f"{entry}={value}"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    return out, done.returncode, done.stderr.strip().split("\n")[-1]


def penetration(out, travel):
    """Arc length of the touching nodes and the deepest penetration of each, in any tool."""
    table = Table(os.path.join(out, f"contact_{travel:g}.csv"))
    deepest = {}
    column = "S0" if "S0" in table else "R0"
    for s, p in zip(table[column], table["penetration"]):
        deepest[s] = max(deepest.get(s, 0.0), p)
    return np.array(sorted(deepest)), np.array([deepest[s] for s in sorted(deepest)])


def write_csv(path, names, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(names)
        writer.writerows(rows)


def figure_2(runs, folder):
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.6), sharey=True)
    rows = []
    for axis, name in zip(axes, CASES):
        for travel, colour in zip(TRAVELS, COLOURS):
            s, p = penetration(runs[name], travel)
            rows += [(name, travel, a, b) for a, b in zip(s, p)]
            axis.semilogy(s, np.maximum(p, 1e-14), ".-", color=colour, linewidth=0.9, markersize=4, label=f"{travel:g} in")
        axis.set_title(name)
        axis.set_xlabel("arc length along the blank [in]")
        axis.set_ylim(1e-11, 1e-2)
    axes[0].set_ylabel("penetration [in]")
    axes[2].legend(title="punch travel", fontsize=8)
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "figure_2.png"), dpi=130)
    write_csv(os.path.join(folder, "figure_2.csv"), ["case", "travel", "arc_length", "penetration"], rows)


def conditions(runs, names, file, folder, columns=("condition_raw", "condition_scaled")):
    labels = {"condition_raw": "raw condition number", "condition_scaled": "after diagonal scaling",
              "digits_lost": "decimal digits lost"}
    figure, axes = plt.subplots(1, len(columns), figsize=(5.4 * len(columns), 3.8))
    rows = []
    for name, colour in zip(names, COLOURS):
        history = Table(os.path.join(runs[name], "history.csv"))
        travel = history["punch_travel"]
        for axis, column in zip(np.atleast_1d(axes), columns):
            draw = axis.plot if column == "digits_lost" else axis.semilogy
            draw(travel, history[column], color=colour, linewidth=1.1, label=name)
            axis.set_title(labels[column])
            axis.set_xlabel("punch travel [in]")
        rows += [(name, *values) for values in zip(travel, *(history[column] for column in columns))]
    np.atleast_1d(axes)[-1].legend(fontsize=8)
    figure.tight_layout()
    figure.savefig(os.path.join(folder, file + ".png"), dpi=130)
    write_csv(os.path.join(folder, file + ".csv"), ["case", "travel", *columns], rows)


def below(runs, name, other):
    """Share of the travel in which the first has the smaller raw condition number."""
    a, b = (Table(os.path.join(runs[key], "history.csv")) for key in (name, other))
    travel = a["punch_travel"]
    return float(np.mean(a["condition_raw"] < np.interp(travel, b["punch_travel"], b["condition_raw"])))


def loaded_ratios(out):
    """p/delta of the loaded points (a force of at least a thousandth of the largest) at all travels."""
    ratios = []
    for travel in TRAVELS:
        table = Table(os.path.join(out, f"contact_{travel:g}.csv"))
        force = table["normal_force"]
        keep = force > 1e-3 * force.max()
        ratios += list((table["penetration"] / table["delta"])[keep])
    return np.array(ratios)


def run_table(runs, states):
    table = MeasuredTable(["run", "status", "increments", "Newton iterations", "max p [in]", "max p/delta", "raw kappa median",
                           "scaled median", "digits lost median, max"])
    for name, out in runs.items():
        code, message = states[name]
        history = Table(os.path.join(out, "history.csv"))
        if len(history) == 0:
            table.add(name, f"{code}: {message}", 0, "", "", "", "", "", "")
            continue
        reached = "" if code == 0 else f" at {history['punch_travel'][-1]:.3f} in"
        lost = history["digits_lost"][np.isfinite(history["digits_lost"])]
        table.add(name, f"{code}{reached}", len(history), int(history["newton_iterations"].sum()),
                  f"{history['max_penetration'].max():.2e}", f"{history['max_penetration_over_delta'].max():.3f}",
                  f"{np.median(history['condition_raw']):.2e}", f"{np.median(history['condition_scaled']):.2e}",
                  f"{np.median(lost):.1f}, {lost.max():.1f}")
    return table


def delta_table(runs):
    table = MeasuredTable(["run", "10 %", "median", "90 %", "largest", "floor share",
                           "increments with a raw condition number below that of constant 1e7 [%]"])
    for name in runs:
        if name.startswith("delta"):
            ratios = loaded_ratios(runs[name])
            share = Table(os.path.join(runs[name], "history.csv"))["floor_share"].mean()
            table.add(name, *(f"{np.quantile(ratios, q):.2f}" for q in (.1, .5, .9)), f"{ratios.max():.3f}", f"{share:.2f}",
                      f"{100 * below(runs, name, 'constant 1e7'):.0f}")
    return table


def main():
    arguments = arguments_of(__doc__, "figures", write="renew pictures in doc/gallery and tables in doc/measured").parse_args()
    if not os.access(arguments.program, os.X_OK):
        sys.exit(f"figures: no program '{arguments.program}': build it (scripts/build.sh) or name it with --program")
    os.makedirs(arguments.output, exist_ok=True)
    plt.rcParams.update(STYLE)

    work = jobs()
    runs, states = {}, {}
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        futures = {name: pool.submit(run, arguments.program, arguments.output, name, *job) for name, job in work.items()}
        for name, future in futures.items():
            runs[name], *state = future.result()
            states[name] = state
            print(f"{name}: exit status {state[0]}")

    folder = arguments.output
    figure_2(runs, folder)
    conditions(runs, list(CASES), "figure_3", folder)
    conditions(runs, ["constant 1e7", "delta 1e-7 in, beta 1", "delta 1e-3 in, beta 1"], "figure_3_beta_1", folder)
    conditions(runs, [f"adaptive, mu {mu:g}" for mu in FRICTION], "condition_friction", folder)
    conditions(runs, [f"rule {rule}" for rule in RULES if rule != "paper"], "condition_rules", folder)
    conditions(runs, list(CASES), "digits_lost", folder, ("condition_raw", "digits_lost"))
    tables = {"figures_runs": (run_table(runs, states),
                               "cup with rigid thickness (Thickness compliance = off): penetration [in], condition numbers, digits lost"),
              "figures_delta": (delta_table(runs), "cup with rigid thickness: penetration/delta of the loaded points at travels .2 to 1 in, "
                                "mean share of points whose factor is the lower bound")}
    for name, (table, title) in tables.items():
        print(f"{title}\n{table}\n")
        if arguments.write:
            table.write(name, title)
    if arguments.write:
        gallery = os.path.join(ROOT, "doc", "gallery")
        for name in ("figure_2", "figure_3", "figure_3_beta_1", "condition_friction", "condition_rules", "digits_lost"):
            shutil.copy(os.path.join(folder, name + ".png"), gallery)


if __name__ == "__main__":
    main()
