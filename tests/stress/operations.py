#!/usr/bin/env python3
"""Runs parts that are made in several operations, drawn at random, each as drawn, with twice the elements and with a quarter of the
increments; the last operation is compared. Then processes of shop.py that end with a release: in one run, and the release as an
operation of its own, on the same mesh and on one of half as many elements again.

    operations.py PROGRAM FOLDER [--first N] [--count N] [--seconds N] [--jobs N] [--worst SHARE] [--again FILE ...] [--write]

The exit status is 1 if an operation stops, if its files show it to be wrong without a warning, or if the largest force of a last one without
a warning differs by more than --worst. --again judges earlier operations.jsonl, and runs nothing. --write renews
doc/measured/stress_operations.csv.
"""
import math
import random
import shutil
import sys

import shop
from shop_chains import CHAINS
from stress import run_limited, warnings_of, wrong_results
from study import options, results_of

VARIANTS = ("drawn", "twice", "quarter")


def run_chain(program, work, texts, limit):
    """What the last of some operations, or the first that stops, has found."""
    folders = [work.with_name(f"{work.name}_{i}") for i in range(len(texts))]
    result, wrong = {}, []
    for i, (text, folder) in enumerate(zip(texts, folders)):
        shutil.rmtree(folder, ignore_errors=True)
        scene = folder.with_suffix(".prm")
        scene.write_text((f"set Start from = {folders[i - 1]}\n" if i else "") + text)
        status, said, seconds = run_limited([program, str(scene), "--quiet", "--output", str(folder)], folder.with_suffix(".txt"), limit)
        result = {"status": status, "seconds": seconds, "operation": i + 1}
        if status != 0:
            result["said"] = said[-400:]
            break
        warnings = warnings_of(folder)
        wrong += [f"operation {i + 1}: {text}" for text in [wrong_results(folder)] if text and not warnings]
        result.update(shop.measures(folder), warnings=warnings, wrong="; ".join(wrong))
    for folder in folders:
        shutil.rmtree(folder, ignore_errors=True)
        folder.with_suffix(".prm").unlink(missing_ok=True)
    return result


def run(program, work, seed, limit):
    make = CHAINS[seed % len(CHAINS)]
    scenes = make(random.Random(f"operations {seed}"))
    result = {"seed": seed, "kind": make.__name__.replace("_", " ")}
    for name in VARIANTS:
        texts = [shop.VARIANTS[name](scene.text(f"{result['kind']} {seed}, operation {i + 1}")) for i, scene in enumerate(scenes)]
        result[name] = run_chain(program, work / f"{seed:05d}_{name}", texts, limit)
        if result["drawn"]["status"] != 0:
            break
    return result


def main():
    parser = options(__doc__, 90)
    parser.add_argument("--worst", type=float, default=math.inf)
    arguments = parser.parse_args()
    results = results_of(arguments, run, "operations.jsonl")
    table = shop.table_of(results)
    print(table)
    bad = [(result, complaint) for result in results for complaint in shop.complaints(result, arguments.worst)]
    for result, complaint in bad:
        print(f"{result['seed']}, {result['kind']}: {complaint}")
    if arguments.write:
        table.write("stress_operations", "parts made in several operations, drawn at random, against finer meshes and shorter increments",
                    script="tests/stress/operations.py")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
