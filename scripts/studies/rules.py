#!/usr/bin/python3
"""Every rule of contact, delta from 1e-1 to 1e-8 t, on three scenes: a table and plots.

    scripts/studies/rules.py [--program PROGRAM] [--output output/rules] [--jobs 2] [--scenes cup,pressed_plate,bent_strip] [--write]

Error in force: root mean square difference from `active set` at ten travels over the largest force. Condition numbers are
medians over every fifth increment. The runs are those of `deltaform sweep`, so that one that fails is a row. --write renews
doc/measured/rules.csv and the picture in doc/gallery.
"""
import os
import shutil
import subprocess
import sys

from measured import ROOT, MeasuredTable, arguments_of

import numpy as np

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from csv_file import rows_of  # noqa: E402
from plot import STYLE  # noqa: E402
from results import NoResults, Table  # noqa: E402

STROKE = {"cup": 1.0, "pressed_plate": 10.0, "bent_strip": 15.0}
LIMIT = 120  # seconds per run


def sweeps():
    """(enforcement and rule, varied entry, its values): one sweep each, all delta of all rules among them."""
    deltas = [f"1e-{k}" for k in range(1, 9)]
    result = [({"Contact/Enforcement": "active set"}, "active set", "Contact/Allowed penetration", ["1e-3"])]
    for rule in ("adaptive", "paper", "proportional", "gap driven"):
        result.append(({"Contact/Penalty rule": rule}, rule, "Contact/Allowed penetration", deltas))
    for enforcement in ("adaptive compensated", "augmented Lagrangian"):
        result.append(({"Contact/Enforcement": enforcement}, enforcement, "Contact/Allowed penetration", deltas))
    result.append(({"Contact/Penalty rule": "constant"}, "constant", "Contact/Penalty factor", [f"1e{k}" for k in range(2, 10)]))
    result.append(({"Contact/Penalty rule": "element stiffness"}, "element stiffness", "Contact/Stiffness factor",
                   ["0.01", "0.1", "1", "10"]))
    return result


def run(program, folder, scene, jobs):
    """All sweeps of a scene. @return (choice, parameter): row of sweep.csv"""
    rows = {}
    travels = ", ".join(f"{STROKE[scene] * k / 10:g}" for k in range(1, 11))
    for entries, choice, entry, values in sweeps():
        out = os.path.join(folder, scene, choice.replace(" ", "_"))
        shutil.rmtree(out, ignore_errors=True)
        unit = "*thickness" if entry.endswith("penetration") else ""
        command = [program, "sweep", os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--jobs", str(jobs),
                   "--seconds", str(LIMIT), "--output", out, "--vary", f"{entry}={','.join(v + unit for v in values)}",
                   "--set", "Output/Pictures=0", "--set", f"Output/Travels={travels}",
                   "--set", "Output/Condition number every=5",
                   "--set", "Blank/Contact points=nodes"]  # all rules at the same places
        for name, value in entries.items():
            command += ["--set", f"{name}={value}"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        table_file = os.path.join(out, "sweep.csv")
        if not os.path.exists(table_file):
            sys.exit(f"rules: {done.stderr.strip()}")
        for row in rows_of(table_file):
            parameter = "" if choice == "active set" else row[entry].replace("*thickness", "")
            rows[(choice, parameter)] = dict(row, folder=os.path.join(out, row["folder"]))
    return rows


def measure(swept, reference, scene):
    """The row of a run: that of sweep.csv, and what needs its history."""
    row = {"status": int(float(swept["exit_status"])), "message": swept["outcome"]}
    try:
        history = Table(os.path.join(swept["folder"], "history.csv"))
        travel = history["punch_travel"]
    except NoResults:
        return row
    if len(history) == 0:
        return row
    row["travel"] = travel[-1]
    row["force_at"] = {round(10 * t / STROKE[scene]): f for t, f in zip(travel, history["punch_force_z"])
                       if abs(10 * t / STROKE[scene] - round(10 * t / STROKE[scene])) < 1e-6}
    if reference:
        common = [k for k in row["force_at"] if k in reference]
        if common:
            square = np.mean([(row["force_at"][k] - reference[k]) ** 2 for k in common])
            row["error"] = float(np.sqrt(square) / max(reference.values()))
    row["max_p"] = history["max_penetration"].max()
    row["ratio"] = history["max_penetration_over_delta"].max()
    row["max_epsilon"] = history["max_epsilon"].max()
    row["iterations"] = int(history["newton_iterations"].sum())
    row["corrections"] = int(history["penalty_iterations"].sum())
    for name in ("condition_raw", "condition_scaled"):
        finite = history[name][np.isfinite(history[name].astype(float))]
        row[name] = float(np.median(finite)) if len(finite) else float("nan")
    row["seconds"] = float(swept["seconds"])
    return row


def text(row, name, form):
    return format(row[name], form) if name in row and row[name] is not None else ""


def add(table, scene, rows):
    for (choice, parameter), row in rows.items():
        state = row["status"] if row["status"] == 0 else f"{row['status']} at {text(row, 'travel', '.3g')}"
        table.add(scene.replace("_", " "), choice, parameter, state, *(text(row, name, form) for name, form in (
            ("error", ".1e"), ("max_p", ".1e"), ("ratio", ".3g"), ("max_epsilon", ".1e"), ("condition_raw", ".1e"),
            ("condition_scaled", ".1e"), ("iterations", "d"), ("corrections", "d"), ("seconds", ".2f"))))


def against_constant(rows):
    """Iterations of adaptive at 1e-3 t against the best constant that penetrates no more."""
    adaptive = rows[("adaptive", "1e-3")]
    rivals = [(row["iterations"], key[1]) for key, row in rows.items()
              if key[0] == "constant" and row["status"] == 0 and row["max_p"] <= adaptive["max_p"] * 1.0001]
    if not rivals:
        return f"adaptive at 1e-3 t {adaptive['iterations']} iterations; no constant keeps its penetration"
    best, factor = min(rivals)
    return (f"adaptive at 1e-3 t {adaptive['iterations']} iterations, of them {adaptive['corrections']} for corrections; best "
            f"constant that penetrates no more: {factor} with {best} ({100 * (adaptive['iterations'] / best - 1):+.0f} %)")


def plot(results, folder):
    figure, axes = plt.subplots(len(results), 3, figsize=(13, 3.4 * len(results)), squeeze=False)
    choices = ["adaptive", "adaptive compensated", "augmented Lagrangian", "constant", "element stiffness", "paper",
               "proportional", "gap driven"]
    for line, (scene, rows) in zip(axes, results.items()):
        for axis, column, label in zip(line, ("error", "condition_raw", "iterations"),
                                       ("error in force", "raw condition number", "Newton iterations")):
            for choice in choices:
                points = sorted((row["max_p"], row[column]) for key, row in rows.items()
                                if key[0] == choice and row["status"] == 0 and column in row and row["max_p"] > 0)
                if points:
                    axis.loglog(*zip(*points), "o-", markersize=3.5, linewidth=1, label=choice)
            axis.set_title(f"{scene.replace('_', ' ')}: {label}")
            axis.set_xlabel("max penetration")
    axes[0][0].legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "rules.png"), dpi=120)


def main():
    parser = arguments_of(__doc__, "rules")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--scenes", default="cup,pressed_plate,bent_strip")
    arguments = parser.parse_args()
    if not os.access(arguments.program, os.X_OK):
        sys.exit(f"rules: no program '{arguments.program}': build it (scripts/build.sh) or name it with --program")
    plt.rcParams.update(STYLE)
    results = {}
    table = MeasuredTable(["scene", "choice", "parameter", "status", "force error", "max penetration", "max penetration/delta",
                           "max penalty factor", "condition raw", "condition scaled", "iterations", "of them corrections", "seconds"])
    for scene in arguments.scenes.split(","):
        reference = None
        results[scene] = {}
        for key, swept in run(arguments.program, arguments.output, scene, arguments.jobs).items():
            results[scene][key] = measure(swept, reference, scene)
            if reference is None:
                reference = results[scene][key]["force_at"]
        add(table, scene, results[scene])
        print(f"{scene}: {against_constant(results[scene])}", flush=True)
    print(table)
    plot(results, arguments.output)
    if arguments.write:
        table.write("rules", "rules of contact on three scenes; parameter: delta over thickness, penalty factor (constant) or "
                    "stiffness factor (element stiffness)")
        shutil.copy(os.path.join(arguments.output, "rules.png"), os.path.join(ROOT, "doc", "gallery"))


if __name__ == "__main__":
    main()
