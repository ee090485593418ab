#!/usr/bin/env python3
"""Instructions of a plastic point of a sheet, with its tangent, by yield surface and backstress, counted by callgrind.

    point_cost.py POINT_COST [--write]

Mises is one; what costs more than its limit fails. Without --write only what has a limit is counted; --write renews
doc/measured/point_cost.csv.
"""
import argparse
import os
import subprocess
import sys

from callgrind import callgrind, exit_with

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "scripts", "studies"))
from measured import MeasuredTable  # noqa: E402

METAL = ["Young's modulus=69004", "Poisson's ratio=.3", "Hardening/Law=swift", "Hardening/Strength coefficient=589",
         "Hardening/Prestrain=1e-4", "Hardening/Hardening exponent=.216"]
ALPHA = "1.0035 .9636 .8832 1.0481 1.0125 .9947 .9215 1.1918"
# Name, entries, most instructions over those of Mises (none: only reported)
LAWS = [
    ("mises", ["Yield surface/Law=mises"], None),
    ("hill, r-bar = 1.6", ["Yield surface/Law=hill", "Yield surface/r-bar=1.6"], 1.2),
    ("hosford, a = 6", ["Yield surface/Law=hosford", "Yield surface/Exponent=6", "Yield surface/r-bar=1.6"], 3.),
    ("hosford, a = 8", ["Yield surface/Law=hosford", "Yield surface/Exponent=8"], 3.),
    ("hill, r0 = 1.6, r90 = .8", ["Yield surface/Law=hill", "Yield surface/r0=1.6", "Yield surface/r90=.8"], None),
    ("yld2000-2d, a = 8", ["Yield surface/Law=yld2000-2d", "Yield surface/Exponent=8", "Yield surface/Alpha=" + ALPHA], 16.),
    ("hosford, a = 6, chaboche of 2 terms", ["Yield surface/Law=hosford", "Yield surface/Exponent=6", "Backstress/Law=chaboche",
                                             "Backstress/Terms=20000 100; 500 0"], None),
    ("mises, chaboche of 2 terms", ["Backstress/Law=chaboche", "Backstress/Terms=20000 100; 500 0"], 3.),
    ("mises, cowper-symonds", ["Rate factor/Law=cowper-symonds", "Rate factor/Reference rate=40.4",
                               "Rate factor/Rate exponent=5"], None),
]


def instructions(program, entries):
    """Per update of a point."""
    command = [program, *["Material/" + entry for entry in METAL + entries]]
    updates = int(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    counts = callgrind(command, options=["--collect-atstart=no", "--toggle-collect=form_points*"])
    return counts.total / updates


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    unit, failed, table = None, False, MeasuredTable(["law", "instructions", "over Mises"])
    for name, entries, most in LAWS:
        if most is None and name != "mises" and not options.write:
            continue  # most of the time is valgrind's start
        count = instructions(options.program, entries)
        if not count > 10:
            sys.exit("point_cost.py: callgrind has not found the points")
        unit = unit or count
        ratio = count / unit
        wrong = most is not None and ratio > most
        failed = failed or wrong
        print(f"{name}: {count:.0f} instructions, {ratio:.2f} of Mises" + (f": FAILED, more than {most}" if wrong else ""),
              flush=True)
        table.add(name, f"{count:.0f}", f"{ratio:.2f}")
    if options.write:
        table.write("point_cost", "instructions of a plastic point of a sheet, with its tangent")
    return 1 if failed else 0


if __name__ == "__main__":
    exit_with(main)
