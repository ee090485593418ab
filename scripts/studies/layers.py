#!/usr/bin/env python3
"""What more layers cost, and what they gain where a sheet is bent and made flat again.

    scripts/studies/layers.py PROGRAM [--write]

Errors: a strip of t = 1, perfectly plastic (problem 9 of doc/verification.md), over radii whose elastic cores are 3 % to 85 % of the
thickness, against fibres (tests/scenes/strip_fibres.py): the worst of the moments over the largest moment, bent and flat; of the
radius after release from bending, where at least half of the bend remains. Side-wall curl under tension: the radius.
Cost: user time of an iteration of the cup with 50 elements, over that with 7 layers, the least of five runs. A minute.
--write renews doc/measured/layers.csv.
"""
import argparse
import csv
import json
import os
import subprocess
import sys
import tempfile

from measured import ROOT, MeasuredTable

sys.path.insert(0, os.path.join(ROOT, "tests", "scenes"))
from strip_fibres import Metal, Strip  # noqa: E402

LAYERS = [7, 9, 15, 25, 45, 61]
FLOW, YOUNG, POISSON = 200., 210e3, .3
CORES = [.03, .06, .1, .16, .25, .36, .5, .65, .85]
FIRST_YIELD = FLOW / (1 - POISSON + POISSON**2)**.5 * (1 - POISSON**2) / YOUNG  # strain along, in plane strain
PLASTIC_MOMENT = FLOW / 3**.5 / 2
CURL = 161.72


def run(program, folder, scene, entries):
    """User time (s)."""
    command = [program, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--output", folder]
    for entry in entries + ["Output/Pictures=0"]:
        command += ["--set", entry]
    with open(os.devnull, "w", encoding="utf-8") as nothing:
        process = subprocess.Popen(command, stderr=nothing)
        _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise RuntimeError(" ".join(command))
    return usage.ru_utime


def rows_of(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def moments(program, folder, radius, layers, rule):
    """Bent to a radius, and flat again."""
    run(program, folder, "springback_bending",
        [f"Blank/Layers={layers}", f"Blank/Layer rule={rule}", "Blank/Elements=1", "Blank/Points=0 0; 1 0",
         f"Supports/bend/Value=0: 0, 1: {1 / radius}, 2: 0", "Supports/bend/Stages=form, flat", "Steps/Stages=form, flat, release",
         "Steps/form/Largest increment=0.02", "Steps/flat/End time=2", "Steps/flat/Largest increment=0.02",
         "Steps/release/End time=3"])
    history = rows_of(folder, "history.csv")
    return [next(float(row["bend_reaction"]) for row in history if float(row["time"]) == time) for time in (1, 2)]


def curl(program, folder, layers, rule):
    run(program, folder, "side_wall_curl", [f"Blank/Layers={layers}", f"Blank/Layer rule={rule}"])
    last = rows_of(folder, "profile_4.csv")[-1]
    return float(last["r"]) / float(last["rotation"])


def cost(program, folder, layers):
    """Microseconds of an iteration."""
    times = [run(program, folder, "cup", [f"Blank/Layers={layers}", "Output/Travels="]) for _ in range(5)]
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        return 1e6 * min(times) / json.load(file)["newton_iterations"]


def reference(radius):
    """Moments of fibres, bent and flat."""
    strip = Strip(Metal(YOUNG, POISSON, lambda x: FLOW), 1., 160, True)
    steps = 40
    bent = [strip.bend((i + 1) / steps / radius, 0.) for i in range(steps)]
    flat = [strip.bend((1 - (i + 1) / steps) / radius, 0.) for i in range(steps)]
    return bent[-1], flat[-1]


def errors(program, folder, exact, layers, rule):
    """Of the moment, bent and flat, and of the radius after release."""
    bent, flat, released = 0., 0., 0.
    for radius, *moment in exact:
        wrong = [abs(a - b) for a, b in zip(moments(program, folder, radius, layers, rule), moment)]
        bent, flat = max(bent, wrong[0]), max(flat, wrong[1])
        springs = 12 * (1 - POISSON**2) / YOUNG  # curvature per moment
        remains = 1 / radius - springs * moment[0]
        if remains > .5 / radius:
            released = max(released, springs * wrong[0] / remains)
    return bent / PLASTIC_MOMENT, flat / PLASTIC_MOMENT, released


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    radii = [core / 2 / FIRST_YIELD for core in CORES]
    exact = [(radius, *reference(radius)) for radius in radii]
    table = MeasuredTable(["layers", "rule", "moment bent", "moment flat", "radius released", "curl under tension",
                           "iteration of the cup"])
    with tempfile.TemporaryDirectory() as parent:
        folder = os.path.join(parent, "run")
        least = 0.
        for layers in LAYERS:
            time = cost(program, folder, layers)
            least = least or time
            for rule in ("gauss", "lobatto"):
                wrong = [*errors(program, folder, exact, layers, rule), abs(curl(program, folder, layers, rule) / CURL - 1)]
                table.add(layers, rule, *(f"{value:.1e}" for value in wrong), f"{time / least:.2f}")
                print(*table.rows[-1], f"{time:.0f}", file=sys.stderr, flush=True)
    print(table)
    if options.write:
        table.write("layers", "layers through the thickness: relative errors of bent sheets, time of an iteration over that with 7 layers")


if __name__ == "__main__":
    main()
