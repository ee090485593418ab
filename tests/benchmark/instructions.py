#!/usr/bin/env python3
"""Instructions of an increment, counted by callgrind: a guard of the speed for machines whose clocks are noisy.

    instructions.py DELTAFORM REFERENCE_KERNEL PRM_FOLDER [--scene NAME] [--set SECTION/ENTRY=VALUE]... [--renew]

Runs small scenes under callgrind, which counts between the begin and the end of Analysis::run only: start-up is left out.
The count over the number of unknowns and of increments, whose size is given, in units of the same program's count of a fixed kernel
(reference_kernel.cc), must not exceed the value in instructions.json by more than 10 %. --renew writes that file; do so after a
change that makes deltaform faster, or slower for a reason.
"""
import argparse
import json
import os
import shutil
import sys
import tempfile

from callgrind import callgrind, exit_with

STORED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "instructions.json")
ALLOWED = 1.1
UNITS = 100  # in a run of the kernel


def fixed(stage, size, end):
    return [f"Steps/{stage}/First increment={size}", f"Steps/{stage}/Largest increment={size}", f"Steps/{stage}/End time={end}"]


SCENES = {
    "shell_cup": ("cup.prm", ["Blank/Elements=50", "Blank/Contact points=nodes", *fixed("form", .01, .1)]),
    "shell_cup_points": ("cup.prm", ["Blank/Elements=50", *fixed("form", .01, .1)]),
    "solid_stretching": ("osu_stretching_solid.prm", ["Blank/Elements=30", "Blank/Contact points=nodes", *fixed("form", .25, 1)]),
    "strip_with_friction": ("bent_strip.prm", ["Blank/Elements=60", "Blank/Contact points=nodes", *fixed("form", .25, 2)]),
}


# Checkpoints go by the clock, which callgrind stretches.
QUIET = ["Output/Pictures=0", "Output/Travels=", "Output/Checkpoint interval=1e6"]


def count(program, prm, name, entries):
    """Instructions per unknown and increment."""
    file, own = SCENES[name]
    with tempfile.TemporaryDirectory() as folder:
        sets = [word for entry in [*own, *QUIET, *entries] for word in ("--set", entry)]
        counts = callgrind([program, os.path.join(prm, file), "--quiet", "--output", folder, *sets],
                           options=["--collect-atstart=no", "--toggle-collect=deltaform::Analysis::run()"])
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
    return counts.total / summary["unknowns"] / summary["increments"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("kernel")
    parser.add_argument("prm")
    parser.add_argument("--scene", action="append", choices=SCENES)
    parser.add_argument("--set", action="append", default=[], help="an entry that is changed, to see the guard bark")
    parser.add_argument("--renew", action="store_true")
    options = parser.parse_args()
    if not shutil.which("valgrind"):
        sys.exit("instructions.py: valgrind is not installed, so that the speed is not guarded: scripts/setup.sh installs it")

    unit = callgrind([options.kernel], options=["--collect-atstart=no", "--toggle-collect=reference_unit*"]).total / UNITS
    if unit < 1:
        sys.exit("instructions.py: callgrind has not found the function of the reference kernel")
    stored, failed = {}, False
    if os.path.exists(STORED):
        with open(STORED, encoding="utf-8") as file:
            stored = json.load(file)
    for name in options.scene or SCENES:
        instructions = count(options.program, options.prm, name, options.set)
        units = instructions / unit
        line = f"{name}: {instructions:.0f} instructions per unknown and increment, {units:.4f} of the kernel ({unit:.0f})"
        if options.renew:
            stored[name] = round(units, 4)
        elif not units > 0:
            line += ": FAILED, nothing was counted"
            failed = True
        else:
            ratio = units / stored[name]
            line += f"; {ratio:.3f} of the stored {stored[name]:.4f}"
            if ratio > ALLOWED:
                line += f": FAILED, more than {ALLOWED}"
                failed = True
            elif ratio < 1 / ALLOWED:
                line += ": faster, --renew would guard that"
        print(line, flush=True)
    if options.renew:
        with open(STORED, "w", encoding="utf-8") as file:
            json.dump(stored, file, indent=2)
            file.write("\n")
    return 1 if failed else 0


if __name__ == "__main__":
    exit_with(main)
