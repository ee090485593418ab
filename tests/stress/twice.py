#!/usr/bin/env python3
"""Runs the sensible scenes of the stress test again with twice the elements: wrong answers that no balance shows.

    twice.py PROGRAM FOLDER [--first N] [--count N] [--seconds N] [--jobs N] [--again FILE ...] [--write]

Of every scene that is done on both meshes within --seconds of processor time each, FOLDER/twice.jsonl has the largest
force of the punch and the smallest thickness at the end on both, and whether the program warned on the mesh as drawn.
--again judges such files, and runs nothing. --write renews doc/measured/stress_twice.csv.
"""
import re
import shutil
import sys

import draw
from stress import MeasuredTable, csv_rows, run_limited, warnings_of
from study import options, results_of


def measures(folder):
    """Largest force of the punch, smallest thickness at the end over the first one."""
    head, *rows = csv_rows(folder / "history.csv")
    force, thickness = head.index("punch_force_z"), head.index("min_thickness")
    return {"force": max(abs(float(row[force])) for row in rows), "thickness": float(rows[-1][thickness]) / float(rows[0][thickness])}


def run_twice(program, work, seed, limit):
    """What is known of a scene; None of one that is not sensible or not done as it is drawn."""
    text, tags = draw.draw(seed)
    if not tags["sensible"]:
        return None
    elements = int(re.search(r"set Elements = (\d+)", text).group(1))
    scene = work / f"{seed:05d}.prm"
    scene.write_text(text)
    result = {"seed": seed}
    for name, n in (("drawn", elements), ("twice", 2 * elements)):
        folder = work / f"{seed:05d}_{name}"
        shutil.rmtree(folder, ignore_errors=True)
        status, _, _ = run_limited([program, str(scene), "--quiet", "--output", str(folder), "--set", f"Blank/Elements={n}",
                                    "--set", "Output/Checkpoint interval=0", "--set", "Output/Pictures=0"],
                                   work / f"{seed:05d}.txt", limit)
        if status == 0:
            result[name] = dict(measures(folder), warnings=warnings_of(folder))
        shutil.rmtree(folder, ignore_errors=True)
        if status != 0:
            break
    scene.unlink()
    return result if "drawn" in result else None


def table_of(results):
    table = MeasuredTable(["a warning on the mesh as drawn", "scenes", "difference of", "median [%]", "nine of ten below [%]", "worst [%]", "of seed"])
    both = [result for result in results if "twice" in result]
    for word, group in (("no", [r for r in both if not r["drawn"]["warnings"]]), ("yes", [r for r in both if r["drawn"]["warnings"]])):
        for name, words in (("force", "largest force"), ("thickness", "smallest thickness")):
            errors = sorted((abs(r["drawn"][name] / r["twice"][name] - 1), r["seed"]) for r in group)
            if errors:
                table.add(word, len(errors), words, *(f"{100 * errors[i][0]:.2f}" for i in (len(errors) // 2, 9 * len(errors) // 10, -1)), errors[-1][1])
    return table, len(results) - len(both)


def main():
    arguments = options(__doc__, 1000).parse_args()
    results = results_of(arguments, run_twice, "twice.jsonl")
    table, left = table_of(results)
    print(table)
    print(f"{left} scenes were not done with twice the elements within their time")
    if arguments.write:
        table.write("stress_twice", "sensible scenes of seeds 0 to 999 against twice the elements", script="tests/stress/twice.py")
    return 0


if __name__ == "__main__":
    sys.exit(main())
