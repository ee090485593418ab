#!/usr/bin/env python3
"""How deep the face of the blank goes into a tool between its contact points, where delta promises nothing.

    scripts/studies/deepest_place.py [--program PROGRAM] [--output output/deepest_place] [--only cup|scenes] [--write]

Every shipped scene with tools, as it is, touched at the nodes and at one or two points inside an element; the cup
with more points, elements and a tighter delta. --write writes doc/measured/deepest_scenes.csv and deepest_cup.csv. Ten minutes; runs that are there are
not done again.
"""
import glob
import json
import os
import re
import subprocess

from measured import ROOT, MeasuredTable, arguments_of
from csv_file import rows_of

SKIPPED = {"u_bend_solid", "u_bend_19600", "forging_flash", "draw_bead", "cup_delta_1e-7"}  # long, or as another
NODES, GAUSS = "Blank/Contact points=nodes", "Blank/Contact points=gauss"


class Runs:
    def __init__(self, program, folder):
        self.program, self.folder = os.path.abspath(program), folder

    def __call__(self, scene, name, *entries):
        """Summary of a run, with the largest depth over delta of its history (corners included); None if it failed."""
        folder = os.path.join(self.folder, name)
        path = os.path.join(folder, "summary.json")
        if not os.path.exists(path):
            command = [self.program, scene, "--quiet", "--force", "--output", folder, "--set", "Output/Pictures=0"]
            for entry in entries:
                command += ["--set", entry]
            try:
                run = subprocess.run(command, capture_output=True, text=True, timeout=900, check=False)
            except subprocess.TimeoutExpired:
                print(f"{name}: not done after 900 s")
                return None
            if not os.path.exists(path):
                print(f"{name}: {run.stderr.strip().splitlines()[-1:]}")
                return None
        with open(path, encoding="utf-8") as file:
            summary = json.load(file)
        summary["corners"] = max((float(row["max_penetration_between_nodes"]) * float(row["max_penetration_over_delta"]) /
                                  float(row["max_penetration"])
                                  for row in rows_of(os.path.join(folder, "history.csv")) if float(row["max_penetration"]) > 0.),
                                 default=0.)
        return summary


def text_of(path):
    """Of a scene, with what it includes."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for name in re.findall(r"^include (\S+)", text, re.MULTILINE):
        with open(os.path.join(os.path.dirname(path), name), encoding="utf-8") as file:
            text += file.read()
    return text


def has_promise(path):
    """Does the scene have tools, and is its contact a penalty that keeps delta?"""
    text = text_of(path)
    return "subsection Tools" in text and not re.search(r"Enforcement *= *active set|Penalty rule *= *constant", text)


def degree_of_solid(path):
    """Of its cells; None: the scene has a shell."""
    text = text_of(path)
    degree = re.search(r"^ *set Degree *= *(\d)", text, re.MULTILINE)
    return (int(degree[1]) if degree else 1) if re.search(r"^ *set Kind *= *solid", text, re.MULTILINE) else None


def cells(summary):
    if summary is None:
        return ["", "", ""]
    smooth, anywhere = summary["max_penetration_between_nodes_over_delta"], summary["corners"]
    return [summary["newton_iterations"], f"{smooth:.3g}", f"{anywhere:.3g}" if anywhere > 1.01 * smooth else ""]


def scenes(run):
    own = ["iterations", "deepest/delta", "at sharp corners"]
    table = MeasuredTable(["scene", *own, "nodes: " + own[0], *own[1:], "gauss: " + own[0], *own[1:]])
    files = [path for pattern in ("prm/*.prm", "prm/shop/*.prm") for path in sorted(glob.glob(os.path.join(ROOT, pattern)))]
    for path in files:
        name = os.path.splitext(os.path.basename(path))[0]
        if name in SKIPPED or not has_promise(path):
            continue
        found = []
        two = (GAUSS, f"Blank/Gauss points={degree_of_solid(path) or 2}")
        for kind, entries in (("default", ()), ("nodes", (NODES,)), ("gauss", two)):
            if name == "redraw_2":
                entries += ("Start from=" + os.path.join(run.folder, "redraw_1_" + kind),)
            found += cells(run(path, f"{name}_{kind}", *entries))
        table.add(name, *found)
        print(*table.rows[-1], flush=True)
    return table


def cup(run):
    table = MeasuredTable(["elements", "points", "delta/t", "iterations", "deepest/delta", "force at 1 in"])
    scene = os.path.join(ROOT, "prm", "cup.prm")
    for elements in (50, 100, 200):
        for points in (0, 2, 3, 5, 10):
            for delta in ("1e-3", "1e-4", "1e-6"):
                own = [GAUSS, f"Blank/Gauss points={points}"] if points else [NODES]
                summary = run(scene, f"cup_{elements}_{points}_{delta}", f"Blank/Elements={elements}",
                              f"Contact/Allowed penetration={delta}*thickness", *own)
                table.add(elements, points or "nodes", delta, *cells(summary)[:2],
                          f"{summary['tools']['punch']['force_z']:.4f}" if summary else "")
                print(*table.rows[-1], flush=True)
    return table


def main():
    parser = arguments_of(__doc__, "deepest_place")
    parser.add_argument("--only", choices=("cup", "scenes"))
    options = parser.parse_args()
    run = Runs(options.program, os.path.abspath(options.output))
    for name, title, study in (("cup", "cup to 1 in: deepest place of the face over delta", cup),
                               ("scenes", "shipped scenes: deepest place of the face over delta, by default (shells: ten "
                                          "points in an element, solids: twenty in an edge, or nodes), at the nodes, and with "
                                          "few Gauss points (shells: 2, solids: the degree)",
                                scenes)):
        if options.only in (None, name):
            table = study(run)
            if options.write:
                table.write("deepest_" + name, title)


if __name__ == "__main__":
    main()
