#!/usr/bin/env python3
"""Runs processes of a press shop that are drawn at random with a shell, and again with a solid: what a shell does not know.

    shell_or_solid.py PROGRAM FOLDER [--first N] [--count N] [--seconds N] [--jobs N] [--again FILE ...] [--write]

The solid has three elements of degree 2 across, half a thickness long. Both
are held in the same way. Largest force, smallest thickness and angles after springback of both. --again judges earlier shell_or_solid.jsonl, and runs nothing. --write renews doc/measured/shell_or_solid.csv.
"""
import math
import re
import shutil
import sys

import draw_shop
from shop import measures
from stress import MeasuredTable, run_limited, warnings_of
from study import options, results_of

SHEETS = [make.__name__.replace("_", " ") for make in draw_shop.SHEETS]


def as_solid(text):
    """The scene with a solid: supports of rotations hold its edges by their displacements alone."""
    thickness = float(re.search(r"set Thickness = (\S+)", text)[1])
    corners = [tuple(float(x) for x in pair.split()) for pair in re.search(r"set Points = (.*)", text)[1].split(";")]
    length = sum(math.dist(a, b) for a, b in zip(corners, corners[1:]))
    text = re.sub(r"set Elements = \d+", f"set Elements = {math.ceil(2 * length / thickness)}", text, count=1)
    text = re.sub(r"set Layers = \d+", "set Kind = solid\n  set Degree = 2\n  set Elements through thickness = 3", text, count=1)
    text = re.sub(r"\n  set (Grading|Contact point) = .*", "", text)
    supports = re.search(r"subsection Supports\n  set Names = (.*)\n", text)
    if not supports:
        return text
    names = [name for name in supports[1].split(", ")]
    for name in list(names):
        own = re.search(rf"  subsection {re.escape(name)}\n(?:    set .*\n)*?    set Component = rotation\n(?:    set .*\n)*  end\n", text)
        if own:
            text = text.replace(own[0], "")
            names.remove(name)
    return text.replace(supports[0], supports[0].replace(supports[1], ", ".join(names)))


SUPPORT = r"  subsection {}\n(?:    set .*\n)*  end\n"


def as_held(text):
    """The scene with a shell whose rotation is held where the solid's is: an edge across the sheet, held along the sheet, cannot turn."""
    supports = re.search(r"subsection Supports\n  set Names = (.*)\n", text)
    if not supports:
        return text
    corners = [pair.split() for pair in re.search(r"set Points = (.*)", text)[1].split(";")]
    along = "r" if len({z for _, z in corners}) == 1 else "z" if len({r for r, _ in corners}) == 1 else None
    blocks = {name: re.search(SUPPORT.format(re.escape(name)), text)[0] for name in supports[1].split(", ")}
    entry = {name: dict(re.findall(r"    set (.*?) += (.*)", block)) for name, block in blocks.items()}
    names = list(blocks)
    for name, what in entry.items():
        if what["Component"] != along:
            continue
        for other, theirs in entry.items():
            if theirs["Component"] == "rotation" and theirs["Boundary"] == what["Boundary"]:
                text = text.replace(blocks[other], "")
                names.remove(other)
        names.append(name + " turn")
        stages = f"    set Stages = {what['Stages']}\n" if "Stages" in what else ""
        hold = "    set Hold = true\n" if what.get("Hold") == "true" else ""
        block = f"  subsection {name} turn\n    set Boundary = {what['Boundary']}\n    set Component = rotation\n{hold}{stages}  end\n"
        text = text.replace(blocks[name], blocks[name] + block)
    return text.replace(supports[0], supports[0].replace(supports[1], ", ".join(names)))


def run(program, work, seed, limit):
    text, kind = draw_shop.draw(seed)
    if kind not in SHEETS:
        return None
    result = {"seed": seed, "kind": kind}
    for name, change in (("shell", as_held), ("solid", as_solid)):
        scene, folder = work / f"{seed:05d}_{name}.prm", work / f"{seed:05d}_{name}"
        shutil.rmtree(folder, ignore_errors=True)
        scene.write_text(change(text))
        status, said, _ = run_limited([program, str(scene), "--quiet", "--output", str(folder), "--set", "Output/Checkpoint interval=0"],
                                      work / f"{seed:05d}_{name}.txt", limit)
        result[name] = dict(measures(folder), warnings=warnings_of(folder)) if status == 0 else {"said": said[-300:]}
        shutil.rmtree(folder, ignore_errors=True)
        scene.unlink()
    return result


def table_of(results):
    table = MeasuredTable(["process", "the shell warns", "scenes", "force: median [%]", "worst [%]", "of seed", "thickness: worst [%]",
                           "angle: median [degree]", "worst [degree]"])
    both = [r for r in results if r["shell"].get("force") and r["solid"].get("force")]
    for kind in sorted({r["kind"] for r in both}) + ["all"]:
        for word, warned in (("no", False), ("yes", True)):
            group = [r for r in both if kind in (r["kind"], "all") and any(" shell:" in said for said in r["shell"]["warnings"]) == warned]
            if not group:
                continue
            forces = sorted(((r["shell"]["force"] / r["solid"]["force"] - 1, r["seed"]) for r in group), key=lambda pair: abs(pair[0]))
            angles = sorted(abs(a - b) for r in group for a, b in zip(r["shell"]["angles"], r["solid"]["angles"]))
            table.add(kind, word, len(group), f"{100 * forces[len(forces) // 2][0]:.2f}", f"{100 * forces[-1][0]:.2f}", forces[-1][1],
                      f"{100 * max((r['shell']['thickness'] / r['solid']['thickness'] - 1 for r in group), key=abs):.2f}",
                      f"{angles[len(angles) // 2]:.2f}" if angles else "", f"{angles[-1]:.2f}" if angles else "")
    return table, len(results) - len(both)


def main():
    arguments = options(__doc__, 150).parse_args()
    results = results_of(arguments, run, "shell_or_solid.jsonl")
    table, incomplete = table_of(results)
    print(table)
    for result in results:
        for name in ("shell", "solid"):
            if "said" in result[name]:
                print(f"{result['seed']}, {result['kind']}, {name}: {result[name]['said'][-200:]}")
    print(f"{incomplete} of {len(results)} are not done by both.")
    if arguments.write:
        table.write("shell_or_solid", "processes drawn at random with a shell against a solid of degree 2", script="tests/stress/shell_or_solid.py")
    return 0


if __name__ == "__main__":
    sys.exit(main())
