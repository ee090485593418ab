#!/usr/bin/env python3
"""Runs bent strips of the stress test again with four times the elements where contact at points takes more than a hundredth of the work.

    artificial_friction.py PROGRAM FOLDER [--first N] [--count N] [--seconds N] [--jobs N] [--again FILE ...] [--write]

Of every strip without a sharp corner that is done on both meshes within --seconds of processor time each, FOLDER/artificial_friction.jsonl
has 'artificial_friction' and the largest force of the punch on both. --again judges such files, and runs nothing. --write renews
doc/measured/artificial_friction.csv.
"""
import json
import re
import shutil
import sys

import draw
from stress import MeasuredTable, run_limited
from study import options, results_of

WORTH_A_LOOK = 0.01


def run_finer(program, work, seed, limit):
    """What is known of a scene; None of others than bent strips that slide over their points."""
    text, tags = draw.draw(seed)
    if tags["kind"] != "bending" or "a sharp corner" in tags["against"]:
        return None
    elements = int(re.search(r"set Elements = (\d+)", text).group(1))
    scene = work / f"{seed:05d}.prm"
    scene.write_text(text)
    result = {"seed": seed, "sensible": tags["sensible"], "against": tags["against"]}
    for name, n in (("drawn", elements), ("finer", 4 * elements)):
        folder = work / f"{seed:05d}_{name}"
        shutil.rmtree(folder, ignore_errors=True)
        status, _, _ = run_limited([program, str(scene), "--quiet", "--output", str(folder), "--set", f"Blank/Elements={n}",
                                    "--set", "Output/Checkpoint interval=0", "--set", "Output/Pictures=0",
                                    "--set", "Solver/Maximal increments=40000"], work / f"{seed:05d}.txt", limit)
        summary = json.loads((folder / "summary.json").read_text()) if status == 0 else None
        shutil.rmtree(folder, ignore_errors=True)
        if summary is None or abs(summary["artificial_friction"]) < (WORTH_A_LOOK if name == "drawn" else 0):
            break
        result[name] = {"share": summary["artificial_friction"], "force": summary["tools"]["punch"]["max_force"]}
    scene.unlink()
    return result if "finer" in result else None


def main():
    arguments = options(__doc__, 400).parse_args()
    results = results_of(arguments, run_finer, "artificial_friction.jsonl")
    table = MeasuredTable(["seed", "sensible", "of the work [%]", "of the work, four times the elements [%]", "largest force over that of the finer mesh"])
    for result in sorted(results, key=lambda result: -abs(result["drawn"]["share"])):
        drawn, finer = result["drawn"], result["finer"]
        table.add(result["seed"], "yes" if result["sensible"] else "no", *(f"{100 * mesh['share']:.1f}" for mesh in (drawn, finer)),
                  f"{drawn['force'] / finer['force']:.3f}")
    print(table)
    if arguments.write:
        table.write("artificial_friction", "bent strips over points that stand apart", script="tests/stress/artificial_friction.py")
    return 0


if __name__ == "__main__":
    sys.exit(main())
