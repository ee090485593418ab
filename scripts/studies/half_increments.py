#!/usr/bin/env python3
"""What the length of increments changes: the processes of process_cost.py again with increments of half the mean length.

    scripts/studies/half_increments.py [--program PROGRAM] [--output output/half_increments] [--write]

'Largest increment' of every stage is half of the mean increment that the default settings take in it; those that are shorter stay as they
are. Forces are those of tools along z with at least a tenth of the largest force: 'peak' is the change of the largest one of a tool, 'mean'
that of the mean over time (of stages at whose end the tool presses), each of the worst tool. 'angle' is the largest change of a measured
angle, 'thinnest' that of the smallest thickness over the initial one. --write writes doc/measured/half_increments.csv. Four minutes.
"""
import os

from measured import MeasuredTable, arguments_of
from csv_file import rows_of
from process_cost import PROCESSES, run

ANGLES = ("theta1", "theta2", "bend_angle")
SMALL = 0.1  # of the largest force: tools with less do not count


class Run:
    """A scene that has run: its summary and its history."""

    def __init__(self, *process):
        self.status, folder, self.summary = run(*process)
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


def change_of_forces(default, half):
    """Of the largest and of the mean forces, in percent; None without tools."""
    largest = {name: tool["max_force"] for name, tool in default.summary["tools"].items()}
    counted = [name for name, force in largest.items() if force > SMALL * max(largest.values())]
    if not counted:
        return None
    peak = max(abs(half.summary["tools"][name]["max_force"] / largest[name] - 1) for name in counted)
    end = min(default.summary["time"], half.summary["time"])
    means = [(default.mean_force(name, end), half.mean_force(name, end)) for name in counted]
    return 100 * peak, 100 * max(abs(b / a - 1) for a, b in means if a != 0)


def compared(options, name, scene, settings):
    """The cells of a row."""
    default = Run(options, scene, settings)
    half = Run(options, scene, (*settings, *default.half_increments()), "_half")
    runs = default, half
    forces = change_of_forces(default, half)
    angles, others = default.angles(), half.angles()
    cells = [name, scene + ".prm", *(f"{r.summary['increments']}; {r.summary['newton_iterations']}" for r in runs),
             *(f"{force:.2g}" for force in forces or ())]
    cells += [""] * (6 - len(cells))
    cells.append(f"{max(abs(angles[key] - others[key]) for key in angles):.2g}" if angles else "")
    cells.append(f"{half.summary['min_thickness'] - default.summary['min_thickness']:.1e}")
    return cells + [f"{r.summary['energy_error']:.1e}" for r in runs] + [f"{r.status}" for r in runs]


def main():
    options = arguments_of(__doc__, "half_increments").parse_args()
    table = MeasuredTable(["process", "scene", "increments; iterations", "increments; iterations, half", "peak [%]", "mean [%]", "angle [degree]",
                           "thinnest", "energy error", "energy error, half", "exit status", "exit status, half"])
    for process in PROCESSES:
        table.add(*compared(options, *process))
        print(table.rows[-1], flush=True)
    print(table)
    if options.write:
        table.write("half_increments", "What increments of half the length change")


if __name__ == "__main__":
    main()
