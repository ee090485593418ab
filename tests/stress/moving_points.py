#!/usr/bin/env python3
"""Runs strips of the stress test at their nodes and with contact points that move, on the elements drawn and on four times as many.

    moving_points.py PROGRAM FOLDER [--seeds N ...] [--first N] [--count N] [--seconds N] [--jobs N] [--again FILE ...] [--write]

Of every strip FOLDER/moving_points.jsonl has the largest force of the punch and the iterations of the four runs; null: not done within
--seconds of processor time. --again judges such files, and runs nothing. --write renews doc/measured/moving_points.csv.
"""
import json
import re
import shutil
import sys

import draw
from stress import MeasuredTable, run_limited
from study import options, results_of

RUNS = [(points, times) for points in ("nodes", "moving") for times in (1, 4)]


def run_four(program, work, seed, limit):
    text, tags = draw.draw(seed)
    elements = int(re.search(r"set Elements = (\d+)", text).group(1))
    scene = work / f"{seed:05d}.prm"
    scene.write_text(text)
    result = {"seed": seed, "sensible": tags["sensible"], "elements": elements, "runs": []}
    for points, times in RUNS:
        folder = work / f"{seed:05d}_{points}_{times}"
        shutil.rmtree(folder, ignore_errors=True)
        status, _, _ = run_limited([program, str(scene), "--quiet", "--output", str(folder), "--set", f"Blank/Elements={times * elements}",
                                    "--set", f"Blank/Contact points={points}", "--set", "Output/Checkpoint interval=0",
                                    "--set", "Output/Pictures=0", "--set", "Solver/Maximal increments=40000"], work / f"{seed:05d}.txt", limit)
        done = None
        if status == 0:
            summary = json.loads((folder / "summary.json").read_text())
            done = {"force": summary["tools"]["punch"]["max_force"], "iterations": summary["newton_iterations"],
                    "share": summary["artificial_friction"]}
        result["runs"].append(done)
        shutil.rmtree(folder, ignore_errors=True)
    scene.unlink()
    return result


def main():
    parser = options(__doc__, 400)
    parser.add_argument("--seeds", type=int, nargs="+")
    arguments = parser.parse_args()
    results = results_of(arguments, run_four, "moving_points.jsonl")
    table = MeasuredTable(["seed", "sensible", "elements"] +
                          [f"{points}, {what}" for points, times in RUNS
                           for what in (("largest force", "iterations", "artificial friction [% of the work]") if times == 1 else
                                        ("largest force on 4 times the elements",))])
    for result in results:
        row = []
        for (_, times), run in zip(RUNS, result["runs"]):
            row.append(f"{run['force']:.4g}" if run else "not done")
            if times == 1:
                row += [run["iterations"], f"{100 * run['share']:.1f}"] if run else ["", ""]
        table.add(result["seed"], "yes" if result["sensible"] else "no", result["elements"], *row)
    print(table)
    if arguments.write:
        table.write("moving_points", "strips at their nodes, and with contact points that move", script="tests/stress/moving_points.py")
    return 0


if __name__ == "__main__":
    sys.exit(main())
