#!/usr/bin/env python3
"""Points of drawn metals as scenes with default increments against points.csv, made by programs that share nothing with
deltaform (reference_points.py).

    points.py PROGRAM FOLDER --part fast|rest [--case NAME]

Every stress, plastic strain and thickness at the end of every stage has to be that of the reference to 1e-4.
"""
import argparse
import csv
import math
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
TOLERANCE = 1e-4
MERIDIANS = {"tube": "{0} 0; {0} {0}", "strip": "0 0; {0} 0", "disc": "0 0; {0} 0"}
# name, boundary, component, is it what pulls?
SUPPORTS = {"tube": [("bottom", "start", "z", False), ("pull", "end", "z", True), ("slope", "start", "rotation", False),
                     ("slope end", "end", "rotation", False)],
            "strip": [("fixed", "start", "r", False), ("height", "start", "z", False), ("slope", "start", "rotation", False),
                      ("pull", "end", "r", True), ("height end", "end", "z", False)],
            "disc": [("pull", "end", "r", True), ("height", "end", "z", False), ("slope", "end", "rotation", False)]}


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def motion(length, path):
    """Of one stage at a constant logarithmic rate, of several by straight lines."""
    if len(path) == 1:
        time, strain = path[0]
        return f"{length!r}*(exp({strain / time!r}*t)-1)"
    return ", ".join(f"{time!r}: {length * math.expm1(strain)!r}" for time, strain in [(0., 0.), *path])


def scene(case):
    """Sections by their names."""
    length, held = float(case["length"]), case["held as"]
    path = [tuple(map(float, pair.split())) for pair in case["time and strain"].split(";")]
    entries = {"Units": case["units"], "Blank/Kind": "shell", "Blank/Elements": "2",
               "Blank/Symmetry": "plane strain" if held == "strip" else "axisymmetric",
               "Blank/Points": MERIDIANS[held].format(length), "Blank/Thickness": f"{length * (1e-4 if held == 'tube' else .05)!r}",
               "Supports/Names": ", ".join(name for name, *_ in SUPPORTS[held]),
               "Output/Pictures": "0", "Output/Checkpoint interval": "0"}
    entries.update(("Material/" + entry).split("=", 1) for entry in case["material"].split(" | "))
    for name, boundary, component, pulls in SUPPORTS[held]:
        entries[f"Supports/{name}/Boundary"], entries[f"Supports/{name}/Component"] = boundary, component
        if pulls:
            entries[f"Supports/{name}/Value"] = motion(length, path)
    entries["Steps/Stages"] = ", ".join(f"stage {i + 1}" for i in range(len(path)))
    begin = 0.
    for i, (end, _) in enumerate(path):
        stage, duration = f"Steps/stage {i + 1}/", end - begin
        entries[stage + "End time"], entries[stage + "Continue after necking"] = repr(end), "true"
        # The defaults of a stage of duration 1.
        for entry, share in (("First increment", .01), ("Largest increment", .02), ("Smallest increment", 1e-7)):
            entries[stage + entry] = repr(share * duration)
        begin = end
    return entries


def write(entries, path):
    lines = []
    for entry, value in entries.items():
        *sections, name = entry.split("/")
        lines += [f"subsection {section}" for section in sections] + [f"set {name} = {value}"] + ["end"] * len(sections)
    path.write_text("\n".join(lines) + "\n")


def wrong(program, case, folder):
    """The largest error over the reference, and what is wrong."""
    folder.mkdir(parents=True, exist_ok=True)
    write(scene(case), folder / "scene.prm")
    run = subprocess.run([program, str(folder / "scene.prm"), "--quiet", "--output", str(folder / "out")], capture_output=True,
                         text=True)
    if run.returncode:
        return math.inf, f"exit status {run.returncode}: {(run.stdout + run.stderr).strip()}"
    profiles = sorted((folder / "out").glob("profile_*.csv"), key=lambda path: float(path.stem.split("_")[1]))
    stages = case["time and strain"].count(";") + 1
    if len(profiles) != stages:
        return math.inf, f"{len(profiles)} profiles of {stages} stages"
    worst, where = 0., ""
    for expected in case["stage, column, value"].split(";"):
        stage, column, value = expected.split()
        got = float(rows(profiles[int(stage) - 1])[0][column])
        error = abs(got / float(value) - 1.)
        if not error <= worst:
            worst, where = error, f"stage {stage}, {column}: {got:.8g}, expected {value}"
    return worst, where


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--part", choices=["fast", "rest"], default="fast")
    parser.add_argument("--case", help="only cases with this in their name")
    options = parser.parse_args()
    failed = n = 0
    for i, case in enumerate(rows(HERE / "points.csv")):
        if options.case and options.case not in case["case"]:
            continue
        if not options.case and (case["fast"] == "yes") != (options.part == "fast"):
            continue
        error, where = wrong(options.program, case, options.folder / str(i))
        bad = not error <= TOLERANCE
        failed, n = failed + bad, n + 1
        print(f"{case['case']}: {error:.1e} ({where})" + (" FAILED" if bad else ""), flush=True)
    print(f"{n - failed} of {n} within {TOLERANCE:g}")
    return 1 if failed or not n else 0


if __name__ == "__main__":
    sys.exit(main())
