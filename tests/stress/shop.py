#!/usr/bin/env python3
"""Runs processes of a press shop that are drawn at random, again with twice the elements, and again with a quarter of the increments;
bulk also with half the elements, to compare the program's estimate of the error by the mesh.

    shop.py PROGRAM FOLDER [--first N] [--count N] [--seconds N] [--jobs N] [--worst SHARE] [--again FILE ...] [--write]

Wrong answers that no balance shows: largest force or pressure, smallest thickness and angles after springback on the three.
The exit status is 1 if a scene stops, if its files show it to be wrong without a warning, or if the largest force or pressure of one
without a warning differs by more than --worst. --again judges earlier shop.jsonl, and runs nothing. --write renews doc/measured/stress_shop.csv and mesh_error.csv.
"""
import json
import math
import re
import shutil
import sys

import draw_shop
from stress import MeasuredTable, csv_rows, run_limited, warnings_of, wrong_results
from study import options, results_of

LARGEST = .015  # default of Largest increment, of a stage


def elements(factor):
    return lambda text: re.sub(r"(set Elements(?: through thickness)? = )(\d+)", lambda found: found[1] + str(max(1, round(factor * int(found[2])))),
                               text)


def quarter_of_increments(text):
    if "Largest increment" in text:
        return re.sub(r"(set Largest increment = )(\S+)", lambda found: found[1] + f"{float(found[2]) / 4:.6g}", text)
    begin = 0.

    def shorter(found):
        nonlocal begin
        length, begin = float(found[1]) - begin, float(found[1])
        return f"{found[0]}\n    set Largest increment = {LARGEST / 4 * length:.6g}"
    return re.sub(r"set End time = (\S+)", shorter, text)


# What a scene has of these shows what its process takes, the first of them.
MAIN = ("ring_force_z", "punch_force_z", "container_force_z", "oil_pressure", "pull_reaction", "ram_reaction", "upper_force_z", "shoulder_force_z",
        "plate_force_z")
BULK = [make.__name__.replace("_", " ") for make in draw_shop.BULK]
VARIANTS = {"drawn": str, "twice": elements(2), "quarter": quarter_of_increments, "half": elements(.5)}


def measures(folder):
    head, *rows = csv_rows(folder / "history.csv")
    loads = [k for k, name in enumerate(head) if name.endswith(("_force_z", "_pressure", "_reaction"))]
    largest = {head[k]: max(abs(float(row[k])) for row in rows) for k in loads}
    main = next((name for name in MAIN if name in largest), None)
    summary = json.loads((folder / "summary.json").read_text())
    found = summary.get("measures", {}).get("part", {})
    work = sum(float(rows[-1][head.index(name)]) for name in ("tool_work", "load_work"))
    return {"force": largest.get(main), "work": work, "mesh_error": summary.get("mesh_error"),
            "thickness": float(rows[-1][head.index("min_thickness")]),
            "angles": [found[name] for name in ("included_angle", "theta1", "theta2") if name in found]}


def run(program, work, seed, limit):
    text, kind = draw_shop.draw(seed)
    result = {"seed": seed, "kind": kind}
    for name, change in VARIANTS.items():
        if name == "half" and kind not in BULK:
            continue
        scene, folder = work / f"{seed:05d}_{name}.prm", work / f"{seed:05d}_{name}"
        shutil.rmtree(folder, ignore_errors=True)
        scene.write_text(change(text))
        status, said, seconds = run_limited([program, str(scene), "--quiet", "--output", str(folder), "--set", "Output/Checkpoint interval=0"],
                                            work / f"{seed:05d}_{name}.txt", limit)
        result[name] = {"status": status, "seconds": seconds}
        if status == 0:
            result[name].update(measures(folder), warnings=warnings_of(folder), wrong=wrong_results(folder))
        else:
            result[name]["said"] = said[-400:]
        shutil.rmtree(folder, ignore_errors=True)
        scene.unlink()
        if name == "drawn" and status != 0:
            break
    return result


def differences(result, variant):
    """Of a variant to the scene as drawn: force and thickness (relative), the largest of the angles (degrees)."""
    a, b = result["drawn"], result[variant]
    return {"force": abs(a["force"] / b["force"] - 1), "thickness": abs(a["thickness"] / b["thickness"] - 1),
            "angle": max((abs(x - y) for x, y in zip(a["angles"], b["angles"])), default=None)}


def table_of(results):
    table = MeasuredTable(["process", "scenes", "done", "of these with a warning", "compared with", "scenes done", "force: median [%]", "worst [%]",
                           "of seed", "thickness: worst [%]", "angle: worst [degree]"])
    for kind in sorted({result["kind"] for result in results}) + ["all without a warning"]:
        group = [r for r in results if kind in (r["kind"], "all without a warning")]
        done = [r for r in group if r["drawn"]["status"] == 0]
        warned = [r for r in done if r["drawn"]["warnings"]]
        silent = [r for r in done if not r["drawn"]["warnings"]]
        for variant in ("twice", "quarter"):
            both = [(r, differences(r, variant)) for r in silent if r[variant]["status"] == 0 and r["drawn"]["force"]]
            if not both:
                continue
            forces = sorted((d["force"], r["seed"]) for r, d in both)
            angles = [d["angle"] for _, d in both if d["angle"] is not None]
            table.add(kind, len(group), len(done), len(warned), "twice the elements" if variant == "twice" else "a quarter of the increments", len(both),
                      f"{100 * forces[len(forces) // 2][0]:.2f}", f"{100 * forces[-1][0]:.2f}", forces[-1][1],
                      f"{100 * max(d['thickness'] for _, d in both):.2f}", f"{max(angles):.2f}" if angles else "")
    return table


def mesh_errors(results):
    table = MeasuredTable(["process", "seed", "elements", "mesh_error [%]", "work [%]", "largest force [%]", "warned of"])
    for result in sorted(results, key=lambda r: (r["kind"], r["seed"])):
        for variant, of_elements in (("half", "half"), ("drawn", "as drawn")):
            one, fine = result.get(variant, {}), result.get("twice", {})
            if one.get("mesh_error") is None or fine.get("status") != 0:
                continue
            off = [100 * (one[name] / fine[name] - 1) for name in ("work", "force")]
            warned = any(warning.startswith("coarse mesh") for warning in one["warnings"])
            table.add(result["kind"], result["seed"], of_elements, f"{100 * one['mesh_error']:.2g}", *(f"{value:.1f}" for value in off),
                      "yes" if warned else "")
    return table


def complaints(result, worst):
    """What is wrong with a scene, in sentences."""
    drawn = result["drawn"]
    if drawn["status"] != 0:
        return [f"status {drawn['status']}: {drawn['said']}"]
    if drawn["warnings"]:
        return []
    texts = [drawn["wrong"]] if drawn["wrong"] else []
    for variant in ("twice", "quarter"):
        if result[variant]["status"] == 0 and drawn["force"] and (off := differences(result, variant)["force"]) > worst:
            texts.append(f"its force differs by {100 * off:.2g} % ({variant})")
    return texts


def main():
    parser = options(__doc__, 150)
    parser.add_argument("--worst", type=float, default=math.inf)
    arguments = parser.parse_args()
    results = results_of(arguments, run, "shop.jsonl")
    print(table_of(results))
    bad = [(result, complaint) for result in results for complaint in complaints(result, arguments.worst)]
    for result, complaint in bad:
        print(f"{result['seed']}, {result['kind']}: {complaint}")
    if arguments.write:
        table_of(results).write("stress_shop", "processes drawn at random against finer meshes and shorter increments", script="tests/stress/shop.py")
        mesh_errors(results).write("mesh_error", "bulk processes drawn at random: the program's estimate of the error by the mesh, and what twice the "
                                   "elements show", script="tests/stress/shop.py")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
