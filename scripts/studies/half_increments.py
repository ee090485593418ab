#!/usr/bin/env python3
"""What the length of increments changes: the processes of process_cost.py again with increments of half the mean length.

    scripts/studies/half_increments.py [--program PROGRAM] [--output output/half_increments] [--write]

'Largest increment' of every stage is half of the mean increment that the default settings take in it; those that are shorter stay as they
are. Forces are those of tools along z with at least a tenth of the largest force: 'peak' is the change of the largest one of a tool, 'mean'
that of the mean over time (of stages at whose end the tool presses), each of the worst tool. 'angle' is the largest change of a measured
angle, 'thinnest' that of the smallest thickness over the initial one. --write writes doc/measured/half_increments.csv. Four minutes.
"""
import json
import os
import subprocess

from measured import ROOT, MeasuredTable, arguments_of
from csv_file import rows_of
from process_cost import PROCESSES

ANGLES = ("theta1", "theta2", "bend_angle")
SMALL = 0.1  # of the largest force: tools with less do not count


class Run:
    """A scene that has run: its summary and its history."""

    def __init__(self, options, folder, scene, settings):
        command = [options.program, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--force", "--output", folder]
        for setting in settings:
            command += ["--set", setting]
        self.status = subprocess.run(command, check=False).returncode
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            self.summary = json.load(file)
        self.history = rows_of(os.path.join(folder, "history.csv"))

    def half_increments(self):
        """Settings for increments of at most half the mean one of their stage."""
        settings, start = [], 0.0
        for stage in dict.fromkeys(row["stage"] for row in self.history):
            rows = [row for row in self.history if row["stage"] == stage]
            end = float(rows[-1]["time"])
            settings.append(f"Steps/{stage}/Largest increment={0.5 * (end - start) / len(rows):.6g}")
            start = end
        return settings

    def angles(self):
        return {(name, key): value for name, measure in self.summary.get("measures", {}).items()
                for key, value in measure.items() if key in ANGLES}

    def mean_force(self, tool, end):
        """Of a tool along z up to the time @p end, over the stages at whose end it presses."""
        pressing = {row["stage"]: float(row[tool + "_force_z"]) != 0 for row in self.history}
        area = time = force = length = 0.0
        for row in self.history:
            now, next_force = min(float(row["time"]), end), float(row[tool + "_force_z"])
            if pressing[row["stage"]]:
                area += 0.5 * (now - time) * (force + next_force)
                length += now - time
            time, force = now, next_force
        return area / length if length > 0 else 0.0


def change_of_forces(run, other):
    """Of the largest and of the mean forces, in percent; None without tools."""
    largest = {name: tool["max_force"] for name, tool in run.summary["tools"].items()}
    counted = [name for name, force in largest.items() if force > SMALL * max(largest.values())]
    if not counted:
        return None
    peak = max(abs(other.summary["tools"][name]["max_force"] / largest[name] - 1) for name in counted)
    end = min(run.summary["time"], other.summary["time"])
    means = [(run.mean_force(name, end), other.mean_force(name, end)) for name in counted]
    return 100 * peak, 100 * max(abs(b / a - 1) for a, b in means if a != 0)


def compared(options, name, scene, settings):
    """The cells of a row."""
    folder = os.path.join(options.output, os.path.basename(scene) + ("_tight" if settings else ""))
    settings = list(settings[1:])
    start = os.path.join(options.output, "redraw_1")
    runs = []
    for suffix in ("", "_half"):
        own = settings + (["Start from=" + start + suffix] if scene == "shop/redraw_2" else [])
        own += runs[0].half_increments() if runs else []
        runs.append(Run(options, folder + suffix, scene, own))
    run, half = runs
    forces = change_of_forces(run, half)
    angles, others = run.angles(), half.angles()
    cells = [name, scene + ".prm", *(f"{r.summary['increments']}; {r.summary['newton_iterations']}" for r in runs),
             *(f"{force:.2g}" for force in forces or ())]
    cells += [""] * (6 - len(cells))
    cells.append(f"{max(abs(angles[key] - others[key]) for key in angles):.2g}" if angles else "")
    cells.append(f"{half.summary['min_thickness'] - run.summary['min_thickness']:.1e}")
    return cells + [f"{r.summary['energy_error']:.1e}" for r in runs] + [f"{r.status}" for r in runs]


def main():
    options = arguments_of(__doc__, "half_increments").parse_args()
    table = MeasuredTable(["process", "scene", "increments; iterations", "the same with half increments", "peak [%]", "mean [%]", "angle [degree]",
                           "thinnest", "energy error", "with half increments", "exit status", "with half increments"])
    for process in PROCESSES:
        table.add(*compared(options, *process))
        print(table.rows[-1], flush=True)
    print(table)
    if options.write:
        table.write("half_increments", "What increments of half the length change")


if __name__ == "__main__":
    main()
